"""Which of several engines or cases a place of a page is about, by labels: engine A, case b, Motor 2.

Where two things are labelled so, the label alone names one: "A: V = 490 cc", "628 rad/s for A".

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
_ALONE = re.compile(
    r"^[ \t]*(?:[-*+•][ \t]*)?(?:\*\*)?(?P<label>[A-Z])(?:\*\*)?(?=[ \t]?[:：)])"
    r"|(?<![^\W\d_])(?:for|of|in|so|and|but|für|bei|und|pour|et|per|e|para|y)\s(?P<other>[A-Z])"
    r"(?=\s(?:has|gives?|we|is|hat|ist|gilt|a|tiene)\s)",
    re.MULTILINE,
)
"""A label alone: where its line begins with it, and before a verb."""
_BEHIND = re.compile(
    r"[\s$)\]}]{0,4}(?:(?:rad|mm|cm|m|s|kN|N|rpm|Hz|cc|kg)[\w/^²·*]{0,6}[\s$]{0,3})?"
    r"\(?(?:for|of|in|bei|für|pour|per|para)\s(?:(?:engine|motor|Motor|moteur|motore)\s)?(?P<label>[A-Z])(?!\w)"
)
_OF_CASE = re.compile(r"(?<=\w)\([A-Z]\)|(?<=\w)_\{?[A-Z]\}?(?!\w)")
"""A label within a formula, which is no letter of it: F(B)/F(A), F_A."""
COMPARED = (
    r"(?:than|unlike|(?:compared|relative)\s+(?:with|to)|verglichen\s+mit|im\s+Vergleich\s+(?:zu[rm]?|mit)"
    r"|rispetto\s+a|compar[ée]+e?\s+[àa]u?|against|versus|vs\.?|instead\s+of|not|from|als|gegenüber|statt|anders\s+als|que|contre)\s+"
)
"""Words before what something is only compared with."""
_COMPARISON = re.compile(
    rf"(?<![^\W\d_])(?:{COMPARED}|(?:that|those|dem|denen|der|jene[rnms]?|celle|celui|quella|quello)\s+(?:at|of|bei|von|à|de|di|a)\s)"
    r"[^,.:;!?。、=]*",
    re.IGNORECASE,
)
_BESIDE = re.compile(
    rf"{COMPARED}(?:(?:for|of|in|bei|für|von|pour|de)\s+)?(?:the\s+|der\s+|dem\s+|le\s+)?$",
    re.IGNORECASE,
)
"""Right before a thing that something is only compared with."""
_SENTENCE_END = re.compile(r"[.!?](?=\s|$)|。")
_NEAR = 40
"""Characters before a label in which the words stand that only compare with it."""


def without_comparisons(words: str) -> str:
    """Return words with blanks for what something is only compared with.

    >>> without_comparisons("less than at 6000 rpm, it is").split()
    ['less', ',', 'it', 'is']
    """
    return _COMPARISON.sub(lambda match: " " * len(match[0]), words)


class LabelsOfCases:
    """The labels of a page in order, and where its sections begin."""

    def __init__(self, text: str, sections: Sections) -> None:
        self._text, self._sections = text, sections
        found = {
            match.start(): match["label"] or match["sign"]
            for match in _LABELLED.finditer(text)
            if _BESIDE.search(text[max(0, match.start() - _NEAR) : match.start()]) is None
        }
        used = {
            name
            for chain in sections.document.chains
            for name in chain.letters
            if re.search(rf"{name}(?!\w)", _OF_CASE.sub("", text[chain.start : chain.end]))
        }
        letters = {label for label in found.values() if label.isalpha() and label not in used}
        self._bare = letters if len(letters) > 1 else set[str]()
        if self._bare:
            alone = {m.start(): m["label"] or m["other"] for m in _ALONE.finditer(text)}
            found |= {place: label for place, label in alone.items() if label in self._bare}
        self._places = sorted(found)
        self._labels = [found[place] for place in self._places]

    @property
    def are_several(self) -> bool:
        """Whether the page has more than one label."""
        return len(set(self._labels)) > 1

    def end_of_line(self, line: int) -> int:
        """Return where a line ends."""
        return self._sections.start_of_line(line + 1) - 1

    def behind(self, place: int) -> str:
        """Return the label that words right behind a relation name: "w = 628 rad/s for A"."""
        match = _BEHIND.match(self._text, place) if self._bare else None
        return match["label"] if match is not None and match["label"] in self._bare else ""

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
