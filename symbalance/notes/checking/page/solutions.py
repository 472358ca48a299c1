"""An equation that is solved in the lines below it: 2c² + ρ c - 1 = 0, so c = (-ρ + √(ρ² + 8))/4.

c is cos θ by what stands before or between, and the equation is true of no angle but one: it claims
nothing of all of them. What it comes to with the solution put in is the verdict on that line.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from symbalance.document.formula import Call, Formula, Name, names, walk
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.letters_in_waves import WAVES
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

NEAR = 4
"""Lines below an equation in which its solution is looked for."""
LONGEST_ARROW = 40
"""Characters behind an equation in which the arrow to its solution stands."""
_SOLVED_NEXT = re.compile(
    r"(?:[\s,;]|\\[,;: ]|\\q?quad(?![A-Za-z]))*"
    r"(?:\\(?:Rightarrow|Longrightarrow|implies)(?![A-Za-z])|[⇒⟹])"
)
"""What stands behind an equation whose solution follows."""

_SOLVED_IN_WORDS = re.compile(
    r"(?:[\s,;$]|\\[,;: ])*(?:also|so|hence|thus|therefore|which\s+gives|giving|somit|daher|folglich"
    r"|mithin|damit|demnach|donc|d'où)(?![A-Za-z])(?:[^\W\d]|[ ,$\n-]){0,50}",
    re.IGNORECASE,
)
"""Words of the same sentence that lead from an equation to its solution."""


_THAT_IS = re.compile(
    r"(?:[\s,;$]|\\[(),;: ])*"
    r"(?:(?:that\s+is|i\.\s?e\.|so|hence|thus|d\.\s?h\.|also|somit|c'est-à-dire|donc|すなわち|よって)"
    r"(?:[\s,:$]|\\[(,;: ])*)?"
)
"""What may stand between an equation and its solution that leaves no room for another meaning."""
_SENTENCE_ENDS = re.compile(r"(?<!\b[A-Za-z])[.;!?。](?:\s|$)|\n\s*\n")


def chains_below(sections: Sections, chain: Chain) -> Iterator[Chain]:
    """Yield the chains that follow one in the text, in its order, as far as they stand near."""
    start = chain.sides[-1].span[0]
    for other in sections.chains_behind(start):
        if other.lines[0] > chain.lines[-1] + NEAR:
            return
        yield other


def solution_behind_arrow(sections: Sections, chain: Chain, knowledge: Knowledge) -> Chain | None:
    """Return the chain that gives an equation's solution behind an arrow, None where none does."""
    behind = sections.document.text[chain.sides[1].span[1] :][:LONGEST_ARROW]
    other = next(chains_below(sections, chain), None)
    if other is None or len(chain.relations) != 1 or not _SOLVED_NEXT.match(behind):
        return None
    return other if _may_be_solved_for(other, chain, knowledge) else None


def solution_behind_words(sections: Sections, chain: Chain, knowledge: Knowledge) -> Chain | None:
    """Return the chain that gives an equation's solution in the same sentence: 2n/60 = f, so n = 30 f."""
    other = next(chains_below(sections, chain), None)
    if other is None or len(chain.relations) != 1:
        return None
    between = sections.document.text[chain.sides[1].span[1] : other.sides[0].span[0]]
    is_next = _SOLVED_IN_WORDS.fullmatch(between) is not None
    return other if is_next and _may_be_solved_for(other, chain, knowledge) else None


def solution_in_sentence(sections: Sections, chain: Chain, knowledge: Knowledge) -> Chain | None:
    """Return the chain of the same sentence that gives the solution of a balance: cos(2γ - σ) = 0, σ = …

    Other forms of the balance may stand between them.
    """
    if len(chain.relations) != 1 or names(chain.sides[1].node) or not names(chain.sides[0].node):
        return None
    text, place = sections.document.text, chain.sides[1].span[1]
    own = names(chain.sides[0].node)
    for other in chains_below(sections, chain):
        if _SENTENCE_ENDS.search(text, place, other.sides[0].span[0]):
            return None
        if _may_be_solved_for(other, chain, knowledge):
            value = names(other.sides[1].node)
            return other if value and value <= own else None
        if names(other.sides[1].node) or names(other.sides[0].node) != own:
            return None
        place = other.sides[-1].span[1]
    return None


def is_said_to_solve(sections: Sections, other: Chain, chain: Chain) -> bool:
    """Tell whether a chain stands right behind an equation, as what it comes to: that is, σ = γ."""
    text = sections.document.text[chain.sides[1].span[1] : other.sides[0].span[0]]
    return _THAT_IS.fullmatch(text) is not None


def _may_be_solved_for(other: Chain, chain: Chain, knowledge: Knowledge) -> bool:
    head = other.sides[0].node
    own = names(chain.sides[0].node) | names(chain.sides[1].node)
    return (
        isinstance(head, Name)
        and other.relations[0].sign == "="
        and head.name not in names(other.sides[1].node)
        and head.name in own - knowledge.universal
    )


def solution_below(sections: Sections, chain: Chain, knowledge: Knowledge) -> Chain | None:
    """Return the chain that solves an equation of one letter that turns with an angle, and constants.

    It is true of single angles only, whoever solves it. None for others, and where no line solves it.
    """
    if len(chain.relations) != 1 or chain.relations[0].sign != "=":
        return None
    own = names(chain.sides[0].node) | names(chain.sides[1].node)
    values = {name: definition.node for name, definition in knowledge.definitions.items()}
    for other in chains_below(sections, chain):
        head, value = other.sides[0].node, other.sides[1].node
        if not _may_be_solved_for(other, chain, knowledge) or not isinstance(head, Name):
            break
        if names(value) <= own:
            is_solution = bool(names(value)) and _is_of_one_moment(own, head.name, values, knowledge)
            return other if is_solution else None
        values.setdefault(head.name, value)  # where c = cos θ: what the letter is
    return None


def _is_of_one_moment(
    own: frozenset[str], name: str, values: Mapping[str, Formula], knowledge: Knowledge
) -> bool:
    """Tell whether of all letters one turns with an angle: what it stands for is a wave."""
    if name not in values:
        return False
    calls = [part for part in walk(values[name]) if isinstance(part, Call) and part.function in WAVES]
    turning = {letter for call in calls for letter in names(call.argument)}
    turning |= knowledge.angles & {*names_behind(values[name], values)}
    others = own - {name}
    still = {letter for other in others for letter in names_behind(Name(other), values)}
    return bool(turning) and still.isdisjoint(turning | knowledge.moving)
