"""Sums over letters that a page defines by a rule for every index: ψ_i = 2π(i − 1)/N, i = 1, …, N.

    Σ cos² ψ_i               without bounds runs as the rule does, over i = 1 to N
    Σ_{i=1}^{3} cos ψ_i      from the rule's first index to a number is of that many: N is 3 there

The second is so because i runs to N by the page's own words; where N stands in the relation beside the
sum, it may be any, and nothing is put in for it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
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
    walk,
    with_children,
)
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.sums import indexed_letters
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

LONGEST = 24
"""Terms that are written out; engines have no more cylinders."""
_RULED = re.compile(r"(?P<stem>.+_)(?P<index>[ijkn]|nu)")


@dataclass(frozen=True, slots=True)
class _Rule:
    """What a letter with an index is for each index, the index, its first value and its last letter."""

    letter: str
    value: Formula
    index: str
    first: int
    last: str
    line: int


def with_sums_by_rule(page: ReadNotes) -> ReadNotes:
    """Return a page whose sums over letters with a rule have its bounds and its number of terms."""
    if not any(isinstance(part, Summation) for chain in page.chains for part in _parts_of(chain)):
        return page
    rules = _rules(page)
    if not rules:
        return page

    def written(chain: Chain) -> Chain:
        line, beside = chain.lines[0], _letters_beside(chain)
        own = {name: rule for name, rule in rules.items() if rule.line < line}
        if not own:
            return chain
        sides = tuple(side.changed(lambda node: _written(node, own, beside)) for side in chain.sides)
        return replace(chain, sides=sides)

    return replace(page, chains=tuple(map(written, page.chains)))


def _parts_of(chain: Chain) -> Sequence[Formula]:
    return [part for side in chain.sides for part in walk(side.node)]


def _rules(page: ReadNotes) -> dict[str, _Rule]:
    """Return the rules of a page whose index is said to run to a letter that stands in the rule."""
    rules: dict[str, _Rule] = {}
    for chain in page.chains:
        head = chain.sides[0].node
        match = _RULED.fullmatch(head.name) if isinstance(head, Name) else None
        if match is None or not isinstance(head, Name) or chain.relations[0].sign != "=":
            continue
        value, index = chain.sides[1].node, match["index"]
        run = _run(page, index)
        if run is None or index not in names(value) or run[1] not in names(value):
            continue
        rules.setdefault(head.name, _Rule(head.name, value, index, *run, chain.lines[0]))
    return rules


def _run(page: ReadNotes, index: str) -> tuple[int, str] | None:
    """Return the first value and the last letter of an index: by i = 1, …, N or by a sum over it."""
    pattern = (
        rf"(?<![\w\\]){index}\s?=\s?(?P<first>[01])\s?,(?:\s?[12]\s?,)?(?:\s?3\s?,)?"
        r"\s?(?:\\l?dots|\\cdots|…|\.\.\.?)\s?,?\s?(?P<last>[A-Za-z])(?![A-Za-z0-9])"
        rf"|(?P<least>[01])\s?(?:\\leq?|≤)\s?{index}\s?(?:\\leq?|≤)\s?(?P<most>[A-Za-z])(?![A-Za-z0-9])"
    )
    if match := re.search(pattern, page.text):
        return int(match["first"] or match["least"]), match["last"] or match["most"]
    sums = (part for chain in page.chains for part in _parts_of(chain) if isinstance(part, Summation))
    for part in sums:
        is_over = part.index is not None and part.index.name == index
        lower, upper = part.lower, part.upper
        if is_over and isinstance(upper, Name) and isinstance(lower, Number) and lower.value in (0, 1):
            return int(lower.value), upper.name
    return None


def _letters_beside(chain: Chain) -> frozenset[str]:
    """Return the letters of a chain that stand outside the bodies of its sums."""
    letters = set[str]()

    def look(node: Formula) -> None:
        if isinstance(node, Name):
            letters.add(node.name)
        if not isinstance(node, Summation):
            for part in children(node):
                look(part)

    for side in chain.sides:
        look(side.node)
    return frozenset(letters)


def _written(node: Formula, rules: Mapping[str, _Rule], beside: frozenset[str]) -> Formula:
    parts = children(node)
    if parts:
        new_parts = tuple(_written(part, rules, beside) for part in parts)
        if any(a is not b for a, b in zip(parts, new_parts, strict=True)):
            node = with_children(node, new_parts)
    return _sum_written(node, rules, beside) if isinstance(node, Summation) else node


def _sum_written(node: Summation, rules: Mapping[str, _Rule], beside: frozenset[str]) -> Formula:
    """Return a sum with its rule's bounds, or with the number of its terms put in; else as it stands."""
    own = [rule for name, rule in rules.items() if name in names(node.body)]
    if not own or len({(rule.index, rule.first, rule.last) for rule in own}) > 1:
        return node
    index, first, last = own[0].index, own[0].first, own[0].last
    is_over_another = node.index is not None and node.index.name != index
    if is_over_another or any(name not in rules for name in indexed_letters(node.body, index)):
        return node
    if node.lower is None and node.upper is None:
        lower = Number(Fraction(first), span=node.span)
        return replace(
            node, index=Name(index, span=node.span), lower=lower, upper=Name(last, span=node.span)
        )
    ends = [end.value if isinstance(end, Number) else None for end in (node.lower, node.upper)]
    if ends[0] != first or ends[1] is None or last in beside | names(node.body):
        return node
    if ends[1].denominator != 1 or first != 1 or not 1 < ends[1] <= LONGEST:
        return node  # from 0 to N there are N + 1
    return _terms(node, own, index, int(ends[1]), last)


def _terms(node: Summation, rules: Sequence[_Rule], index: str, end: int, last: str) -> Formula:
    terms: list[Formula] = []
    try:
        for number in range(1, end + 1):
            body = node.body
            for rule in rules:
                body = substitute(body, rule.letter, rule.value)
            body = substitute(body, index, Number(Fraction(number)))
            terms.append(_moved(substitute(body, last, Number(Fraction(end))), node.span))
    except NoFormError:  # the index of a derivative is no number
        return node
    return Sum(tuple(terms), span=node.span)


def _moved(node: Formula, span: Span) -> Formula:
    """Return a term with every part at the place of the sum: no part of it stands alone in the text."""
    parts = children(node)
    moved = with_children(node, tuple(_moved(part, span) for part in parts)) if parts else node
    return replace(moved, span=span)
