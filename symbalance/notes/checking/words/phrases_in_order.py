r"""Quantities that one sentence names in a row, and the formulas that follow in the same order.

"Its velocity and its acceleration are" before v = … and γ = … says of γ that it is the acceleration.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property

from symbalance.document.formula import Name
from symbalance.notes.checking.words.sentences import SENTENCE_END, bare
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

LONGEST = 300
"""Characters of a sentence that introduces formulas."""
_AND = re.compile(
    r",?\s+(?:and|und|sowie|et|y|e|och|oraz)\s+|(?<=[\u3040-\u9fff])(?:と|および|及び|、)(?=[\u3040-\u9fff])"
)
_COMMA = re.compile(r"[,，、]")
_SET = re.compile(
    r"\\(?:begin|end)\{[a-z]+\*?\}|\\(?:q?quad|text|mathrm|mbox|hspace|left|right|label|tag|notag|nonumber|item)"
    r"(?![A-Za-z])(?:\{[^{}]{0,30}\})?|\\\\(?:\[[^\]]{0,10}\])?|</?[a-z]{1,4}[^<>]{0,30}>"
    r"|(?<![A-Za-z])(?:and|und|et|y|e|og|och)(?![A-Za-z])|\([0-9]{1,2}[a-z]?\)"
)
_WORD = re.compile(r"[^\W\d_]{3,}|[\u3040-\u9fff]{2,}")


class PhrasesInOrder:
    """The phrases of one page's sentences that name formulas in a row."""

    def __init__(
        self, text: str, chains: Sequence[Chain], section_start: Callable[[int], int | None]
    ) -> None:
        """Take a page's text, its formulas in order, and what tells where a section begins."""
        self.text, self.chains, self.section_start = text, chains, section_start

    @cached_property
    def _phrases(self) -> dict[int, str]:
        """The phrase of each formula, by the place where it begins."""
        phrases: dict[int, str] = {}
        row: list[Chain] = []
        for chain in self.chains:
            if row and not self._follows(row[-1], chain):
                phrases |= self._of_row(row)
                row = []
            row.append(chain)
        return phrases | self._of_row(row)

    def of(self, chain: Chain) -> str:
        """Return the phrase that names a formula, "" where no sentence names as many as follow it."""
        return self._phrases.get(chain.start, "")

    def _follows(self, before: Chain, chain: Chain) -> bool:
        """Tell whether nothing but what sets the formulas stands between two of them."""
        between = self.text[before.end : chain.start]
        return len(between) <= LONGEST and _WORD.search(_SET.sub(" ", between)) is None

    def _of_row(self, row: list[Chain]) -> dict[int, str]:
        """Return the phrases of formulas in a row by their places, none where their number differs."""
        heads = {chain.sides[0].node for chain in row if isinstance(chain.sides[0].node, Name)}
        if len(row) < 2 or len(heads) < len(row):
            return {}
        start = row[0].start
        first = max(start - LONGEST, self.section_start(start) or 0)
        sentence = SENTENCE_END.split(bare(self.text[first:start]))[-1]
        *_, joint = [None, *_AND.finditer(sentence)]
        if joint is None:
            return {}
        pieces = _COMMA.split(sentence[: joint.start()])[1 - len(row) :]
        phrases = [*pieces, sentence[joint.end() :]]
        is_whole = all(_WORD.search(phrase) and not _AND.search(phrase) for phrase in phrases)
        if len(phrases) != len(row) or not is_whole:
            return {}
        return {chain.start: phrase.strip() for chain, phrase in zip(row, phrases, strict=True)}
