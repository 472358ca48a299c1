"""Which of several engines or cases a place of a page is about, by labels: engine A, case b, Motor 2.

A label in a heading stands for its thing until the next label of its section; one in a sentence to the
end of its paragraph, or of the sentence where that goes on in a display.
"""

from __future__ import annotations

from bisect import bisect_left

from symbalance.notes.checking.words.sections import Sections
from symbalance.text import lazy_patterns as re

_THING = (
    r"(?:engine|motor|machine|case|variant|version|design|layout|example|fall|maschine|variante|ausführung"
    r"|auslegung|beispiel|moteur|cas|machine|exemple|motore|caso|versione|esempio|ejemplo)"
)
_LABELLED = re.compile(
    rf"(?<![^\W\d_])(?i:{_THING})[ ~]{{1,2}}[\"“„'$(]?(?P<label>[A-Z]|[IVX]{{1,4}}|[1-9])(?![\w.,]?\w)"
    r"|(?:エンジン|機関|場合|ケース)\s?(?P<sign>[A-Z1-9])(?!\w)"
)
"""A thing with its label: Engine A, "case II", エンジンB; no word that begins with it, engine Alpha."""
COMPARED = (
    r"(?:than|unlike|(?:compared|relative)\s+(?:with|to)|verglichen\s+mit|im\s+Vergleich\s+(?:zu[rm]?|mit)"
    r"|rispetto\s+a|compar[ée]+e?\s+[àa]u?|against|versus|vs\.?|instead\s+of|not|from|als|gegenüber|statt|anders\s+als|que|contre)\s+"
)
"""Words before what something is only compared with."""
_BESIDE = re.compile(
    rf"{COMPARED}(?:(?:for|of|in|bei|für|von|pour|de)\s+)?(?:the\s+|der\s+|dem\s+|le\s+)?$",
    re.IGNORECASE,
)
"""Right before a thing that something is only compared with."""
_SENTENCE_END = re.compile(r"[.!?](?=\s|$)|。")
_NEAR = 40
"""Characters before a label in which the words stand that only compare with it."""


class LabelsOfCases:
    """The labels of a page in order, and where its sections begin."""

    def __init__(self, text: str, sections: Sections) -> None:
        self._text, self._sections = text, sections
        self._places: list[int] = []
        self._labels: list[str] = []
        for match in _LABELLED.finditer(text):
            before = text[max(0, match.start() - _NEAR) : match.start()]
            if _BESIDE.search(before) is None:
                self._places.append(match.start())
                self._labels.append(match["label"] or match["sign"])

    @property
    def are_several(self) -> bool:
        """Whether the page has more than one label."""
        return len(set(self._labels)) > 1

    def end_of_line(self, line: int) -> int:
        """Return where a line ends."""
        return self._sections.start_of_line(line + 1) - 1

    def at(self, place: int, line: int) -> str:
        """Return the label that a place of a line is about, "" for none in its section."""
        sections, k = self._sections, bisect_left(self._places, place) - 1
        heading = sections.section_start(line)
        if k < 0 or self._places[k] < sections.start_of_line(heading):
            return ""
        label = self._places[k]
        is_in_heading = label < sections.start_of_line(heading + 1) and sections.heading_above(line) != ""
        is_here = is_in_heading or label >= sections.start_of_line(sections.paragraph_start(line))
        return self._labels[k] if is_here or not _SENTENCE_END.search(self._text, label, place) else ""
