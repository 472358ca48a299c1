"""Relations of which only one can be true: either x < y or y < x; the items x < y, x = y, x > y.

None of them is said to be so, and what the one says ends where the next stands. Words tell that they are
alternatives ("or", "three cases", "one of"), or a list or table whose items or rows begin with them, all
about the same two sides.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from symbalance.document.formula import names
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_GAP = r"(?:[\s$,:(){}]|\\[,;: ()\[\]]|\\q?quad(?![a-z])|\\text(?=\{))*"
_OR = r"(?<![^\W\d_])(?:or|oder|ou(?:\s+bien)?|o|oppure|soit|sei\s+es|u)(?![^\W\d_])|または|あるいは|か"
_AND = r"(?<![^\W\d_])(?:and|und|et|e|y)(?![^\W\d_])|と|および|、"
_CONNECTED = re.compile(rf"{_GAP}(?:(?P<or>{_OR})|(?:{_AND}))?{_GAP}")
_ALTERNATIVES = re.compile(
    r"(?<![^\W\d_])(?:either|cases?|distinguish\w*|one\s+of|possibilit\w+|alternativ\w*|entweder|F[äa]lle\w*"
    r"|unterscheid\w*|soit|cas|distinguon\w*|casi|distinguiamo|casos|distinguimos)(?![^\W\d_])|場合|いずれか",
    re.IGNORECASE,
)
_ITEM = re.compile(
    r"[ \t>]*(?:[-*+•]|[0-9]{1,2}[.)]|\(?[a-h0-9]\)|\|(?:[^|=<>≤≥$\n]{0,30}\|)?)[ \t]*"
    r"(?:\(?[a-h0-9]{1,2}[.)]\s*)?(?:\*\*)?(?:(?:case|for|if|fall|für|wenn|cas|si|pour|caso|se|per)\b[^$<>=\n]{0,12})?[\s$\\(*]*",
    re.IGNORECASE,
)
"""What stands before the relation that an item or a row begins with."""
_MOST_LINES = 4
"""Lines from one item to the next."""
_SENTENCE = 200


class RivalCases:
    """The relations of a page of which only one can be true, each with the others."""

    def __init__(self, document: ReadNotes) -> None:
        self.document = document
        self._others: dict[int, list[Chain]] = {}
        chains = sorted((c for c in document.chains if len(c.relations) == 1), key=lambda c: c.start)
        items = [chain for chain in chains if self._is_item(chain)]
        lists = [*self._groups(items, "list")]
        listed = {chain.start for group in lists for chain in group}
        others = [chain for chain in chains if chain.start not in listed]
        for group in (*lists, *self._groups(others, "words")):
            for chain in group:
                self._others[chain.start] = [other for other in group if other is not chain]
        self._in_words = self._others.keys() - listed

    def enter(self, state: JudgingState, chain: Chain) -> None:
        """Forget what the alternatives of a relation say, before it is judged."""
        for other in self._others.get(chain.start, ()):
            is_above = chain.start not in self._in_words and other.start < chain.start
            _forget(state, other, chain.lines[0] if is_above else other.lines[0] + 1)

    def are_beside(self, chain: Chain) -> bool:
        """Tell whether a relation is one of several of which only one can be true."""
        return chain.start in self._others

    def leave(self, state: JudgingState, chain: Chain) -> None:
        """Forget what one of the alternatives in a sentence says: none of them is said to be so."""
        if chain.start in self._in_words:
            _forget(state, chain, chain.lines[0] + 1)

    def _groups(self, chains: Sequence[Chain], kind: str) -> Iterator[list[Chain]]:
        """Yield the alternatives among some relations, as items of a list or in words."""
        group: list[Chain] = []
        for chain in chains:
            if group and self._is_beside(group[-1], chain, kind):
                group.append(chain)
                continue
            if self._is_group(group, kind):
                yield group
            group = [chain]
        if self._is_group(group, kind):
            yield group

    def _is_beside(self, before: Chain, chain: Chain, kind: str) -> bool:
        """Tell whether two relations are set side by side, as items or with nothing but "or" between."""
        if kind == "list":
            is_near = 0 < chain.lines[0] - before.lines[-1] <= _MOST_LINES
            return is_near and _sides(before) == _sides(chain)
        between = self.document.text[before.end : chain.start]
        is_title = ":" in between.replace("\\:", "")  # Case 2 (x < 0): |x| = -x
        return _CONNECTED.fullmatch(between) is not None and "\n\n" not in between and not is_title

    def _is_group(self, group: Sequence[Chain], kind: str) -> bool:
        if len(group) < 2:
            return False
        signs = [chain.relations[0].sign for chain in group]
        is_about_order = any(sign in SATISFIED_BY for sign in signs)
        if kind == "list":
            return is_about_order and len({_direction(c) for c in group}) == len(group)
        text = self.document.text
        before = re.split(
            r"[.!?]\s|[。；]|\n\s*\n", text[max(0, group[0].start - _SENTENCE) : group[0].start]
        )[-1]
        inner = [text[a.end : b.start] for a, b in pairwise(group)]
        is_or = any(re.search(_OR, words, re.IGNORECASE) for words in inner)
        is_of_letters = all(names(s.node) for c in group for s in c.sides)
        is_named = _ALTERNATIVES.search(before) is not None
        if is_about_order or not is_or:
            return is_about_order and (is_or or is_named)
        # l sin β = r sin φ, or sin β = λ sin φ says one thing twice
        is_of_one = len({chain.sides[0].node for chain in group}) == 1
        return is_of_letters and (is_named or is_of_one)

    def _is_item(self, chain: Chain) -> bool:
        """Tell whether an item of a list, or a row of a table, begins with a relation."""
        text = self.document.text
        first = text.rfind("\n", 0, chain.start) + 1
        return _ITEM.fullmatch(text, first, chain.start) is not None


def _forget(state: JudgingState, chain: Chain, stop: int) -> None:
    """Forget what a relation says of its letters, and the ranges of its item, before the line `stop`."""
    state.definitions.forget_range(chain)
    lines, own = range(chain.lines[0], stop), chain.letters
    state.definitions.ranges = [
        r
        for r in state.definitions.ranges
        if r.line not in lines or not names(r.left) | names(r.right) <= own
    ]
    if chain.relations[0].sign == "=":
        for name in chain.letters:
            state.definitions.forget_line(name, chain.lines[0])


def _sides(chain: Chain) -> frozenset[object]:
    return frozenset((chain.sides[0].node, chain.sides[1].node))


def _direction(chain: Chain) -> str:
    """Return a relation's sign as it is with the sides in one order."""
    first, second = (formula_text(side.node) for side in chain.sides)
    sign = chain.relations[0].sign
    mirrored = {"<": ">", ">": "<", "≤": "≥", "≥": "≤"}
    return sign if first <= second else mirrored.get(sign, sign)
