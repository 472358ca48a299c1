"""The equations a page takes as given, solved together for the letters of a relation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from symbalance.document.formula import Formula, Name, Negative, Product, Sum, children, names
from symbalance.notes.algebra.letters_behind import letters_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.premises.constraints import letter_counts
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.premises.system import (
    EVERYWHERE,
    Premise,
    eliminate,
    has_decimals,
    nonzero_texts,
    related,
)


@dataclass(frozen=True, slots=True)
class Solved:
    """What is known with premises solved, and the premises that no letter could be solved from."""

    knowledge: Knowledge
    leftover: tuple[Premise, ...]
    premises: tuple[Premise, ...] = ()


def solve_premises(
    definitions: Definitions, nodes: Sequence[Formula], line: int, knowledge: Knowledge
) -> Solved | None:
    """Return what is known with the premises that formulas are connected with solved together.

    None where there are none beside those that fix a letter each, or they contradict each other.
    """
    premises = related(definitions.premises_at(line), nodes, knowledge)
    if all(p.fixes and _is_in_effect(p, knowledge) for p in premises):
        return None
    result = eliminate(premises, knowledge)
    if not result.is_consistent:
        return None
    texts = (*dict.fromkeys(p.text for p in premises), *nonzero_texts(result))
    known = replace(knowledge, solved=result.values, solved_from=texts)
    return Solved(known, result.leftover, tuple(premises))


def _is_in_effect(premise: Premise, knowledge: Knowledge) -> bool:
    """Tell whether the letter that a premise fixes still has its value from there."""
    definition = knowledge.definitions.get(premise.fixes)
    return definition is not None and definition.line == premise.line


def concerns(solved: Solved, decision: Decision) -> bool:
    """Tell whether what could not be solved has letters of the two sides that were compared.

    An angle is free in what has other letters too, and what a letter of its own satisfies, T_i in
    T_i ω = -m a v, says nothing of the others.
    """
    if decision.left is None or decision.right is None:
        return True
    own = {*letters(decision.left), *letters(decision.right)}
    values = {n: d.node for n, d in solved.knowledge.definitions.items()}
    values = {**values, **solved.knowledge.meaning.values, **solved.knowledge.solved}
    free = solved.knowledge.universal
    for p in solved.leftover:
        behind = {name for node in (p.left, p.right) for name in letters_behind(node, values)}
        if not behind <= free:
            behind -= free
        others = {n for other in solved.premises if other is not p for n in other.names}
        private = p.names - others - own - free - solved.knowledge.meaning.values.keys()
        if own & behind and not any(_is_factor_once(p, name) for name in private):
            return True
    return False


def _is_factor_once(premise: Premise, name: str) -> bool:
    """Tell whether a letter stands once in an equation, in a product or sum: it can always satisfy it."""
    node = premise.left if name in names(premise.left) else premise.right
    if letter_counts(premise.left)[name] + letter_counts(premise.right)[name] != 1:
        return False
    while isinstance(node, Product | Sum | Negative):
        node = next(part for part in children(node) if name in names(part))
    return isinstance(node, Name)


def solve_without_scope(
    definitions: Definitions, nodes: Sequence[Formula], line: int, knowledge: Knowledge
) -> Solved | None:
    """Return what would be known if what holds to the end of its section held further.

    A line below the next heading may still rest on it: it is not refuted then.
    """
    past = [
        p
        for p in definitions.premises
        if p.last_line < line and definitions.reaches(p.line, line, p.names) and not has_decimals(p)
    ]
    for name, entries in definitions.values.items():
        last = entries[-1]
        is_ended = last.last_line is not None and last.last_line < line
        if is_ended and definitions.sections.section_end(last.definition.line) >= line:
            continue  # the item ended that looked at one angle
        if is_ended and not decimals(last.definition.node) and name not in knowledge.definitions:
            own = last.definition
            past.append(Premise(Name(name), own.node, own.line, last.last_line or EVERYWHERE))
    own_past = related(past, nodes, knowledge)
    if not own_past:
        return None
    premises = related([*definitions.premises_at(line), *own_past], nodes, knowledge)
    result = eliminate(premises, knowledge)
    if not result.is_consistent:
        return None
    texts = tuple(dict.fromkeys(p.text for p in premises))
    known = replace(knowledge, solved=result.values, solved_from=texts)
    return Solved(known, result.leftover, tuple(p for p in premises if p in own_past))
