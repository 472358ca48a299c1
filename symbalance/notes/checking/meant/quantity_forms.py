"""Quantities known by the form of their formula, where no words beside a letter name it.

τ = 32 T/(π d³) differs by one factor from the torsional stress, whose letters these are, and the
paragraph speaks of shear stress: that is what τ must be. Such a formula is compared with every one of the
catalogue whose left letter it has. It is left alone where it is any of them, whatever the words are; and
where it is none, it is wrong only if

    the words of its paragraph or heading name the quantity, or lines elsewhere use the letter as such:
    I beside E is of bending, W below M too, W below T of torsion,
    all its letters may stand for the roles of the formula,
    and all formulas that are one slip away come to the same.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from functools import cached_property

from symbalance.document.formula import Call, Formula, Name, Product, Quotient, Sum, names, walk
from symbalance.notes.checking.meant.catalogue import QUANTITIES, Quantity
from symbalance.notes.checking.meant.catalogue.roles import words
from symbalance.notes.checking.meant.catalogue.strength import HOLLOW
from symbalance.notes.checking.meant.letter_roles import index_of, stem_of, without_accent
from symbalance.notes.checking.meant.quantity_words import Named, QuantityWords
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_BENDING, _TORSION, _EITHER = "bending", "torsion", "either"
_USES = {
    "axial second moment of area of a round section": _BENDING,
    "section modulus of a round section in bending": _BENDING,
    "section modulus of a hollow round section in bending": _BENDING,
    "section modulus of a round section by which bending is reckoned": _BENDING,
    "second moment of area of a round section": _EITHER,
    "second moment of area of a hollow round section": _EITHER,
    "section modulus of a round section": _EITHER,
    "polar second moment of area of a round section": _TORSION,
    "polar second moment of area of a hollow round section": _TORSION,
    "polar section modulus of a round section": _TORSION,
    "polar section modulus of a hollow round section": _TORSION,
}
"""Quantities that are of bending or of torsion, which a section is used for."""
_BESIDE = {"E": _BENDING, "G": _TORSION}
"""What stands beside a second moment of area: E I is of bending, G I of torsion."""
_STRESSES = {"sigma": _BENDING, "tau": _TORSION}
"""What is a moment over a section modulus."""
_SECTIONS = frozenset(["W", "Z", "I", "J"])
_SUBSCRIPTS = {_TORSION: frozenset(["p", "t", "P", "T", "pol"]), _BENDING: frozenset({"ax"})}
"""Letters of sections, and the subscripts that say what they are used for."""
_HOLLOW = words(HOLLOW)
_OF_THE_ROD = {
    "side force on the cylinder wall": frozenset(["N", "H", "G", "L"]),
    "force in the connecting rod": frozenset(["K", "S", "Q"]),
}
"""Letters of what a force along the stroke gives with the rod's angle, each of one of the two."""
_NEVER_LARGEST = frozenset({"piston acceleration at the bottom dead centre"})
"""Quantities that no largest value is, whatever its formula looks like."""
_OF_SWINGS = frozenset({"amplitude of a stress that swings", "mean of a stress that swings"})
"""Quantities whose subscript parts them: σ_a is no mean."""
_PLAIN_INDICES = frozenset({"", "0", "1", "2", "3", "a", "b", "d", "e", "i", "k", "m", "n"})
"""Subscripts that number letters and say nothing of what they are."""
_FEW = 2
"""Letters of which a formula has at least one more, or a number: F = m a is too plain to be known."""


_CLOSE = 80
_CLAUSE_END = re.compile(r"[.;]\s|[。；]")
_SUMMED = re.compile(r"(?<![^\W\d_])(?:sum|summe|somme|somma|suma)(?![^\W\d_])|和は|合計", re.IGNORECASE)
_PROJECTED = "force of two cylinders on one pin"
"""What is added up in one direction: words for a sum, of mere sizes, name something else."""


@dataclass
class QuantityForms:
    """Looks for the quantities that a formula of one document may be by its form."""

    words: QuantityWords
    refuted: dict[str, int] = field(default_factory=dict)
    """Letters of formulas that were refuted by their form, with the place of the first."""

    def candidates(self, name: str, chain: Chain, forces: Collection[str]) -> Iterator[Named]:
        """Yield the quantities that a letter may be by the words around, or by its use elsewhere.

        `forces` are the letters that other lines show to be forces along the stroke.
        """
        use, around = self.use_of(name), self.words.around(chain)
        by_use = name in self.uses
        if around is None:
            return
        claim = chain.sides[1].node
        if names(claim) & self.rod_angles and names(claim) - self.rod_angles <= set(forces):
            stem = stem_of(name)
            for quantity in QUANTITIES:
                if stem in _OF_THE_ROD.get(quantity.name, ()):
                    named = around.by_use(quantity, "lines above have its force and the rod angle")
                    if named.may_refute:
                        yield named
            return
        before = self.words.document.text[max(0, chain.start - _CLOSE) : chain.start]
        is_sum = _SUMMED.search(_CLAUSE_END.split(before)[-1]) is not None
        for quantity in _of_letter(name):
            if is_sum and quantity.name.startswith(_PROJECTED):
                continue
            if use and _USES.get(quantity.name) == use:
                if "hollow" in quantity.name or not _HOLLOW.search(around.places.around):
                    yield around.by_use(
                        quantity,
                        f"other formulas use it for {use}" if by_use else f"its subscript says {use}",
                    )
            elif not use or quantity.name not in _USES:
                named = around.by_topic(quantity, name)
                if named is not None:
                    yield named

    def possible(self, name: str, candidates: Collection[Named]) -> Iterator[Quantity]:
        """Yield the quantities that a letter may be for all that its use and its subscript say.

        The largest acceleration a_max is not that at the bottom, which has no such subscript.
        """
        use, index = self.use_of(name), index_of(name)
        is_telling_index = index not in _PLAIN_INDICES and any(
            index in named.quantity.indices for named in candidates
        )
        for quantity in _of_letter(name):
            other = _USES.get(quantity.name)
            if use and other and other != use:
                continue
            if quantity.name in _OF_SWINGS and index and index not in quantity.indices:
                continue
            is_never = is_telling_index and quantity.name in _NEVER_LARGEST and index == "max"
            fits = not is_telling_index or not quantity.indices or index in quantity.indices
            if fits and not is_never:
                yield quantity

    def of_letter(self, name: str, declared: str) -> Iterator[Quantity]:
        """Yield the quantities of a letter, those that its declaration names if it has one."""
        for quantity in _of_letter(name):
            if not declared or quantity.phrases.search(declared):
                yield quantity

    def use_of(self, name: str) -> str:
        """Return what the letter of a section is used for elsewhere or by its subscript, or ""."""
        is_section = stem_of(name) in _SECTIONS
        by_index = next((use for use, own in _SUBSCRIPTS.items() if index_of(name) in own), "")
        return (
            by_index if is_section and by_index else self.uses.get(name, "")
        )  # I_p beside E stays polar

    @cached_property
    def rod_angles(self) -> frozenset[str]:
        """The letters of angles that a line shows to be the rod's: β of sin β = λ sin α."""
        angles: set[str] = set()
        for chain in self.words.document.chains:
            sides = [side.node for side in chain.sides]
            own = {name for node in sides if (name := _angle_of_sine(node))}
            others = {_angle_of_sine(part) for node in sides for part in walk(node)} - own - {""}
            if len(own) == len(others) == 1:
                angles |= own
        return frozenset(angles)

    @cached_property
    def uses(self) -> dict[str, str]:
        """What letters of sections are used for elsewhere on the page, if it is one thing only."""
        uses: dict[str, set[str]] = {}
        for chain in self.words.document.chains:
            for side in chain.sides:
                for part in walk(side.node):
                    for name, use in _beside_modulus(part):
                        uses.setdefault(name, set()).add(use)
            for name, use in _below_moment(chain):
                uses.setdefault(name, set()).add(use)
        return {name: next(iter(each)) for name, each in uses.items() if len(each) == 1}


def _angle_of_sine(node: Formula) -> str:
    """Return the letter of which a formula is the sine; "" for any other."""
    if not isinstance(node, Call) or node.function != "sin" or not isinstance(node.argument, Name):
        return ""
    return node.argument.name


def is_telling(formula: Formula) -> bool:
    """Tell whether a formula has a form of its own: a sum, a function, a number or many letters."""
    is_plain = all(isinstance(part, Name | Product | Quotient) for part in walk(formula))
    return len(names(formula)) > _FEW or not is_plain


def _of_letter(name: str) -> Iterator[Quantity]:
    alone = without_accent(name)
    alone = alone.rstrip("'")
    stem = alone if alone.startswith("Delta_") else stem_of(alone)
    for quantity in QUANTITIES:
        if {stem, alone} & quantity.letters:
            yield quantity


def _beside_modulus(part: Formula) -> Iterator[tuple[str, str]]:
    """Yield the letters of second moments of area that stand beside an elastic modulus: I of E I."""
    factors = part.factors if isinstance(part, Product) else ()
    letters = {factor.name for factor in factors if isinstance(factor, Name)}
    for modulus, use in _BESIDE.items():
        if modulus in letters:
            yield from ((n, use) for n in letters if n.partition("_")[0] in ("I", "J"))


def _below_moment(chain: Chain) -> Iterator[tuple[str, str]]:
    """Yield the letters of section moduli below a moment that gives a stress: W of σ = M/W."""
    head = chain.sides[0].node
    use = _STRESSES.get(head.name.partition("_")[0]) if isinstance(head, Name) else None
    for side in chain.sides[1:]:
        node = side.node
        if use and isinstance(node, Quotient) and isinstance(node.denominator, Name):
            below = node.denominator.name
            if below.partition("_")[0] in (*_SECTIONS, "S") and not isinstance(node.numerator, Sum):
                yield below, use
