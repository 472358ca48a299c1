"""Which letter of a formula is the crank radius, the rod, their ratio, the speed or the crank angle.

By what the page says of it, else as is usual: the letter in a sine is the crank angle, of two the second
one is the rod's. A ratio λ of which nothing says whether it is r/l or l/r may be either.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import permutations
from math import asin, isfinite, sin
from typing import NamedTuple

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    children,
    names,
    with_children,
)
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.meant.formula_slips import value_at
from symbalance.notes.checking.meant.meant_words import MeantWords
from symbalance.notes.checking.meant.pistons.motion_slips import Point, Values
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

OF_CRANK = ("theta", "vartheta", "alpha", "phi", "varphi", "psi", "gamma", "delta", "beta")
"""Letters of angles, those of the crank first: of two, the later one is the rod's."""
_STEMS: Mapping[str, frozenset[str]] = {
    "w": frozenset({"omega", "Omega", "w"}),
    "r": frozenset({"r", "R"}),
    "l": frozenset({"l", "L", "ell"}),
    "ratio": frozenset({"lambda", "kappa", "rho", "varepsilon", "epsilon", "mu", "k", "q", "nu", "n"}),
    "e": frozenset({"e", "d", "a", "y", "c"}),
    "s": frozenset({"S", "H", "s", "h"}),
}
_CRANK_OVER_ROD = re.compile(
    r"crank(?:[- ](?:radius|throw|length))?\s*(?:/|over|to|by|divided by|:)\s*"
    r"(?:the\s+)?(?:connecting[- ])?rod|(?:crank|rod)[- ]ratio\s+\$?r\s*/\s*l"
    r"|ratio of (?:the )?crank(?: \w+)? to (?:the )?(?:connecting[- ])?rod"
    r"|(?:half[- ]stroke|throw) (?:over|to|by) (?:the )?(?:connecting[- ])?rod"
    r"|manivelle(?:\s*/\s*|\s+(?:sur|à)\s+)bielle|manivela(?:\s*/\s*|\s+y\s+)(?:longitud de )?biela"
    r"|(?:schub|pleuel)stangenverhältnis|pleuelverhältnis|kurbelradius (?:zu|durch|/) "
    r"|\b[rR]\s*/\s*[lL]\b",
    re.IGNORECASE,
)
_ROD_OVER_CRANK = re.compile(
    r"(?:connecting[- ])?rod(?:[- ]length)?\s*(?:/|over|to|by|divided by|:)\s*(?:the\s+)?crank"
    r"|ratio of (?:the )?(?:connecting[- ])?rod(?: \w+)? to (?:the )?crank|\b[lL]\s*/\s*[rR]\b",
    re.IGNORECASE,
)
_OF_STROKE = re.compile(
    r"(?:stroke|hub|行程|ストローク)\s*(?:/|to|over|zu)\s*(?:the\s+)?(?:rod|pleuel|stange)"
    r"|(?:rod|pleuel\w*)\s*(?:/|to|over|zu)\s*(?:the\s+)?(?:stroke|hub)"
    r"|\b[lL]\s*/\s*[sS]\b|\b[sS]\s*/\s*[lL]\b",
    re.IGNORECASE,
)
_OTHER_LENGTH = (
    r"(?:bore|diameter|stroke|circle|distance|pitch|spacing|height|offset|bohrung|durchmesser|\bhub|abstand|höhe|versatz|alésage|diamètre"
    r"|course|alesaggio|diametro|corsa|distanza|diámetro|carrera|distancia|直径|行程|内径|距離|ストローク)"
)
"""Lengths that are neither the crank radius nor the rod."""
_OTHER_BEFORE = re.compile(
    rf"{_OTHER_LENGTH}\w*(?:\s(?:of|is|von|ist|de|est|di|è|es))?[\s$({{\\:]*$", re.IGNORECASE
)
_OTHER_BEHIND = re.compile(
    r"[\s$)},]{0,4}(?:(?:is|ist|est|è|es|being|denotes|bezeichnet)\s)?(?:the|der|die|das|den|la|le|il|lo|el)\s"
    rf"(?:[^\W\d_]+\s){{0,2}}?\w*{_OTHER_LENGTH}",
    re.IGNORECASE,
)
_BESIDE = 24
"""Characters beside a letter in which such a word says what it is."""
_ROLES = {
    "crank radius": "r", "rod length": "l", "stroke": "s", "angular speed": "w", "rod ratio l/r": "ratio",
    "crank ratio r/l": "ratio",
}  # fmt: skip


class Reading(NamedTuple):
    """Which letter of a claim plays which role, with the convention of its ratio."""

    letters: Mapping[str, str]
    is_inverse: bool
    law: Formula | None
    """What stands for the crank angle: ω t."""

    def point(self, at: Point) -> dict[str, Fraction]:
        """Return the numbers of the claim's letters at a point of the roles."""
        numbers = {"r": at["r"], "w": at["w"], "theta": at["theta"], "e": at["e"]}
        numbers |= {"l": at["r"] / at["lam"], "s": 2 * at["r"]}
        numbers["ratio"] = 1 / at["lam"] if self.is_inverse else at["lam"]
        inclined = asin(float(at["lam"]) * sin(float(at["theta"])))
        numbers["rod"] = Fraction(inclined).limit_denominator(10**15)
        numbers["t"] = at["theta"] / at["w"]
        return {letter: numbers[role] for letter, role in self.letters.items()}

    def target(self, node: Formula) -> Formula | None:
        """Return a formula of the catalogue in the letters of the claim, if it has those it needs."""
        of = {role: Name(letter) for letter, role in self.letters.items()}
        radius: Formula | None = of.get("r") or (
            Quotient(of["s"], Number(Fraction(2))) if "s" in of else None
        )
        ratio: Formula | None = of.get("ratio")
        if ratio is not None and self.is_inverse:
            ratio = Quotient(Number(Fraction(1)), ratio)
        if ratio is None and "l" in of and radius is not None:
            ratio = Quotient(radius, of["l"])
        if radius is None and ratio is not None and "l" in of:
            radius = Product((ratio, of["l"]))
        if ratio is None and "rod" in of and "theta" in of:
            ratio = Quotient(Call("sin", of["rod"]), Call("sin", of["theta"]))
        angle = self.law or of.get("theta")
        values = {"r": radius, "lam": ratio, "w": of.get("w"), "theta": angle, "e": of.get("e")}
        needed = names(node)
        if any(values[role] is None for role in needed):
            return None
        return with_roles(node, {role: value for role, value in values.items() if value is not None})


def with_roles(node: Formula, values: Mapping[str, Formula]) -> Formula:
    """Return a formula with all its roles replaced at once."""
    if isinstance(node, Name):
        return values.get(node.name, node)
    parts = children(node)
    return with_children(node, tuple(with_roles(part, values) for part in parts)) if parts else node


@dataclass(frozen=True)
class MotionLetters:
    """The letters of one page."""

    document: ReadNotes
    words: MeantWords

    def readings(
        self, claim: Formula, knowledge: Knowledge, line: int, *, is_offset: bool
    ) -> Iterator[Reading]:
        """Yield the ways in which the letters of a claim may play their roles."""
        inside = letters_in_waves(claim)
        letters: dict[str, str] = {}
        law: Formula | None = None
        if "t" in inside and len(inside) > 1:
            speeds = [n for n in inside if n.partition("_")[0] in _STEMS["w"]]
            if len(speeds) != 1 or len(inside) != 2:
                return
            letters |= {speeds[0]: "w", "t": "t"}
            law = Product((Name(speeds[0]), Name("t")))
        elif inside == {"t"}:
            letters["t"] = "theta"  # cos t: no time stands alone in a cosine
        elif inside:
            angles = sorted(inside, key=angle_rank)
            if len(angles) > 2 or any(angle_rank(n) >= len(OF_CRANK) for n in angles):
                return
            letters |= dict(zip(angles, ("theta", "rod"), strict=False))
        conventions = [False]
        told = self._told(line)
        for letter in sorted(names(claim) - letters.keys()):
            stem = letter.partition("_")[0]
            roles = [role for role in ("w", "r", "l", "ratio") if stem in _STEMS[role]]
            roles = [told[letter]] if letter in told and roles != ["ratio"] else roles
            if is_offset and stem in _STEMS["e"] and not roles:
                roles = ["e"]
            elif stem in _STEMS["s"] and not roles:
                roles = ["s"]
            if len(roles) != 1 or roles[0] in letters.values():
                return
            letters[letter] = roles[0]
            if roles == ["ratio"]:
                conventions = list(self._conventions(letter, knowledge, told))
        if {"r", "s"} <= {*letters.values()}:
            return
        for is_inverse in conventions:
            yield Reading(letters, is_inverse, law)

    def _told(self, line: int) -> dict[str, str]:
        """Return the roles of letters by what the page says of them, or by a ratio of two lengths.

        With a rod L, q = e/L says that e is the crank radius, and κ = R/b that b is the rod.
        """
        declared, proposed = self.words.sizes(line)
        told = {
            n: _ROLES[role] for n, m in {**proposed, **declared}.items() if (role := role_of(m)) in _ROLES
        }
        for one, other in self._lengths_of_ratios:
            known = _length(other, told)
            if known and not _length(one, told) and one not in declared:
                told[one] = "r" if known == "l" else "l"
        return told

    @cached_property
    def _lengths_of_ratios(self) -> list[tuple[str, str]]:
        """The letters of ratios q = e/L, each with its other one, but those of another length."""
        pairs = [
            pair
            for _, name, ratio in self.words.ratios
            if name.partition("_")[0] in _STEMS["ratio"]
            and isinstance(ratio.numerator, Name)
            and isinstance(ratio.denominator, Name)
            for pair in permutations((ratio.numerator.name, ratio.denominator.name))
        ]
        others = {one for one, _ in pairs if _is_another_length(one, self.document.text)}
        return [(one, other) for one, other in pairs if one not in others]

    def _conventions(self, letter: str, knowledge: Knowledge, told: Mapping[str, str]) -> Iterator[bool]:
        """Yield whether a ratio may be l/r (True) or r/l (False); nothing for any other ratio."""
        known: set[bool] = set()
        definition = knowledge.definitions.get(letter)
        values = [definition.node] if definition is not None else []
        for chain in self.document.chains:
            if chain.sides[0].node == Name(letter):
                values += [side.node for side in chain.sides[1:]]
        for value in values:
            if (
                isinstance(value, Quotient)
                and isinstance(value.numerator, Name)
                and isinstance(value.denominator, Name)
            ):
                pair = tuple(_length(n.name, told) for n in (value.numerator, value.denominator))
                is_crank, is_rod = pair == ("r", "l"), pair == ("l", "r")
                if not is_crank and not is_rod:
                    return
                known.add(is_rod)
            elif not names(value):
                number = value_at(value, {})
                if isfinite(number) and not 0.6 < number < 1.7:
                    known.add(number > 1)
        if not known:
            known |= self._by_sines(letter)
        declared, text = knowledge.meanings.get(letter, ""), self.document.text
        if _OF_STROKE.search(text) or "l/s" in declared:
            return
        if not known:
            if "r/l" in declared or (_CRANK_OVER_ROD.search(text) and not _ROD_OVER_CRANK.search(text)):
                known.add(False)
            elif "l/r" in declared or (_ROD_OVER_CRANK.search(text) and not _CRANK_OVER_ROD.search(text)):
                known.add(True)
        yield from sorted(known or {False, True})

    def _by_sines(self, letter: str) -> set[bool]:
        """Return what a line of the page says of a ratio that takes one sine to the other's: r/l or l/r.

        Of sin β = λ sin φ λ is r/l, where β is the rod's angle: the later letter of the two.
        """
        known: set[bool] = set()
        for chain in self.document.chains:
            if len(chain.sides) != 2 or chain.relations[0].sign != "=":
                continue
            first, second = (side.node for side in chain.sides)
            if not isinstance(first, Call) or first.function != "sin":
                continue
            angles = [*names(first), *letters_in_waves(second)]
            if len(angles) != 2 or angle_rank(angles[0]) <= angle_rank(angles[1]):
                continue
            sine = Call("sin", Name(angles[1]))
            known |= (
                {second == Quotient(sine, Name(letter))} if _is_product(second, letter, sine) else set()
            )
        return known


def _is_another_length(letter: str, text: str) -> bool:
    """Tell whether words beside a letter call it neither crank radius nor rod: the bore b.

    >>> _is_another_length("b", "the bore $b$"), _is_another_length("e", "the throw $e$")
    (True, False)
    """
    return any(
        _OTHER_BEFORE.search(text[max(0, m.start() - _BESIDE) : m.start()])
        or _OTHER_BEHIND.match(text, m.end())
        for m in re.finditer(rf"(?<![\w\\])\\?{re.escape(letter)}(?!\w)", text)
    )


def _length(letter: str, told: Mapping[str, str]) -> str:
    """Return whether a letter is the crank radius, "r", or the rod, "l"; "" for neither."""
    if letter in told:
        return told[letter] if told[letter] in ("r", "l") else ""
    stem = letter.partition("_")[0]
    return next((role for role in ("r", "l") if stem in _STEMS[role]), "")


def _is_product(node: Formula, letter: str, sine: Formula) -> bool:
    """Tell whether a formula is a ratio times a sine, or the sine over it."""
    parts = node.factors if isinstance(node, Product) else ()
    return node == Quotient(sine, Name(letter)) or (len(parts) == 2 and {*parts} == {Name(letter), sine})


def with_letter_e(node: Formula) -> Formula:
    """Return a formula in which e is a letter: an offset, and not the base of logarithms."""
    if node == Constant("e"):
        return Name("e")
    if isinstance(node, Call) and node.function == "exp":
        return Power(Name("e"), with_letter_e(node.argument))
    parts = children(node)
    return with_children(node, tuple(map(with_letter_e, parts))) if parts else node


def angle_rank(letter: str) -> int:
    """Return how late among the letters of crank angles a letter is; those behind are no angles."""
    stem = letter.partition("_")[0]
    return OF_CRANK.index(stem) if stem in OF_CRANK else len(OF_CRANK)


def values_in(reading: Reading) -> Values:
    """Return the values of a claim in the letters of its page."""
    return lambda node, at: value_at(node, reading.point(at))


def known_of(claim: Formula, reading: Reading, chain: Chain) -> Knowledge:
    """Return what is known for a comparison: sizes are positive, the rod's angle follows the crank's."""
    angles = {letter for letter, role in reading.letters.items() if role in ("theta", "rod", "t")}
    known = Knowledge(SymbolValue(positive=frozenset(names(claim) - angles)), corrects=True)
    of = {role: letter for letter, role in reading.letters.items()}
    if "rod" in of and "theta" in of:
        ratio: Formula = Name(of.get("ratio", "lambda"))
        if reading.is_inverse:
            ratio = Quotient(Number(Fraction(1)), ratio)
        elif "l" in of and "r" in of:
            ratio = Quotient(Name(of["r"]), Name(of["l"]))
        angle = Call("asin", Product((ratio, Call("sin", Name(of["theta"])))))
        known = known.with_definition(of["rod"], Definition(angle, chain.lines[0]))
    return known
