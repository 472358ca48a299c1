"""Cases that a page opens (for θ = 0): which relations leave them, and what ends with them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from symbalance.document.formula import Name, names
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.definitions import Definitions, Entry, OpenCase
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_ARROW = (
    r"(?:[⇒⟹⇔⟺]|=+>"
    r"|\\(?:Rightarrow|Longrightarrow|implies|Leftrightarrow|Longleftrightarrow|iff)(?![A-Za-z]))"
)
_ARROW_BEHIND = re.compile(rf"(?:[\s$&,;]|\\[,;: ]|\\q?quad)*{_ARROW}")
_ARROW_BEFORE = re.compile(rf"{_ARROW}(?:[\s$&]|\\[,;: ]|\\q?quad)*$")
_WE_HAVE = re.compile(
    r"[\s$)\]\\]*,?\s*(?:we\s+(?:have|get|find)|(?:one|this)\s+(?:has|gets|gives)|there\s+is|it\s+is|is"
    r"|ist|wird|gilt|hat\s+man|on\s+a|si\s+ha|se\s+tiene)?[\s$(\[\\]*(?:stem:\[)?",
    re.IGNORECASE,
)
"""Between a case and what is said of it."""
_NEAR = 30
"""Characters between an arrow and the relation it leads to."""


def past_cases(
    definitions: Definitions, line: int, angles: frozenset[str], turned: frozenset[str] = frozenset()
) -> frozenset[int]:
    """Return the lines that put an angle in, θ = 90°, whose paragraph ends before a line.

    The letters `turned` stand in sines, and nobody has declared them: what is given of them may be of the
    whole page, so that only a case is past, "at the dead centre A = 0".
    """
    entries = (e.definition for name in angles for e in definitions.values.get(name, ()))
    lines = {d.line for d in entries if d.assumption or d.numeric}
    cases = (e.definition for name in turned - angles for e in definitions.values.get(name, ()))
    lines |= {d.line for d in cases if d.assumption}
    lines |= {p.line for p in definitions.premises if p.names <= angles}
    return frozenset(case for case in lines if definitions.sections.case_end(case) < line)


def lines_of_cases(definitions: Definitions, line: int, angles: frozenset[str]) -> frozenset[int]:
    """Return the lines above that put angles in: t = 0, at θ = 90°."""
    entries = (e.definition for name in angles for e in definitions.values.get(name, ()))
    return frozenset(d.line for d in entries if d.numeric and d.line < line)


def cases_left_by(definitions: Definitions, chain: Chain, angles: frozenset[str]) -> list[OpenCase]:
    """Return the cases that a relation is claimed beyond, which is said to be true of all values."""
    if not definitions.cases:
        return []
    letters_of_cases = {name: name in angles for case in definitions.cases for name in case.letters}
    general = definitions.sections.spoken_of_generally(chain, letters_of_cases)
    return [
        case
        for case in definitions.cases
        if case.letters & general and not definitions.sections.stands_in_clause(case.start, chain)
    ]


def cases_replaced_by(definitions: Definitions, chain: Chain) -> list[OpenCase]:
    """Return the earlier cases of the letters of a relation that opens a case of its own."""
    own = chain.letters
    start = chain.start
    if not definitions.sections.opens_case(chain):
        return []
    return [case for case in definitions.cases if case.start < start and case.letters & own]


def lines_of_numbers(definitions: Definitions, letters_of_all: frozenset[str]) -> frozenset[int]:
    """Return the lines that give letters numbers; what is said of all their values rests on none."""
    entries = (entry.definition for name in letters_of_all for entry in definitions.values.get(name, ()))
    return frozenset(definition.line for definition in entries if definition.numeric)


def end_cases(definitions: Definitions, cases: list[OpenCase], start: int) -> None:
    """Forget for good the cases among these that were opened before a place in the text."""
    for case in cases:
        if case.start >= start:
            continue
        definitions.cases.remove(case)
        definitions.premises = [
            p for p in definitions.premises if not (p.line == case.line and p.names <= case.letters)
        ]
        definitions.ranges = [
            r
            for r in definitions.ranges
            if not (r.line == case.line and names(r.left) | names(r.right) <= case.letters)
        ]
        for name in case.letters & definitions.values.keys():
            definitions.values[name] = [
                e
                for e in definitions.values[name]
                if e.definition.line != case.line or not e.definition.assumption
            ]
            if not definitions.values[name]:
                del definitions.values[name]


@contextmanager
def without_cases(
    definitions: Definitions, lines: frozenset[int], angles: frozenset[str]
) -> Iterator[None]:
    """Leave out for a while what lines say of angles: a reader may have left the case."""
    apart = [p for p in definitions.premises if p.line in lines and p.names <= angles]
    definitions.premises = [p for p in definitions.premises if p not in apart]
    ranges = definitions.ranges
    definitions.ranges = [
        r for r in ranges if r.line not in lines or not names(r.left) | names(r.right) <= angles
    ]
    apart_by_name: dict[str, list[Entry]] = {}
    for name in angles & definitions.values.keys():
        entries = definitions.values.pop(name)
        apart_by_name[name] = [e for e in entries if e.definition.line in lines]
        if rest := [e for e in entries if e.definition.line not in lines]:
            definitions.values[name] = rest
    fewer = list(definitions.ranges)
    try:
        yield
    finally:
        new = [r for r in definitions.ranges if all(r is not other for other in fewer)]
        definitions.ranges = [r for r in ranges if r in definitions.ranges or r not in fewer] + new
        definitions.premises = sorted([*apart, *definitions.premises], key=lambda premise: premise.line)
        for name, entries in apart_by_name.items():
            whole = [*entries, *definitions.values.get(name, [])]
            if whole:
                definitions.values[name] = sorted(whole, key=lambda entry: entry.definition.line)


_OTHER_CASE = re.compile(
    r"(?<![^\W\d_])(?:(?:case|fall|cas|caso)\s*\(?(?:[2-9]|ii+|iv|v|[b-h]|two|three|zwei|drei)(?![^\W\d_])"
    r"|(?:second|third|other|last|zweite[nrs]?|dritte[nrs]?|andere[nrs]?)\s+(?:case|fall|range|region)"
    r"|above|below|beyond|over|under|oberhalb|unterhalb|über|unter|au-dessus|en\s+dessous|otherwise|else|conversely|umgekehrt|sonst"
    r"|if|when|for|wenn|falls|für|bei|si|pour|quand|left|right|links|rechts)(?![^\W\d_])|(?:場合|とき|なら)",
    re.IGNORECASE,
)
"""Words by which a range is that of another case than the one before."""
_CLAUSE_ENDS = re.compile(r"[.;!?]\s|[。；]|\n\s*\n")


def leave_range_of_case(state: JudgingState, chain: Chain) -> bool:
    """Forget the ranges of the case before, where a range is of the next one: above it, ω > ω_0; tell.

    What is said to follow from what stands before is of the same case.
    """
    sections, own = state.sections, chain.letters
    above = (c for c in reversed(sections.in_order) if c.end <= chain.start and c.letters == own)
    last = next((c for c in above if c.relations and c.relations[0].sign in SATISFIED_BY), None)
    if last is None or sections.is_consequence(chain):
        return False
    between = state.document.text[last.end : chain.start]
    words = f"{between} {state.document.text[chain.end : chain.end + 6]}"
    is_apart = not sections.same_section(last.lines[0], chain.lines[0])
    is_apart = is_apart or bool(_CLAUSE_ENDS.search(between) and _OTHER_CASE.search(words))
    ranges = state.definitions.ranges
    rest = [r for r in ranges if names(r.left) | names(r.right) != own] if is_apart else ranges
    state.definitions.ranges = rest
    return len(rest) < len(ranges)


def case_of_a_letter(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> bool:
    """Tell whether a range is a case, of a letter that a line above gave a number: for k < 1/2, this.

    Where the number is given as one of its own sentence, "for k = 1/3 < 1/2", the range is claimed of it.
    """
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    given = [d for name in chain.letters if (d := knowledge.definitions.get(name)) and d.numeric]
    is_supposed = len(chain.letters) == 1 and bool(given) and _leads_on(state, chain)
    if is_supposed or _is_behind_case(state, chain, knowledge):
        return True
    letters = [side for side in (left, right) if isinstance(side, Name)]
    if len(letters) != 1 or names(left) & names(right):
        return False
    if _is_varied(state, letters[0], chain):
        return True
    if len(chain.relations) != 1:
        return False
    definition = knowledge.definitions.get(letters[0].name)
    if definition is None or not definition.numeric or not state.sections.opens_case(chain):
        return False
    return definition.line < chain.lines[0] or _has_value_in_another_case(state, letters[0], chain)


def _leads_on(state: JudgingState, chain: Chain) -> bool:
    """Tell whether an arrow stands behind a range, and none before it: B > 1/2 ⇔ 1 - B < B."""
    text, before = state.document.text, state.sections.chain_before(chain.start)
    first = chain.start if before is None else before.end
    is_drawn = _ARROW_BEFORE.search(text, max(first, chain.start - _NEAR), chain.start) is not None
    return not is_drawn and _ARROW_BEHIND.match(text, chain.end) is not None


def _is_behind_case(state: JudgingState, chain: Chain, knowledge: Knowledge) -> bool:
    """Tell whether a range is said of a case right before it, of a letter that has a number above.

    After ε = 11.6°: for ε < 2° we have F < 0.035 F_0. What ε is above says nothing of it.
    """
    before = state.sections.chain_before(chain.start)
    if before is None or len(before.letters) != 1 or not before.relations:
        return False
    (letter,) = before.letters
    definition = knowledge.definitions.get(letter)
    between = state.document.text[before.end : chain.start]
    is_case = all(relation.sign in SATISFIED_BY for relation in before.relations)
    return (
        is_case
        and definition is not None
        and definition.numeric
        and definition.line < before.lines[0]
        and _WE_HAVE.fullmatch(between) is not None
        and state.sections.opens_case(before)
    )


def letters_supposed(state: JudgingState, chain: Chain) -> frozenset[str]:
    """Return the letter of a range from which an arrow leads to a relation, claimed of all its values.

    None where an arrow leads to that range too.
    """
    before = state.sections.chain_before(chain.start)
    if before is None or not before.relations or len(before.letters) != 1:
        return frozenset()
    is_range = all(relation.sign in SATISFIED_BY for relation in before.relations)
    between = state.document.text[before.end : chain.start]
    is_led_to = _ARROW_BEHIND.match(between) is not None and _leads_on(state, before)
    return before.letters if is_range and is_led_to else frozenset()


def _is_varied(state: JudgingState, letter: Name, chain: Chain) -> bool:
    """Tell whether a page gives a letter different numbers itself, as a choice: B = 0, B = 1/2, B = 0.7.

    Between numbers it is then what others choose, 0.6 < B < 0.85, and says nothing of the last one.
    """
    if state.sections.is_consequence(chain) or names(chain.sides[0].node) & names(chain.sides[-1].node):
        return False
    every = [c for c in state.sections.chains_of(letter) if c.sides[0].node == letter and c.relations]
    first = [(c.relations[0].sign, c.sides[1].node) for c in every]
    if any(sign == "≈" or (sign == "=" and names(value)) for sign, value in first):
        return False  # a result
    given = [c for c in every if sets_number(c) and c.start != chain.start]
    is_inline = all(c.inline for c in given) and chain.inline
    return is_inline and len({c.sides[1].node for c in given}) > 1


def _has_value_in_another_case(state: JudgingState, letter: Name, chain: Chain) -> bool:
    """Tell whether a letter has its value in a case before, on one line: for λ = 0 …, for λ > 0 …"""
    own = [c for c in state.sections.chains_of(letter) if c.lines[0] == chain.lines[0]]
    before = [c for c in own if c.start < chain.start]
    return bool(before) and all(state.sections.opens_case(c) for c in before)
