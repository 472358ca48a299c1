"""Which of several numbers of a letter a line means: those given last before it, as one reads.

A line that they make true holds with them; one that is true by an older number only is open.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import (
    Name,
    names,
)
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import REFUTED, UNDECIDED
from symbalance.notes.checking.words.case_words import clause_start, is_place_behind
from symbalance.notes.checking.words.cases_named import (
    names_another_example,
)
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Side

MOST_ROUNDED, MOST_APART = 0.05, 5
"""Of a result: what rounding may leave, and what a slip makes; a change of units makes more."""
MOST_VALUES = 4
"""Other values of letters that are tried, the nearest first."""


def with_other_values(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a refuted relation by other numbers that the page gives its letters.

    It is proved, on that condition, with those given last before it, as one reads; with any others it is
    open. None where none of them make it true.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    if k and not names(left.node):
        if _is_miscalculated(left, right, knowledge):
            return None
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


def _is_miscalculated(left: Side, right: Side, knowledge: Knowledge) -> bool:
    """Tell whether typed numbers come to another result than the one printed, by no change of units.

    2·0.071·7000/60 = 8.28 m/s is wrong, though the formula before it comes to that at another speed.
    """
    typed, printed = (number_of(side.node, knowledge) for side in (left, right))
    if typed is None or printed is None or not typed or not printed:
        return False
    ratio = abs(typed / printed)
    return abs(ratio - 1) > MOST_ROUNDED and 1 / MOST_APART < ratio < MOST_APART


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
    behind = {*names_behind(left.node, values)}
    behind -= {left.node.name} if isinstance(left.node, Name) else set()
    given = {name: _numbers_given(state, name, chain) for name in sorted(behind & values.keys())}
    wrong = {(each.name, each.line) for each in state.wrong_numbers.results}
    given = {
        n: [c for c in chains if (n, c.lines[0]) not in wrong and c.sides[1].span[0] not in state.refuted]
        for n, chains in given.items()
    }
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
    above = state.sections.chains_above(Name(name), chain.start)
    if of_case := state.sections.of_its_named_case(chain, above):
        above = of_case
    else:
        above = [c for c in above if not state.cases.is_of_case_before(c.lines[0], chain.lines[0])]
    above = [c for c in above if c not in state.ended_cases]
    of_one = [c for c in above if len(c.relations) == 1 and not names(c.sides[1].node)]
    of_several = [c for c in above if len(c.relations) > 1 and _ends_in_number(state, c)]
    given = [c for c in (*of_one, *of_several) if c.relations[-1].sign in "=≈"]
    return sorted(given, key=lambda c: -c.start)


def _ends_in_number(state: JudgingState, chain: Chain) -> bool:
    """Tell whether a chain comes to a number, T = P/ω = 142 N m, in a step that is not refuted."""
    value = chain.sides[-1]
    is_of_formula = bool(names(chain.sides[1].node)) and not names(value.node)
    return is_of_formula and value.span[0] not in state.refuted
