r"""Values listed for listed values: y = 2x + 1, and "for x = 1, 2, 3 we get y = 3, 5, 7".

Each list is read as a range of its letter. Two lists of one sentence that are of one length are a row of
cases: each value of the one goes with the value of the other at its place, by the formula above.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Number, names
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import RANGE, Verdict
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_NUMBER = r"[-−]?[0-9]+(?:\.[0-9]+)?"
_COMMA = r"(?:[,;]\s?(?:\\[,;: ])?\s*|[,;]?\s+(?:and|und|et|e|y)\s+|、)"
_LISTED = re.compile(rf"[^=<>≤≥]{{1,20}}=\s*(?P<list>{_NUMBER}(?:{_COMMA}{_NUMBER})+)\s*")
"""How a list of a letter's values is written; where commas are decimal, they stand without a space."""
_GOES_ON = re.compile(r"[\s$]*(?:[,、]|and|und|et|e|y|or|oder)\s*\$?\s*[-−]?[0-9]")
"""A last value in words behind a list: 3, 5 and 8."""
_TIGHT = re.compile(r"[0-9],[0-9]")
_UNIT_BEHIND = re.compile(
    r"[\s$}~]*(?:\\,|\\ )?\s*(?:\\(?:mathrm|text)|[°%]|[A-Za-zµΩ]{1,3}(?:/[a-z]{1,3})?(?=[\s,.;)]|$))"
)
_NO_UNIT = re.compile(
    r"[\s$}~]*(?:we|so|is|it|for|bei|für|and|und|et|e|y|at|the|one|wir|man|on|in|per|con)(?![A-Za-z])",
    re.IGNORECASE,
)
"""Short words behind a list that are no unit."""


def unless_wrong_in_row(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a list of values is judged by the list of those that they are of."""
    own = _listed(state, chain) if verdict.verdict == RANGE else None
    if own is None:
        return verdict
    name, values = own
    definitions = state.knowledge(chain.lines[0]).definitions
    formula = definitions.get(name)
    if formula is None or not names(formula.node):
        return verdict
    behind = {*names_behind(formula.node, {n: d.node for n, d in definitions.items()})}
    beside = _beside(state, chain, behind, len(values))
    judged = None if beside is None else _judged(state, chain, own, beside)
    return verdict if judged is None else describe(state.document, chain, k, judged)


def _judged(
    state: JudgingState,
    chain: Chain,
    own: tuple[str, list[Formula]],
    beside: tuple[str, list[Formula]],
) -> Decision | None:
    """Return the decision on values by those of another letter at their places; None if one is open."""
    (name, values), (other, places) = own, beside
    line = chain.lines[0]
    knowledge = state.knowledge(line)
    for place, value in zip(places, values, strict=True):
        known = knowledge.with_definition(other, Definition(place, line, numeric=True))
        if number_of(Name(name), known) is None:
            return None  # a letter in it has no value
        decision = decide(lone_side(Name(name)), lone_side(value), "=", known)
        if decision.status == REFUTED:
            reason = f"not so for {plain_letter(other)} = {_typed(place)}"
            return Decision(REFUTED, reason, witness=decision.witness)
        if not decision.is_proved:
            return None
    return Decision(PROVED, f"for each of the values of {plain_letter(other)}")


def _beside(
    state: JudgingState, chain: Chain, letters: set[str], count: int
) -> tuple[str, list[Formula]] | None:
    """Return the list of values of another letter in a list's sentence, right before it or behind."""
    before = state.sections.chain_before(chain.start)
    behind = next(state.sections.chains_behind(chain.end - 1), None)
    for other in (before, behind):
        if other is None:
            continue
        between = state.document.text[min(chain.end, other.end) : max(chain.start, other.start)]
        listed = _listed(state, other)
        if listed is not None and listed[0] in letters and len(listed[1]) == count:
            return listed if re.search(r"[.;!?]\s|\n\s*\n", between) is None else None
    return None


def _listed(state: JudgingState, chain: Chain) -> tuple[str, list[Formula]] | None:
    """Return the letter of a list and its values as they are printed, None for other relations."""
    if {relation.sign for relation in chain.relations} != {"≤"} or len(chain.sides) != 3:
        return None
    text, middle = state.document.text, chain.sides[1].node
    match = _LISTED.fullmatch(text, chain.start, chain.end)
    if match is None or not isinstance(middle, Name) or _TIGHT.search(match["list"]):
        return None
    if _GOES_ON.match(text, chain.end):
        return None
    if _UNIT_BEHIND.match(text, chain.end) and not _NO_UNIT.match(text, chain.end):
        return None
    return middle.name, [_number(typed) for typed in re.findall(_NUMBER, match["list"])]


def _number(typed: str) -> Formula:
    """Return a typed number with the last of its digits."""
    digits = typed.replace("−", "-")
    decimals = len(digits.partition(".")[2])
    number = Number(abs(Fraction(digits)), Fraction(1, 10**decimals) if decimals else None)
    return Negative(number) if digits.startswith("-") else number


def _typed(node: Formula) -> str:
    number = node.operand if isinstance(node, Negative) else node
    value = float(number.value) if isinstance(number, Number) else 0.0
    return f"{-value if isinstance(node, Negative) else value:g}"
