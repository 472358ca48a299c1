"""The order in which relations are judged: line by line, a case before what is said of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Call, Name, Number, names
from symbalance.notes.algebra.letters_in_waves import WAVES
from symbalance.notes.checking.deciding.cases import states_a_case
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.judging.premises_behind import is_worked_out_behind
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.checking.words.case_words import (
    LONGEST_PLACE,
    is_case_behind,
    is_place_behind,
    is_said_generally,
)
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re


def chains_in_turn(document: ReadNotes, sections: Sections) -> list[Chain]:
    """Return the chains by lines, on one line first what states a case: x² = 4 for x = 2.

    A result is no case (so x = 2; v = 2 s n, v = 9; k = G I/L above, k = 203; the last number of an
    equation before it), nor is the second value of a letter on one line, nor what stands behind that:
    r = 40, l = 160; r = 45, l = 150, λ = 0.3.
    """
    by_line: dict[int, list[Chain]] = {}
    for chain in document.chains:
        by_line.setdefault(chain.lines[0], []).append(chain)
    ordered: list[Chain] = []
    with_formula: set[frozenset[str]] = set()
    for line in sorted(by_line):
        first: dict[frozenset[str], Chain] = {}
        heads_above: set[frozenset[str]] = set()
        is_second, end_of_clause = False, 0
        for chain in by_line[line]:
            own = names(chain.sides[0].node)
            is_second = is_second or (own in first and states_a_case(chain))
            is_result = sections.is_consequence(chain) or own in heads_above | with_formula or is_second
            is_result = is_result or any(relation.sign == "≈" for relation in chain.relations)
            is_result = is_result or _is_led_to(document, chain, by_line[line])
            end_of_clause = _clause_opened(document, chain, by_line[line]) or end_of_clause
            is_result = is_result or chain.start < end_of_clause
            is_result = is_result or _completes_equation(document, sections, chain, by_line[line])
            is_result = is_result or _is_beside_result(document, chain, by_line[line])
            is_case = states_a_case(chain) or is_worked_out_behind(document, chain, by_line[line])
            if is_case and not is_result:
                first[own] = chain
            is_letter = isinstance(chain.sides[0].node, Name) or _asks_for_angle(chain)
            if is_letter or not any(names(s.node) for s in chain.sides[1:]):
                heads_above.add(own)
        with_formula |= {names(c.sides[0].node) for c in by_line[line] if _gives_formula(c)}
        cases = list(first.values())
        others = [c for c in by_line[line] if all(c is not case for case in cases)]
        general = _said_before_exceptions(sections, others, cases)
        others = [c for c in others if all(c is not each for each in general)]
        in_turn = [*general, *cases, *_cases_before_claims(document, others)]
        ordered += _places_before_values(document, in_turn)
    return ordered


_BUT = (
    r"(?<![^\W\d_])(?:but|however|only|aber|jedoch|doch|nur|mais|cependant|seulement|ma|però|solo|pero|sólo)"
    r"(?![^\W\d_])|ただし"
)
"""Words of an exception."""
_EXCEPT = re.compile(_BUT, re.IGNORECASE)
_ENDS = re.compile(rf"[.;!?。；]|{_BUT}", re.IGNORECASE)
"""What parts a claim from the case that is its exception."""


def _said_before_exceptions(
    sections: Sections, chains: Sequence[Chain], cases: Sequence[Chain]
) -> list[Chain]:
    """Return the inequalities that are said in general, before a case: in general x² ≠ 2x. For x = 2 …"""
    first, text = min((case.start for case in cases), default=0), sections.document.text

    def is_apart(chain: Chain) -> bool:
        if is_said_generally(sections.sentence_before(chain)):
            return _ENDS.search(text, chain.end, first) is not None
        is_unequal = {relation.sign for relation in chain.relations} == {"≠"}
        return is_unequal and _EXCEPT.search(text, chain.end, first) is not None

    inequalities = (c for c in chains if all(r.sign in SATISFIED_BY for r in c.relations))
    return [c for c in inequalities if c.end <= first and is_apart(c)]


def _gives_formula(chain: Chain) -> bool:
    """Tell whether a chain gives a letter a formula: a number of it below is a result."""
    return isinstance(chain.sides[0].node, Name) and bool(names(chain.sides[1].node))


_LEADS = re.compile(
    r"(?:gives?|yields?|leads?\s+to|(?:we|one)\s+(?:gets?|obtains?|finds?|ha(?:s|ve))|ergibt(?:\s+sich)?|liefert|folgt"
    r"|erhält(?:\s+man)?|erhalten\s+wir|donnent?|(?:on|nous)\s+(?:obtient|trouve|obtenons|trouvons)|dà|danno"
    r"|si\s+(?:ottiene|trova|ha)|resulta|da|dan|obtenemos|se\s+(?:obtiene|tiene))[\s$:(\\]*$",
    re.IGNORECASE,
)
"""Words right before a number by which it is a result."""
_LEADING = 40


def _is_led_to(document: ReadNotes, chain: Chain, row: Sequence[Chain]) -> bool:
    """Tell whether words lead to a number, but from no chain set to zero, dE/dk = 2k - 1 = 0."""
    before = max((c for c in row if c.end <= chain.start), key=lambda c: c.end, default=None)
    is_zero = before is not None and before.sides[-1].node == Number(Fraction(0))
    if before is not None and is_zero and (len(before.relations) > 1 or len(before.letters) > 1):
        return False
    return _LEADS.search(document.text, max(0, chain.start - _LEADING), chain.start) is not None


_OPENS = re.compile(
    r"[.;]\s+(?:for|with|at|if|für|mit|bei|wenn|pour|avec|si|per|con|para)\s+[$(\\]*$", re.IGNORECASE
)
"""Words that begin a clause, with a case for what stands behind it."""


_PLACE = re.compile(
    r"(?<![^\W\d_])(?:at|for|when|if|bei|für|wenn|pour|à|quand|si|per|quando|para|cuando|en)\s+[$(\\]*$",
    re.IGNORECASE,
)
"""Words right before a number at which something else is had."""


def _clause_opened(document: ReadNotes, chain: Chain, row: Sequence[Chain]) -> int:
    """Return where the clause ends that a case begins, right before what it is for; 0 for others.

    "; for x = 3, F = 45": the case is of that number alone, and of nothing before it.
    """
    text = document.text
    if _OPENS.search(text, max(0, chain.start - _LEADING), chain.start) is None:
        return 0
    end = re.search(r"[.;]\s|\n\n|$", text[chain.end :])
    last = chain.end + (end.start() if end else 0)
    return last if any(chain.end <= other.start < last for other in row) else 0


def _completes_equation(
    document: ReadNotes, sections: Sections, chain: Chain, row: Sequence[Chain]
) -> bool:
    """Tell whether a number is the last that an equation before it on its line wants.

    m_1 r_1 = m_2 r_2; with m_1 = 2 kg, r_1 = 30 mm and r_2 = 40 mm it is m_2 = 1.5 kg, a result.
    """
    head = chain.sides[0].node
    if not isinstance(head, Name) or not states_a_case(chain):
        return False
    is_place = _PLACE.search(document.text, max(0, chain.start - _LEADING), chain.start) is not None
    equations = [
        c
        for c in row
        if c.end <= chain.start
        and head.name in c.letters
        and (_is_implicit(c) or (not is_place and _is_formula_of(head, c)))
        if not (sections.is_only_if(c) or sections.is_said_to_fail(c))
    ]
    if not equations:
        return False
    given = {
        c.sides[0].node.name
        for c in document.chains
        if c.end <= chain.start and isinstance(c.sides[0].node, Name) and not names(c.sides[-1].node)
    }
    given |= {"omega"} if given & {"n", "N"} else set()  # P = T ω, and n = 3000 rpm
    return head.name not in given and any(c.letters - {head.name} <= given for c in equations)


_BESIDE = re.compile(r"[\s$,;&}]*(?:\\(?:text|mathrm)\{)?\s*(?:\\q?quad|and|und|et|y|e|と)\}?[\s$&\\,]*")
"""Between two results in a row: m_1 = m h/l = 0.17 kg, and m_2 = 0.43 kg."""


def _is_beside_result(document: ReadNotes, chain: Chain, row: Sequence[Chain]) -> bool:
    """Tell whether a number stands in a row with the result of a formula that has not its letter."""
    for before in row:
        is_next = _BESIDE.fullmatch(document.text, before.end, chain.start) is not None
        if is_next and _gives_formula(before) and chain.letters.isdisjoint(before.letters):
            return not names(before.sides[-1].node)
    return False


def _is_implicit(chain: Chain) -> bool:
    """Tell whether a relation is an equation of several letters that gives none of them."""
    is_one = len(chain.relations) == 1 and chain.relations[0].sign == "="
    are_sizes = is_one and all(names(s.node) and not isinstance(s.node, Name) for s in chain.sides)
    return are_sizes and len(chain.letters) > 1


def _is_formula_of(head: Name, chain: Chain) -> bool:
    """Tell whether a chain is the formula of another letter in which one stands: t of s = g t²/2."""
    is_one = len(chain.relations) == 1 and chain.relations[0].sign == "="
    own = chain.sides[0].node
    return is_one and isinstance(own, Name) and own != head and head.name in names(chain.sides[1].node)


def _cases_before_claims(document: ReadNotes, chains: list[Chain]) -> list[Chain]:
    """Return the chains of a line, another case before the claim it stands behind: for θ = π."""
    ordered: list[Chain] = []
    for chain in chains:
        last = ordered[-1] if ordered else None
        first, end = chain.sides[0].span[0], chain.sides[-1].span[1]
        is_behind = last is not None and is_case_behind(document.text, last.sides[-1].span[1], first, end)
        is_case = is_behind and states_a_case(chain)
        if last is not None and _asks_for_angle(last) and last.letters >= chain.letters:
            is_case = False  # the solution of the equation before
        ordered.insert(len(ordered) - 1 if is_case else len(ordered), chain)
    return ordered


_ANGLE = re.compile(r"°|\\circ|\\pi(?![A-Za-z])|π|deg|^\W*0\W*$")
"""The angle at which a value is had: at θ = 0, and not at 4200 rpm."""


def _places_before_values(document: ReadNotes, chains: list[Chain]) -> list[Chain]:
    """Return the chains of a line, where a value is had before it: F = 5 N at θ = 0 and at θ = π."""
    ordered: list[Chain] = []
    by_end: dict[int, Chain] = {}
    for chain in chains:
        start = chain.sides[0].span[0]
        near = (by_end.get(end) for end in range(start - LONGEST_PLACE, start))
        value = next((each for each in near if each and _is_at(document, each, chain)), None)
        place = len(ordered)
        if value is not None:
            place = next(n for n, each in enumerate(ordered) if each is value)
        ordered.insert(place, chain)
        by_end[chain.sides[-1].span[1]] = chain
    return ordered


def _is_at(document: ReadNotes, value: Chain, place: Chain) -> bool:
    """Tell whether a value is had at the angle that the next relation gives."""
    is_behind = is_place_behind(document.text, value.sides[-1].span[1], place.sides[0].span[0])
    are_values = is_behind and _is_value(value) and _is_value(place)
    is_angle = are_values and _ANGLE.search(document.source(place.sides[-1].span)) is not None
    return is_angle and value.letters.isdisjoint(place.letters)


def _is_value(chain: Chain) -> bool:
    """Tell whether a chain gives a letter a number: no range, u > 1."""
    return states_a_case(chain) and chain.relations[0].sign in ("=", "≈")


def _asks_for_angle(chain: Chain) -> bool:
    """Tell whether a chain gives an angle by a function of it, tan A = n: its value is a result."""
    head = chain.sides[0].node
    if not isinstance(head, Call) or head.function not in WAVES or not isinstance(head.argument, Name):
        return False
    return all(head.argument.name not in names(side.node) for side in chain.sides[1:])


def number_verdicts(verdicts: list[Verdict]) -> Iterator[Verdict]:
    """Yield the verdicts in the order of the text; `link` counts those on one line."""
    count, line = 0, 0
    for verdict in sorted(verdicts, key=lambda v: (v.line, bool(v.piece), v.span, v.link)):
        count = count + 1 if verdict.line == line else 1
        line = verdict.line
        yield replace(verdict, link=count)
