"""A relation where a page's datum holds that no letter was solved from: l = 140 mm, where l is n r.

A size that is declared through others, the rod's length n r, gets its number as an equation in those. For
one of them it is solved here, and the relation is decided with that: what it says of r and n together may
make a line in numbers true, and it saves no line that is wrong for all r and n with this product.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Formula, Name, names
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.premises.constraints import letter_counts, solve_for
from symbalance.notes.checking.premises.solved_premises import Solved
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.reading.equations import Side


def decide_with_sizes(left: Side, right: Side, sign: str, solved: Solved) -> Decision | None:
    """Return the decision on a relation with the sizes that are left over put in; None where it is open.

    Only numbers of letters that the geometry is written in are such sizes, and each is solved for a
    letter of its own. What moves is none: an acceleration that is 0 at one place makes no radius 0.
    """
    values: dict[str, Formula] = {}
    for premise in solved.leftover:
        pair = _solved_size(premise, solved, values)
        if pair is None:
            return None
        values[pair[0]] = pair[1]
    knowledge = solved.knowledge
    texts = tuple(dict.fromkeys((*knowledge.solved_from, *(p.text for p in solved.leftover))))
    known = replace(knowledge, solved={**knowledge.solved, **values}, solved_from=texts)
    decision = decide(left, right, sign, known)
    return decision if decision.is_proved or decision.status == REFUTED else None


def _solved_size(
    premise: Premise, solved: Solved, others: dict[str, Formula]
) -> tuple[str, Formula] | None:
    """Return a letter and its value by a datum on a size, l = 0.14 as n = 0.14/r; None for any other."""
    size, value, meaning = premise.left, premise.right, solved.knowledge.meaning.values
    if not isinstance(size, Name) or names(value) or size.name not in meaning:
        return None
    if size.name in solved.knowledge.moving:
        return None
    written = meaning[size.name]
    own = letter_counts(written)
    taken = solved.knowledge.solved.keys() | others.keys() | meaning.keys()
    for name in sorted(own, key=lambda n: (n not in solved.knowledge.universal, n)):
        is_free = own[name] == 1 and name not in taken and not own.keys() & others.keys()
        result = solve_for(written, value, name) if is_free else None
        if result is not None:
            return name, result
    return None
