"""Letters with two meanings, by words and units: the torque T = 200 N m, the temperature T = 300 K.

The second value is no slip in the unit where the noun before it names another quantity, whose unit it
has. Behind it each formula is of the meaning that it is true of.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.dimensions import Dimension, Dimensions, unit_of
from symbalance.notes.checking.units.unit_by_noun import unit_asked_for
from symbalance.notes.checking.verdicts import CONTRADICTION, DEFINITION, REFUTED, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_NOUNS = tuple(
    (unit_of(unit), re.compile(rf"(?:{words})", re.IGNORECASE))
    for unit, words in (
        ("K", r"temperatur[ea]?|température|温度"),
        ("m^3", r"volumen?|hubraum|cilindrata|cilindrada|体積|容積"),
        ("N m", r"torque|moment|drehmoment|couple|coppia|momento|par\s+motor|トルク|モーメント"),
        ("N", r"force|kraft|forza|fuerza|力"),
        ("kg", r"mass|masse|massa|masa|質量"),
        ("s", r"time|period|zeit|dauer|temps|période|periodo|tempo|tiempo|周期|時間"),
        ("Pa", r"pressure|stress|druck|spannung|pression|contrainte|pressione|presión|圧力|応力"),
        ("W", r"power|leistung|puissance|potenza|potencia|出力|動力"),
        (
            "J",
            r"energy|work|energie|arbeit|énergie|travail|energia|lavoro|energía|trabajo|エネルギー|仕事",
        ),
        (
            "m",
            r"length|distance|stroke|länge|weg|hub|longueur|course|lunghezza|corsa|longitud|carrera|長さ",
        ),
        ("m/s", r"speed|velocity|geschwindigkeit|vitesse|velocità|velocidad|速度"),
        ("m/s^2", r"acceleration|beschleunigung|accélération|accelerazione|aceleración|加速度"),
        ("m^2", r"area|fläche|surface|aire|superficie|área|面積"),
        ("A", r"current|strom|stromstärke|courant|corrente|corriente|電流"),
    )
)
"""Nouns before a letter, each with the unit of what it names."""
_CLAUSE = re.compile(r"[.,;:!?。、；=]|(?<![^\W\d_])(?:and|und|et|e|y)(?![^\W\d_])")
_PRONOUN = re.compile(
    r"(?<![^\W\d_])(?:it|this|that|they|es|das|dies|sie|il|elle|ce|cela|esso|essa|ciò|ello|eso)(?![^\W\d_])",
    re.IGNORECASE,
)
"""Words for something that was named before."""
_REACH = 60


def unless_of_another_meaning(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a value that noun and unit make another quantity's is its letter anew.

    A relation that is wrong, or open, with one meaning of a letter holds where it does with the other.
    """
    if verdict.verdict not in (REFUTED, CONTRADICTION, UNDECIDED):
        return verdict
    if not k and verdict.verdict != UNDECIDED and _is_another_quantity(state, chain):
        return _defined_anew(state, chain)
    twice = sorted(chain.letters & state.other_meanings.keys())
    (left, right), sign = chain.sides[k : k + 2], chain.relations[k].sign
    for name, other in ((n, other) for n in twice for other in state.other_meanings[n]):
        knowledge = state.knowledge(chain.lines[0]).with_definition(name, other)
        there = decide(left, right, sign, knowledge)
        if there.is_proved:
            return describe(state.document, chain, k, there)
    return verdict


def _is_another_quantity(state: JudgingState, chain: Chain) -> bool:
    """Tell whether a noun asks for the unit of a value, and the letter's value above has another unit."""
    head, value, line = chain.sides[0].node, chain.sides[1], chain.lines[0]
    if not isinstance(head, Name) or names(value.node) or len(chain.relations) != 1:
        return False
    if head.name in state.declarations.symbols_at(line):
        return False
    own = Dimensions({}, {}, state.document.text).of_numbers(value.node)
    sentence = state.sections.sentence_leading_to(chain)
    asked = unit_asked_for(chain, sentence, state.document.source(value.span))
    named = _named(sentence) if asked is None else asked[1]
    if own is None or named != own:
        return False
    units = Dimensions({}, {}, state.document.text)
    others = [units.of_numbers(c.sides[-1].node) for c in _values_above(state, chain, head)]
    return any(other not in (None, own) for other in others)


def _named(sentence: str) -> Dimension | None:
    """Return the dimension of what the one noun of the clause before a letter names, None for several."""
    clause = _CLAUSE.split(sentence)[-1][-_REACH:]
    if _PRONOUN.search(clause):
        return None
    found = {unit for unit, pattern in _NOUNS if pattern.search(clause)}
    return next(iter(found)) if len(found) == 1 else None


def _values_above(state: JudgingState, chain: Chain, head: Name) -> list[Chain]:
    """Return the last relation above that begins with a letter, if it gives it a number."""
    above = state.sections.chains_above(head, chain.start)
    return [c for c in above[-1:] if not names(c.sides[-1].node)]


def _defined_anew(state: JudgingState, chain: Chain) -> Verdict:
    head = chain.sides[0].node
    assert isinstance(head, Name)
    above = _values_above(state, chain, head)[0]
    earlier = Definition(above.sides[-1].node, above.lines[0], numeric=True)
    state.other_meanings.setdefault(head.name, []).append(earlier)
    state.definitions.forget_all(head.name)
    state.definitions.define(head.name, chain.sides[1].node, chain)
    reason = f"another {plain_letter(head.name)} than that of line {above.lines[0]}"
    return describe(state.document, chain, 0, Decision(DEFINITION, reason))
