"""Letters that a section uses as plain numbers, though another section defined them as lengths or forces.

z = r cos φ + l cos β is the place of a piston; under another heading cos(z sin φ) = J_0(z) + 2 Σ … is of
any number z. Where a relation's only letter with a unit is such a one, and makes it meaningless, it is
another letter.
"""

from __future__ import annotations

from symbalance.document.formula import Summation, names, walk
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain

_WITHOUT_UNIT = ("crank angle", "rod angle", "integer")


def numbers_of_this_section(sections: Sections, chain: Chain, knowledge: Knowledge) -> frozenset[str]:
    """Return the one letter with a value in a relation, if another section gave it that.

    A declared letter is what it is declared to be, and beside others with units any of them may be wrong.
    """
    own = frozenset(name for side in chain.sides for name in names(side.node))
    bound = {
        part.index.name
        for side in chain.sides
        for part in walk(side.node)
        if isinstance(part, Summation) and part.index is not None
    }
    free = {n for n in own - bound if role_of(knowledge.meanings.get(n, "")) not in _WITHOUT_UNIT}
    known = {n for n in free if n in knowledge.meanings or n in knowledge.definitions}
    if len(known) != 1:
        return frozenset()
    (name,) = known
    definition = knowledge.definitions.get(name)
    if name in knowledge.meanings or definition is None or definition.numeric:
        return frozenset()
    is_elsewhere = not sections.same_section(definition.line, chain.lines[0])
    return frozenset(known) if is_elsewhere else frozenset()
