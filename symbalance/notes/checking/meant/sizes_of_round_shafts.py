"""Ratios of two round shafts: at the same torque τ_1/τ_2 = (d_2/d_1)³, and I_1/I_2 = (d_1/d_2)⁴.

What words name goes with one power of the diameter, whatever the numbers before it. A ratio of two
diameters, or of two radii, with the same subscripts is judged by that power.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, Name, Quotient
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.meant.letter_roles import index_of, stem_of
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.meant.products import NoProductError, product_of
from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_DIAMETERS = frozenset("dDrR")
_SAME_LOAD = (
    r"(?:same|equal)\s+(?:\w+\s+)?(?:torque|(?:bending|twisting|torsional)\s+moment|moment)"
    r"|gleiche[mnrs]?\s+(?:dreh|biege|torsions)?moment|同じ(?:トルク|(?:曲げ|ねじり)モーメント)|等しい(?:トルク|曲げモーメント)"
)
_TURNED = r"torsion\w*|shear\w*|twist\w*|schub\w*|ねじり|せん断"
_KINDS: tuple[tuple[str, int, frozenset[str], re.Pattern[str], re.Pattern[str] | None], ...] = (
    (
        "stresses at the same moment", -3, frozenset({"tau", "sigma", "S", "f"}),
        re.compile(rf"(?:{_TURNED}|bending|biege\w*|曲げ)\s?\w*(?:stress|spannung|応力)|(?:stress|spannung|応力)",
                   re.IGNORECASE),
        re.compile(_SAME_LOAD, re.IGNORECASE),
    ),
    (
        "polar or axial second moments of area", 4, frozenset({"I", "J"}),
        re.compile(r"second\s+moments?|moments?\s+of\s+area|flächen(?:trägheits)?momente?"
        r"|断面二次", re.IGNORECASE),
        None,
    ),
    (
        "section moduli", 3, frozenset({"W", "Z", "S"}),
        re.compile(r"section\s+modul|widerstandsmoment|断面係数", re.IGNORECASE), None,
    ),
    (
        "torsional stiffnesses", 4, frozenset({"c", "k", "C", "K"}),
        re.compile(r"torsional\s+(?:stiffness|rigidit)\w*|(?:torsions|dreh(?:feder)?)steifigkeit\w*|ねじり剛性",
                   re.IGNORECASE),
        re.compile(r"(?:same|equal)\s+length|gleiche[rn]?\s+länge|同じ長さ", re.IGNORECASE),
    ),
)  # fmt: skip
"""What words name, its power of the diameter, its letters, the words, and others that have to stand."""
_NOT_ROUND = re.compile(
    r"hollow|tube|rectang|square|hohl|rohr|rechteck|quadrat|中空|key|feder\b|weld|rivet|bearing\s+pressure|tension"
    r"|tensile|zug|引張|power|leistung|\bforce|kraft|thin|dünn|rings?\b|rim\b|per\s+unit|disc|scheibe|円板|spring",
    re.IGNORECASE,
)
_REACH = 260


def decide_round_ratio(chain: Chain, k: int, document: ReadNotes) -> Decision | None:
    """Return the decision on the ratio of two round shafts; None for other relations."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    pair = _pair(left)
    if k or pair is None or chain.relations[0].sign != "=":
        return None
    power = _power(right, pair)
    words = glossary_of(document.text).english(document.text[max(0, chain.start - _REACH) : chain.start])
    if power is None or _NOT_ROUND.search(words):
        return None
    stem = stem_of(pair[0])
    found = [
        each
        for each in _KINDS
        if stem in each[2] and each[3].search(words) and (each[4] is None or each[4].search(words))
    ]
    if len(found) != 1:
        return None
    kind, wanted, _, pattern, _ = found[0]
    match = pattern.search(words)
    said = f"{NOBODY}; taken from the words “{match[0] if match else ''}”"
    one, other = map(plain_letter, pair)
    text = f"{one} and {other} are {kind} of two solid round shafts ({said})"
    if power == wanted:
        return Decision(PROVED, assumptions=(text,))
    return Decision(REFUTED, f"if {text}, which go with the power {wanted} of the diameter")


def _pair(node: Formula) -> tuple[str, str] | None:
    """Return the two letters of a quotient that differ in their subscripts alone."""
    match node:
        case Quotient(numerator=Name(name=one), denominator=Name(name=other)):
            is_pair = stem_of(one) == stem_of(other) and index_of(one) != index_of(other)
            return (one, other) if is_pair and index_of(one) and index_of(other) else None
    return None


def _power(node: Formula, pair: tuple[str, str]) -> Fraction | None:
    """Return n of (d_1/d_2)^n with the subscripts of τ_1/τ_2; None for another formula."""
    try:
        product = product_of(node)
    except NoProductError:
        return None
    powers = product.powers
    if product.number != 1 or product.wave is not None or len(powers) != 2:
        return None
    by_index = {index_of(n): p for n, p in powers.items()}
    stems = {stem_of(n) for n in powers}
    one, other = map(index_of, pair)
    if len(stems) != 1 or not stems <= _DIAMETERS or set(by_index) != {one, other}:
        return None
    return by_index[one] if by_index[one] == -by_index[other] else None
