"""An order of a product that a sentence has as two formulas: "multiply the force $F$ by $r \\sin θ$".

The second-order part of the torque is then the term with 2θ of their product, with its sign, whichever
direction a torque may count in elsewhere.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from symbalance.document.formula import Call, Formula, Name, Product, names, parts_of_kind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.values_at_points import value_at
from symbalance.notes.checking.meant.engines.order_indices import wave_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import DEFINITION, PROVED_WORDS, UNDECIDED, Verdict
from symbalance.notes.checking.words.formulas_typed import formula_typed
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_FORMULA = r"\$(?P<{}>[^$=<>≈]{{5,120}})\$"
_NAMED = r"(?:[^\W\d_][\w'’-]*\s+){0,6}?"
_MULTIPLIED = re.compile(
    rf"(?<![^\W\d_])(?:multiply|multiplying|multiplizier\w*|multiplie[rnz]*|multipliant|moltiplic\w+|multiplica\w*)\s+{_NAMED}"
    rf"{_FORMULA.format('first')}\s+(?:by|with|times|mit|par|per|por)\s+{_NAMED}{_FORMULA.format('second')}"
    rf"|{_FORMULA.format('one')}\s*(?:に|と)\s*[^$。]{{0,12}}{_FORMULA.format('other')}\s*を(?:掛け|乗じ)",
    re.IGNORECASE,
)
"""Two formulas that are multiplied with each other."""
_ORDINALS = (
    r"first|1st|1\.|erste\w*|premier|primo|primer|[一1]次",
    r"second|2nd|2\.|zweite\w*|deuxième|secondo?|segundo|[二2]次",
    r"third|3rd|3\.|dritte\w*|troisième|terzo|tercer|[三3]次",
    r"fourth|4th|4\.|vierte\w*|quatrième|quarto|cuarto|[四4]次",
)
_PART = re.compile(
    r"(?<![A-Za-z0-9])(?:"
    + "|".join(f"(?P<n{k}>{words})" for k, words in enumerate(_ORDINALS, 1))
    + r")(?:[\s-]*(?:orders?|ordnung|ordre|ordine|orden|harmoni(?:c|sche|que)|armonica|成分|の))",
    re.IGNORECASE,
)
"""Words for the part of one order."""
_SIZE = re.compile(
    r"(?<![^\W\d_])(?:amplitude|magnitude|size|amount|betrag|größe|norme|module|modulo|módulo|mean|mittel\w*|moyenne)(?![^\W\d_])"
    r"|振幅|大きさ",
    re.IGNORECASE,
)
_OF_MORE = re.compile(
    r"cylind|zylinder|cilind|気筒|シリンダ|(?<![^\W\d_])(?:engine|motor\w*|moteur|motore|all|alle[rn]?|tous|tutti|each|je)(?![^\W\d_])",
    re.IGNORECASE,
)
"""Words for other forces than the two of the product."""
_REACH = 700
_SAMPLES = 24
"""Points of a turn: more than twice the highest order of a product of two forces."""
_CLOSE, _ROUGH = 1e-7, 0.3
"""How far an order may be from that of the product, with = and with ≈."""
_POINTS = (0.37, 0.61, 1.3, 1.7, 0.83, 2.1)


def unless_other_part_of_product(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted for an order that a product in the prose does not have."""
    value = without_dots(chain.sides[1].node)[0]
    is_open = verdict.verdict in PROVED_WORDS or verdict.verdict in (DEFINITION, UNDECIDED)
    if (
        k
        or not is_open
        or not isinstance(chain.sides[0].node, Name)
        or chain.relations[0].sign not in "=≈"
    ):
        return verdict
    waves = [c for c in parts_of_kind(value, Call) if c.function in ("cos", "sin")]
    sentence = state.sections.sentence_leading_to(chain) if len(waves) == 1 else ""
    orders = {int((m.lastgroup or "n0")[1:]) for m in _PART.finditer(sentence)}
    is_other = any(words.search(sentence) for words in (_SIZE, _OF_MORE))
    if len(orders) != 1 or {wave_of(waves[0])[0]} != orders or is_other:
        return verdict
    product = _product(state, chain)
    angle = wave_of(waves[0])[1]
    if product is None or angle not in names(product) or not names(value) <= names(product):
        return verdict
    rounding = _ROUGH if chain.relations[0].sign == "≈" else _CLOSE
    outcomes = [*_are_equal(product, value, waves[0], angle, rounding)]
    if len(outcomes) < 2 or any(outcomes):
        return verdict
    reason = "not the part of that order of the product in words above"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _product(state: JudgingState, chain: Chain) -> Formula | None:
    """Return the one product of two formulas that the paragraph has before a relation."""
    sections = state.sections
    first = sections.start_of_line(sections.paragraph_start(chain.lines[0]))
    text = state.document.text[max(first, chain.start - _REACH) : chain.start]
    found = [*_MULTIPLIED.finditer(text)]
    if len(found) != 1:
        return None
    typed = (found[0]["first"] or found[0]["one"], found[0]["second"] or found[0]["other"])
    letters = chain.letters | {"r", "l", "lambda", "m", "omega"}
    nodes = [formula_typed(each, letters) for each in typed]
    return None if nodes[0] is None or nodes[1] is None else Product((nodes[0], nodes[1]))


def _are_equal(
    product: Formula, value: Formula, wave: Call, angle: str, rounding: float
) -> Iterator[bool]:
    """Yield at two points whether a formula is the part of a product that goes with its wave."""
    letters = sorted((names(product) | names(value)) - {angle})
    for turn in (0, 1):
        values = {name: _POINTS[(k + turn) % len(_POINTS)] for k, name in enumerate(letters)}
        if len(letters) > len(_POINTS):
            return
        sizes = [0.0, 0.0]
        for k in range(_SAMPLES):
            at = {**values, angle: 2 * math.pi * k / _SAMPLES}
            whole, own, shape = (value_at(node, at) for node in (product, value, wave))
            if whole is None or own is None or shape is None:
                return
            sizes[0] += whole * shape
            sizes[1] += own * shape
        yield math.isclose(sizes[0], sizes[1], rel_tol=rounding, abs_tol=_CLOSE)
