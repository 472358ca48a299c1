"""Ways an engine works that words name: two-stroke or four-stroke, single- or double-acting.

One page may go through several: what one of them has per turn, another has not.
"""

from __future__ import annotations

from symbalance.notes.checking.words.sentences import SENTENCE_END
from symbalance.text import lazy_patterns as re

_KINDS = {
    "four": r"(?:four|4)[-\s]?stroke(?!s)|(?:vier|4)[-\s]?takt|(?:4|四)\s?(?:ストローク|サイクル)"
    r"|quatre\s+temps|cuatro\s+tiempos|quattro\s+tempi|quatro\s+tempos|czterosuw|fyrtakt"
    r"|čtyřdob",
    "two": r"(?:two|2)[-\s]?stroke(?!s)|(?:zwei|2)[-\s]?takt|(?:2|二)\s?(?:ストローク|サイクル)"
    r"|deux\s+temps|dos\s+tiempos|due\s+tempi|dois\s+tempos|tweetakt|dwusuw|tvåtakt|dvoudob",
    "double": r"double[-\s]acting|doppelt\s?wirkend|複動",
    "single": r"single[-\s]acting|einfach\s?wirkend|単動",
}
_CYCLE = re.compile(
    "|".join(rf"(?P<{kind}>{pattern})" for kind, pattern in _KINDS.items()), re.IGNORECASE
)
_BEHIND = re.compile(
    r"[\s$\\)\]]{0,6}(?:for|in|with|of|bei|beim|für|im|pour|の場合)\s[^.,;:。、$=]{0,40}", re.IGNORECASE
)
_STROKES = {"two": 2, "four": 4}
_REACH = 300
"""Characters before a formula in which its engine's cycle is named."""
_SECTION = 2000
"""Characters above in which an engine is named that a section is of."""


def names_cycles(text: str) -> bool:
    """Tell whether a text names any way in which engines work."""
    return _CYCLE.search(text) is not None


def strokes_named(words: str) -> set[int]:
    """Return 2, 4 or both, the strokes of the engines that words name.

    >>> strokes_named("for a two-stroke engine"), strokes_named("Viertakt"), strokes_named("two strokes")
    ({2}, {4}, set())
    """
    return {_STROKES[kind] for m in _CYCLE.finditer(words) if (kind := m.lastgroup or "") in _STROKES}


def last_strokes(words: str) -> int:
    """Return 2 or 4, the strokes of the engine that words name last, of late; 0 for none.

    >>> last_strokes("a two-stroke and then a four-stroke engine"), last_strokes("an engine")
    (4, 0)
    """
    near = words[-_SECTION:]
    strokes = [_STROKES[kind] for m in _CYCLE.finditer(near) if (kind := m.lastgroup or "") in _STROKES]
    return strokes[-1] if strokes else 0


def cycles_named(text: str, start: int) -> frozenset[str]:
    """Return the ways of working that the last sentence before a place names that names any.

    >>> text = "For a two-stroke P = p V n. The four-stroke has P = p V n/2"
    >>> sorted(cycles_named(text, 17)), sorted(cycles_named(text, 48))
    (['two'], ['four'])
    """
    for sentence in reversed(SENTENCE_END.split(text[max(0, start - _REACH) : start])):
        kinds = frozenset(match.lastgroup or "" for match in _CYCLE.finditer(sentence))
        if kinds:
            return kinds
    return frozenset()


def cycles_behind(text: str, end: int) -> frozenset[str]:
    """Return the ways of working that words right behind a formula name: = W/2π for a two-stroke.

    >>> sorted(cycles_behind("T = W/a for a two-stroke engine, and", 7))
    ['two']
    """
    match = _BEHIND.match(text, end)
    return frozenset(m.lastgroup or "" for m in _CYCLE.finditer(match[0])) if match else frozenset()


def strokes_of(text: str, place: tuple[int, int], before: int) -> int:
    """Return 2 or 4, the strokes of the engine that a formula is of; 0 where words name none or both.

    `before` is where the formula before it ends: what is named since then counts first.

    >>> text = "a four-stroke has P = p V n/2, a two-stroke P = p V n"
    >>> strokes_of(text, (18, 29), 0), strokes_of(text, (44, 53), 29)
    (4, 2)
    """
    start, end = place
    near = text[max(before, start - _REACH) : start]
    for kinds in (cycles_behind(text, end), cycles_named(near, len(near)), cycles_named(text, start)):
        if kinds:
            strokes = {_STROKES[kind] for kind in kinds if kind in _STROKES}
            return strokes.pop() if len(strokes) == 1 else 0
    return 0


def is_another_cycle(text: str, earlier: tuple[int, int], place: tuple[int, int]) -> bool:
    """Tell whether the engines of two formulas, both named, work otherwise.

    >>> text = "For a two-stroke P = p V n. The four-stroke has P = p V n/2"
    >>> is_another_cycle(text, (17, 26), (48, 59)), is_another_cycle(text, (17, 26), (20, 26))
    (True, False)
    """
    between = text[max(earlier[1], place[0] - _REACH) : place[0]]
    before = cycles_behind(text, earlier[1]) or cycles_named(text, earlier[0])
    now = cycles_behind(text, place[1]) or cycles_named(between, len(between))
    now = now or cycles_named(text, place[0])
    return bool(before and now) and not (before <= now or now <= before)
