"""Balances that are solved below for a letter behind their own: F_Σ + F_B = 0, from which U = ρ m R/2.

No letter of the balance is new, so nothing in it is solved for; what its letters stand for has one that
is.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from symbalance.document.formula import Formula, Name, Number, names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.declared.symbol_roles import KNOWN, role_of
from symbalance.notes.checking.page.solutions import chains_below
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.solved_below import as_solution
from symbalance.notes.checking.verdicts import CONDITION
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_SOLVED = re.compile(
    r"(?<![A-Za-z\\])(?:find|finds|gives?|get|gets|obtain|obtains|yields?|follows?|asks?\s+for|needs|requires?"
    r"|demands|leads\s+to|hence|so|thus|therefore|then|if|when|folgt|ergibt|liefert|verlangt|erfordert|also"
    r"|daher|somit|damit|erhält\s+man|wenn|falls)(?![A-Za-z])"
    r"|\\(?:Rightarrow|Longrightarrow|implies)(?![A-Za-z])|[⇒⟹]|より|から|得る|よって|したがって|ゆえに|必要"
)
LONGEST = 80
"""Characters between a balance and its solution."""


def as_balance(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return that a balance is a condition which the next line solves for a letter behind it."""
    if k or len(chain.relations) != 1 or chain.relations[0].sign != "=":
        return None
    right = chain.sides[1].node
    if not (isinstance(right, Number) and not right.value):
        return None
    following = next(chains_below(state.sections, chain), None)
    formulas = knowledge.formulas
    if following is None or not _solves(following, chain, formulas, state, knowledge):
        return None
    head, value = following.sides[0].node, following.sides[1].node
    assert isinstance(head, Name)
    solution = Definition(value, following.lines[0])
    with_solution = replace(knowledge, definitions={**formulas, head.name: solution})
    at_value = decide(chain.sides[0], chain.sides[1], "=", with_solution)
    if _is_closed(at_value, following, knowledge):
        place = following.sides[0].span[0]
        state.solutions[place] = state.definitions.premise_of(chain, 0), at_value
        state.balances.add(place)
    return Decision(CONDITION, f"solved for {plain_text(head)} below")


def _is_closed(at_value: Decision, following: Chain, knowledge: Knowledge) -> bool:
    """Tell whether a balance with its solution has no letters but that one's and the crank's sizes.

    With others, of which only words say what they are, it is neither right nor wrong. The sizes of the
    crank are declared for good: nothing further can be said of them.
    """
    if at_value.left is None or at_value.right is None:
        return at_value.is_proved
    rest = {*letters(at_value.left), *letters(at_value.right)} - names(following.sides[1].node)
    sizes = {name for name, text in knowledge.meanings.items() if role_of(text) in KNOWN}
    return rest <= {*sizes, *knowledge.angles, *knowledge.universal}


def as_balance_solution(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return the proof or refutation of what is said to solve a balance above, None for others."""
    if k or chain.sides[0].span[0] not in state.balances:
        return None
    decision, head = as_solution(state, chain, k), chain.sides[0].node
    if decision is not None and decision.is_proved and isinstance(head, Name):
        state.definitions.define(head.name, chain.sides[1].node, chain)
    return decision if decision is not None and decision.status in (PROVED, REFUTED) else None


def _solves(
    following: Chain,
    chain: Chain,
    formulas: Mapping[str, Definition],
    state: JudgingState,
    knowledge: Knowledge,
) -> bool:
    """Tell whether a chain gives a letter behind a balance a value of the others there."""
    head = following.sides[0].node
    start, end = chain.sides[-1].span[1], following.sides[0].span[0]
    between = state.document.text[start:end]
    if not isinstance(head, Name) or len(between) > LONGEST or following.relations[0].sign != "=":
        return False
    values: dict[str, Formula] = {name: d.node for name, d in formulas.items()} | dict(
        knowledge.meaning.values
    )
    behind = {*names_behind(chain.sides[0].node, values)}
    value = following.sides[1].node
    is_open = head.name not in values and head.name not in knowledge.universal
    own = {*names_behind(value, values)}
    is_of_them = own <= behind | knowledge.meanings.keys() and knowledge.angles.isdisjoint(own)
    is_open = is_open and head.name not in names(chain.sides[0].node)
    return is_open and head.name in behind and is_of_them and bool(_SOLVED.search(between))
