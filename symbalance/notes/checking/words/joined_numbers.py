"""Numbers of one letter in one breath: for x = 2 and for x = 3; x = 2 or x = 3; neither this nor that.

What is said behind them is said of each, unless its words name one of them: "in the first case x² = 4".
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_WORD = (
    r"(?:and|or|as\s+well\s+as|nor|neither|und|oder|sowie|bzw\.|noch|wie\s+auch|et|ou"
    r"|ainsi\s+que|soit|ni|e|o|oppure|né|sia|y|u)"
)
_PLACE = r"(?:also|even|auch|either|for|at|with|if|when|für|bei|mit|wenn|pour|à|avec|si|per|con|se|para)"
_JOIN = re.compile(
    rf"[\s$)}}\]]*(?:(?P<comma>[,;])?[\s$]*(?P<word>(?<![^\W\d_]){_WORD}(?![^\W\d_])\s*"
    rf"(?:{_PLACE}\s+){{0,3}})?|(?P<sign>または|あるいは|および|と|や|でも|の場合も?、?))[\s$({{\[]*"
)
"""Between two numbers of a letter that are named in one breath; a comma alone joins within a list."""
_SENTENCE = re.compile(r"(?<![0-9])(?<!bzw)(?<!resp)[.!?;](?=\s|$)|[。；]|\n\s*\n")
_THEN = re.compile(
    r"[\s$)*]*[.;。]?\s*(?:then|so|thus|hence|therefore|always|in\s+(?:each|every|either|any|both)\s+cases?|dann|also|daher|somit|immer|stets"
    r"|in\s+(?:jedem|beiden)\s+F[aä]ll(?:en)?|alors|donc|toujours|dans\s+(?:chaque|tous\s+les|les\s+deux)\s+cas|allora|quindi|sempre"
    r"|in\s+(?:ogni\s+caso|entrambi\s+i\s+casi)|entonces|siempre|en\s+(?:cada\s+caso|ambos\s+casos)|よって|いずれの場合も|どちらの場合も|どの場合も)"
    r"(?![^\W\d_])",
    re.IGNORECASE,
)
"""Words that lead on from alternatives in a sentence of their own."""
_NEITHER = re.compile(r"(?<![^\W\d_])(?:neither|weder|ni|né)\s+(?:\w+\s+){0,2}[\s$({\[]*$", re.IGNORECASE)
_CASE = (
    r"(?<![^\W\d_])(?:(?:in|for|of|im|in\s+dem|für|bei|beim|dans|pour|à|nel|per|en|para|,|;|and|und|et|e|y)\s+)?"
    r"(?:(?:the|der|den|dem|die|das|im|le|la|il|el|l['’])\s*)"
)
_FIRST = r"(?:first|former|erste[nrsm]?|premi(?:er|[eè]re)|primo|prima|primera?)"
_SECOND = (
    r"(?:second|latter|other|zweite[nrsm]?|andere[nrsm]?|deuxième|seconde?|autre|secondo|seconda"
    r"|altro|segund[oa]|otr[oa])"
)
_ORDINAL = re.compile(
    rf"{_CASE}(?:(?P<first>{_FIRST})|(?P<second>{_SECOND}))"
    r"(?=\s+(?:case|one|fall|cas|caso|is|it|we|gives?|has|ist|gilt|hat|gibt|on|est|è|es|si|se)(?![^\W\d_])|[\s,:$]*$)"
    r"|(?P<one>前者|(?:第一|最初|1つ目)の場合)|(?P<two>後者|(?:第二|2つ目|次)の場合)",
    re.IGNORECASE,
)
"""Words that name one of two numbers by its turn: in the first case, im zweiten Fall, dans le second."""
_NEAR = 40


@dataclass(frozen=True, slots=True)
class Joined:
    """The last of several numbers of a letter that stand in one breath, by their places in a sequence."""

    first: int
    """The place of the first one of them; they go on to the end of the sequence."""
    is_denied: bool
    """Whether what is said of them is said of none: neither for x = 2 nor for x = 3."""


def joined_numbers(text: str, givers: Sequence[Chain]) -> Joined | None:
    """Return which numbers of a letter stand in one breath, up to the last; None for fewer than two."""
    first, has_word = len(givers) - 1, False
    while first:
        match = _JOIN.fullmatch(text, givers[first - 1].end, givers[first].start)
        is_word = match is not None and (match["word"] or match["sign"]) is not None
        if match is None or not (is_word or match["comma"]) or not (is_word or has_word):
            break
        has_word = has_word or is_word
        first -= 1
    if first == len(givers) - 1:
        return None
    start = givers[first].start
    return Joined(first, _NEITHER.search(text, max(0, start - _NEAR), start) is not None)


def named_by_turn(words: str) -> int | None:
    """Return 0 for the first and 1 for the second case that words speak of last, None for neither.

    >>> named_by_turn("In the first case"), named_by_turn("im zweiten Fall gilt"), named_by_turn("then")
    (0, 1, None)
    """
    found = [*_ORDINAL.finditer(words)]
    return None if not found else 0 if found[-1]["first"] or found[-1]["one"] else 1


def is_said_of_each(text: str, last: Chain, chain: Chain) -> bool:
    """Tell whether a relation is said of each of the numbers that stand in one breath before it.

    It stands in their sentence, or in the next one behind "then".
    """
    between = text[last.end : chain.start]
    ends = [*_SENTENCE.finditer(between)]
    return not ends or (len(ends) == 1 and _THEN.match(between, ends[0].start()) is not None)
