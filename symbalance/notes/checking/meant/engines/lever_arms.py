"""Lever arms of an engine's cylinders in line, one letter with a number each: z_1 = 3t/2, z_2 = t/2.

With equal distances the arms about the middle of n cylinders are (n + 1)/2 - i distances, about the first
cylinder i - 1. Where words speak of lever arms, one that does not go with the others is refuted.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from symbalance.document.formula import Formula, Name, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.meant.engines.engine_claims import EngineClaims
from symbalance.notes.checking.meant.products import NoProductError, product_of
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_ARMS = re.compile(
    r"lever(?:\s+arm)?s?(?![a-z])|(?:axial\s+)?positions?\s+(?:along|on)\s+the\s+crank"
    r"|distances?\s+from\s+the\s+(?:middle|cent)"
    r"|hebelarme?n?|abstände\s+(?:von|zu)\s+der\s+(?:motor)?mitte|(?<![a-z])arms(?![a-z])|腕の長さ|てこ"
    r"|bras\s+de\s+levier",
    re.IGNORECASE,
)
_UNEVEN = re.compile(
    r"unequal|uneven|offset|ungleich|not\s+equally|b[oó]xer|flat[\s-]|opposed|不等", re.IGNORECASE
)
_MIDDLE = re.compile(r"middle|cent(?:re|er)|mitte|中央|中心|milieu|centro", re.IGNORECASE)
_FIRST = re.compile(
    r"first|cylinder\s+1|ersten?|第[1一]|premier|primer|primo|reference\s+plane\s+at", re.IGNORECASE
)
_FEWEST, _MOST = 3, 12


def refute_lever_arm(claims: EngineClaims, chain: Chain, k: int) -> Decision | None:
    """Return the refutation of one arm that does not go with the others of its paragraph; else None."""
    own = _arm(chain)
    if k or own is None:
        return None
    stem, index, pitch, number = own
    section = claims.section(chain)
    if not _ARMS.search(section) or _UNEVEN.search(section):
        return None
    first = claims.sections.paragraph_start(chain.lines[0])
    arms: dict[int, Fraction] = {}
    for other in claims.words.document.chains:
        each = _arm(other) if claims.sections.paragraph_start(other.lines[0]) == first else None
        if each is None or each[0] != stem or each[2] not in (pitch, ""):
            continue
        if each[1] in arms:
            return None
        arms[each[1]] = each[3]
    engine = claims.engine_of(chain)
    count = engine.cylinders if engine is not None and engine.cylinders >= max(arms) else 0
    is_middle, is_first = _MIDDLE.search(section) is not None, _FIRST.search(section) is not None
    laws = _laws(count, max(arms), with_middle=is_middle or not is_first, with_first=not is_middle)
    least = 1 if count and is_middle and not is_first else 2
    fitting = [law for law in laws if _fits(arms, law, index, least)]
    values = {law(index) for law in fitting}
    if len(values) != 1 or number in values:
        return None
    value = values.pop()
    text = f"the cylinders are at equal distances {plain_letter(pitch)}"
    return Decision(
        REFUTED, f"if {text}: as the other lever arms are, it is {value} {plain_letter(pitch)}"
    )


Law = Callable[[int], Fraction]


def _fits(arms: dict[int, Fraction], law: Law, index: int, least: int) -> bool:
    """Tell whether all other arms obey a law, as many as it takes."""
    others = [law(i) == number for i, number in arms.items() if i != index]
    return all(others) and len(others) >= least


def _laws(count: int, last: int, *, with_middle: bool, with_first: bool) -> list[Law]:
    """Return the arms about the middle, in both directions, and about the first cylinder."""
    counts = [count] if count else range(max(_FEWEST, last), last + 1)
    laws: list[Law] = []
    for n in counts if with_middle else ():
        laws += [lambda i, n=n: Fraction(n + 1, 2) - i, lambda i, n=n: i - Fraction(n + 1, 2)]
    return [*laws, lambda i: Fraction(i - 1)] if with_first else laws


def _arm(chain: Chain) -> tuple[str, int, str, Fraction] | None:
    """Return the stem and the index of an arm, its distance's letter, and how many of these it is."""
    head = chain.sides[0].node
    if len(chain.sides) < 2 or not isinstance(head, Name) or chain.relations[0].sign != "=":
        return None
    stem, _, index = head.name.partition("_")
    value: Formula = chain.sides[1].node
    if not index.isdecimal() or not 1 <= int(index) <= _MOST or len(names(value)) > 1:
        return None
    try:
        product = product_of(value)
    except NoProductError:
        return None
    number = Fraction(product.number).limit_denominator(4)
    is_multiple = abs(float(number) - product.number) < 1e-9 and product.wave is None
    if not is_multiple or any(p != 1 for p in product.powers.values()) or stem in product.powers:
        return None
    if not product.powers and number:
        return None
    return stem, int(index), next(iter(product.powers), ""), number
