"""Marks that open a case of a page: "## Engine B", "**Motor B**", "Case II.", "(b)", "- V6: …".

A page that works out one thing after another opens each in the same way. The lines that do are its marks;
what stands from one to the next is a case if its data say so, and that is no matter of words.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from symbalance.text import lazy_patterns as re

_NOUNS = (
    r"engines?|motors?|moteur|motore|machine|maschine|version|variante?|design|entwurf|layout|option|case|fall|cas|caso"
    r"|example|exercise|problem|beispiel|aufgabe|übung|exemple|exercice|ejemplo|esempio|configuration|konfiguration|car"
    r"|bike|compressor|verdichter|crankshaft|kurbelwelle|set|例題?|問題?|ケース|機関|エンジン|演習"
)
_LABELLED = re.compile(
    rf"(?:{_NOUNS})[\s~]*(?:No\.?|Nr\.?|\#)?[\s~]*\(?(?P<own>[A-H]|[IVX]{{1,4}}|[0-9]{{1,2}}|[a-h])\)?(?![A-Za-z0-9,])",
    re.IGNORECASE,
)
"""A thing that is one of several, by its letter or number: Engine B, Beispiel 2, 例2."""
_HEADING = re.compile(
    r"(?P<mark>#{1,6}|={1,6}|\*{1,6}(?=\s)|[■□◆◇▼▽◎◉★☆❖【]|\\(?:part|chapter|(?:sub){0,2}section|(?:sub)?paragraph)\*?|<h[1-6])[\s{\[>]*"
)
_OPEN = re.compile(
    r"[ \t>]*(?:(?P<bullet>[-*+•]|\\item)(?=[\s\[]))?[\s\[]*(?P<bold>\*\*|__|'''|\\textbf\{)?[ \t]*"
)
_LETTER = re.compile(r"\(?(?P<own>[a-h]|[ivx]{1,4}|[A-H])\)(?=[\s*_.:]|$)")
_NUMBER = re.compile(r"\(?(?P<own>[0-9]{1,2})[.)](?=[\s*_]|$)")
_LEAD = re.compile(r"(?P<own>[^=$:：`|<\\\n]{1,40}?)[\s*_}']{0,4}(?:[:：]|$)")
_BOLD_LEAD = re.compile(r"(?P<own>[^=$`|<\\\n*_}]{1,40}?)[\s.:：]{0,2}(?:\*\*|__|'''|\})")
_NO_CASE = re.compile(
    r"(?:given|data|find|wanted|sought|solution|results?|checks?|summary|conclusions?|notes?|remarks?|answers?|steps?|proof"
    r"|hints?|where|with|so|then|hence|thus|therefore|total|sum|table|figure|fig|comparison|formula|equation|overview|gegeben"
    r"|gesucht|lösung|ergebniss?e?|probe|kontrolle|schritt|zusammenfassung|bemerkung|hinweis|daraus|also|mit|vergleich|données"
    r"|résultats?|solution|résumé|étape|datos|resultados?|solución|paso|解|答|結果|まとめ|検算|手順|諸元|データ|与えられた)"
    r"(?![a-zäöü])",
    re.IGNORECASE,
)
"""Words that open a part of one case: its data, its solution, its summary."""


@dataclass(frozen=True, slots=True)
class CaseMark:
    """A line, from 1, that may open a case: how it does so, and what names the case."""

    line: int
    shape: str
    label: str
    is_named: bool
    """Whether it names one thing of several by a letter or number."""


def case_marks(lines: Sequence[str], headings: Sequence[int]) -> Iterator[CaseMark]:
    """Yield the marks of a page whose headings stand on some lines, from 1.

    >>> [(m.shape, m.label) for m in case_marks(["**Motor B**", "- V6: stroke 84 mm", "(b) m = 1"], [])]
    [('motor', 'b'), ('bullet', 'v6'), ('letter', 'b')]
    >>> list(case_marks(["Given: m = 1", "so r = 2"], []))
    []
    """
    with_headings = set(headings)
    for number, text in enumerate(lines, 1):
        if number in with_headings:
            yield _of_heading(number, text)
        elif (mark := _of_line(number, text)) is not None:
            yield mark


def _of_heading(number: int, text: str) -> CaseMark:
    opened = _HEADING.match(text.lstrip())
    level = "line" if opened is None else opened["mark"].strip("*\\") or opened["mark"]
    words = text.strip() if opened is None else text.lstrip()[opened.end() :]
    named = _LABELLED.search(words[:60])
    if named is not None:
        return CaseMark(number, f"heading {level}", named["own"].lower(), True)
    label = "" if _NO_CASE.match(words) else words.strip(" *_}#=】").lower()
    return CaseMark(number, f"heading {level}", label, False)


def _of_line(number: int, text: str) -> CaseMark | None:
    """Return the mark of a line that is no heading, None for most lines."""
    opened = _OPEN.match(text)
    assert opened is not None  # it may be empty
    words = text[opened.end() : opened.end() + 80]
    numbered = _NUMBER.match(words)
    bare = words[numbered.end() :].lstrip(" \t*_") if numbered else words
    named = _LABELLED.match(bare)
    if named is not None:
        return CaseMark(
            number, bare[: named.start("own")].strip(" ~(").lower(), named["own"].lower(), True
        )
    if letter := _LETTER.match(words):
        return CaseMark(number, "letter", letter["own"].lower(), False)
    lead = (_BOLD_LEAD if opened["bold"] else _LEAD).match(bare)
    shape = (
        "bold" if opened["bold"] else "number" if numbered else "bullet" if opened["bullet"] else "lead"
    )
    if lead is None or not lead["own"].strip() or _NO_CASE.match(lead["own"].lstrip()):
        return None
    is_sentence = shape == "lead" and len(lead["own"].split()) > MOST_WORDS
    return None if is_sentence else CaseMark(number, shape, lead["own"].strip().lower(), False)


MOST_WORDS = 4
"""Words of a lead before its colon; more of them are a sentence."""
