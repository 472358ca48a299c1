"""What a page says behind a letter that it is: with p the pressure in the cylinder and D the bore.

In such a list each letter has its words behind it, up to the next letter; in "with bore D and pressure p"
they stand before it. What stands between two letters goes with the one from which no comma or "and"
parts it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from symbalance.text import lazy_patterns as re

SIGN = (
    r"\\?(?:[^\W\d_]|\\?[A-Za-z]{2,9})(?:_(?:\{[^{}$]{1,14}\}|\w))?'{0,2}"
    r"|\\[a-z]{3,8}\s?\{?\\?[A-Za-z]+\}?(?:_\w)?"
)
_LONE = re.compile(rf"\$\s?(?P<sign>{SIGN})(?:\([^()$]{{1,9}}\))?\s?\$|\\\(\s?(?P<other>{SIGN})\s?\\\)")
"""A letter alone between the marks of a formula."""
_ENDS = re.compile(r"[.。!?](?=\s|$)|\n\s*\n|\$\$|\\\[|\\begin|;\s*\n")
"""Where a sentence ends, or a displayed formula begins."""
_LINK = (
    r"with|where|here|let|and|for|if|mit|wobei|worin|darin|hier|und|sei(?:en)?|für|soit|soient|avec|où|et"
    r"|con|dove|ed?|y|donde|sean?|siano?|dett[aeio]|と|は"
)
_INTRODUCED = re.compile(rf"(?:^|[(,;:.、。*•-]|(?<![^\W\d_])(?:{_LINK}))[\s*]*$", re.IGNORECASE)
"""Before a letter whose words stand behind it: with p the pressure."""
_IS = re.compile(
    r"\s*(?:is|are|be|being|denotes?|means?|stands? for|represents?|ist|sind|sei(?:en)?|bezeichnet"
    r"|bedeutet|est|étant|désigne|è|essendo|sia|siendo|es|denota|indica)\s+",
    re.IGNORECASE,
)
_ARTICLE = re.compile(
    r"\s*(?:the|its|an?|their|one|der|die|das|de[mn]|ein(?:e[rmn]?)?|le|la|les|un[ae]?|il|el|los|las)\s+"
    r"|\s*l['’]",
    re.IGNORECASE,
)
_PARTED = re.compile(r"(?:[,;、]|(?<![^\W\d_])(?:and|und|ed?|et|y))\s*$", re.IGNORECASE)
_PARTED_BEFORE = re.compile(r"\s*(?:[,;、]|(?:and|und|ed?|et|y)\s)", re.IGNORECASE)
_NAME_ENDS = re.compile(
    r"[,;:.(。、$=]|\s(?:and|und|et|which|that|so that|then|when|welche[rs]?|che|que|qui)\s|\\"
)
_CLAUSE = re.compile(
    r"\s(?:is|are|be|becomes?|has|have|gives?|follows?|ist|sind|wird|beträgt|hat|gilt|folgt|est|vaut|sont"
    r"|è|vale|es)\s",
    re.IGNORECASE,
)
"""A verb that makes of the words behind a letter what is said of another thing."""
LONGEST = 110
"""Characters of the words behind a letter that say what it is."""
_PREPOSITION = re.compile(
    r"\s(?=(?:of (?:the|an?|its|one|each|every|both)|in|on|at|from|to|between|along|per|for|against|about"
    r"|through|by|with|without|due|under|above|below|acting|after|before|measured|counted|der|des|von|vom|am|im|an|zu|zum|zur|auf|ab|bei"
    r"|gegen|um|zwischen|nach|mit|du|de|della?|del|en|a|por|desde|entre)\b)",
    re.IGNORECASE,
)
_ADJECTIVE = re.compile(
    r"\s(total[ei]?|mean|relative?|relativa|absolue?|absolut[ao]|constante?|maxim\w+|minim\w+|result\w+"
    r"|uniforme?|linéique|medi[ao])$",
    re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class SaidBehind:
    """A letter as it is typed, and the words behind it that say what it is."""

    sign: str
    start: int
    words: str


def all_said_behind(text: str) -> Iterator[SaidBehind]:
    """Yield each letter that a text explains behind it.

    >>> text = "with $p$ the absolute pressure in the cylinder, $p_0$ that outside and $D$ the bore."
    >>> [(each.sign, each.words) for each in all_said_behind(text)]
    [('p', 'absolute pressure in the cylinder'), ('D', 'bore')]
    """
    letters = list(_LONE.finditer(text))
    is_listed = False  # whether the letter before had its words behind it
    for k, match in enumerate(letters):
        before = text[max(0, match.start() - 24) : match.start()]
        behind = text[match.end() : match.end() + LONGEST]
        end = _ENDS.search(behind)
        following = letters[k + 1].start() - match.end() if k + 1 < len(letters) else LONGEST
        is_last = (end.start() if end else LONGEST) < following or following >= LONGEST
        between = behind[: min(following, end.start() if end else LONGEST)]
        has_end = end is not None and end.start() <= following and end[0] in ".。!?"
        words = _words(between, before, is_last=is_last, is_listed=is_listed, has_end=has_end)
        is_listed = bool(words) and not is_last
        if words:
            group = "sign" if match["sign"] else "other"
            yield SaidBehind(match[group], match.start(group), words)


def _words(between: str, before: str, *, is_last: bool, is_listed: bool, has_end: bool) -> str:
    """Return the name behind a letter; "" where the words there are no name, or of what follows."""
    link = _IS.match(between)
    if link is None:
        is_parted = is_last or _PARTED.search(between) is not None
        if (
            not is_parted
            or _PARTED_BEFORE.match(between)
            or not (is_listed or _INTRODUCED.search(before))
        ):
            return ""
    article = _ARTICLE.match(between, link.end() if link is not None else 0)
    if article is None:
        return ""  # F is given by, m is 3 kg
    rest = between[article.end() :]
    end = _NAME_ENDS.search(rest)
    name = rest[: end.start() if end else len(rest)]
    if is_last and _CLAUSE.search(name):
        return ""  # between the radii a and b the force is F: a clause of its own
    runs_on = not has_end if end is None else end[0] in "$=\\"
    if runs_on and (is_last or link is not None):
        return ""  # with β the force $$F = …$$, mit F ist das Moment $M = …$: the formula's words
    return name.replace("\n", " ").strip()


def heads_of(name: str) -> Iterator[str]:
    """Yield a name, and what is left of it before each of its prepositions, the longest first.

    Each also with an adjective behind it, as Romance languages have it, put before.

    >>> list(heads_of("angle of the rod to the axis"))
    ['angle of the rod to the axis', 'angle of the rod', 'angle']
    >>> list(heads_of("speed mean"))
    ['speed mean', 'mean speed', 'speed']
    >>> list(heads_of("moment of inertia of the flywheel"))
    ['moment of inertia of the flywheel', 'moment of inertia']
    """
    cuts = [len(name), *reversed([match.start() for match in _PREPOSITION.finditer(name)])]
    for cut in cuts:
        yield name[:cut]
        if (behind := _ADJECTIVE.search(name[:cut])) is not None:
            yield f"{behind[1]} {name[: behind.start()]}"
            yield name[: behind.start()]


def shortest_head_of(name: str) -> str:
    """Return what stands before the first preposition of a name: the angle, of the angle of the rod."""
    match = _PREPOSITION.search(name)
    return name[: match.start()] if match is not None else name
