"""Forces of the cylinders of one engine, one letter with a number each: F_1, F_2, F_3 and F_4.

With throws at 0° and 180° each force is ±F (cos θ ± λ cos 2θ). A throw at 180° changes the sign of the
first order alone, as seen from one side; a cylinder that points the other way changes that of the second:

    first order     + where the throw is at 0°, - where it is at 180°
    second order    + for a cylinder that points one way, - for one that points the other way

One force is refuted where all others of its family are so and it alone is not. None of them is a single
piston's force in general: the others count their signs in the same direction.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Sum, names
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.meant.engines.engine_claims import EngineClaims
from symbalance.notes.checking.meant.engines.order_indices import wave_of
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.meant.products import NoProductError, product_of, terms_of
from symbalance.notes.checking.repair.fixes import Repair, fix_of
from symbalance.notes.checking.verdicts import DEFINITION, Verdict
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_FEWEST, _FLAT_FOUR = 3, (0, 180, 180, 0)
_NEAR = 16
"""Lines within which the forces of one engine stand."""
_SIDE = re.compile(
    r"(?<![0-9.,])(?P<first>[1-6])\s?(?:,|and|und|et|ed?|y|&|と|・|、)\s?(?P<second>[1-6])(?![0-9.,]*[0-9°])"
)
"""Two cylinders that are spoken of together: 1 and 3 on the right."""

Signs = tuple[int, int]


@dataclass(frozen=True, slots=True)
class _Force:
    """A cylinder's number, the signs of its two orders, and its formula in two terms."""

    number: int
    signs: Signs
    terms: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class _Reading:
    """The signs that the cylinders' forces have if the words are taken in one way."""

    signs: tuple[Signs, ...]
    text: str


@dataclass
class CylinderForces:
    """Judges the forces of single cylinders that are counted in one direction on one page."""

    claims: EngineClaims

    def judge(self, chain: Chain, k: int) -> Verdict | Decision | None:
        """Return the verdict on one force of a family, a definition where it is open; None for others."""
        own = None if k else _force(chain)
        if own is None or chain.relations[0].sign not in "=≈":
            return None
        family = self._family(chain)
        if len(family) < _FEWEST or sorted(family) != list(range(1, len(family) + 1)):
            return None
        if len({force.signs for force in family.values()}) == 1:
            return None
        readings = list(self._readings(chain, len(family)))
        misses = [_misses(family, reading) for reading in readings]
        least = min(map(len, misses), default=2)
        fitting = [(r, m) for r, m in zip(readings, misses, strict=True) if len(m) == least]
        if (
            least > 1
            or len({tuple(m.items()) for _, m in fitting}) != 1
            or (least == 0 < len(fitting) - 1)
        ):
            return Decision(DEFINITION)
        reading, missed = fitting[0]
        if own.number in missed:
            return self._refuted(chain, own, missed[own.number], reading)
        return Decision(PROVED, assumptions=(self._assumption(chain, reading), "the rod is long"))

    def _family(self, chain: Chain) -> dict[int, _Force]:
        """Return the forces of a letter with numbers near a relation, by their numbers."""
        head = chain.sides[0].node
        stem = head.name.rpartition("_")[0] if isinstance(head, Name) else ""
        sections, line = self.claims.sections, chain.lines[0]
        family: dict[int, _Force] = {}
        for other in self.claims.words.document.chains:
            name = other.sides[0].node
            is_near = abs(other.lines[0] - line) <= _NEAR and sections.same_section(other.lines[0], line)
            if not is_near or not isinstance(name, Name) or name.name.rpartition("_")[0] != stem:
                continue
            force = _force(other)
            if force is not None:
                family.setdefault(force.number, force)
        return family

    def _readings(self, chain: Chain, count: int) -> Iterator[_Reading]:
        """Yield the signs that the cylinders may have by the engine's name, its throws and its sides."""
        engine, listed = self.claims.engine_of(chain), self.claims.listed(chain)
        if engine is None or engine.cylinders != count:
            return
        pins: tuple[int | Fraction, ...] = _FLAT_FOUR if count == len(_FLAT_FOUR) else ()
        pins = listed.degrees if listed is not None and len(listed.degrees) == count else pins
        if not pins or any(degrees % 180 for degrees in pins):
            return
        shown = ", ".join(f"{float(degrees):g}°" for degrees in pins)
        for sides in self._sides(chain, count) if engine.is_boxer else [(1,) * count]:
            signs = tuple(
                (1 if not pin % 360 else -1, side) for pin, side in zip(pins, sides, strict=True)
            )
            way = " and ".join(str(k) for k, side in enumerate(sides, 1) if side > 0)
            where = f", cylinders {way} on one side" if engine.is_boxer else ""
            words = " ".join(engine.words.split())
            yield _Reading(signs, f"the throws are at {shown}{where} (“{words}”)")

    def _sides(self, chain: Chain, count: int) -> list[tuple[int, ...]]:
        """Return which way each cylinder may point: as words pair them, in turn, or in halves."""
        pairs = [{int(m["first"]), int(m["second"])} for m in _SIDE.finditer(self.claims.section(chain))]
        alternate = tuple((-1) ** k for k in range(count))
        halves = tuple(1 if 2 * k < count else -1 for k in range(count))
        ways = [alternate, halves]
        told = [
            way for way in ways if any({k for k, s in enumerate(way, 1) if s > 0} == p for p in pairs)
        ]
        return told if len(told) == 1 else ways

    def _assumption(self, chain: Chain, reading: _Reading) -> str:
        name = chain.sides[0].node
        letter = plain_letter(name.name) if isinstance(name, Name) else ""
        return f"{letter} is that cylinder's inertia force in one direction ({NOBODY}); {reading.text}"

    def _refuted(
        self, chain: Chain, own: _Force, signs: Signs, reading: _Reading
    ) -> Verdict | Decision | None:
        """Return the refutation of a force whose signs do not go with the others."""
        side, document = chain.sides[1], self.claims.words.document
        changed = (first * second for first, second in zip(own.signs, signs, strict=True))
        target = Sum(tuple(t if c > 0 else _negated(t) for t, c in zip(own.terms, changed, strict=True)))
        known = Knowledge(SymbolValue(positive=frozenset(names(side.node))), corrects=True)
        decision = decide(Side((target,), chain.sides[0].span), side, "=", known)
        reason = f"if {self._assumption(chain, reading)}: as the others are, its signs are otherwise"
        verdict = describe(document, chain, 0, Decision(REFUTED, reason, witness=decision.witness))
        node = without_dots(side.node)[0]
        return replace(
            verdict, fix=fix_of(Repair("sign", target, ((node, target),), 1.0), document, side)
        )


def _negated(node: Formula) -> Formula:
    return node.operand if isinstance(node, Negative) else Negative(node)


def _force(chain: Chain) -> _Force | None:
    """Return a relation as the force of one cylinder: ±F (cos θ ± λ cos 2θ); None for any other."""
    head = chain.sides[0].node
    if len(chain.sides) < 2 or not isinstance(head, Name) or head.name[:1] not in ("F", "P", "K", "f"):
        return None
    number = head.name.rpartition("_")[2]
    terms = terms_of(without_dots(chain.sides[1].node)[0])
    if not number.isdecimal() or len(terms) != 2:
        return None
    try:
        products = [product_of(term) for term in terms]
    except NoProductError:
        return None
    waves = [each.wave for each in products if each.wave is not None and each.wave.function == "cos"]
    if len(waves) != 2 or any(isinstance(wave.argument, Sum) for wave in waves):
        return None
    (first, angle), (second, other) = (wave_of(wave) for wave in waves)
    if (first, second) != (1, 2) or angle != other or not names(chain.sides[1].node):
        return None
    own, above = products
    is_of_ratio = len({*own.powers} ^ {*above.powers}) <= 2 and abs(own.number) == abs(above.number)
    signs = (1 if own.number > 0 else -1, 1 if above.number > 0 else -1)
    return _Force(int(number), signs, terms) if is_of_ratio else None


def _misses(family: dict[int, _Force], reading: _Reading) -> dict[int, Signs]:
    """Return the signs, either way up, that a reading gives those forces which have others."""
    ways = [
        {
            number: (way * reading.signs[number - 1][0], way * reading.signs[number - 1][1])
            for number, force in family.items()
            if force.signs != tuple(way * sign for sign in reading.signs[number - 1])
        }
        for way in (1, -1)
    ]
    return min(ways, key=len)
