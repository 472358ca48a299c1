"""Whether a formula of a named quantity is another one than the standard one, in the same letters.

Where words name a quantity and each letter of a formula fits a role of its standard formula, a formula
that agrees with none is wrong, also if no single slip lies between: ζ = 2 √(k m)/c is upside down,
ω = √(k/(J₁ + J₂)) has lost the product. What may be the quantity roughly, or with the other sign, is not.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import isfinite

from symbalance.document.formula import Formula, Name, Negative, Sum, names, walk
from symbalance.notes.checking.meant.catalogue import Quantity
from symbalance.notes.checking.meant.formula_slips import POINTS, agrees, differs, is_multiple, value_at
from symbalance.text import lazy_patterns as re

INVERTED, OTHER = "fraction inverted", "another formula"
_EITHER_WAY = re.compile(
    r"(?<!compression )(?<!damping )ratio(?! at)|slenderness|stiffness|complian|share|(?<!quality )factor"
)
"""Names of quantities that some have one way up and some the other."""
_JOINED = re.compile(
    r"rigidly|fixed\s+(?:to|on)\b|bolted|together|starr\s|fest\s+(?:miteinander\s+)?verbunden|gemeinsam|剛に|一体"
    r"|rigid[ae]ment[e]?|solidaire|solidal",
    re.IGNORECASE,
)
"""Words of bodies that move as one: their inertias are added."""
_CONVENTIONS = frozenset({"ratio", "slenderness", "slender", "share"})
"""Roles of letters that some have upside down: λ is r/l or l/r."""
_SCALES = (Fraction(1, 1000), Fraction(1, 30), Fraction(30), Fraction(1000))
"""Sizes of the letters at which a rough formula comes near to the exact one."""
_NEAR = 0.02


def kind_of_other(
    target: Formula,
    targets: Sequence[Formula],
    claim: Formula,
    quantity: Quantity,
    around: str,
    *,
    is_part: bool,
) -> str:
    """Return how a formula differs from the standard one of a quantity; "" where it may be meant.

    `targets` are all its standard forms in these letters. A formula that is upside down is wrong of a
    part of the quantity too; one with another factor is not judged here.
    """
    if names(target) != names(claim) or is_multiple(target, claim) or agrees(Negative(target), claim):
        return ""
    is_upside_down = not _EITHER_WAY.search(quantity.name) and is_multiple(1 / target, claim)
    if is_upside_down and not any(is_multiple(each, claim) for each in targets):
        return INVERTED
    is_of_any_shape = quantity.only is None and quantity.name.startswith("moment of inertia")
    if is_of_any_shape or (_has_sum_of_letters(claim) and _JOINED.search(around)):
        return ""
    if any(_CONVENTIONS & names(node) for node in quantity.formulas):
        return ""
    if is_part or _is_sum_of_letters(claim) or not differs(target, claim):
        return ""
    is_rough = any(
        is_multiple(each, claim) or _is_near_somewhere(each, claim)
        for each in targets
        if names(each) == names(claim)
    )
    return "" if is_rough else OTHER


def _is_sum_of_letters(node: Formula) -> bool:
    """Tell whether a formula is m_p + m_B, whose letters may be shares already."""
    return isinstance(node, Sum) and all(isinstance(term, Name) for term in node.terms)


def _has_sum_of_letters(node: Formula) -> bool:
    """Tell whether a formula has a sum of letters alone in it, J_1 + J_2."""
    return any(_is_sum_of_letters(part) for part in walk(node))


def _is_near_somewhere(target: Formula, claim: Formula) -> bool:
    """Tell whether a formula comes near to another one where its letters are all small or all large."""
    letters = sorted(names(target))
    for scale in _SCALES:
        gaps = []
        for row in POINTS:
            point = {n: row[k] * scale / 10 for k, n in enumerate(letters)}
            exact, rough = value_at(target, point), value_at(claim, point)
            if exact and abs(exact - 1) < _NEAR:  # of two numbers near 1 what they lack of it is compared
                exact, rough = exact - 1, rough - 1
            gaps.append(abs(rough / exact - 1) if exact else float("nan"))
        finite = [gap for gap in gaps if isfinite(gap)]
        if finite and all(gap < _NEAR for gap in finite):
            return True
    return False
