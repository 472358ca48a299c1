"""Cases side by side: Engine A with s = 88 mm, then Engine B with s = 84 mm, each with its own results.

Which case a line stands in decides which data are in force. Two parts of a page that are opened alike are
cases if the second gives the letters of the first numbers anew: its data, and what follows from them.
There the numbers of the case before hold no longer, nor do its results; the formulas in letters do, and
so does what the second case does not give anew.

A list of data opens a case too, whatever stands before it: m = 0.52 kg, r = 41 mm, l = 144 mm after the
0.50 kg, 40 mm and 140 mm of the first engine. Where it gives F = 2400 N, and nothing that F = m r ω²
rests on, then m, r and ω are those of the case before, and unknown in its own.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass, field, replace
from functools import cached_property

from symbalance.document.formula import Formula, Name, names
from symbalance.document.formula import Number as Digits
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.meant.given_numbers import GivenNumbers
from symbalance.notes.checking.premises.another_prefix import is_in_another_prefix
from symbalance.notes.checking.premises.another_value import NEARLY
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.words.case_markers import CaseMark, case_marks
from symbalance.notes.checking.words.cases_named import names_another_example, names_next_example
from symbalance.notes.checking.words.lists_of_data import lists_of_data
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.checking.words.worked_out import is_worked_out
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

MOST = 30
"""Parts before one with which it is compared."""
FEWEST = 2
"""Letters in common, or sizes in words, by which parts without a name are cases."""
_SIZE_IN_WORDS = re.compile(
    r"(?<![\w$])(?P<what>[^\W\d_]{3,20})\s(?:of\s|is\s|von\s|=\s)?\$?(?P<size>[0-9]+(?:[.,][0-9]+)?)"
    r"(?:[\s~$]|\\,){0,3}(?:mm|cm|m|kg|g|rpm|min|1/min|k?N|kW|bar|°|Hz|cc)(?![A-Za-z])"
)

_ALIKE = 1e-9
"""By which numbers differ that are the same in other units."""
_DIGITS = re.compile(r"[0-9]+(?:[.,][0-9]+)*")


@dataclass(frozen=True, slots=True)
class Number:
    """A number that a case gives a letter, or a word for it."""

    text: str
    value: str
    is_datum: bool
    line: int
    node: Formula | None = None
    """The number itself, None of one in words."""


@dataclass
class CasePart:
    """What a mark opens: its lines, and the numbers it gives letters first, in their order."""

    mark: CaseMark
    last: int
    numbers: dict[str, Number] = field(default_factory=dict)
    zeros: set[str] = field(default_factory=set)
    """Letters that it looks at where they are 0."""
    given: frozenset[str] = frozenset()
    """The letters of the list of data that opens it, none where a mark does."""
    results: frozenset[str] = frozenset()
    """Those of them that have a formula above."""
    is_another: bool = False
    """Whether the words before the list name another example, or another engine."""

    @property
    def data(self) -> dict[str, Number]:
        """The numbers that follow from nothing."""
        return {name: number for name, number in self.numbers.items() if number.is_datum}


@dataclass
class CasesSideBySide:
    """The cases of a page, and the one that was entered last."""

    document: ReadNotes
    sections: Sections
    data: Sequence[Chain] = ()
    _entered: int = 0
    _by_line: dict[int, list[tuple[CasePart, list[CasePart]]]] = field(default_factory=dict)

    def enter(self, line: int, definitions: Definitions, given: GivenNumbers) -> None:
        """End the numbers of the cases before where a line is the first of the next case."""
        while self._entered < len(self.cases) and self.cases[self._entered][0].mark.line <= line:
            part, earlier = self.cases[self._entered]
            changed = _end_numbers(part, earlier, definitions)
            if part.given:
                given.end(changed, earlier[0].mark.line)
            self._entered += 1

    def line_replaced(self, name: str, line: int) -> int | None:
        """Return the line of the case before whose number of a letter the case of a line gives anew."""
        for part, earlier in self._cases_at(line):
            if name in part.data:
                lines = [p.numbers[name].line for p in earlier if name in p.numbers]
                return lines[-1] if lines else None
        return None

    def is_of_case_before(self, earlier_line: int, line: int) -> bool:
        """Tell whether a line is of a case before the one that another line stands in."""
        return any(
            p.mark.line <= earlier_line <= p.last for _, earlier in self._cases_at(line) for p in earlier
        )

    def gives_all_anew(self, letters: Set[str], line: int) -> bool:
        """Tell whether the case of a line gives all those letters numbers that the case before gave."""
        for part, earlier in self._cases_at(line):
            own = letters & earlier[-1].numbers.keys()
            return bool(own) and own <= part.numbers.keys()
        return False

    def _cases_at(self, line: int) -> list[tuple[CasePart, list[CasePart]]]:
        """Return the cases that a line stands in, with those before each."""
        if line not in self._by_line:
            self._by_line[line] = [c for c in self.cases if c[0].mark.line <= line <= c[0].last]
        return self._by_line[line]

    @cached_property
    def cases(self) -> list[tuple[CasePart, list[CasePart]]]:
        """The parts that are a case beside others before them, with those."""
        cases: list[tuple[CasePart, list[CasePart]]] = []
        for parts in self._groups():
            group = [part for part in parts if part.numbers]
            for n, part in enumerate(group):
                before = group[max(0, n - MOST) : n]
                earlier = [p for p in before if p.mark.label != part.mark.label]
                is_beside = _has_other_data if part.given else _is_case_beside
                if any(is_beside(p, part) for p in earlier):
                    cases.append((part, earlier))
        return sorted(cases, key=lambda case: case[0].mark.line)

    def _groups(self) -> Iterator[list[CasePart]]:
        """Yield the parts that are opened alike, without a mark of a higher kind between them."""
        lines = self.document.text.split("\n")
        marks = list(case_marks(lines, self.sections.heading_lines))
        by_shape: dict[tuple[str, int], list[CaseMark]] = {}
        for mark in marks:
            home = 1 if mark.shape.startswith("heading") else self.sections.section_start(mark.line)
            by_shape.setdefault((mark.shape, home), []).append(mark)
        for (shape, _), alike in by_shape.items():
            if len(alike) > 1:
                yield self._parts(shape, alike, marks, len(lines))
        yield list(self._lists(len(lines)))

    def _parts(
        self, shape: str, alike: list[CaseMark], marks: list[CaseMark], last: int
    ) -> list[CasePart]:
        """Return the parts that marks of one shape open, with their numbers."""
        ends: list[int] = [mark.line - 1 for mark in alike[1:]]
        is_heading = shape.startswith("heading")
        ends.append(last if is_heading else self.sections.section_end(alike[-1].line))
        if is_heading:
            higher = [
                m.line for m in marks if m.shape.startswith("heading") and _level(m.shape) < _level(shape)
            ]
            ends = [
                min([e, *(h - 1 for h in higher if h > a.line)]) for e, a in zip(ends, alike, strict=True)
            ]
        elif shape == "bullet":
            ends = [min(e, self.sections.paragraph_end(a.line)) for e, a in zip(ends, alike, strict=True)]
        parts = [CasePart(mark, end) for mark, end in zip(alike, ends, strict=True)]
        for part in parts:
            part.numbers = dict(self._numbers(part))
        return parts

    def _lists(self, last: int) -> Iterator[CasePart]:
        """Yield what lists of data open, each up to the next one; one within a line opens nothing."""
        chains_on = self.sections.chains_on
        lists = [
            own
            for own in self._lists_of_data
            if own[0] is min(chains_on(own[0].lines[0]), key=lambda c: c.start)
        ]
        ends = [own[0].lines[0] - 1 for own in lists[1:]]
        for own, end in zip(lists, [*ends, last], strict=False):
            line, start = own[0].lines[0], own[0].start
            heads = {head.name for c in own if isinstance(head := c.sides[0].node, Name)}
            results = {name for name in heads if self._has_formula(name, start)}
            mark = CaseMark(line, "list", str(start), is_named=False)
            words = self.sections.sentence_leading_to(own[0])
            part = CasePart(mark, end, given=frozenset(heads), results=frozenset(results))
            part.is_another = names_another_example(words) or names_next_example(words)
            part.numbers = dict(self._numbers(part))
            yield part

    def is_in_list_of_data(self, chain: Chain) -> bool:
        """Tell whether a relation gives one of the numbers of a list of data."""
        return any(chain is each for own in self._lists_of_data for each in own)

    @cached_property
    def _lists_of_data(self) -> list[list[Chain]]:
        lists = lists_of_data(self.document.text, self.sections.in_order)
        return [own for own in lists if not self.sections.is_consequence(own[0])]

    def _has_formula(self, name: str, before: int) -> bool:
        """Tell whether a letter has a formula in letters somewhere above a place."""
        above = self.sections.chains_above(Name(name), before)
        return any(names(side.node) for chain in above for side in chain.sides[1:])

    def _numbers(self, part: CasePart) -> Iterator[tuple[str, Number]]:
        """Yield the letters to which a part gives a number, each once, and the sizes it has in words."""
        given: dict[str, tuple[int, Number]] = {}
        start, end = self.sections.start_of_line(part.mark.line), self.sections.end_of_line(part.last)
        first, stop = bisect_left(self._lines, part.mark.line), bisect_right(self._lines, part.last)
        own = self._chains[first:stop]
        for chain in own:
            head, value = chain.sides[0].node, chain.sides[-1]
            if not isinstance(head, Name) or names(value.node) or head.name in given:
                continue
            is_zero = isinstance(value.node, Digits) and not value.node.value
            if is_zero and self.sections.is_condition(chain):
                part.zeros.add(head.name)  # where a = 0 is no datum of a case
                continue
            source = self.document.source(chain.sides[1].span).strip()
            result = self.document.source(value.span).strip()
            is_datum = _is_datum(chain, source) and not self.sections.is_consequence(chain)
            number = Number(source, result, is_datum, chain.lines[0], value.node)
            given[head.name] = (chain.start, number)
        for match in _SIZE_IN_WORDS.finditer(self.document.text, start, end):
            if not any(c.start <= match.start() < c.end for c in own[:MOST]):
                word = f"in words: {match['what'].lower()}"
                line = self.document.line_of(match.start())
                given.setdefault(word, (match.start(), Number(match["size"], match["size"], True, line)))
        for name, (_, number) in sorted(given.items(), key=lambda item: item[1][0]):
            yield name, number

    @cached_property
    def _chains(self) -> list[Chain]:
        chains = [c for c in (*self.document.chains, *self.data) if c.relations]
        return sorted(chains, key=lambda c: (c.lines[0], c.start))

    @cached_property
    def _lines(self) -> list[int]:
        return [chain.lines[0] for chain in self._chains]


def _level(shape: str) -> tuple[int, str]:
    """Return how deep a heading is, by its mark; marks of several kinds are not compared."""
    mark = shape.removeprefix("heading ")
    names_of_levels = (
        "part",
        "chapter",
        "section",
        "subsection",
        "subsubsection",
        "paragraph",
        "subparagraph",
    )
    if mark in names_of_levels:
        return names_of_levels.index(mark), ""
    return (int(mark[-1]), "") if mark[-1].isdigit() else (len(mark), "")


def _is_datum(chain: Chain, source: str) -> bool:
    """Tell whether a relation gives one number that is not worked out: 84 mm, 2·10⁵ N/m."""
    is_single = len(chain.relations) == 1 and not names(chain.sides[1].node)
    return is_single and not is_worked_out(source)


def _is_case_beside(earlier: CasePart, part: CasePart) -> bool:
    """Tell whether a part gives anew what an earlier one gave: its own data, and another number."""
    common = [name for name in part.numbers if name in earlier.numbers]
    if part.mark.is_named and earlier.mark.is_named:
        given = [n for n in common if part.numbers[n].is_datum or is_worked_out(part.numbers[n].text)]
        return any(_is_other(earlier.numbers[n], part.numbers[n]) for n in given)
    first = next(iter(part.numbers), None)
    alike = [name for name in common if _are_given_alike(earlier.numbers[name], part.numbers[name])]
    if first not in alike or len(common) < FEWEST:
        return False
    return any(_is_other(earlier.numbers[n], part.numbers[n]) for n in alike)


def _has_other_data(earlier: CasePart, part: CasePart) -> bool:
    """Tell whether a list of data is of another case than an earlier one.

    It has another number for what follows from nothing, and for a second letter, or far from the first:
    one number of a list that is nearly as before may be a slip. Words that name another example say it.
    """
    common = [name for name in part.given if name in earlier.numbers and name in part.numbers]
    gaps = {name: _gap(earlier.numbers[name], part.numbers[name]) for name in common}
    other = {name for name, gap in gaps.items() if gap > _ALIKE}
    data = {name for name in other - part.results if earlier.numbers[name].is_datum}
    if part.is_another:
        return bool(other)
    return bool(data) and (len(other) > 1 or any(gaps[name] > NEARLY for name in data))


def _gap(first: Number, second: Number) -> float:
    """Return by what part of the larger one two numbers differ, 0 where only their prefix does."""
    if first.node is None or second.node is None or is_in_another_prefix(first.node, second.node):
        return 0.0
    points = sample_trees([first.node, second.node], SymbolValue(), 1)
    if not points:
        return 0.0
    old, new = (complex(value) for value in points[0][1])
    return abs(old - new) / max(abs(old), abs(new)) if old != new else 0.0


def _is_other(first: Number, second: Number) -> bool:
    """Tell whether two numbers differ, or are worked out from others."""
    both = is_worked_out(first.text) and is_worked_out(second.text)
    return first.value != second.value or (both and first.text != second.text)


def _are_given_alike(first: Number, second: Number) -> bool:
    """Tell whether two numbers are both data, or both worked out in the same way: 2π·3000/60."""
    if first.is_datum or second.is_datum:
        return first.is_datum and second.is_datum
    is_same = _DIGITS.sub("#", first.text) == _DIGITS.sub("#", second.text)
    return is_same and is_worked_out(first.text)


def _end_numbers(part: CasePart, earlier: Sequence[CasePart], definitions: Definitions) -> frozenset[str]:
    """End the numbers of earlier cases that a part gives anew, and what follows from them.

    The letters of those numbers are returned. Below a list of data a number is given anew by the list, or
    where it is worked out.
    """
    last, numbers = part.mark.line - 1, part.numbers
    if part.given:
        numbers = {n: each for n, each in numbers.items() if n in part.given or is_worked_out(each.text)}
    before = {name: [p.numbers[name] for p in earlier if name in p.numbers] for name in numbers}
    changed = {
        name
        for name, number in numbers.items()
        if not before[name] or any(_is_other(each, number) for each in before[name])
    } - part.zeros
    formulas = {
        name: entry.definition.node
        for name, entries in definitions.values.items()
        for entry in entries
        if names(entry.definition.node)
    }
    for name in part.results & changed & formulas.keys():
        behind = {*names_behind(formulas[name], formulas)}
        if before[name] and behind.isdisjoint(part.given):
            changed |= behind  # what it rests on is of the case before

    def is_replaced(name: str, line: int) -> bool:
        if not any(p.mark.line <= line <= p.last for p in earlier):
            return False
        formula = formulas.get(name)
        behind = set() if formula is None else {*names_behind(formula, formulas)}
        return name in changed or (name not in part.zeros and not behind.isdisjoint(changed))

    for name, entries in definitions.values.items():
        for n, entry in enumerate(entries):
            if not is_replaced(name, entry.definition.line):
                continue
            if entry.definition.numeric:
                entries[n] = replace(entry, last_line=min(last, entry.last_line or last))
            elif entry.definition.rounded is not None:  # r = s/2 = 38 is s/2 here
                entries[n] = replace(entry, definition=replace(entry.definition, rounded=None))
    definitions.premises = [
        replace(p, last_line=min(last, p.last_line))
        if not names(p.right) and any(is_replaced(name, p.line) for name in p.names)
        else p
        for p in definitions.premises
    ]
    return frozenset(changed)
