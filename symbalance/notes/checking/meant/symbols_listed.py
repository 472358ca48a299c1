r"""What a page's list or table of symbols says that its letters are.

- $v$: mean piston speed          | $v$ | mean piston speed | m/s |        v ... mean piston speed
\item[$v$] mean piston speed      $v$ & mean piston speed & m/s \\         v = mean piston speed
($v$ mean piston speed, $s$ stroke, $n$ revolutions per second)            $v$ は平均ピストン速度
"""

from __future__ import annotations

from collections.abc import Iterator

from symbalance.notes.checking.meant.said_behind import SIGN, SaidBehind
from symbalance.text import lazy_patterns as re

_GREEK = (
    r"alpha|beta|gamma|delta|epsilon|eta|theta|kappa|lambda|mu|nu|rho|sigma|tau|phi|psi|omega|xi|zeta"
)
_PLAIN = rf"(?:[^\W\d_]|\\?(?:{_GREEK}))(?:_?(?:\{{[^{{}}$\n]{{1,14}}\}}|[A-Za-z0-9]{{1,4}}))?'{{0,2}}"
_LETTER = (
    rf"(?:\$\s?(?P<math>{SIGN})\s?\$|\\\(\s?(?P<round>{SIGN})\s?\\\)|`\s?(?P<code>{SIGN})\s?`"
    rf"|<math>\s?(?P<wiki>{SIGN})\s?</math>|<(?:i|em|var|b|code)>(?P<html>{SIGN})</(?:i|em|var|b|code)>"
    rf"|\*{{1,2}}(?P<strong>{_PLAIN})\*{{1,2}}|(?P<plain>{_PLAIN}))"
)
_MARKED = (
    rf"(?:\$\s?(?P<math>{SIGN})\s?\$|\\\(\s?(?P<round>{SIGN})\s?\\\)|<math>\s?(?P<wiki>{SIGN})\s?</math>)"
)
_WORDS = r"(?P<words>[^\W\d_](?:[^\n\t|&\\=$<:;。、]|(?<=\w)<(?=\w)){2,90}?)"
"""A name: it ends where a cell, a formula or a clause begins."""
_BULLET = r"^[ \t>]*(?:(?:[-*+•·–]|\\item|;|[0-9]{1,2}[.)]|<(?:li|p|dt|tr)>(?:\s*<t[dh]>)?)[ \t]*)?"
_ENTRY = re.compile(
    rf"{_BULLET}{_LETTER}[ \t]*(?:\*{{2}})?"
    r"(?:[ \t]*(?::|：|=|\.{2,}|…|[-–—]{1,3}(?=[ \t]))[ \t]*|</dt>\s*<dd>|[ \t]{2,}|\t+)"
    rf"(?:\*{{2}})?{_WORDS}(?=[ \t]*(?:[.,;(\[。、（]|<|\\\\|$))",
    re.MULTILINE,
)
"""An entry of a list, on a line of its own."""
_TITLED = re.compile(
    rf"\\item\[\s*{_LETTER}\s*:?\s*\]\s*{_WORDS}(?=[ \t]*(?:[.,;(\[\\]|$))", re.MULTILINE
)
_ROW = re.compile(
    rf"^[ \t]*(?:\|{{1,2}}|<tr>\s*<t[dh]>)?[ \t]*{_LETTER}"
    rf"[ \t]*(?:\|{{1,2}}|&|</t[dh]>\s*<t[dh]>)[ \t]*{_WORDS}"
    r"(?=[ \t]*(?:[.,;(\[]|\||&|</t[dh]>|\\\\|$))",
    re.MULTILINE,
)
"""A row of a table of which the first cell is a letter."""
_LINES = (_ENTRY, _TITLED, _ROW)
_SAID_EQUAL = re.compile(
    rf"{_MARKED}[ \t]*=[ \t]*{_WORDS}(?=[ \t]*(?:[.,;(\[。、（]|\sand\s|\sund\s|\set\s|$))", re.MULTILINE
)
"""A letter that is set equal to words: $v$ = mean piston speed."""
_IN_BRACKETS = re.compile(
    r"(?:[(（,;、]|(?<=[(（])(?:where|with|mit|wobei|avec|où|con|dove|donde))[ \t\n]{0,2}"
    rf"{_MARKED}[ \t]{{0,2}}:?[ \t]{{0,2}}{_WORDS}(?=[,;)）、])",
    re.MULTILINE,
)
"""An entry of a list in brackets."""
_IN_JAPANESE = re.compile(rf"{_MARKED}[ \t]*(?:は|：|が)[ \t]*(?P<words>[^\n$。、，,（(=：]{{2,40}})")
_LIST_IN_BRACKETS = re.compile(r"[(（][^()（）\n]{0,400}[)）]")
_IS_CLAUSE = re.compile(
    r"\s/\s|[*^]|\b(?:is|are|was|be|becomes?|gives?|follows?|has|have|we|it|so|then|ist|sind|wird|werden|beträgt|gilt"
    r"|folgt|wir|est|sont|vaut|on|è|vale|si|es|se)\b|次の?式",
    re.IGNORECASE,
)
"""In words that are a clause or a formula, and no name."""
_OF_HEAD = re.compile(r"[^\n]*\n[ \t]*\|?[ \t]*:?-{2,}")
"""Behind what stands in the head of a table: its next line is the rule below."""
_ENDINGS = re.compile(r"(?:である|です|とする|を表す|を示す)$")
_UNIT = re.compile(r"\s+(?:in|en)\s+\S{1,12}(?:\s?[/·]\s?\S{1,8})?$|\s+[/[]\S{1,12}$")
"""The unit behind a name: mean piston speed in m/s."""


def symbols_listed(text: str) -> Iterator[SaidBehind]:
    """Yield each letter that a list or a table of symbols explains.

    >>> [(each.sign, each.words) for each in symbols_listed("- $v$: mean speed in m/s\\n- $s$: stroke")]
    [('v', 'mean speed'), ('s', 'stroke')]
    >>> [(each.sign, each.words) for each in symbols_listed("| $F_1$ | first-order force | 25 N |")]
    [('F_1', 'first-order force')]
    """
    found: dict[int, SaidBehind] = {}
    for pattern in (*_LINES, _SAID_EQUAL, _IN_JAPANESE):
        for match in pattern.finditer(text):
            _take(match, 0, found)
    for brackets in _LIST_IN_BRACKETS.finditer(text):
        entries = [*_IN_BRACKETS.finditer(brackets[0])]
        for match in entries if len(entries) > 1 else ():
            _take(match, brackets.start(), found)
    yield from (found[start] for start in sorted(found))


def ends_of_entries(text: str) -> list[int]:
    """Return the ends of the lines that are entries of a list or table of symbols, in order."""
    found: dict[int, SaidBehind] = {}
    for pattern in _LINES:
        for match in pattern.finditer(text):
            _take(match, 0, found)
    ends = (text.find("\n", start) for start in found)
    return sorted(end if end >= 0 else len(text) for end in ends)


def _take(match: re.Match[str], offset: int, found: dict[int, SaidBehind]) -> None:
    """Note what an entry says, unless its words are no name."""
    group = next(g for g, sign in match.groupdict().items() if sign and g != "words")
    words = _UNIT.sub("", _ENDINGS.sub("", match["words"].strip()))
    is_of_head = _OF_HEAD.match(match.string, match.end()) is not None
    if len(words) > 1 and not is_of_head and not _IS_CLAUSE.search(words):
        start = match.start(group) + offset
        found.setdefault(start, SaidBehind(match[group], start, words))
