"""What stands beside a value as the range it is said for: M = M₀ sin θ for 0 ≤ θ ≤ π."""

from __future__ import annotations

from collections.abc import Iterator

from symbalance.document.formula import Name
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_FOR = r"(?:for|if|when|where|on|in|für|wenn|falls|bei|im\s+Bereich|pour|si|per|para|con|のとき|では)?"
_RANGE_BEHIND = re.compile(
    rf"[\s$,(\\]*(?:quad|qquad|text\s*\{{)?[\s$({{]*{_FOR}[\s$(}}]*", re.IGNORECASE
)
"""Between a value and its range behind it."""
_RANGE_BEFORE = re.compile(
    r"[\s$):,、]*(?:is|we\s+have|let|ist|gilt|sei|on\s+a|est|si\s+ha|es|では|のとき)?[\s$]*",
    re.IGNORECASE,
)
"""Between a range and the value behind it."""
_OPENS = re.compile(
    r"(?<![^\W\d_])(?:for|if|when|where|für|wenn|falls|bei|pour|si|per|para)[\s$(]*$", re.IGNORECASE
)
_REACH = 20


class RangesBeside:
    """The values that a page gives letters on ranges; each letter's are looked for once."""

    def __init__(self, sections: Sections) -> None:
        self._sections = sections
        self._of: dict[str, list[tuple[Chain, list[Chain]]]] = {}

    def of(self, name: str) -> list[tuple[Chain, list[Chain]]]:
        """Return the values of a letter, in order, each with the inequalities that may be its range."""
        if name not in self._of:
            beside = [
                (giver, list(self._beside(giver))) for giver in self._sections.chains_of(Name(name))
            ]
            self._of[name] = [(giver, ranges) for giver, ranges in beside if ranges]
        return self._of[name]

    def _beside(self, giver: Chain) -> Iterator[Chain]:
        """Yield the inequality right behind a value, and the one right before it."""
        if len(giver.relations) != 1 or giver.relations[0].sign not in "=≈":
            return
        text = self._sections.document.text
        behind = next(self._sections.chains_behind(giver.end), None)
        is_behind = behind is not None and _RANGE_BEHIND.fullmatch(text, giver.end, behind.start)
        if behind is not None and is_behind and _bounds_one_letter(behind):
            yield behind
        before = self._sections.chain_before(giver.start)
        if before is not None and _bounds_one_letter(before):
            is_opened = _OPENS.search(text, max(0, before.start - _REACH), before.start)
            if is_opened and _RANGE_BEFORE.fullmatch(text, before.end, giver.start):
                yield before


def _bounds_one_letter(chain: Chain) -> bool:
    return len(chain.letters) == 1 and all(r.sign in SATISFIED_BY for r in chain.relations)
