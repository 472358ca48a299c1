"""Cases that words beside a formula name: other cranks, another order, another value for a while.

C_1 of a twin with cranks at 180° is not C_1 of one with 270°, and n_0/2 is the critical speed of order 2
alone. "For 2α = 60° the backward part is" opens a case after 2α = 90°: it ends with its paragraph, and
the value before comes back.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    Sum,
    names,
    walk,
)
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import PREMISE
from symbalance.notes.checking.words.case_labels import are_two_cases, words_of_case
from symbalance.notes.checking.words.case_words import clause_before
from symbalance.notes.checking.words.cases_named import (
    crank_spread_named,
    orders_named,
)
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_OPENS = re.compile(
    r"(?<![A-Za-zÀ-ÿ])(?:for|with|if|when|where|at|having|suppose|supposing|take|let|choose|say|für|bei|mit|wenn|falls"
    r"|nimm|sei|pour|avec|si|par|para|con|per)\s[^.;:!?\n=$]{0,40}[\s$\\(\[]*$",
    re.IGNORECASE,
)
_BEHIND = re.compile(r"[\s$)\]}\\,]{0,6}(?:なら|のとき|の時|の場合|では|とすると|とすれば|に対して)")
"""What opens a case, before a letter's value or behind it."""
_CRITICAL = re.compile(r"critical|kritisch|resonan|危険|共振|critique", re.IGNORECASE)
"""On pages of critical speeds these go with one over the order, and a formula that does not is wrong."""
REACH = 120
"""Characters beside a formula in which its order is named."""
FARTHEST = 3000
"""Characters above a formula in which its cranks are named."""


def leave_named_case(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget the formula that a letter has of other cranks, or of another order; tell of any."""
    head = _in_relation_to(chain.sides[0].node)
    if k or not isinstance(head, Name) or not names(chain.sides[1].node):
        return False
    above = state.sections.chains_above(head, chain.start)
    formulas = [c for c in above if names(c.sides[1].node)]
    if not formulas or not _is_another_case(state, formulas[-1], chain):
        return False
    known = [
        state.definitions.forget_line(head.name, line) for line in sorted({c.lines[0] for c in above})
    ]
    return any(known)


def _in_relation_to(node: Formula) -> Formula:
    """Return the letter F of F/P, a letter in relation to another; any other formula as it is."""
    is_ratio = isinstance(node, Quotient) and isinstance(node.denominator, Name)
    return node.numerator if is_ratio and isinstance(node, Quotient) else node


def leave_formula_of_opening(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget the formulas that a letter has of other things, by the words that open them; tell of any."""
    head, line = chain.sides[0].node, chain.lines[0]
    if k or not isinstance(head, Name) or head.name in state.declarations.symbols_at(line):
        return False
    if not names(chain.sides[1].node) or state.sections.is_consequence(chain):
        return False
    above = state.sections.chains_above(head, chain.start)
    formulas = [c for c in above if names(c.sides[1].node)]
    others = _of_other_openings(state, formulas, chain)
    left = [state.definitions.forget_line(head.name, c.lines[0]) for c in others]
    return any(left)


def leave_value_of_case(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget what a letter is "for N = 2" where "for N = 3" stands before it again; tell of any.

    A formula in that letter has the letter's values in it: it is not forgotten.
    """
    head, line = chain.sides[0].node, chain.lines[0]
    if k or not isinstance(head, Name) or head.name in state.declarations.symbols_at(line):
        return False
    own = state.sections.chains_above(head, chain.start)
    last = own[-1] if own else None
    if last is None or not state.sections.same_section(last.lines[0], line):
        return False
    opened = [c for c in state.sections.in_order if c.end <= chain.start and _opens_with_number(state, c)]
    for now in (c for c in opened if c.start > last.end):
        before = [c for c in opened if c.end <= last.start and c.sides[0].node == now.sides[0].node]
        is_of_letter = any(names(now.sides[0].node) & names(c.sides[1].node) for c in own)
        if not before or is_of_letter:
            continue
        if before[-1].sides[1].node != now.sides[1].node:
            state.definitions.forget_all(head.name)
            return True
    return False


def _opens_with_number(state: JudgingState, chain: Chain) -> bool:
    """Tell whether a relation opens a case by a letter's number: for N = 3."""
    is_plain = len(chain.relations) == 1 and isinstance(chain.sides[0].node, Name) and chain.inline
    is_number = is_plain and chain.relations[0].sign == "=" and not names(chain.sides[1].node)
    return is_number and state.sections.opens_case(chain)


def _of_other_openings(state: JudgingState, formulas: list[Chain], chain: Chain) -> list[Chain]:
    """Return the formulas of a letter whose opening words name another thing than its next one's.

    Where an opening names the same thing once more, its formula counts: nothing is left.
    """
    own = _words_of_case(state, chain)
    if not own:
        return []
    openings = [_words_of_case(state, formula) for formula in formulas]
    if own in openings:
        return []
    return [c for c, words in zip(formulas, openings, strict=True) if are_two_cases(words, own)]


def _words_of_case(state: JudgingState, chain: Chain) -> frozenset[str]:
    """Return the words that open a formula's sentence, item or clause and name what it is of."""
    first = state.sections.end_before(chain.start) or 0
    return words_of_case(state.document.text, first, chain.start, chain.end)


def _is_another_case(state: JudgingState, earlier: Chain, chain: Chain) -> bool:
    """Tell whether words, or the formulas themselves, part two formulas of one letter."""
    text, end = state.document.text, earlier.end
    before = crank_spread_named(text, max(0, earlier.start - FARTHEST), earlier.start)
    now = crank_spread_named(text, max(end, chain.start - FARTHEST), chain.start)
    turns = (_phase_shifts(earlier) or {before[1]}) if before else _phase_shifts(earlier)
    own = _phase_shifts(chain) or ({now[1]} if now else set[int]())
    if turns and own and turns.isdisjoint(own):
        return True
    if state.sections.headings_name_other_engines(chain.lines[0], earlier.lines[0]):
        return True
    if _is_of_another_angle(state, earlier, chain):
        return True
    orders = _order_beside(state, earlier), _order_beside(state, chain)
    if None in orders or orders[0] == orders[1]:
        return False
    if not _CRITICAL.search(text):
        return True
    first, second = (
        lone_side(Product((Number(Fraction(order)), each.sides[1].node)))
        for order, each in zip(orders, (earlier, chain), strict=True)
        if order is not None
    )
    return decide(first, second, "=", state.knowledge(chain.lines[0])).is_proved


_ANGLE_OF_CASE = re.compile(
    r"(?P<degrees>[0-9]{1,3})\s?(?:°|\^\s?\{?\s?\\circ\s?\}?|\\degree|\\ang|degrees?|deg|Grad)[\s$)}\]\\,]{0,6}"
    r"(?:,?[^:。.;=]{0,12}=[^:。.;=]{0,12})?(?::|の場合|のとき|では)"
)
"""An angle that a list's item or a clause is about: β = 45°, n = 1: the force is."""
_ITEM = re.compile(r"\\item|\n\s*\n|\n[ \t]{0,4}[-*•]\s|[。]|[.;]\s")


def _is_of_another_angle(state: JudgingState, earlier: Chain, chain: Chain) -> bool:
    """Tell whether items or clauses about two angles, none the crank's, part two formulas of a letter."""
    now = _angle_of_item(state, chain)
    if now is None:
        return False
    degrees, start, end = now
    before = _angle_of_item(state, earlier)
    angles = _phase_shifts(earlier) if before is None else {before[0]}
    formula = {name for side in earlier.sides[1:] for name in names(side.node)}
    given = [c for c in state.document.chains if start <= c.start < end]
    heads = {name for c in given for name in names(c.sides[0].node)}
    return bool(angles and heads) and degrees not in angles and not heads & formula


def _angle_of_item(state: JudgingState, chain: Chain) -> tuple[int, int, int] | None:
    """Return the angle that a relation's item or clause is about, and where its words begin and end."""
    text, first = state.document.text, max(0, chain.start - REACH)
    start = max((m.end() for m in _ITEM.finditer(text, first, chain.start)), default=first)
    match = next(_ANGLE_OF_CASE.finditer(text, start, chain.start), None)
    return None if match is None else (int(match["degrees"]), start, match.end())


def _order_beside(state: JudgingState, chain: Chain) -> str | None:
    """Return the order that the words before a relation name last, or those right behind it."""
    text = state.document.text
    first = max(state.sections.end_before(chain.start) or 0, chain.start - REACH, 0)
    if orders := orders_named(text[first : chain.start]):
        return orders[-1]
    behind = re.split(r"[.;:,。；\n=]", text[chain.end : chain.end + REACH], maxsplit=1)[0]
    orders = orders_named(behind)
    return orders[0] if orders else None


def _phase_shifts(chain: Chain) -> set[int]:
    """Return the numbers of degrees by which a formula's waves stand apart: 270 of cos(θ + 270°)."""
    shifts: set[int] = set()
    for side in chain.sides[1:]:
        for call in walk(side.node):
            if not isinstance(call, Call) or not isinstance(call.argument, Sum):
                continue
            for term in call.argument.terms:
                if not names(term) and (turn := whole_degrees(term)) is not None:
                    shifts.add(turn)
    return shifts


def whole_degrees(node: Formula) -> int | None:
    """Return an angle's whole number of degrees, None for anything else: 3π/2 is 270."""
    value, power = Fraction(1), 0
    parts = [(node, 1)]
    while parts:
        part, sign = parts.pop()
        if isinstance(part, Product):
            parts += [(factor, sign) for factor in part.factors]
        elif isinstance(part, Quotient):
            parts += [(part.numerator, sign), (part.denominator, -sign)]
        elif isinstance(part, Number) and part.value:
            value *= part.value**sign
        elif isinstance(part, Constant) and part.name == "pi":
            power += sign
        else:
            return None
    degrees = value * 180
    return int(degrees) if power == 1 and degrees.denominator == 1 else None


_AT = re.compile(r"(?<![A-Za-zÀ-ÿ])(?:at|bei|à|con)[\s$\\(\[]*$", re.IGNORECASE)
"""A word before a value that may open a case, or go with what was said: the shafts turn at 2n."""


_SAYS = re.compile(
    r"(?<![^\W\d_])(?:it|is|are|was|we|get|gets|gives?|takes?|needs?|becomes?|has|have|ist|sind|beträgt|wird|ergibt|hat"
    r"|haben|man|wir|est|sont|vaut|on|il|elle|è|sono|vale|ha|son|tiene)(?![^\W\d_])|(?<=[\u3041-\u9fff])は",
    re.IGNORECASE,
)
"""Behind the words of a case, what is said in it: for four pistons it is 4m = 1.6 kg."""


def _has_value_in_clause(state: JudgingState, chain: Chain, name: str) -> bool:
    """Tell whether a sentence gives a letter its value, and says of a multiple of it what is "at" that.

    "For n = 5000 rpm the shafts turn at 2n = 10000 rpm"; after "at n = …" an "at" opens another case.
    """
    text, start = state.document.text, chain.sides[0].span[0]
    if not _AT.search(text, max(0, start - REACH), start):
        return False
    for other in state.document.chains:
        head, end = other.sides[0], other.end
        if not isinstance(head.node, Name) or head.node.name != name or not 0 < start - end < REACH:
            continue
        between, first = text[end:start], head.span[0]
        is_at = _AT.search(text, max(0, first - REACH), first) is not None
        return not is_at and re.search(r"[.;:!?。](?=\s)|\n\s*\n", between) is None
    return False


def as_case_of_multiple(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return that 2α = 60° behind "for" is a case, after 2α = 90°; None for other relations.

    The value reaches as far as its paragraph and its displays, and the one before it counts again below.
    """
    left, value, line = chain.sides[0].node, chain.sides[-1].node, chain.lines[0]
    factors = left.factors if isinstance(left, Product) else ()
    if k or len(chain.relations) != 1 or len(factors) != 2 or names(value):
        return None
    number, letter = factors
    if not isinstance(number, Number) or not isinstance(letter, Name) or not number.value:
        return None
    text = state.document.text
    before = clause_before(text, chain.start)
    opens = _OPENS.search(before)
    if (opens is None or _SAYS.search(before, opens.start())) and not _BEHIND.match(text, chain.end):
        return None
    if state.sections.is_consequence(chain) or not chain.inline:
        return None
    definitions, name = state.definitions, letter.name
    above = state.sections.chains_above(letter, chain.start)
    is_named = bool(state.sections.of_its_named_case(chain, above))
    if is_named or _has_value_in_clause(state, chain, name) or name in state.knowledge(line).angles:
        return None
    definitions.premises = [p for p in definitions.premises if p.names != {name}]
    definitions.define(name, Quotient(value, number), chain, definitions.sections.case_end(line))
    return Decision(PREMISE, "a case, by the words around it: lines above have another value")
