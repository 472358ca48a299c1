"""Letters that stand still above and swing here: θ_1 + θ_2 = T/k, and below I_1 θ̈_1 + k(θ_1 - θ_2) = 0.

The twist of a loaded shaft is one thing, the angle of a swinging disc in another section is another one:
what fixes the first says nothing of the second. A stiffness k = T/θ = G J/L is the same whatever θ is,
so that it keeps the formula without θ. What moves as an engine has it may stand still or swing here:
m ẍ + k x = 0 is no equation of the piston whose x another section has by the crank angle.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from symbalance.document.formula import Derivative, Formula, Name, Sum, children, names, parts_of_kind
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.checking.deciding.knowledge import Definition
from symbalance.notes.checking.declared.symbol_roles import MOVING, role_of
from symbalance.notes.checking.premises.definitions import Entry
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain

_TIME = "t"
_TURNING = frozenset({*MOVING, "crank angle"})
"""Roles of letters that move in any engine, so that what they say of others is said of every moment."""


def leave_letters_at_rest(state: JudgingState, chain: Chain, k: int) -> None:
    """Forget what another section has a letter be that swings here, and formulas of what rests on it."""
    if k:
        return
    moving = {name for side in chain.sides for name in _moved(side.node)}
    swinging = _swinging(chain)
    for name in sorted(moving):
        _leave_formulas_of(state, name, chain)
        _forget_at_rest(state, name, chain, of_any_motion=name in swinging)


def _moved(node: Formula) -> Iterator[str]:
    """Yield the letters that a formula differentiates by the time."""
    for part in parts_of_kind(node, Derivative):
        if isinstance(part.expression, Name) and part.variable == Name(_TIME):
            yield part.expression.name


def _swinging(chain: Chain) -> frozenset[str]:
    """Return the letters of an equation that have a second rate in it, and stand there themselves."""
    if len(chain.relations) != 1 or chain.relations[0].sign != "=":
        return frozenset()
    sides = [side.node for side in chain.sides]
    twice = {
        part.expression.name
        for node in sides
        for part in parts_of_kind(node, Derivative)
        if isinstance(part.expression, Name) and part.variable == Name(_TIME) and part.order > 1
    }
    return frozenset(name for name in twice if any(_stands_bare(node, name) for node in sides))


def _stands_bare(node: Formula, name: str) -> bool:
    """Tell whether a letter stands in a formula otherwise than differentiated."""
    if isinstance(node, Derivative):
        return False
    return node == Name(name) or any(_stands_bare(part, name) for part in children(node))


def _forget_at_rest(state: JudgingState, name: str, chain: Chain, *, of_any_motion: bool) -> None:
    line, definitions, sections = chain.lines[0], state.definitions, state.sections
    entries = definitions.values.get(name, [])
    of_any_motion &= role_of(state.declarations.symbols_at(line).get(name, "")) not in _TURNING
    kept = [
        e
        for e in entries
        if e.definition.numeric
        or sections.same_section(e.definition.line, line)
        or (not of_any_motion and _moves(state, e.definition, line))
    ]
    if len(kept) == len(entries):
        return
    definitions.values.pop(name)
    if kept:
        definitions.values[name] = kept
    gone = {e.definition.line for e in entries} - {e.definition.line for e in kept}
    definitions.premises = [p for p in definitions.premises if p.line not in gone or name not in p.names]


def _moves(state: JudgingState, definition: Definition, line: int) -> bool:
    """Tell whether a formula changes with the time, or with what is differentiated anywhere.

    θ_1 = T/k - θ_2 does not, though both swing elsewhere: it was solved for, and has a load that stands.
    """
    node = definition.node
    values = {n: d.node for n, d in state.definitions.at(line).items()}
    behind = names_behind(node, values)
    formulas = (node, *(values[n] for n in behind if n in values))
    if _TIME in behind or any(any(parts_of_kind(each, Derivative)) for each in formulas):
        return True
    symbols = state.declarations.symbols_at(line)
    turning = {n for n, text in symbols.items() if role_of(text) in _TURNING}
    turning |= state.motions.turning(line) | {n for each in formulas for n in letters_in_waves(each)}
    if not turning.isdisjoint(behind):
        return True
    swinging = {each.name for each in state.motions.differentiated}
    terms = node.terms if isinstance(node, Sum) else (node,)
    if definition.solved:
        return all(not swinging.isdisjoint(names(term)) for term in terms)
    return not swinging.isdisjoint(behind)


def _leave_formulas_of(state: JudgingState, name: str, chain: Chain) -> None:
    """Give letters that a line above has in two forms, k = T/θ = G J/L, the one without a letter."""
    for other, entries in state.definitions.values.items():
        for n, entry in enumerate(entries):
            if name not in names(entry.definition.node) or entry.definition.line >= chain.lines[0]:
                continue
            if (node := _form_without(state, other, name, entry)) is not None:
                entries[n] = replace(entry, definition=replace(entry.definition, node=node))


def _form_without(state: JudgingState, letter: str, name: str, entry: Entry) -> Formula | None:
    """Return what a letter is by a later side of the line that defines it, without another letter."""
    own = [c for c in state.sections.chains_of(Name(letter)) if c.lines[0] == entry.definition.line]
    sides = [side for c in own for side in c.sides[2:] if c.sides[1].node == entry.definition.node]
    sound = [s.node for s in sides if s.span[0] not in state.refuted and names(s.node)]
    return next((node for node in sound if name not in names(node)), None)
