"""Multiples and parts in words beside a relation, put into signs: F_2 = twice F_1, 3 times 4 mm = 12 mm.

English and German say them before what is multiplied, Japanese behind it: das 1,17-fache von R, half of
88, rの1.172倍. Only what a relation stands next to is put into signs: where the swing is 1.2 times R, or
so, nothing is claimed. Beside a sum or a stroke it stays in words: twice a + b says two things. 1200 N +
12 % is 12 % more than 1200 N.
"""

from __future__ import annotations

from collections.abc import Iterator

from symbalance.notes.reading.rewriting import Rewriter, Rewritten, Span
from symbalance.text import lazy_patterns as re

_NUMBER = r"[0-9]{1,9}(?:[.,][0-9]{1,9})?"
_FORCE = r"(?:[kMmc]?(?:N|Pa|W|J|m|g|s)|rpm|lb|kp|Hz)"
_UNIT = rf"(?:[ ~]?(?:°|%|‰|(?:{_FORCE}|U/min)(?:[²³]|[ ·]?m|/[A-Za-z]{{1,3}}[²³]?)?(?![A-Za-z_])))?"
_INDEX = r"(?:_\{[^{}\n]{1,12}\}|_[A-Za-z0-9]{1,6}|[\u2080-\u208e]{1,3})"
_LETTER = rf"(?:[A-Za-z\u03b1-\u03c9\u0394\u03a9]{_INDEX}?(?:[²³]|\^[0-9])?)(?![A-Za-z0-9_])"
_OPERAND = (
    rf"(?:{_NUMBER}{_UNIT}|(?!(?:a|A|I)[ ][a-z]{{2}}){_LETTER}(?:[ ·]{_LETTER}(?![ ][a-z]{{2}})){{0,4}})"
)
_Change = tuple[int, int, tuple[str | Span, ...]]
_COUNTS = {
    "two": "2", "three": "3", "four": "4", "five": "5", "six": "6", "eight": "8", "ten": "10",
    "zwei": "2", "drei": "3", "vier": "4", "fünf": "5", "sechs": "6", "acht": "8", "zehn": "10",
}  # fmt: skip
_PARTS = {
    "third": "3",
    "quarter": "4",
    "fourth": "4",
    "fifth": "5",
    "sixth": "6",
    "eighth": "8",
    "tenth": "10",
}
_TEILE = {"Drittel": "3", "Viertel": "4", "Fünftel": "5", "Sechstel": "6", "Achtel": "8", "Zehntel": "10"}
_TENS = {
    "five": "5", "ten": "10", "twenty": "20", "thirty": "30", "forty": "40", "fifty": "50", "sixty": "60",
    "seventy": "70", "eighty": "80", "ninety": "90", "zehn": "10", "zwanzig": "20", "dreißig": "30",
    "vierzig": "40", "fünfzig": "50", "sechzig": "60", "siebzig": "70", "achtzig": "80", "neunzig": "90",
}  # fmt: skip
_MULTIPLES = {"Doppelte": "2", "Zweifache": "2", "Dreifache": "3", "Vierfache": "4", "Fünffache": "5"}
_COUNT = "|".join(_COUNTS)
_AS = r"(?:[ ]as[ ][a-z]{3,8}[ ]as|[ ]so[ ][a-zäöüß]{3,8}[ ]wie)"
_TIMES = rf"(?:times{_AS}?|mal{_AS}?|fois)"
_HALF = rf"(?:[Hh]alf(?:[ ]of)?{_AS}?|(?:[Dd]ie[ ]Hälfte|[Hh]älfte)[ ]von|halb{_AS}"
_HALF += r"|[Ll]a[ ](?:moitié[ ]de|mitad[ ]de|metà[ ]di)|[Mm]etade[ ]de|(?:[Dd]e[ ])?helft[ ]van)"
_MULTIPLE = re.compile(
    rf"(?<![\w.,])(?:(?P<left>{_OPERAND}|(?:{_COUNT})(?=[ ](?:times|mal)))[ ~]{_TIMES}[ ]"
    rf"|(?P<fold>{_NUMBER})(?:[ -]?fold[ ]|-?mal[ ]|-?fach(?:e|en|es)?[ ](?:von[ ])?)"
    rf"|(?:das|dem)[ ](?P<fache>{_NUMBER})[ -]?[fF]ache[n]?[ ]von[ ]"
    rf"|(?:das|dem)[ ](?P<named>{'|'.join(_MULTIPLES)})[ ]von[ ]"
    rf"|(?P<counted>{_COUNT})mal[ ]|(?P<twice>[Tt]wice|double|doppelt){_AS}?[ ]"
    rf"|(?P<half>{_HALF})[ ]"
    rf"|(?:(?P<count>(?i:an?|one|{_COUNT}))[ -](?P<part>{'|'.join(_PARTS)})s?[ ]of[ ])"
    rf"|(?:(?P<zahl>(?i:ein|{_COUNT}))[ ](?P<teil>{'|'.join(_TEILE)})[ ]von[ ])"
    rf"|(?P<tens>(?i:{'|'.join(_TENS)}))[ ](?:per[ ]?cent[ ]of|Prozent[ ]von)[ ]"
    rf"|(?P<share>{_NUMBER})[ ~]?%[ ](?:of|von)[ ](?=[A-Za-z\u03b1-\u03c9]))"
    rf"(?P<right>{_OPERAND})"
)
_JAPANESE = re.compile(
    rf"(?<![A-Za-z0-9_.,])(?P<right>{_OPERAND})[ ]?の[ ]?(?:(?P<times>{_NUMBER})[ ]?倍|(?P<half>半分)"
    rf"|(?P<below>[0-9]{{1,3}})[ ]?分の[ ]?(?P<above>[0-9]{{1,3}})|(?P<share>{_NUMBER})[ ]?%)"
)
_SHARE_ADDED = re.compile(
    rf"(?<![\w.,+−*/·×^-])(?P<whole>{_NUMBER}[ ~]?{_FORCE}(?:[ ·]?m)?(?:/(?:s|mm|m)[²³]?)?)"
    rf"[ ](?P<sign>[+−-])[ ](?P<share>{_NUMBER})[ ~]?%(?=[ ]*[=≈])"
)
_RELATION_BEFORE = re.compile(r"[=≈+−][ ~]*$")
_RELATION_BEHIND = re.compile(r"[ ~]*[=≈]")
_GOES_ON = re.compile(
    r"[ ~]*(?:[-+−*/·×^(²³]"
    r"|(?:plus|minus|times|mal|over|durch|divided|geteilt|squared|cubed|hoch|sin|cos|tan)\b)"
)
_TO_RELATION = re.compile(
    r"[ ~$]*(?:[,:;、，：]|\bor\b|\bso\b|で|は)?[ ~]*(?:[^\W\d]{1,8}[ ~]){0,2}[$`*]*"
)
"""From a multiple to the relation that has its number: half of 811 N m, so M = 406 N m."""
_TIMES_SIGN = " ⋅ "
"""Neither × nor ·: where products have a cross, a point between digits is a decimal point."""
_BEFORE = 8
"""Characters looked at before a multiple for the sign of a relation."""


def with_multiples_in_signs(text: str) -> Rewritten | None:
    """Return a text with multiples and parts beside its relations in signs, None where there are none.

    >>> with_multiples_in_signs("So F_2 = twice F_1 = 2400 N, half of 88 = 44.").text
    'So F_2 = 2 ⋅ F_1 = 2400 N, (1/2) ⋅ 88 = 44.'
    >>> with_multiples_in_signs("It is 1.2 times R, or twice the swing.") is None
    True
    """
    kinds = (_before_their_operand, _behind_their_operand, _shares_added)
    changes = sorted((change for kind in kinds for change in kind(text)), key=lambda change: change[:2])
    if not changes:
        return None
    rewriter = Rewriter(text)
    for start, end, parts in changes:
        if start >= rewriter.place:
            rewriter.replace(start, end, *parts)
    return rewriter.finish()


def multiple_said_before(text: str) -> float | None:
    """Return the number that words at the end of a text compute, None for others.

    >>> multiple_said_before("we take half of 811 N m, so ")
    405.5
    """
    matches = [*_MULTIPLE.finditer(text), *_JAPANESE.finditer(text)]
    last = max(matches, key=re.Match.end, default=None)
    if last is None or not _TO_RELATION.fullmatch(text[last.end() :]):
        return None
    number = re.match(_NUMBER, last["right"])
    factor = _multiple(last)
    return None if number is None or factor is None else factor * _value(number.group())


def _multiple(match: re.Match[str]) -> float | None:
    """Return what a multiple in words multiplies by, None where that is a letter."""
    groups = match.groupdict()
    if digits := next((groups[n] for n in ("times", "fold", "fache", "share") if groups.get(n)), ""):
        return _value(digits) / (100 if groups["share"] else 1)
    if groups.get("above"):
        return float(groups["above"]) / float(groups["below"])
    if groups["half"]:
        return 0.5
    if groups.get("left"):
        count = _COUNTS.get(groups["left"], groups["left"])
        return _value(count) if re.fullmatch(_NUMBER, count) else None
    if part := _part(match):
        above, _, below = part.strip("()").partition("/")
        return float(above.rstrip(" %")) / float(below or 100)
    return float(_MULTIPLES.get(groups["named"], _COUNTS.get(groups["counted"], "2")))


def _value(digits: str) -> float:
    return float(digits.replace(",", "."))


def _before_their_operand(text: str) -> Iterator[_Change]:
    for match in _MULTIPLE.finditer(text):
        if not _is_claimed(text, match):
            continue
        if match["left"] is not None:
            factor: str | Span = _COUNTS.get(match["left"]) or match.span("left")
            yield match.start(), match.start("right"), (factor, _TIMES_SIGN)
        else:
            yield match.start(), match.start("right"), (*_factor(match), _TIMES_SIGN)


def _factor(match: re.Match[str]) -> tuple[str | Span, ...]:
    """Return what a multiple multiplies by, a number of the text in its own place."""
    for name in ("fold", "fache"):
        if match[name]:
            return (match.span(name),)
    if match["share"]:
        return (match.span("share"), " %")
    if part := _part(match):
        return (part,)
    if match["named"]:
        return (_MULTIPLES[match["named"]],)
    return (_COUNTS[match["counted"]] if match["counted"] else "2",)


def _part(match: re.Match[str]) -> str:
    """Return a half, two thirds or twenty percent in signs, "" for a multiple."""
    if match["half"]:
        return "(1/2)"
    if match["part"] or match["teil"]:
        below = _PARTS[match["part"]] if match["part"] else _TEILE[match["teil"]]
        return f"({_COUNTS.get((match['count'] or match['zahl']).lower(), '1')}/{below})"
    return f"{_TENS[match['tens'].lower()]} %" if match["tens"] else ""


def _behind_their_operand(text: str) -> Iterator[_Change]:
    for match in _JAPANESE.finditer(text) if "の" in text else ():
        if not _is_claimed(text, match):
            continue
        factor: tuple[str | Span, ...] = ("(1/2)",)
        if match["times"]:
            factor = (match.span("times"),)
        elif match["share"]:
            factor = (match.span("share"), " %")
        elif match["above"]:
            factor = (f"({match['above']}/{match['below']})",)
        yield match.end("right"), match.end(), (_TIMES_SIGN, *factor, " ")


def _shares_added(text: str) -> Iterator[_Change]:
    for match in _SHARE_ADDED.finditer(text) if "%" in text else ():
        sign = "+" if match["sign"] == "+" else "-"
        yield match.end("whole"), match.end(), (f"{_TIMES_SIGN}(1 {sign} ", match.span("share"), " %)")


def _is_claimed(text: str, match: re.Match[str]) -> bool:
    """Tell whether a relation stands right before or behind a multiple, and no sum or stroke does."""
    before, behind = (
        text[max(match.start() - _BEFORE, 0) : match.start()],
        text[match.end() : match.end() + 16],
    )
    if _GOES_ON.match(behind) or "\n" in match.group():
        return False
    return _RELATION_BEFORE.search(before) is not None or _RELATION_BEHIND.match(behind) is not None
