"""A page that looks at one angle and then at another: tan α = 1/λ here, cos α + λ cos 2α = 0 there.

A second condition on an angle, in a paragraph of its own and introduced as one ("it vanishes where"), is
not to be satisfied together with the first: it is about another angle, and what fixed the first is left.
A number that a letter has at one place, a = 5519 at top dead centre, is not its number at the next.
"""

from __future__ import annotations

from collections.abc import Callable

from symbalance.document.formula import Call, Name, Number, Product, names
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_MEANS_THE_SAME = re.compile(
    r"(?<![^\W\d_])(?:maxim|largest|greatest|highest|peak|top|smallest|minim|größt|höchst|kleinst|is|lies"
    r"|stands|occurs|liegt|ist|steht|folgt|so|thus|then|hence|also|est|vaut|donc)(?:[a-zäöü]{0,8})(?![^\W\d_])",
    re.IGNORECASE,
)
"""Words by which a number is that of the place above, and no place of its own."""


def leave_place(state: JudgingState, chain: Chain) -> bool:
    """Forget what fixed the angle of a new condition in a paragraph above; tell whether anything did."""
    sections, definitions = state.sections, state.definitions
    is_angle = is_multiple_of_angle(chain) and sections.opens_case(chain)
    is_elsewhere = sections.is_condition(chain) or sections.place_named(chain) is not None
    if len(chain.relations) != 1 or not (is_angle or is_elsewhere):
        return False
    angles = {
        name
        for side in chain.sides
        for name in (names(side.node) if is_angle else letters_in_waves(side.node))
    }
    is_past = _lines_before_sentence(state, chain, angles)
    fixing = [p for p in definitions.premises if is_past(p.line) and _is_condition_on(p, angles)]
    fixed = {name for premise in fixing for name in premise.names & angles}
    valued = {
        name
        for name in angles
        if any(
            is_past(e.definition.line) and e.definition.numeric for e in definitions.values.get(name, ())
        )
    }
    fixed |= valued if is_elsewhere else set()
    if not fixed:
        return False
    definitions.premises = [p for p in definitions.premises if not is_past(p.line) or not p.names & fixed]
    for name in fixed:
        for entry in list(definitions.values.get(name, ())):
            if is_past(entry.definition.line):
                definitions.forget(name, entry.definition.line)
    return True


def _lines_before_sentence(state: JudgingState, chain: Chain, angles: set[str]) -> Callable[[int], bool]:
    """Return what tells whether a line speaks of angles before a relation's paragraph or sentence."""
    first = state.sections.paragraph_start(chain.lines[0])
    sentence = chain.start - len(state.sections.sentence_before(chain))
    spoken = {
        c.lines[0]: c.start < sentence
        for c in state.document.chains
        if c.start < chain.start and c.letters & angles
    }
    return lambda line: line < first or spoken.get(line, False)


def leave_condition_of_place(state: JudgingState, chain: Chain) -> bool:
    """Forget where a letter is looked at, "largest at η² = 1 - 2D²", before "at η = 2"; tell of any.

    Both are introduced as cases. The next place is not one that the first equation claims anything of.
    """
    head, sections, definitions = chain.sides[0].node, state.sections, state.definitions
    is_case = len(chain.relations) == 1 and isinstance(head, Name) and not names(chain.sides[1].node)
    if not is_case or not isinstance(head, Name) or not sections.opens_case(chain):
        return False
    if _MEANS_THE_SAME.search(sections.sentence_before(chain)):
        return False
    places = [p for p in definitions.premises if head.name in p.names and p.names != {head.name}]
    places = [p for p in places if _opened_as_case(state, p, chain)]
    definitions.premises = [p for p in definitions.premises if p not in places]
    for premise in places:
        for name in premise.names:
            definitions.forget(name, premise.line)
    return bool(places)


def _opened_as_case(state: JudgingState, premise: Premise, chain: Chain) -> bool:
    """Tell whether a premise stands above in a line of its own as a case: largest at η² = 1 - 2D²."""
    above = [c for c in state.sections.chains_of(premise.left) if c.lines[0] == premise.line]
    before = [c for c in above if c.lines[-1] < chain.lines[0]]
    return bool(before) and all(state.sections.opens_case(c) for c in before)


def leave_number_of_place(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget the number that a letter has at another place, a at TDC before a at 90°; tell of any.

    Of an angle its sine may have had it: sin β = λ sin 30°, and at 60° sin β = 0.26.
    """
    head = chain.sides[0].node
    is_wave = isinstance(head, Call) and isinstance(head.argument, Name)
    letter = head.argument if is_wave and isinstance(head, Call) else head
    if k or not isinstance(letter, Name) or not state.sections.is_at_another_place(chain):
        return False
    is_known = False
    for entry in list(state.definitions.values.get(letter.name, ())):
        if entry.definition.numeric or is_wave:
            is_known |= state.definitions.forget_number(letter.name, entry.definition.line)
    return is_known


def is_multiple_of_angle(chain: Chain) -> bool:
    """Tell whether a relation gives a multiple of an angle a value: at 2θ = 126.87°."""
    left, right = chain.sides[0].node, chain.sides[-1].node
    factors = left.factors if isinstance(left, Product) else ()
    is_multiple = len(factors) == 2 and isinstance(factors[0], Number) and isinstance(factors[1], Name)
    return is_multiple and not names(right)


def _is_condition_on(premise: Premise, angles: set[str]) -> bool:
    """Tell whether an equation fixes an angle: one in its sine or cosine, or its value, or that of 2θ."""
    turning = letters_in_waves(premise.left) | letters_in_waves(premise.right)
    lone = {side.name for side in (premise.left, premise.right) if isinstance(side, Name)}
    own = names(premise.left) | names(premise.right)
    is_multiple = len(own) == 1 and own <= angles
    return len(turning & angles) == 1 == len(turning) or bool(lone & angles) or is_multiple
