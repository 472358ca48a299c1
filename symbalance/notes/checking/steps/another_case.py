"""Cases that words beside a letter name: other cranks, another order, another value for one sentence.

C_1 of a twin with cranks at 180° is not C_1 of one with 270°, and n_0/2 is the critical speed of order 2
alone. "For 2α = 60° the backward part is" opens a case after 2α = 90°: it ends with its paragraph, and
the value before comes back. Where numbers are put into a formula that are none of those above, another
engine's are meant.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    names,
    walk,
)
from symbalance.notes.algebra.tree_values import names_behind
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import paired, without_unit
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.conversions import quantity_of
from symbalance.notes.checking.verdicts import PREMISE, REFUTED, UNDECIDED
from symbalance.notes.checking.words.case_words import clause_start, is_place_behind
from symbalance.notes.checking.words.cases_named import (
    crank_spread_named,
    names_another_example,
    names_some_engine,
    orders_named,
)
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain, Side

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
FEWEST = 2
"""Numbers of another engine that are put in together; one alone may be a slip."""
MOST_VALUES = 4
"""Other values of letters that are tried, the nearest first."""


def leave_named_case(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget the formula that a letter has of other cranks, or of another order; tell of any."""
    head = chain.sides[0].node
    if k or not isinstance(head, Name) or not names(chain.sides[1].node):
        return False
    above = [c for c in state.document.chains if c.start < chain.start and c.sides[0].node == head]
    formulas = [c for c in above if c.relations and names(c.sides[1].node)]
    if not formulas or not _is_another_case(state, max(formulas, key=lambda c: c.start), chain):
        return False
    known = [
        state.definitions.forget_line(head.name, line) for line in sorted({c.lines[0] for c in above})
    ]
    return any(known)


def _is_another_case(state: JudgingState, earlier: Chain, chain: Chain) -> bool:
    """Tell whether words, or the formulas themselves, part two formulas of one letter."""
    text, end = state.document.text, earlier.end
    before = crank_spread_named(text, max(0, earlier.start - FARTHEST), earlier.start)
    now = crank_spread_named(text, max(end, chain.start - FARTHEST), chain.start)
    turns = (_phase_shifts(earlier) or {before[1]}) if before else _phase_shifts(earlier)
    own = _phase_shifts(chain) or ({now[1]} if now else set[int]())
    if turns and own and turns.isdisjoint(own):
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


def _order_beside(state: JudgingState, chain: Chain) -> str | None:
    """Return the order that the words before a relation name last, or those right behind it."""
    text = state.document.text
    starts = [c.end for c in state.document.chains if c.end <= chain.start]
    first = max(*starts, chain.start - REACH, 0) if starts else max(chain.start - REACH, 0)
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
                if not names(term) and (turn := _degrees(term)) is not None:
                    shifts.add(turn)
    return shifts


def _degrees(node: Formula) -> int | None:
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
    before = text[max(0, clause_start(text, chain.start)) : chain.start]
    if not _OPENS.search(before) and not _BEHIND.match(text, chain.end):
        return None
    if state.sections.is_consequence(chain) or not chain.inline:
        return None
    definitions, name = state.definitions, letter.name
    if name in state.knowledge(line).angles:
        return None
    definitions.premises = [p for p in definitions.premises if p.names != {name}]
    definitions.define(name, Quotient(value, number), chain, definitions.sections.case_end(line))
    return Decision(PREMISE, "a case, by the words around it: lines above have another value")


def puts_another_engines_numbers_in(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return what 4π·142/0.0016 for 4πT/V is, where T and V have other numbers above; else None.

    All of them are other ones, two at least: with words that name another engine they are its data.
    Without such words it may be wrong.
    """
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    is_result = names(right) or isinstance(right, Number) or isinstance(left, Name)
    if is_result or quantity_of(chain.sides[k + 1], state.document) is not None:
        return None
    pairs = _numbers_for_letters(left, without_unit(right))
    others = {part.name: number for part, number in pairs}
    if not FEWEST <= len(others) == len(pairs) or not all(
        _is_another(*pair, knowledge) for pair in pairs
    ):
        return None
    shown = ", ".join(f"{plain_text(Name(name))} = {plain_text(node)}" for name, node in others.items())
    text = state.document.text
    words = text[max(clause_start(text, chain.start), 0) : chain.start]
    if not names_another_example(words):
        return Decision(UNDECIDED, f"numbers of another case are put in, or wrong ones: {shown}")
    for name, node in others.items():
        state.definitions.define(name, node, chain, state.sections.case_end(chain.lines[0]))
    return Decision(PREMISE, f"another engine's numbers put in: {shown}")


def _is_another(letter: Name, number: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a number is none that a letter has above, in any unit, nor a slip of it."""
    known, put_in = number_of(letter, knowledge), number_of(number, knowledge)
    if not known or not put_in:
        return False
    definition = knowledge.definitions.get(letter.name)
    typed = walk(definition.node) if definition is not None else ()
    own = [known, *(each.value for each in typed if isinstance(each, Number))]
    return not any(_may_be_slip(float(each) / float(put_in)) for each in own if each)


def _numbers_for_letters(left: Formula, right: Formula) -> list[tuple[Name, Formula]]:
    """Return the letters of a product or quotient with the numbers that stand for them; none elsewhere.

    The numbers that both have are left out: 4 and π of 4πT/V and 4π·142/0.0016.
    """
    wanted, given = list(_factors(left)), _with_powers_of_ten(list(_factors(right)))
    pairs: list[tuple[Name, Formula]] = []
    for part, power in wanted:
        place = next((n for n, each in enumerate(given) if each == (part, power)), None)
        if place is None and isinstance(part, Name):
            place = next((n for n, (_, other) in enumerate(given) if other == power), None)
        if place is None:
            return []
        number, _ = given.pop(place)
        if isinstance(part, Name):
            pairs.append((part, number))
    return [] if given else pairs


def _factors(node: Formula, sign: int = 1) -> Iterator[tuple[Formula, Fraction]]:
    """Yield the factors of a formula with their exponents."""
    match node:
        case Product(factors=parts):
            for part in parts:
                yield from _factors(part, sign)
        case Quotient(numerator=above, denominator=below):
            yield from _factors(above, sign)
            yield from _factors(below, -sign)
        case Power(base=base, exponent=Number(value=exponent)) if names(base) or base != _TEN:
            yield base, sign * exponent
        case _:
            yield node, Fraction(sign)


def _with_powers_of_ten(factors: list[tuple[Formula, Fraction]]) -> list[tuple[Formula, Fraction]]:
    """Return factors with each power of ten as a part of the number before it."""
    whole: list[tuple[Formula, Fraction]] = []
    for part, power in factors:
        is_ten = isinstance(part, Power) or part == _TEN
        if is_ten and whole and whole[-1][1] == power:
            whole[-1] = (Product((whole[-1][0], part)), power)
        else:
            whole.append((part, power))
    return whole


_TEN = Number(Fraction(10))


def as_number_of_another(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return that a letter has its number in another engine, which the words before name; or None."""
    head, value = chain.sides[0].node, chain.sides[-1].node
    if k or not isinstance(head, Name) or len(chain.relations) != 1 or names(value):
        return None
    text, line = state.document.text, chain.lines[0]
    words = text[max(clause_start(text, chain.start), 0) : chain.start]
    behind = re.split(r"[.;,。；\n=$]", text[chain.end : chain.end + 30], maxsplit=1)[0]
    given = state.definitions.at(line).get(head.name)
    is_known = given is not None or any(p.names == {head.name} for p in state.definitions.premises)
    if not is_known:
        return None
    if state.sections.is_consequence(chain):
        is_open = _SUPPOSED.search(words) is not None
        return Decision(UNDECIDED, "supposed, and not so above") if is_open else None
    is_datum = given is not None and given.numeric and given.formula is None
    is_elsewhere = is_datum and given is not None and not state.sections.same_exercise(given.line, line)
    is_elsewhere = is_elsewhere or (given is not None and _has_another_subject(state, chain, given.line))
    if is_elsewhere or names_another_example(words) or names_another_example(behind):
        state.definitions.forget_all(head.name)
        state.definitions.define(head.name, value, chain)
        return Decision(PREMISE, "of another engine than above")
    is_below = given is not None and given.line < state.sections.paragraph_start(line)
    if is_below and names_some_engine(words):
        return Decision(UNDECIDED, "of the engine above it is another number: say which is meant")
    return None


def as_number_in_words(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return that a letter has its number anew, with one that the words before give; or None."""
    head, value, text = chain.sides[0].node, chain.sides[1].node, state.document.text
    words = text[max(clause_start(text, chain.start), 0) : chain.start]
    if k or not isinstance(head, Name) or names(value) or not _is_in_words(value, words):
        return None
    knowledge = state.knowledge(chain.lines[0])
    given = knowledge.definitions.get(head.name)
    formula = None if given is None else given.formula if given.numeric else given.node
    if formula is not None and not _puts_words_in(formula, value, words, knowledge):
        return None
    state.definitions.forget_all(head.name)
    state.definitions.define(head.name, value, chain)
    return Decision(PREMISE, "with a number that the words before it give")


def _is_in_words(value: Formula, words: str) -> bool:
    """Tell whether words give a number that is put in: with a 150 mm rod n = 150/39.5."""
    numbers = [part for part in walk(value) if isinstance(part, Number)]
    if value in numbers:
        return False
    typed = {number.value for number in numbers if abs(number.value.numerator) >= _COUNTS}
    return any(Fraction(match[1].replace(",", ".")) in typed for match in _WITH_UNIT.finditer(words))


def _puts_words_in(formula: Formula, value: Formula, words: str, knowledge: Knowledge) -> bool:
    """Tell whether an arithmetic is a letter's formula with numbers of the words or of the page."""
    pairs = paired(formula, without_unit(value))
    for part, number in pairs or ():
        known, put_in = number_of(part, knowledge), number_of(number, knowledge)
        if isinstance(number, Number) and _is_in_words(Product((number, number)), words):
            continue
        if not known or not put_in:
            return False
        if not any(abs(float(known) / float(put_in) / shift - 1) < _EXACT for shift in _SHIFTED):
            return False
    return bool(pairs)


_EXACT = 1e-3
_COUNTS = 10
_WITH_UNIT = re.compile(
    r"(?:\b(?:with|mit|avec|con|for|für|a|an|ein(?:er|em)?|une?)\s)(?:an?\s|ein(?:er|em)?\s|une?\s)?"
    r"([0-9]+(?:[.,][0-9]+)?)(?:&nbsp;|[\s~]|\\,)?(?:mm|cm|m|kg|g|rpm|min|N|kN|%)(?![A-Za-z])",
    re.IGNORECASE,
)
"""A size in words, which a letter may have from there on."""
_SUPPOSED = re.compile(
    r"(?<![A-Za-zäöü])(?:were|would|had\s+been|wären?|würden?)(?![A-Za-zäöü])|仮に", re.IGNORECASE
)
"""In a clause that speaks of what is not so: if γ were 60°."""


def as_supposed(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return that a relation refuted by lines above is one of a clause that only supposes; or None.

    A step from a formula to its value supposes nothing, nor does a line that was ended before.
    """
    text = state.document.text
    words = text[max(clause_start(text, chain.start), 0) : chain.start]
    if k or _RELATION_ABOVE.search(words) or _SUPPOSED.search(words) is None or not chain.letters:
        return None
    return Decision(UNDECIDED, "supposed, and not so above")


_RELATION_ABOVE = re.compile(r"[=≈][^\n]*\n")
"""A line of its own above, with a relation: its words say nothing of the next."""
_SUBJECT = re.compile(
    r"(?<![A-Za-z])(?:the|die|der|das)\s+(?P<kind>[\w-]+)\s+(?P<noun>[\w-]+)"
    r"\s+(?:is|was|ist|war|beträgt)[\s$]*$",
    re.IGNORECASE,
)


def _has_another_subject(state: JudgingState, chain: Chain, line: int) -> bool:
    """Tell whether a letter is that of two things by their sentences: the gas force, the drag force."""
    text = state.document.text
    now = _SUBJECT.search(text, max(0, chain.start - REACH), chain.start)
    above = [c for c in state.sections.chains_on(line) if c.sides[0].node == chain.sides[0].node]
    matches = (_SUBJECT.search(text, max(0, c.start - REACH), c.start) for c in above if c is not chain)
    before = [match for match in matches if match is not None]
    return now is not None and any(
        match["noun"].lower() == now["noun"].lower() and match["kind"].lower() != now["kind"].lower()
        for match in before
    )


def leave_products_of_another(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget m r = 20 of engine A before m r = 0.6·44 of engine B; tell if there was such an equation."""
    left, right = chain.sides[0].node, chain.sides[1].node
    text, own = state.document.text, names(left)
    words = text[max(clause_start(text, chain.start), 0) : chain.start]
    if k or isinstance(left, Name) or names(right) or not own or not names_another_example(words):
        return False
    rest = [p for p in state.definitions.premises if p.names != own]
    is_known = len(rest) < len(state.definitions.premises)
    state.definitions.premises = rest
    return is_known


_ONE = 0.03
_SHIFTED = tuple(10.0**power for power in range(-6, 7))


def _may_be_slip(ratio: float) -> bool:
    """Tell whether one number may stand for another: rounded, or in another unit, by a power of ten."""
    return ratio < 0 or any(abs(ratio / shift - 1) < _ONE for shift in _SHIFTED)


def with_other_values(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a refuted relation by other numbers that the page gives its letters.

    It is proved, on that condition, with those given last before it, as one reads; with any others it is
    open. None where none of them make it true.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    if k and not names(left.node):
        left = next((side for side in reversed(chain.sides[:k]) if names(side.node)), left)
    values = {name: d.node for name, d in knowledge.definitions.items()}
    behind = {*names(left.node), *names(right.node)}
    behind |= {*names_behind(left.node, values), *names_behind(right.node, values)}
    if isinstance(left.node, Name) and knowledge.definitions.get(left.node.name) is not None:
        is_datum = knowledge.definitions[left.node.name].numeric and not names(right.node)
        behind -= {left.node.name} if is_datum else set()
    given = {name: _numbers_given(state, name, chain) for name in sorted(behind & values.keys())}
    given = {
        name: chains for name, chains in given.items() if chains and knowledge.definitions[name].numeric
    }
    given = {
        name: chains
        for name, chains in given.items()
        if len(chains) > 1 or _is_stale(chains, name, knowledge)
    }
    for rank in range(MOST_VALUES if given else 0):
        here = {name: chains[rank] for name, chains in given.items() if len(chains) > rank}
        sets = [here] if not rank else [here, *({name: c} for name, c in here.items())]
        for chosen in sets:
            there = _decide_with(chosen, left, right, chain.relations[k].sign, knowledge)
            if there is None or not there.is_proved:
                continue
            shown = tuple(_shown(n, c) for n, c in chosen.items())
            if not rank and not _names_older(state, chain, chosen):
                return replace(there, assumptions=(*there.assumptions, *shown))
            if rank and _stands_with(state, chain, chosen, {n: chains[0] for n, chains in given.items()}):
                return None
            words = " and ".join(shown)
            return Decision(UNDECIDED, f"it holds with {words}: say whether that is meant")
    return None


def refuted_by_nearest(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return that a proved relation is true by an older number of a letter only, not by the nearest one.

    Below d = 60 mm and I = 1.27·10⁶ mm⁴ the next journal has d = 50 mm, and the same I. A number that is
    refuted is none.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    if k and not names(left.node):
        left = next((side for side in reversed(chain.sides[:k]) if names(side.node)), left)
    if names(right.node) or isinstance(right.node, Name):
        return None
    values = {name: d.node for name, d in knowledge.definitions.items()}
    behind = {*names(left.node), *names_behind(left.node, values)}
    behind -= {left.node.name} if isinstance(left.node, Name) else set()
    given = {name: _numbers_given(state, name, chain) for name in sorted(behind & values.keys())}
    wrong = {(each.name, each.line) for each in state.wrong_numbers.results}
    given = {n: [c for c in chains if (n, c.lines[0]) not in wrong] for n, chains in given.items()}
    given = {name: c for name, c in given.items() if len(c) > 1 and knowledge.definitions[name].numeric}
    nearest = {name: chains[0] for name, chains in given.items()}
    older = {name: chains[1] for name, chains in given.items()}
    if not given or all(_is_same(nearest[n], older[n]) for n in given):
        return None
    if _names_older(state, chain, nearest):
        return None
    sign = chain.relations[k].sign
    there = _decide_with(nearest, left, right, sign, knowledge)
    before = _decide_with(older, left, right, sign, knowledge)
    if there is None or there.status != REFUTED or before is None or not before.is_proved:
        return None
    words = " and ".join(_shown(name, c) for name, c in older.items())
    return Decision(UNDECIDED, f"it holds with {words}, and another number stands nearer")


def _is_same(first: Chain, second: Chain) -> bool:
    return first.sides[-1].node == second.sides[-1].node


def _is_stale(chains: list[Chain], name: str, knowledge: Knowledge) -> bool:
    """Tell whether a letter's nearest number is not the one that is in force."""
    return bool(chains) and chains[0].sides[-1].node != knowledge.definitions[name].node


def _decide_with(
    chosen: dict[str, Chain], left: Side, right: Side, sign: str, knowledge: Knowledge
) -> Decision | None:
    """Return the decision with the numbers that lines give letters; None where these are in force."""
    others = {n: c for n, c in chosen.items() if c.sides[-1].node != knowledge.definitions[n].node}
    definitions = {n: Definition(c.sides[-1].node, c.lines[0], True) for n, c in others.items()}
    known = replace(knowledge, definitions={**knowledge.definitions, **definitions})
    return decide(left, right, sign, known)


def _names_older(state: JudgingState, chain: Chain, nearest: dict[str, Chain]) -> bool:
    """Tell whether a clause names an example, "the first has", and gives it no number of its own."""
    text = state.document.text
    start = clause_start(text, chain.start)
    is_here = any(c.start >= start for c in nearest.values())
    return not is_here and names_another_example(text[max(start, 0) : chain.start])


def _stands_with(
    state: JudgingState, chain: Chain, older: dict[str, Chain], nearest: dict[str, Chain]
) -> bool:
    """Tell whether a relation speaks of the numbers given last: in their paragraph, or their section.

    Words that name the example before, "the first has", lead away from them.
    """
    sections, line = state.sections, chain.lines[0]
    if _names_older(state, chain, nearest):
        return False
    last = max((c for n, c in nearest.items() if n in older), key=lambda c: c.start, default=None)
    if last is None:
        return False
    if sections.paragraph_start(line) == sections.paragraph_start(last.lines[0]):
        return True
    is_of_section = sections.same_section(last.lines[0], line)
    return is_of_section and not any(sections.same_section(c.lines[0], line) for c in older.values())


def _shown(name: str, chain: Chain) -> str:
    return f"{plain_text(Name(name))} = {plain_text(chain.sides[-1].node)} of line {chain.lines[0]}"


def _numbers_given(state: JudgingState, name: str, chain: Chain) -> list[Chain]:
    """Return the relations above that give a letter a number, the nearest first.

    None where it gets one right behind the relation: S = 1278 lb at a = 0.
    """
    text = state.document.text
    own = [
        c for c in state.sections.chains_on(chain.lines[-1]) if is_place_behind(text, chain.end, c.start)
    ]
    if any(c.sides[0].node == Name(name) and not names(c.sides[-1].node) for c in own):
        return []
    above = [
        c
        for c in state.document.chains
        if c.start < chain.start and len(c.relations) == 1 and c.sides[0].node == Name(name)
    ]
    given = [c for c in above if not names(c.sides[1].node) and c.relations[0].sign in "=≈"]
    return sorted(given, key=lambda c: -c.start)
