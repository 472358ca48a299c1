"""Which of several numbers of a letter the words before a relation speak of: at idle, the small one, (a).

The words before each number that those before the others lack are its own: "at idle ω = 80, at full speed
ω = 600". So are words right behind it: "F = 3600 N at 3000 rpm and F = 14400 N at 6000 rpm". A later
sentence with own words of one number, and none of the others, speaks of that one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from symbalance.notes.checking.words.joined_numbers import (
    Joined,
    is_said_of_each,
    joined_numbers,
    named_by_turn,
)
from symbalance.notes.checking.words.labels_of_cases import COMPARED
from symbalance.notes.checking.words.numbers_by_place import by_index, by_order, by_own_column
from symbalance.notes.checking.words.places_in_words import with_dead_centres
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_SIZE = (
    r"(?<![\w.,])[0-9]+(?:[.,][0-9]+)?(?=(?:[\s~$}]|\\[,;: ]|\\(?:mathrm|text|textrm)\s*\{){0,4}"
    r"(?:rpm|r\.\s?p\.\s?m|(?:[U1r]|tr|revs?|tours|giri)?\s?(?:/|per|pro|par|al)\s?min|min\s*\^?\s?\{?\s?[-−]\s?1|min⁻¹|回転"
    r"|°|\^\s?\{?\s?\\circ|度|Grad|degrees?|rad/s|1/s|s⁻¹|Hz|km/h|m/s|mm|cm|kg|bar|kW|%))"
)
"""A number before a unit, which tells a case from another: at 3000 rpm."""
_TOKEN = re.compile(
    rf"{_SIZE}|"
    r"(?<![\w\\])[^\W\d_\u3040-\u9fff]{2,}|(?<![\w\\])[A-Z](?!\w)|\([a-h1-9]\)"
    r"|(?<=[^\W\d_] )[1-9](?=\s*(?:[:：()$]|$|\.\s|(?:has|have|is|hat|ist|we|gives?|a|est)\s))"
    r"|(?<![\w.])[1-9](?=[.)]\s)|[\u30a0-\u30ff\u4e00-\u9fff]+"
)
_LITTLE = re.compile(
    r"(?:an?|the|of|its|our|his|is|are|was|were|it|they|we|has|have|had|gives?|be|to|and|or|by|as|get|becomes?|finds?|then|thus|therefore"
    r"|there|so|hence|here|this|that|these|those|with|for|at|in|on|from|into|when|if|now\s|let|take|now|also|again|one|ones|about|our"
    r"|der|die|das|den|dem|des|eine?[nmrs]?|und|oder|mit|bei|beim|im|in|am|an|für|von|vom|zu|ist|sind|war|hat|haben|wird|also|man|er|sie|es"
    r"|gilt|so|dann|daher|somit|auch|sich|nun|le|la|les|l|un|une|du|de|des|d|et|ou|a|est|on|il|elle|pour|avec|dans|à|au|aux|en|sur|donc"
    r"|cranks?|crankshafts?|radius|radii|rods?|pistons?|strokes?|engines?|motors?|machines?|bores?|cylinders?|mass|force|forces|lengths?|speeds?"
    r"|values?|angles?|numbers?|diameters?|kurbel(?:n|wellen?|radius|winkel)?|pleuel\w*|kolben\w*|hub|motor(?:en|s)?|masse|kraft|länge|drehzahl|winkel|zahl|wert"
    r"|moteurs?|manivelles?|bielles?|rayon|course|valeur|vitesse|半径|値|場合|機関|質量|力|角|長)",
    re.IGNORECASE,
)
"""Words that tell no case from another: little ones, and those of any engine."""
_BEHIND = re.compile(
    r"[\s$)\]}~]*(?:\((?P<aside>[^()$=\n]{2,40})\)"
    r"|(?P<words>(?:at|for|in|on|with|when|bei|beim|im|für|am|mit|à|au|pour|en|avec|per|con|para|al|alla|a(?=\s[0-9]))\s(?:[^.,;:!?。、=$()\n]|\([a-h1-9]\)|\n(?!\s*\n)|[.,](?=[0-9])){2,60}?)"
    r"(?=\s+(?:and|und|but|aber|et|mais|e|ma|y|pero)\s|[.,;:!?。、)]|\s*(?:\n\s*\n|$)))",
    re.IGNORECASE,
)
"""Words right behind a number that say of what it is: at 3000 rpm, (TDC)."""
_ENDING = re.compile(r"(?<=[^\W\d_]{3})(?:en|em|er|es|e|s|n)$")
_ORDINAL = re.compile(
    r"(?<![^\W\d_])(?:the|der|die|das|dem|den|beim|im|le|la|du|il|el)\s+(?:(?P<first>first|former|erste[nrs]?|premi[eè]re?|primo|primera?|original)"
    r"|(?P<second>second|latter|zweite[nrs]?|deuxième|secondo?|segund[oa]))(?![^\W\d_])|(?P<one>前者)|(?P<two>後者)",
    re.IGNORECASE,
)
_OF_EACH = (
    r"(?:engines?|motor(?:en|s)?|machines?|maschinen?|moteurs?|designs?|variant\w*|versions?|samples?|examples?|pistons?|cylinders?|shafts?|wheels?"
    r"|springs?|bodies|body|rods?|cases?|f[aä]ll\w*|cas|cas[io]s?|motor[ei]|proben?|beispielen?|exemples?|échantillons?|kolben|zylindern?|wellen?)"
)
_BOTH = re.compile(
    r"(?<![^\W\d_])(?:both|beide[nr]?|(?:tou)?(?:te)?s\s+les\s+deux|les\s+deux|entrambi|ambos)\s*"
    r"(?:(?:the|der|die)\s+)?(?:$|(?:ha(?:ve|t|ben)|are|sind|ont|sont|give|ergeben)(?![^\W\d_])"
    rf"|{_OF_EACH}(?![^\W\d_]))|(?:両者|両方|どちらも|どちらの場合も|いずれの場合も|どの場合も|各場合|常に)"
    rf"|(?<![^\W\d_])(?:each|every|either|any|all|jede[nrsm]?|alle[nr]?|chaque|tou(?:s|tes)\s+les|chacune?\s+des|ogni|tutt[ie]\s+[ig]l?[ie]?|cada"
    rf"|tod[oa]s\s+l[oa]s)\s+(?:(?:the|of|der|den|von)\s+){{0,2}}{_OF_EACH}(?![^\W\d_])"
    r"|(?<![^\W\d_])(?:always|immer|stets|jeweils|toujours|sempre|siempre|each\s+time|jedes\s+Mal)(?![^\W\d_])",
    re.IGNORECASE,
)
"""Words that speak of each of several cases: both have, in each case, always."""
_COMPARISON = re.compile(rf"(?:{COMPARED})[^,.:;!?。、]*", re.IGNORECASE)
_SENTENCE = re.compile(r"(?<!^[0-9])(?<!\s[0-9])[.!?]\s|[;。；]|\n\s*\n")
_ALL = -1
"""Of which number words speak that speak of all of them."""
REACH, MOST, SENTENCES = 200, 6, 2
"""Characters before a number, words before it, and sentences before a relation that are looked at."""


class Spoken(NamedTuple):
    """The places of the numbers that words speak of."""

    places: tuple[int, ...]
    is_denied: bool = False
    """Whether the words say that it is so for none of them."""


def numbers_spoken_of(
    sections: Sections, text: str, chain: Chain, givers: Sequence[Chain], now: int
) -> Spoken:
    """Return which of several numbers of a letter the words before a relation are about.

    None where they tell none, several where they are about each of them. `now` is the one in force. So
    does its column in a table, and its place in a row of results "respectively".
    """
    by_place = number_by_place(sections, text, chain, givers)
    if by_place is not None:
        return Spoken((by_place,))
    leads = [_lead_of(sections, text, giver) for giver in givers]
    own = [lead.difference(*(leads[:n] + leads[n + 1 :])) for n, lead in enumerate(leads)]
    named = _by_words_behind(text, chain, own) if own[now] else None
    named = by_index(sections, chain, own) if named is None and own[now] else named
    if named is not None:
        return Spoken((named,))
    joined = joined_numbers(text, givers) if now == len(givers) - 1 else None
    if joined is not None:
        return _of_joined(sections, text, chain, givers, joined)
    if not own[now]:
        return Spoken(())  # a number given since, in no case, is that of every case
    named = _by_words_before(sections, text, chain, givers[now], own)
    every = tuple(range(len(givers)))
    return Spoken(() if named is None else every if named == _ALL else (named,))


def number_by_place(sections: Sections, text: str, chain: Chain, givers: Sequence[Chain]) -> int | None:
    """Return which of several numbers a relation goes with by its column, or by its turn in a row."""
    by_place = by_own_column(text, chain, givers)
    if by_place is not None:
        return by_place
    joined = joined_numbers(text, givers)
    first = 0 if joined is None else joined.first
    by_turn = by_order(sections, text, chain, givers[first:])
    return None if by_turn is None else first + by_turn


def _of_joined(
    sections: Sections, text: str, chain: Chain, givers: Sequence[Chain], joined: Joined
) -> Spoken:
    """Return which of the numbers in one breath a relation is about: each, or the one that words name."""
    last, every = givers[-1], tuple(range(joined.first, len(givers)))
    words = _without_formulas(sections, text, last.end, chain.start)
    turn = named_by_turn(words) if len(every) == len(("first", "second")) else None
    if turn is not None:
        return Spoken((every[turn],))
    is_of_each = is_said_of_each(text, last, chain) or _BOTH.search(words) is not None
    return Spoken(every if is_of_each else (), joined.is_denied and is_of_each)


def _by_words_before(
    sections: Sections, text: str, chain: Chain, last: Chain, own: Sequence[frozenset[str]]
) -> int | None:
    """Return the number of which the last sentences before a relation speak, behind the one in force."""
    first = max(last.end, sections.start_of_line(sections.section_start(chain.lines[0])))
    for k, sentence in enumerate(reversed(_sentences(sections, text, first, chain))):
        if not k and _BOTH.search(sentence):
            return _ALL
        words = _tokens(with_dead_centres(_COMPARISON.sub(" ", sentence)))
        named = {n for n, each in enumerate(own) if each & words}
        if named:
            return None if len(named) > 1 else named.pop()
        ordinal = _ORDINAL.search(_COMPARISON.sub(" ", sentence))
        if ordinal is not None and len(own) > 1 and all(own):
            return 0 if ordinal["first"] or ordinal["one"] else 1
    return None


def _by_words_behind(text: str, chain: Chain, own: Sequence[frozenset[str]]) -> int | None:
    """Return the only number with whose words those right behind a relation agree: 7 in case (a)."""
    words = _tokens(with_dead_centres(_words_behind(text, chain)))
    named = {n for n, each in enumerate(own) if each & words}
    return named.pop() if len(named) == 1 else None


def _sentences(sections: Sections, text: str, first: int, chain: Chain) -> list[str]:
    """Return the last sentences before a relation, without formulas, behind the section's heading."""
    line = chain.lines[0]
    near = max(first, chain.start - 2 * REACH)
    sentences = _SENTENCE.split(_without_formulas(sections, text, near, chain.start))
    heading = sections.heading_above(line)
    own = [each for each in sentences if each.strip(" \t\n$\\([{")][-SENTENCES:]
    is_headed_here = sections.start_of_line(sections.section_start(line)) >= first
    return [heading, *own] if is_headed_here and heading not in own else own


def _lead_of(sections: Sections, text: str, giver: Chain) -> frozenset[str]:
    """Return the words that a number is given with: those of its clause, and of its heading."""
    before, stop = sections.chain_before(giver.start), giver.start
    start = max(0, stop - REACH)
    words = behind = _tokens(with_dead_centres(_words_behind(text, giver)))
    while (not words or words == behind) and stop > start:
        first = before.end + len(_words_behind(text, before)) if before is not None else 0
        words = _tokens(with_dead_centres(_SENTENCE.split(text[max(start, first) : stop])[-1])) | behind
        if before is None or _SENTENCE.search(text, before.end, stop) or before.start >= stop or behind:
            break
        stop = before.start
        before = sections.chain_before(stop)
    return words | _tokens(sections.heading_above(giver.lines[0]))


def _words_behind(text: str, giver: Chain) -> str:
    """Return the words right behind a number that say of what it is, with what stands before them."""
    match = _BEHIND.match(text, giver.end)
    return match[0] if match is not None else ""


def _tokens(words: str) -> frozenset[str]:
    """Return the last words that may tell cases apart, without their endings.

    >>> sorted(_tokens("the small one has"))
    ['small']
    """
    found = [m[0] for m in _TOKEN.finditer(words) if not _LITTLE.fullmatch(m[0]) or m[0].isupper()]
    return frozenset(_ENDING.sub("", w.lower()) if len(w) > 1 else w for w in found[-MOST:])


def _without_formulas(sections: Sections, text: str, start: int, stop: int) -> str:
    shown, place = list[str](), stop
    while (before := sections.chain_before(place)) is not None and before.start >= start:
        shown.append(text[before.end : place])
        place = before.start
    return " ".join([text[start:place], *reversed(shown)])
