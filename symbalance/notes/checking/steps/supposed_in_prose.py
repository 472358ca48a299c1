r"""Numbers that a sentence supposes in its words, against what is so: we have x = 4; if x were 3, x² = 9.

No relation says that x is 3 there. What the sentence concludes is judged by that number, and not by the
one that the lines above give.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Number
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY, compare
from symbalance.notes.checking.deciding.knowledge import Definition
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import DEFINITION, PROVED_WORDS, UNREADABLE, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.letters.letter_names import canonical_name
from symbalance.text import lazy_patterns as re

_LETTER = r"\$?\\?(?P<{0}>[^\W\d_]+(?:_\{{?\w{{1,8}}\}}?)?)\$?"
_NUMBER = r"\$?(?P<{0}>[-−–]?\s?[0-9]+(?:\.[0-9]+)?)\$?(?![0-9.]*[0-9])"
_EQUAL = r"(?:(?:equal\s+to|only|just|gleich|nur|égale?\s+à|uguale\s+a|igual\s+a)\s+)?"


def _pattern(number: int, before: str, between: str, behind: str = "") -> str:
    """Return a pattern for a letter and the number it is supposed to be."""
    letter, value = _LETTER.format(f"letter_{number}"), _NUMBER.format(f"value_{number}")
    return rf"{before}{letter}\s*{between}{_EQUAL}{value}{behind}"


_WORDS = (
    (r"if\s+", r"(?:were|was|had\s+been|equal(?:l)?ed)\s+", ""),
    (r"(?:were|had)\s+", r"(?:been\s+)?(?:to\s+be\s+)?", ""),
    (r"(?:wäre|würde)\s+", "", r"(?:\s+sein)?"),
    (r"(?:wenn|falls)\s+", "", r"\s+(?:wäre|gewesen\s+wäre|betrüge)"),
    (r"si\s+", r"(?:était|valait|fuera|fuese)\s+", ""),
    (r"se\s+", r"(?:fosse|valesse)\s+", ""),
)
_SUPPOSED = re.compile(
    rf"(?<![^\W\d_])(?:{'|'.join(_pattern(n, *words) for n, words in enumerate(_WORDS))})(?![^\W\d_])"
    rf"|(?:もし|仮に)\s*{_pattern(len(_WORDS), '', 'が')}\s*(?:なら|だった|であれば|とすれば)",
    re.IGNORECASE,
)
"""Words by which a letter is a number that it is not: if x were 3."""
_TURNS = re.compile(
    r"(?<![^\W\d_])(?:but|however|aber|jedoch|mais|cependant|ma|però|pero)(?![^\W\d_])|しかし",
    re.IGNORECASE,
)
"""Words that turn back to what is so."""
_SENTENCE = re.compile(r"[.;!?]\s|[。；]|\n\s*\n")
_REACH = 240


def unless_supposed_otherwise(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; what follows from a number that is only supposed is judged by that number."""
    if verdict.verdict in (UNREADABLE, DEFINITION) or not chain.relations:
        return verdict
    supposed = _supposed_before(state, chain)
    if supposed is None:
        return verdict
    name, value = supposed
    (left, right), sign = chain.sides[k : k + 2], chain.relations[k].sign
    knowledge = state.knowledge(chain.lines[0])
    values = {n: d.node for n, d in knowledge.definitions.items() if n != name}
    behind = {n for side in (left, right) for n in names_behind(side.node, values)}
    if name not in behind or left.node == Name(name):
        return verdict
    shown = f"{plain_letter(name)} = {plain_text(value)}"
    there = knowledge.with_definition(name, Definition(value, chain.lines[0], assumption=shown))
    if sign in SATISFIED_BY:
        decision = compare(left.node, right.node, sign, there)
    else:
        decision = decide(left, right, sign, there)
    if decision is not None and (decision.is_proved or decision.status == REFUTED):
        return describe(state.document, chain, k, decision)
    if verdict.verdict in PROVED_WORDS:
        return describe(state.document, chain, k, Decision(UNDECIDED, f"{shown} is supposed here"))
    return verdict


def _supposed_before(state: JudgingState, chain: Chain) -> tuple[str, Formula] | None:
    """Return the letter that the sentence before a relation supposes to be a number, with that."""
    words = state.document.text[max(0, chain.start - _REACH) : chain.start]
    sentence = _SENTENCE.split(words)[-1]
    match = next(iter([*_SUPPOSED.finditer(sentence)][-1:]), None)
    if match is None or _TURNS.search(sentence, match.end()):
        return None
    groups = {key.partition("_")[0]: text for key, text in match.groupdict().items() if text}
    typed = groups["value"].replace("−", "-").replace("–", "-").replace(" ", "")
    number = Number(Fraction(typed.lstrip("-")))
    letter = canonical_name(groups["letter"])
    name = next((n for n in state.letters if letter in (n, plain_letter(n))), None)
    value: Formula = Negative(number) if typed.startswith("-") else number
    return None if name is None else (name, value)
