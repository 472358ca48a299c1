"""Lines at odds with others of their page: wrong by a slip, or said of something else.

Pages call every engine's force F, count an angle otherwise in the next exercise, and put a second set of
numbers into a formula. Where a line comes out wrong only by what other lines of the page say, it is wrong
if one small change makes it right again: a sign, a factor, a function, an exponent, a digit. Anything
else may speak of another case, and is said to be at odds with the lines above, not to be wrong.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Constant,
    Formula,
    Name,
    Number,
    Product,
    Sum,
    Summation,
    names,
    walk,
)
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.descriptions import describe, printed_value
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.judging.cases_in_words import opens_case_in_words
from symbalance.notes.checking.judging.usual_slips import (
    LEAST_APART,
    is_slip,
    is_usual_factor,
    ratio_of_sides,
)
from symbalance.notes.checking.page.indexed_data import is_sum_of_order
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.premises.roots_of_unity import order_of_root
from symbalance.notes.checking.steps.dead_centres import angle_there
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.relation_fixes import add_fix_of_relation
from symbalance.notes.checking.verdicts import REFUTED, UNDECIDED, Verdict
from symbalance.notes.checking.words.case_labels import thing_of_case
from symbalance.notes.checking.words.case_words import engine_named
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_DIGITS = re.compile(r"\d[\d.,]*")
_SUM = re.compile(r"\\sum(?![A-Za-z])|[Σ∑]")
MOST_APART = 4
"""How many times larger or smaller a number may be that somebody worked out wrongly."""
NEAR = 2
"""Lines within which a formula speaks of what stands above it."""
DISPLAYS = 8
"""Lines within which words between two displays speak of the first one."""
_PLAIN = frozenset(Fraction(number) for number in (*range(11), 100, 1000, 10**6))
_ORDERS = ("n", "k", "m", "p", "i", "j", "nu", "h")
"""Letters of orders, as indices of what is given for any of them."""
MOST_LINES = 3
"""Lines that a verdict names."""
LEADING = 120
"""Characters between equations and what words say that they come to."""
_MULTIPLIED_OUT = re.compile(
    r"ausmultipli|multipl\w+\s+(?:it\s+|this\s+|them\s+)?out|expanding|expand\w*\s+the\s+(?:product|brackets)"
    r"|klammern\s+auf|en\s+développant|desarrollando|sviluppando|展開する"
    r"|(?:with|using|from)\s+(?:the|these|both|our)\s+(?:\w+\s+)?(?:definitions|relations|equations|formulas)"
    r"|mit\s+(?:den|diesen|beiden)\s+(?:\w+\s+)?(?:Definitionen|Beziehungen|Gleichungen|Formeln)"
    r"|avec\s+(?:les|ces)\s+(?:\w+\s+)?(?:définitions|relations|équations)|これらの(?:定義|式|関係)",
    re.IGNORECASE,
)
"""Words by which what follows is the same as what stands above, or comes of it."""
_PUT_IN = re.compile(
    r"(?<![^\W\d_])(?:(?:putt?|insert|substitut|plugg)ing\s+(?:it|this|that|these|them)\b|setzt\s+man\s+(?:das|dies\w*|es|sie)\s"
    r"|(?:das|dies\w*|es|sie)\s+eingesetzt|einsetzen\s+(?:ergibt|liefert)|en\s+(?:remplaçant|portant|substituant)"
    r"|sostituendo(?:lo|la|li)?\b|sustituyendo(?:lo|la|los)?\b|substituindo)|(?:これ|上式|それ)を?[^。、]{0,12}代入",
    re.IGNORECASE,
)
"""Words by which the line above is put into a formula: putting this in (5) we obtain."""
_SOLVED = re.compile(
    r"(?<![^\W\d_])(?:solutions?|solv\w+|whence|so\s+that|hence|therefore|gives?|yields?|follows"
    r"|lösung|auf(?:ge)?lös\w*|lösen|folgt|ergibt|ergeben|daraus|somit|résol\w+|d['’]où|donc|il\s+vient"
    r"|soluzione|risolv\w+|da\s+cui|quindi|solución|resolv\w+|de\s+donde|luego)(?![^\W\d_])|解くと|解は|より|よって",
    re.IGNORECASE,
)
"""Words by which what follows is what equations come to."""


def note_other_case(
    state: JudgingState,
    chain: Chain,
    k: int,
    verdict: Verdict,
    against: Side,
    decision: Decision,
    knowledge: Knowledge,
) -> Verdict:
    """Return a verdict; a refuted one that no slip explains notes that another case may be meant."""
    if verdict.verdict != REFUTED or verdict.decision is None or decision.reason or decision.of_matrices:
        return verdict
    sides = (against, chain.sides[k + 1])
    rested_on = [knowledge.definitions[n] for side in sides for n in _names_rested_on(side, knowledge)]
    rows = sorted({each.line for each in rested_on} - {*chain.lines})
    is_at_number = any(each.numeric and each.line in chain.lines for each in rested_on)
    of_numbers = not any(names(side.node) for side in chain.sides[k : k + 2])
    is_told = not k and opens_case_in_words(chain, state.document)
    if is_told and not rows:  # both may stand in one line
        rows = sorted({each.line for each in rested_on})
    if not rows or of_numbers or _is_wrong_anyway(chain, k, against, knowledge):
        return verdict
    if (line := _line_of_angle(chain, k, against, knowledge)) is not None:
        at_odds = f"it holds for the angle of line {line}: say whether it is meant there"
        return replace(verdict, decision=replace(verdict.decision, at_odds=at_odds))
    is_datum, is_result = _is_datum(chain, k, knowledge), _is_result(state, chain, k)
    is_of_roots = not is_told and _is_of_roots_of_unity(state, chain, rested_on)
    is_of_roots = is_of_roots or (not is_told and _is_of_order(state, chain, k, knowledge))
    is_same_case = is_of_roots or (
        not is_datum
        and not is_told
        and (
            _is_miscalculated(state, chain, k, decision, knowledge)
            or _is_cut_wrongly(decision)
            or _stands_below(chain, k, knowledge)
            or (rows[-1] >= chain.lines[0] - NEAR and _is_all_declared(chain, k, knowledge))
            or (not is_result and _puts_numbers_in(chain, k, against, knowledge))
            or any(isinstance(part, Summation) for part in walk(against.node))
            or _SUM.search(state.document.source(chain.sides[k].span)) is not None  # written out since
            or _is_multiplied_out(state, chain, k, knowledge)
            or _is_put_in_wrongly(state, chain, k, decision, knowledge)
            or _is_said_to_solve(state, chain, k, rows)
            or angle_there(state, chain, k, knowledge) is not None
            or (is_result and (k > 0 or is_at_number))
        )
    )
    if is_same_case:
        return verdict
    searched = verdict
    if not knowledge.corrects:
        known = replace(knowledge, corrects=True)
        searched = add_fix_of_relation(state, verdict, chain, k, against, decision, known)
    is_near = is_slip(searched.fix, decision, is_datum=is_datum, is_result=is_result)
    if is_near and not (is_told and _is_of_new_thing(state, chain)):
        return verdict
    at = ", ".join(map(str, rows[:MOST_LINES])) + (", …" if len(rows) > MOST_LINES else "")
    at_odds = (
        f"does not follow from line{'s' if len(rows) > 1 else ''} {at}, and no single slip lies between:"
        " another case is meant, or it is wrong"
    )
    return replace(verdict, decision=replace(verdict.decision, at_odds=at_odds))


def _is_multiplied_out(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> bool:
    """Tell whether words say that a relation is the formula of its letter above, multiplied out."""
    head = chain.sides[k].node
    above = knowledge.definitions.get(head.name) if isinstance(head, Name) else None
    is_near = above is not None and not above.numeric and above.line >= chain.lines[0] - DISPLAYS
    return is_near and _MULTIPLIED_OUT.search(state.sections.sentence_leading_to(chain)) is not None


def _is_put_in_wrongly(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> bool:
    """Tell whether one line above is said to be put into a letter's formula, and powers do not come out.

    P = 0.00034 W r N is none of P = W r ω²/g, whatever the units are: ω² is N² but for a factor.
    """
    head, right = chain.sides[k].node, chain.sides[k + 1].node
    above = knowledge.definitions.get(head.name) if isinstance(head, Name) else None
    if k or above is None or above.numeric or above.line < chain.lines[0] - DISPLAYS:
        return False
    exact, claimed = decision.left, decision.right
    if not names(right) or exact is None or claimed is None:
        return False
    forms = (exact.numerator, exact.denominator, claimed.numerator, claimed.denominator)
    if any(len(terms) != 1 for terms in forms) or not letters(exact.over(claimed)):
        return False
    return _PUT_IN.search(state.sections.sentence_leading_to(chain)) is not None


def _is_said_to_solve(state: JudgingState, chain: Chain, k: int, rows: Sequence[int]) -> bool:
    """Tell whether words say that a letter's formula is what the equations right above come to."""
    head, line = chain.sides[k].node, chain.lines[0]
    if k or not isinstance(head, Name) or rows[-1] < line - DISPLAYS:
        return False
    given = [p for p in state.definitions.premises_at(line) if p.line in rows and head.name in p.names]
    before = state.sections.chain_before(chain.start)
    words = "" if before is None else state.document.text[before.end : chain.start]
    return bool(given) and len(words) < LEADING and _SOLVED.search(words) is not None


def _is_of_roots_of_unity(state: JudgingState, chain: Chain, rested_on: Sequence[Definition]) -> bool:
    """Tell whether a relation rests on roots of unity alone, no other engine being named since."""
    orders = {order_of_root(each.node) for each in rested_on}
    if not orders or 0 in orders:
        return False
    engine = _engine_since(state, chain, max(each.line for each in rested_on))
    return engine == 0 or all(engine % order == 0 for order in orders)


def _is_of_order(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> bool:
    """Tell whether a side is a member of a sum given for every order: S_8 of S_n = Σ e^{-inφ_k}."""
    heads = [side.node for side in chain.sides[k : k + 2]]
    rules: list[Definition] = []
    for head in heads:
        stem, _, number = head.name.rpartition("_") if isinstance(head, Name) else ("", "", "")
        for index in _ORDERS if number.isdecimal() else ():
            rule = knowledge.definitions.get(f"{stem}_{index}")
            if rule is not None and is_sum_of_order(rule.node, index):
                rules.append(rule)
    engine = _engine_since(state, chain, max((rule.line for rule in rules), default=0))
    counts = {_count_of_terms(rule.node) for rule in rules}
    return bool(rules) and (engine == 0 or counts == {engine})


def _count_of_terms(node: Formula) -> int:
    """Return how many terms a sum has, 0 where its bounds are no numbers."""
    if isinstance(node, Sum):
        return len(node.terms)
    ends = (node.lower, node.upper) if isinstance(node, Summation) else ()
    numbers = [int(end.value) for end in ends if isinstance(end, Number)]
    return numbers[1] - numbers[0] + 1 if len(numbers) > 1 else 0


def _engine_since(state: JudgingState, chain: Chain, line: int) -> int:
    """Return how many cylinders the engine has that was named last since a line, 0 if none was."""
    lines = state.document.text.splitlines(keepends=True)
    since = state.document.text[sum(map(len, lines[:line])) : chain.start]
    engine = engine_named(since, len(since))
    return 0 if engine is None else engine[0]


def unless_other_case(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a refuted one that may speak of another case is undecided."""
    decision = verdict.decision
    if verdict.verdict != REFUTED or decision is None or not decision.at_odds:
        return verdict
    undecided = replace(decision, status=UNDECIDED, reason=decision.at_odds)
    return describe(state.document, chain, k, undecided)


def _is_of_new_thing(state: JudgingState, chain: Chain) -> bool:
    """Tell whether a formula is said to be for a thing of which the page has not spoken above."""
    first = state.sections.end_before(chain.start) or 0
    words = thing_of_case(state.document.text, first, chain.start)
    above = state.document.text[:first].lower()
    return bool(words) and not any(word in above for word in words)


def _line_of_angle(chain: Chain, k: int, against: Side, knowledge: Knowledge) -> int | None:
    """Return the line that gives an angle its number, if a relation is true there; None elsewhere."""
    behind = {*_names_rested_on(against, knowledge), *_names_rested_on(chain.sides[k + 1], knowledge)}
    lines = [
        knowledge.definitions[name].line
        for name in sorted(behind & knowledge.universal)
        if knowledge.definitions[name].numeric
    ]
    there = replace(knowledge, universal=frozenset())
    is_true = (
        bool(lines) and decide(against, chain.sides[k + 1], chain.relations[k].sign, there).is_proved
    )
    return max(lines) if is_true else None


def _is_result(state: JudgingState, chain: Chain, k: int) -> bool:
    """Tell whether a right side is one number, perhaps with its unit: what a formula comes to."""
    right = chain.sides[k + 1]
    return not names(right.node) and len(_DIGITS.findall(state.document.source(right.span))) == 1


def _names_rested_on(side: Side, knowledge: Knowledge) -> Iterator[str]:
    """Yield the letters of a side, and those behind them, to which lines above give values."""
    nodes = {name: definition.node for name, definition in knowledge.definitions.items()}
    for name in dict.fromkeys(names_behind(side.node, nodes)):
        if name in knowledge.definitions and name not in knowledge.meaning.values:
            yield name


def _is_wrong_anyway(chain: Chain, k: int, against: Side, knowledge: Knowledge) -> bool:
    """Tell whether a relation is wrong whatever numbers the lines above give: sin 2θ = sin θ cos θ.

    A step between two formulas speaks of one case; an equation at its beginning may be one to be solved,
    unless both sides have the same letters. A letter alone may always have another value.
    """
    left, right = against, chain.sides[k + 1]
    if isinstance(left.node, Name) or isinstance(right.node, Name):
        return False
    if not names(right.node) or not names(left.node):
        return False
    if not k and names(right.node) != names(left.node):
        return False
    known = knowledge.definitions
    formulas = {name: d for name, d in known.items() if k and not d.numeric}
    free = replace(knowledge, definitions=formulas, solved={}, solved_from=())
    return decide(left, right, chain.relations[k].sign, free).status == REFUTED


def _stands_below(chain: Chain, k: int, knowledge: Knowledge) -> bool:
    """Tell whether a letter's formula stands right below another one of it, of one meaning or letters."""
    head = chain.sides[0].node
    head_name = head.name if not k and isinstance(head, Name) else ""
    earlier = knowledge.definitions.get(head_name)
    if earlier is None or earlier.line < chain.lines[0] - NEAR:
        return False
    own = names(chain.sides[1].node)
    return bool(own) and (own <= names(earlier.node) or head_name in knowledge.meanings)


def _is_all_declared(chain: Chain, k: int, knowledge: Knowledge) -> bool:
    """Tell whether an equation of several letters has none that nobody declared: each has one meaning."""
    sides = [chain.sides[j].node for j in (k, k + 1)]
    letters = {name for side in sides for name in names(side)}
    return not any(isinstance(side, Name) for side in sides) and letters <= knowledge.meanings.keys()


def _is_cut_wrongly(decision: Decision) -> bool:
    """Tell whether an expansion agrees in its first terms: it is that of the lines above."""
    exact, claimed = decision.left, decision.right
    if decision.through is None or exact is None or claimed is None:
        return False
    terms = claimed.numerator
    return any(terms.get(key) == coefficient for key, coefficient in exact.numerator.items())


def _is_miscalculated(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> bool:
    """Tell whether a number is a result that somebody got wrong: of its size, or with its digits."""
    right = chain.sides[k + 1]
    if names(right.node):
        return False
    printed = printed_value(decision, state.document, right, chain.sides[k])
    if printed is not None:
        claim, value, _ = printed
        ratio = float(value / (Fraction(claim.factor) * claim.size)) if claim.mantissa else 0.0
    else:
        ratio = ratio_of_sides(decision) or _ratio_of_numbers(chain, k, knowledge) or 0.0
    if not ratio:
        return False
    return LEAST_APART < abs(math.log10(abs(ratio))) < math.log10(MOST_APART) or is_usual_factor(ratio)


def _puts_numbers_in(chain: Chain, k: int, against: Side, knowledge: Knowledge) -> bool:
    """Tell whether numbers are put in that the lines above give for letters: 0.5·0.04·300² for m r ω²."""
    right = chain.sides[k + 1].node
    if names(right) or isinstance(right, Number):
        return False
    given = set()
    for name in _names_rested_on(against, knowledge):
        if knowledge.definitions[name].numeric:
            given |= _long_numbers(knowledge.definitions[name].node)
    return not given.isdisjoint(_long_numbers(right))


def _long_numbers(node: Formula) -> set[Fraction]:
    """Return the numbers of a formula but for those that stand in many formulas."""
    numbers = {abs(part.value) for part in walk(node) if isinstance(part, Number)}
    return {number for number in numbers if number not in _PLAIN}


def _ratio_of_numbers(chain: Chain, k: int, knowledge: Knowledge) -> float | None:
    """Return how many times larger a left side with the page's numbers is than the number right of it."""
    exact, claimed = (number_of(chain.sides[j].node, knowledge) for j in (k, k + 1))
    return float(exact) / float(claimed) if exact and claimed else None


def _is_datum(chain: Chain, k: int, knowledge: Knowledge) -> bool:
    """Tell whether a letter that has a number gets another one: that of the next example."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if isinstance(left, Product) and len(left.factors) == 2 and isinstance(left.factors[0], Number):
        angle = left.factors[1]  # 2γ = 90°: the case of another bank angle
        known = knowledge.definitions.get(angle.name) if isinstance(angle, Name) else None
        has_degrees = any(isinstance(part, Constant) for part in walk(right)) and not names(right)
        return known is not None and known.numeric and has_degrees
    if not isinstance(left, Name) or not isinstance(right, Number):
        return False
    definition = knowledge.definitions.get(left.name)
    return definition is not None and definition.numeric and definition.formula is None
