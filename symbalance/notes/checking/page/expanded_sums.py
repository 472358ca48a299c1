"""Sums over letters whose values a page lists, written out: Σ z_k cos δ_k is z_1 cos δ_1 and so on.

A list, a table or a row z = (1, i, −i, −1) says how far such a sum runs, where its sign does not. A
letter that the page defines for every index at once (α_k = 2πk/3) stays as it is, and so does a sum whose
own sentence says other angles: "γ_k only 0° and 180°".
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document.formula import (
    Formula,
    Name,
    Number,
    Span,
    Sum,
    Summation,
    children,
    names,
    with_children,
)
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.sums import at_index, indexed_letters
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.deciding.sums_over_cylinders import is_of_arguments
from symbalance.notes.checking.words.crank_angles_listed import crank_angles
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

LONGEST = 24
"""Terms that are written out; engines have no more cylinders."""
_INDICES = ("i", "j", "k", "n", "nu")
_NUMBERED = re.compile(r"(?P<stem>.+[_,])(?P<number>\d{1,2})")


@dataclass(frozen=True)
class _Values:
    """Where a page gives numbered letters their values, by lines; and what it gives for all at once."""

    lines: Mapping[str, Mapping[int, tuple[int, ...]]]
    rules: Mapping[str, tuple[_Rule, ...]]

    def numbers(self, stem: str, line: int) -> list[int]:
        """Return the numbers that a letter has values for, by lines above where there are any.

        A list that begins anew is a list of its own: three angles below five are those of a three.
        """
        own = self.lines.get(stem, {})
        above = {number: [at for at in lines if at <= line] for number, lines in own.items()}
        last = {number: lines[-1] for number, lines in above.items() if lines}
        if not last:
            return sorted(own)
        begun = last[min(last)]
        current = sorted(number for number, at in last.items() if at >= begun)
        return current if len(current) > 1 else sorted(last)

    def rule(self, letter: str, line: int) -> _Rule | None:
        """Return what a letter is for every index, None where a list of values stands nearer above."""
        rules = self.rules.get(letter, ())
        above = [rule for rule in rules if rule.line <= line] or list(rules[:1])
        if not above:
            return None
        own = self.lines.get(_stem_of(letter), {})
        listed = max((at for lines in own.values() for at in lines if at <= line), default=0)
        return None if listed > above[-1].line else above[-1]


@dataclass(frozen=True)
class _Rule:
    """What a letter is for every index, z_i = (i − 1) a, and the line that says so."""

    value: Formula
    line: int


def _stem_of(letter: str) -> str:
    return letter[: letter.rfind("_") + 1]


def with_expanded_sums(page: ReadNotes, data: Iterable[Chain] = ()) -> ReadNotes:
    """Return a page whose sums over letters with listed values are written out."""
    if not any(
        isinstance(part, Summation) for c in page.chains for s in c.sides for part in _parts(s.node)
    ):
        return page
    values = _values([*page.chains, *data])
    lists = crank_angles(page.text)
    ends = sorted(chain.end for chain in page.chains)

    def expanded(chain: Chain) -> Chain:
        line, above = chain.lines[0], bisect_right(ends, chain.start)
        sentence = ends[above - 1] if above else 0
        if any(sentence <= each.place < chain.start and each.line == line for each in lists):
            return chain
        last = [each for each in lists if each.place < chain.start][-1:]
        cranks = (len(last[0].degrees), last[0].line) if last else (0, 0)
        sides = tuple(
            side.changed(lambda node: _expanded(node, values, line, cranks)) for side in chain.sides
        )
        return replace(chain, sides=sides)

    return replace(page, chains=tuple(map(expanded, page.chains)))


def _parts(node: Formula) -> Iterable[Formula]:
    yield node
    for part in children(node):
        yield from _parts(part)


def _values(chains: Iterable[Chain]) -> _Values:
    lines: dict[str, dict[int, tuple[int, ...]]] = {}
    rules: dict[str, tuple[_Rule, ...]] = {}
    for chain in sorted(chains, key=lambda chain: chain.lines[0]):
        line = chain.lines[0]
        for k, side in enumerate(chain.sides):
            is_given = isinstance(side.node, Name) and (
                any(r.sign == "=" for r in chain.relations[max(k - 1, 0) : k + 1])
            )
            if not is_given or not isinstance(side.node, Name):
                continue
            name = side.node.name
            match = _NUMBERED.fullmatch(name)
            if match is None:
                other = chain.sides[k + 1 if k + 1 < len(chain.sides) else k - 1].node
                rules[name] = (*rules.get(name, ()), _Rule(other, line))
            else:
                numbers = lines.setdefault(match["stem"], {})
                number = int(match["number"])
                numbers[number] = (*numbers.get(number, ()), line)
    return _Values(lines, rules)


def _expanded(node: Formula, values: _Values, line: int, cranks: tuple[int, int]) -> Formula:
    parts = children(node)
    if parts:
        node = with_children(node, tuple(_expanded(part, values, line, cranks) for part in parts))
    return _written_out(node, values, line, cranks) if isinstance(node, Summation) else node


def _written_out(node: Summation, values: _Values, line: int, cranks: tuple[int, int]) -> Formula:
    """Return a sum with its terms, unless as many cranks as it has not are listed since its letters.

    `cranks` are the number of the crank angles that the page lists last before it, and their line.
    """
    index = node.index.name if node.index is not None else _index_of(node.body)
    body = node.body if not index else _with_places_put_in(node.body, index, values, line)
    letters = indexed_letters(body, index) if index else []
    if not letters or any(values.rule(letter, line) for letter in letters) or is_of_arguments(node):
        return node
    stems = [letter[: -len(index)] for letter in letters if letter.endswith(index)]
    if len(stems) < len(letters):
        return node  # c_2k
    lists = [values.numbers(stem, line) for stem in stems]
    numbers = _range(node) if node.lower is not None or node.upper is not None else lists[0]
    is_listed = (
        bool(numbers) and len(numbers) <= LONGEST and all(set(numbers) <= set(own) for own in lists)
    )
    if not is_listed or _is_of_fewer_cranks(stems, numbers, values, line, cranks):
        return node
    is_whole = numbers == list(range(numbers[0], numbers[-1] + 1)) and numbers[0] in (0, 1)
    if node.lower is None and not (
        is_whole and len(numbers) > 1 and all(own == numbers for own in lists)
    ):
        return node
    try:
        terms = [
            _moved(substitute(at_index(body, index, k), index, Number(Fraction(k))), node.span)
            for k in numbers
        ]
    except NoFormError:  # the index of a derivative is no number
        return node
    return Sum(tuple(terms), span=node.span) if len(terms) > 1 else terms[0]


def _is_of_fewer_cranks(
    stems: list[str], numbers: list[int], values: _Values, line: int, cranks: tuple[int, int]
) -> bool:
    """Tell whether a sum's letters have values of another engine: four places, and six cranks since."""
    lines = (at for stem in stems for own in values.lines.get(stem, {}).values() for at in own)
    listed = max((at for at in lines if at <= line), default=0)
    return cranks[0] not in (0, len(numbers)) and cranks[1] > listed


def _with_places_put_in(body: Formula, index: str, values: _Values, line: int) -> Formula:
    """Return what is summed with the letters put in that a rule gives for every index, beside a list.

    With z_i = (i − 1) a and the angles φ_1, φ_2, φ_3 it says how many terms the sum of z_i cos φ_i has.
    Where all letters have rules the sum stays as it is: its number of terms is open.
    """
    letters = indexed_letters(body, index)
    ruled = {letter: rule for letter in letters if (rule := values.rule(letter, line))}
    if not ruled or len(ruled) == len(letters):
        return body
    for letter, rule in ruled.items():
        own = names(rule.value)
        if index not in own or indexed_letters(rule.value, index):
            return body
        body = substitute(body, letter, rule.value)
    return body


def _index_of(body: Formula) -> str:
    """Return the index that the letters of a sum without one carry, "" where they differ."""
    carried = {name.rpartition("_")[2] for name in names(body) if "_" in name}
    carried &= set(_INDICES)
    return carried.pop() if len(carried) == 1 else ""


def _range(node: Summation) -> list[int]:
    ends = [bound.value for bound in (node.lower, node.upper) if isinstance(bound, Number)]
    if len(ends) < 2 or any(end.denominator != 1 for end in ends):
        return []
    return list(range(int(ends[0]), int(ends[1]) + 1))[: LONGEST + 1]


def _moved(node: Formula, span: Span) -> Formula:
    """Return a term with every part at the place of the sum: no part of it stands alone in the text."""
    parts = children(node)
    moved = with_children(node, tuple(_moved(part, span) for part in parts)) if parts else node
    return replace(moved, span=span)
