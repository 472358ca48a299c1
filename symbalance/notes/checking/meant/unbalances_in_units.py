"""Unbalances with their units: F = 10⁻⁶ U ω² with U in g mm, e = 6.3 mm/s over 314 rad/s, U = m e.

Unbalances are counted in g mm, eccentricities in µm and grades of balance in mm/s, so that a power of ten
or the 60 of minutes is the slip. Where the words name the quantity and the page gives each of its sizes
one number with a unit, or each letter a unit, its value is known:

    U = m e        F = m e ω² = U ω²        e = G/ω        U = m G/ω

A value or a formula that is another is wrong; nothing is said where a size has two numbers, or where the
words make a part of it, of one of two planes.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import isclose, log10, pi

from symbalance.document.formula import Formula, Name, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.meant.formula_slips import value_at
from symbalance.notes.checking.meant.given_numbers import number_in_example
from symbalance.notes.checking.meant.letter_roles import sign_of
from symbalance.notes.checking.meant.named_quantities import NamedQuantities, may_be_part
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

REACH = 1200
"""Characters above a relation, in its section, in which its sizes are given."""
ROUNDED, EXACT = 0.03, 0.006
"""How near a value comes to the right one by rounding, and a formula's constant, 9549 or 9550."""
_NAMES = {
    "grade eccentricity": re.compile(
        r"(?:permissible|allowable|admissible|zulässige\w*|許容|ammissibile|admisible)[^.;=]{0,24}?"
        r"(?:e[cx]cc?entri[ck]it\w*|exzentrizität|specific\s+(?:unbalance|imbalance)|偏心"
        r"|(?:spezifische|bezogene)\w*\s+(?:rest)?unwucht)"
        r"|(?:excentricité|eccentricità|excentricidad)\s+(?:résiduelle\s+)?(?:admissible|ammissibile|admisible)",
        re.IGNORECASE,
    ),
    "grade unbalance": re.compile(
        r"(?:permissible|allowable|admissible|zulässige\w*|許容)[^.;=]{0,24}?"
        r"(?:unbalance|imbalance|unwucht|不釣り?合い)"
        r"|(?:balourd|squilibrio|desequilibrio)\s+(?:résiduel\s+|residuo\s+|residual\s+)?"
        r"(?:admissible|ammissibile|admisible)",
        re.IGNORECASE,
    ),
    "force": re.compile(
        r"(?:centrifugal|unbalance|rotating)\s+forces?|(?:flieh|unwucht|zentrifugal)kraft|遠心力|不釣り?合い力"
        r"|force\s+centrifuge|forza\s+centrifuga|fuerza\s+centrífuga",
        re.IGNORECASE,
    ),
    "unbalance": re.compile(
        r"unbalance|imbalance|unwucht|balourd|squilibrio|desequilibrio|不釣り?合い", re.IGNORECASE
    ),
}
"""What words name, the first of them that a sentence has."""
_FORMULAS = {
    "grade eccentricity": (("grade", "speed"),),
    "grade unbalance": (("mass", "grade", "speed"),),
    "force": (("mass", "eccentricity", "speed"), ("unbalance", "speed")),
    "unbalance": (("mass", "eccentricity"),),
}
"""By which sizes each is known."""
_OTHER = re.compile(
    r"\bplanes?\b|\bebenen?\b|\bplans\b|piani|planos|修正面|\bper\b|\bje\b|\bjede|\bcouple|moment|dynami[cs]"
    r"|bearing|lager|initial|urunwucht|two\s+(?:rotor|dis[ck])|zwei",
    re.IGNORECASE,
)
"""Words by which a part, a couple or another state is meant."""
_ROLES = {
    "grade": ("grade",),
    "mass": ("mass", "unbalanced"),
    "eccentricity": ("eccentricity",),
    "unbalance": ("unbalance",),
    "speed": ("omega", "rotation", "turn_rate"),
}
_MINUTE = 2 * pi / 60
_UNITS: dict[str, tuple[tuple[str, float], ...]] = {
    "grade": ((r"mm\s?/\s?s", 1e-3), (r"mm\s?s⁻¹", 1e-3)),
    "mass": ((r"kg(?!\s?[·m])|kilograms?|kilogramm", 1.0), (r"g(?!\s?[·a-z/])"
    r"|grams?\b(?!\s?-?milli)", 1e-3),
             (r"t(?![a-z])", 1e3)),
    "eccentricity": ((r"µm|μm|micrometre?s?|micrometers?|microns?", 1e-6),
                     (r"mm(?!\s?/)|millimet(?:re|er)s?", 1e-3), (r"m(?![a-zµ²/^])|met(?:re"
                     r"|er)s?\b", 1.0)),
    "unbalance": ((r"kg\s?·?\s?mm", 1e-3), (r"kg\s?·?\s?m(?!m)", 1.0), (r"g\s?·?\s?cm", 1e-5),
                  (r"g\s?·?\s?mm|gram[\s-]?millimet(?:re|er)s?|grammmillimeter", 1e-6)),
    "speed": ((r"rad\s?/\s?s|rad\s?s⁻¹|radians?\s+per\s+second", 1.0),
              (r"rpm|rev\s?/\s?min|r\s?/\s?min|min⁻¹|1\s?/\s?min|U\s?/\s?min|tr\s?/\s?min|giri\s?/\s?min"
               r"|rev(?:olution)?s?\s+per\s+minute|Umdrehungen\s+(?:je|pro)\s+Minute", _MINUTE),
              (r"Hz|rev\s?/\s?s|1\s?/\s?s|s⁻¹", 2 * pi)),
    "force": ((r"kN|kilonewtons?", 1e3), (r"N(?![a-z]|\s?m)|newtons?", 1.0)),
}  # fmt: skip
"""Units of sizes, by what each is multiplied."""
_UNITS_OF = {
    "grade eccentricity": "eccentricity", "grade unbalance": "unbalance",
    "unbalance": "unbalance", "force": "force",
}  # fmt: skip
_NUMBER = r"(?<![\w.,^])([0-9]{1,6}(?:[.,][0-9]{1,4})?)(?:\s?[·×]\s?10\^?\{?([-−]?\d)\}?)?"
_GRADE = re.compile(
    r"(?:\bG|(?:grade|gütestufe|等級|classe|clase)\s)\s?([0-9]{1,4}(?:[.,][0-9]{1,2})?)(?![\w])",
    re.IGNORECASE,
)
_ECCENTRIC = re.compile(
    r"exzentri|[eé]?xcentr|eccentr|\boff\b|offset|displaced|neben\s+der|偏心|ずれ|decentr|décal",
    re.IGNORECASE,
)
"""Words by which a short length is that of a centre of mass from the axis."""
_TEX = (
    (re.compile(r"\^\s?\{?\s?[-−]\s?1\s?\}?"), "⁻¹"),
    (re.compile(r"\\(?:mathrm|text|mathit|unit|si)\s?\{([^{}]{0,30})\}"), r"\1"),
    (re.compile(r"\\,|\\ |~|\\;"), " "),
    (re.compile(r"\{,\}"), ","),
    (re.compile(r"\\mu\s?"), "µ"),
    (re.compile(r"\\cdot|\\times|⋅"), "·"),
    (re.compile(r"[${}]"), ""),
)
_SAMPLES = (1.7, 2.9, 0.8, 3.1)


@dataclass
class UnbalancesInUnits:
    """Judges what one document says of unbalances, forces and grades with their units."""

    named: NamedQuantities

    def judge(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the refutation of a value or a formula that its sizes in their units deny."""
        left, right = chain.sides[0].node, chain.sides[1].node
        if k or not isinstance(left, Name) or chain.relations[0].sign not in "=≈":
            return None
        sentence = self.named.words.sentence_before(chain)
        kind = next((each for each, words in _NAMES.items() if words.search(sentence)), "")
        other = _OTHER.search(sentence)
        if not kind or left.name in names(right) or (other is not None and other[0] not in _NAMES):
            return None
        if names(right):
            return self._of_letters(chain, kind, left.name, right, knowledge)
        return None if may_be_part(sentence) else self._of_numbers(chain, kind, left.name, knowledge)

    def _of_numbers(self, chain: Chain, kind: str, name: str, knowledge: Knowledge) -> Decision | None:
        """Return the refutation of numbers put in: e = 6.3/3000 = 2.1 µm at 3000 revolutions a minute."""
        document = self.named.document
        first = number_in_example(chain.sides[1].node, knowledge)
        last = number_in_example(chain.sides[-1].node, knowledge)
        shown = _plain(document.text[chain.sides[-1].span[0] : chain.end + 24])
        value = next(_numbers(shown, _UNITS_OF[kind]), None)
        if first is None or last is None or value is None or not float(first) or not float(last):
            return None
        shift = log10(abs(float(first) / float(last)))
        source = _plain(document.source(chain.sides[1].span))
        is_with_units = re.search(r"[0-9]\s?(?:kg|g|[µm]?m|rad|N|min|s)(?![a-z])", source) is not None
        if abs(shift if is_with_units else shift - round(shift)) > ROUNDED / 2:
            return None  # the arithmetic is wrong: that is another relation's fault
        sizes = self._sizes(chain)
        truths = {
            _product(kind, {size: sizes[size] for size in own})
            for own in _FORMULAS[kind]
            if all(size in sizes for size in own)
        }
        if len(truths) != 1:
            return None
        (truth,) = truths
        if not truth or isclose(value, truth, rel_tol=ROUNDED):
            return None
        unit = _UNITS[_UNITS_OF[kind]]
        scale = min((scale for _, scale in unit), key=lambda s: abs(log10(truth / s) - 1))
        text = f"{truth / scale:.3g}·{scale:g}"
        reason = f"by the numbers of the page {plain_letter(name)} is {text} in SI units"
        return Decision(REFUTED, reason, witness={plain_letter(name): f"{truth:.4g}"})

    def _sizes(self, chain: Chain) -> dict[str, float]:
        """Return the sizes of which the section above gives one number."""
        text = self.named.document.text[max(0, chain.start - REACH) : chain.start]
        text = _plain(text[text.rfind("\n#") + 1 :])
        every: dict[str, set[float]] = {
            "mass": set(_numbers(text, "mass")),
            "speed": set(_numbers(text, "speed")),
            "unbalance": set(_numbers(text, "unbalance")),
            "grade": {_number(match[1]) * 1e-3 for match in _GRADE.finditer(text)},
        }
        lengths = set(_numbers(text, "eccentricity"))
        every["eccentricity"] = lengths if _ECCENTRIC.search(text) else set()
        return {
            size: next(iter(numbers))
            for size, numbers in every.items()
            if numbers and all(isclose(n, next(iter(numbers)), rel_tol=5e-3) for n in numbers)
        }

    def _of_letters(
        self, chain: Chain, kind: str, name: str, claim: Formula, knowledge: Knowledge
    ) -> Decision | None:
        """Return the refutation of a formula between numbers of units: F = 10⁻³ U ω², U in g mm."""
        text = self.named.document.text
        before = _plain(text[max(0, chain.start - 70) : chain.start])
        head = _unit_in(before, _UNITS_OF[kind])
        if head is None:
            return None
        for own in _FORMULAS[kind]:
            letters = self._letters(own, chain, claim, knowledge)
            scales = {
                size: self._scale(letter, size, chain, knowledge) for size, letter in letters.items()
            }
            if len(letters) != len(own) or any(scale is None for scale in scales.values()):
                continue
            ratio = _ratio(kind, claim, letters, {s: v for s, v in scales.items() if v is not None})
            if (
                ratio is None
                or isclose(ratio * head, 1, rel_tol=EXACT)
                or isclose(ratio, 1, rel_tol=EXACT)
            ):
                return None
            units = ", ".join(f"{plain_letter(n)} times {scales[s]:.4g}" for s, n in letters.items())
            reason = (
                f"no formula between these numbers: {plain_letter(name)} times {head:g} and {units}"
                " are in SI units"
            )
            return Decision(REFUTED, reason)
        return None

    def _letters(
        self, sizes: tuple[str, ...], chain: Chain, claim: Formula, knowledge: Knowledge
    ) -> dict[str, str]:
        """Return the letter of each size, by its role or its unit, of a formula that has no others."""
        found: dict[str, str] = {}
        for size in sizes:
            fitting = [
                n
                for n in sorted(names(claim) - {*found.values()})
                if any(self.named.roles.may_be(n, role, knowledge.meanings) for role in _ROLES[size])
                or (size != "grade" and self._scale(n, size, chain, knowledge) is not None)
            ]
            if fitting:
                found[size] = fitting[0]
        return found if {*found.values()} == names(claim) else {}

    def _scale(self, letter: str, size: str, chain: Chain, knowledge: Knowledge) -> float | None:
        """Return what a letter's number is multiplied by: by its declared unit, or words behind it."""
        declared = _plain(knowledge.meanings.get(letter, ""))
        if (unit := re.search(r"\[([^\]]+)\]", declared)) is not None:
            return _unit_in(f" {unit[1]}", size)
        if size == "grade":
            return 1e-3
        text = self.named.document.text[max(0, chain.start - REACH) : chain.end + 200]
        for match in re.finditer(rf"(?<![^\W_])(?<!\\){sign_of(letter)}", text):
            behind = _plain(text[match.end() : match.end() + 60]).lstrip(" )],")
            link = re.match(
                r"(?:(?:is|are|given|measured|steht|ist|gemessen)\s+)*(?:in|en)\s+|\(|\[", behind
            )
            unit = _unit_in(f" {behind[link.end() :]}" if link else f" {behind}", size, at_start=True)
            if unit is not None:
                return unit
        return None


def _product(kind: str, sizes: dict[str, float]) -> float:
    """Return the size of a quantity by the sizes that it has."""
    total = 1.0
    for size, value in sizes.items():
        exponent = 1 if size != "speed" else -1 if kind.startswith("grade") else 2
        total *= value**exponent
    return total


def _ratio(kind: str, claim: Formula, letters: dict[str, str], scales: dict[str, float]) -> float | None:
    """Return a claim over what it should be in SI units; None where that is no number."""
    ratios: list[float] = []
    for shift in range(2):
        numbers = {size: _SAMPLES[(k + shift) % len(_SAMPLES)] for k, size in enumerate(sorted(letters))}
        point = {letters[size]: Fraction(number) for size, number in numbers.items()}
        truth = _product(kind, {size: number * scales[size] for size, number in numbers.items()})
        ratios.append(value_at(claim, point) / truth)
    return ratios[0] if ratios[0] > 0 else None


def _plain(text: str) -> str:
    for pattern, put in _TEX:
        text = pattern.sub(put, text)
    return text


def _number(text: str) -> float:
    return float(text.replace(",", "."))


def _numbers(text: str, size: str) -> Iterator[float]:
    """Yield the numbers of a text that have a unit of some size, times that unit."""
    for unit, scale in _UNITS[size]:
        for match in re.finditer(rf"{_NUMBER}\s{{0,2}}(?:{unit})(?![A-Za-z])", text):
            power = int((match[2] or "0").replace("−", "-"))
            yield _number(match[1]) * 10**power * scale


def _unit_in(text: str, size: str, *, at_start: bool = False) -> float | None:
    """Return the unit of some size that words say, "in newtons"; None where they say none."""
    opening = r"\A\s?" if at_start else r"(?:\b(?:in|en)\s|^\s|\[|\()"
    found = {
        scale
        for unit, scale in _UNITS[size]
        if re.search(rf"{opening}(?:{unit})(?![A-Za-z·])", text) is not None
    }
    return next(iter(found)) if len(found) == 1 else None
