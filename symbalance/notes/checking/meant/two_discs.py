"""Two discs on a shaft swing against each other: θ₁/θ₂ = -J₂/J₁, and the node lies at l₁ J₁ = l₂ J₂.

Such an equation is of four letters, in any form,
and gives none of them a value. It is judged by what it makes
of the ratio of the two amplitudes, or of the two parts of the shaft,
where words say that these are meant.
"""

from __future__ import annotations

from fractions import Fraction
from math import isclose

from symbalance.document.formula import Formula, Negative, Sum, names
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.meant.letter_roles import index_of, stem_of
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_INERTIAS = frozenset({"J", "I", "Theta"})
_AMPLITUDES = frozenset({"theta", "Theta", "vartheta", "A", "a", "alpha", "phi", "varphi", "X", "beta"})
_LENGTHS = frozenset({"l", "L", "ell", "a", "x", "s", "b", "d"})
_OF_AMPLITUDES = re.compile(r"amplitude|ausschl[aä]g|振幅|mode|swing|schwing", re.IGNORECASE)
_OF_NODE = re.compile(r"\bnod(?:e|al)|knoten|節", re.IGNORECASE)
_OF_SHAFT = re.compile(
    r"torsion|twist|drehschwing|ねじり|扭|rotors?\b|dis[ck]s?\b|scheibe|円板|shaft|zweimassen|two-mass",
    re.IGNORECASE,
)
_OF_MORE = re.compile(
    r"\bthree|\bdrei|\b[3-9][- ](?:mass|dis[ck]|rotor)|三|[3３]つ|gear|getriebe|歯車|holzer|two[- ]node"
    r"|in phase"
    r"|wrong|falsch|\bnot\b",
    re.IGNORECASE,
)
_OF_SIGNED = re.compile(
    r"mode[- ]?(?:shape|vector)|eigen(?:vector|vektor|form|mode)|固有モード|with\s+(?:their|its|the"
    r"|due)\s+signs?"
    r"|\bsigned|vorzeichen|con\s+su\s+signo|avec\s+(?:leurs?|son)\s+signes?|col\s+(?:loro|suo)\s+segno|符号(?:を含|つき|付き|も)"
    r"|com\s+(?:seu\s+)?sinal|opposite",
    re.IGNORECASE,
)
"""Words for amplitudes that have a sign."""
NEXT = 60
"""Characters before an equation in which words say that its amplitudes have signs."""
NEAR = 700
"""Characters before an equation in which the words stand."""
FIRST, SECOND = Fraction(2), Fraction(3)


def decide_two_discs(chain: Chain, k: int, document: ReadNotes) -> Decision | None:
    """Return the decision on the amplitudes or the node of two discs; None for other equations."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    letters = _letters_of(left, right)
    if k or len(chain.relations) != 1 or chain.relations[0].sign != "=" or letters is None:
        return None
    (one, other), inertias = letters
    start = chain.start
    words = glossary_of(document.text).english(document.text[max(0, start - NEAR) : start])
    stem = stem_of(one)
    of_node = _OF_NODE.search(words) if stem in _LENGTHS else None
    of_modes = _OF_AMPLITUDES.search(words) if stem in _AMPLITUDES and of_node is None else None
    meant = of_node or of_modes
    if meant is None or not _OF_SHAFT.search(words) or _OF_MORE.search(words):
        return None
    ratio = _ratio(Sum((left, Negative(right))), (one, other), inertias)
    if ratio is None:
        return None
    kind = "parts of the shaft beside the node" if of_node else "amplitudes"
    pair = f"{plain_letter(one)} and {plain_letter(other)}"
    source = f"{NOBODY}; taken from the words “{meant[0]}”"
    what = f"{pair} are the {kind} of two discs ({source})"
    wanted = SECOND / FIRST if of_node else -SECOND / FIRST
    if isclose(ratio, wanted):
        return Decision(PROVED, assumptions=(what,))
    reason = ""
    if isclose(abs(ratio), FIRST / SECOND):
        reason = "of which the smaller belongs to the larger inertia"
    elif isclose(ratio * ratio, SECOND / FIRST) or isclose(ratio * ratio, FIRST / SECOND):
        reason = "of which the smaller belongs to the larger inertia, with no root"
    elif of_modes and isclose(ratio, -wanted) and _OF_SIGNED.search(words[-NEXT:]):
        reason = "which have opposite signs in the shape of a mode"
    return Decision(REFUTED, f"if {what}, {reason}") if reason else None


def _letters_of(left: Formula, right: Formula) -> tuple[tuple[str, str], tuple[str, str]] | None:
    """Return the two amplitudes or lengths and the two inertias of an equation, by subscript."""
    by_stem: dict[str, list[str]] = {}
    for name in sorted(names(left) | names(right)):
        by_stem.setdefault(stem_of(name), []).append(name)
    usual = _INERTIAS - {"Theta"} if by_stem.keys() & {"J", "I"} else _INERTIAS
    inertias = [pair for stem, pair in by_stem.items() if stem in usual]
    others = [pair for stem, pair in by_stem.items() if stem not in usual]
    if len(inertias) != 1 or len(others) != 1 or len(inertias[0]) != 2 or len(others[0]) != 2:
        return None
    indices = [[index_of(name) for name in pair] for pair in (*others, *inertias)]
    if indices[0] != indices[1] or not all(indices[0]):
        return None
    (one, other), (first, second) = others[0], inertias[0]
    return (one, other), (first, second)


def _ratio(gap: Formula, pair: tuple[str, str], inertias: tuple[str, str]) -> float | None:
    """Return the ratio of two letters that makes a gap vanish, where it is one."""
    values = {inertias[0]: FIRST, inertias[1]: SECOND, pair[1]: Fraction(1)}
    try:
        at = [TreeValues(SymbolValue(), {**values, pair[0]: Fraction(x)}).value(gap) for x in (1, 2, 4)]
    except NO_VALUE:
        return None
    low, middle, high = (float(each.real) for each in at)
    if isclose(high - middle, 2 * (middle - low), rel_tol=1e-9) and middle != low:
        return 1 - low / (middle - low)
    return _by_inverse(low, middle, high)


def _by_inverse(low: float, middle: float, high: float) -> float | None:
    """Return the root of a + b/x by its values at 1, 2 and 4; None where it is of another form."""
    slope = 2 * (low - middle)
    if not slope or not isclose(4 * (middle - high), slope, rel_tol=1e-9):
        return None
    rest = low - slope
    return -slope / rest if rest else None
