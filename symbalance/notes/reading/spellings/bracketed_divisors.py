r"""Units with several parts below their stroke, in brackets: 287 J/(kg K) is 287 J/kg/K.

Brackets behind a stroke hold a product of letters elsewhere. They are of a unit right behind a number,
all of whose parts are units, and none a letter to which the page gives a value: 3 W/(m K) where m = 2 kg
may be a quotient.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.units import divisors_apart, scale_of
from symbalance.text import lazy_patterns as re

_EXPONENT = r"(?:\^\{?[1-4]\}?|[²³⁴])?"
_WORD = rf"[A-Za-zµμ]{{1,4}}{_EXPONENT}"
_SPACE = r"(?:\s|~|\\[,;: ]){0,2}"
_JOINT = rf"{_SPACE}(?:[·⋅*.]|\\cdot(?![A-Za-z])|\\times(?![A-Za-z]))?{_SPACE}"
_PRODUCT = rf"{_WORD}(?:{_JOINT}{_WORD}){{0,2}}"
_BEHIND_NUMBER = r"(?<=[0-9}])(?P<gap>(?:[ ~\u2009\u202f$]|\\[,;: ]){0,3})"
_OPENED = r"(?P<set>\\(?:mathrm|text|textrm|mbox|unit)\s?\{\s?)?"
_DIVISOR = re.compile(
    rf"{_BEHIND_NUMBER}{_OPENED}(?P<above>{_PRODUCT}){_SPACE}/{_SPACE}"
    rf"\(\s?(?P<below>{_PRODUCT})(?:\s?/\s?(?P<twice>{_WORD}))?\s?\)(?![\w^'′²³(])"
)
_PARTS = re.compile(_WORD)
_LONG = re.compile(r"[A-Za-zµμ]{2,}")
_VALUE = r"(?<![\w\\{{^./·*+\-−]){letter}(?:_?[0-9])?(?:[ ]?&)?[ ]?[=≈](?!=)"
_MORE = re.compile(r"[ ]?(?:[·⋅*+]|\\cdot|[A-Za-z(](?![A-Za-z]))")
"""What goes on with a formula behind the brackets: 3 W/(m s) · t."""


def with_bracketed_divisors(text: str) -> Rewritten | None:
    r"""Return a text with such units as they are read, None where there are none.

    >>> with_bracketed_divisors("R = 287 J/(kg K), d = 40 N/(m/s)").text
    'R = 287 J/kg/K, d = 40 N s/m'
    >>> with_bracketed_divisors(r"$c = 1\,\mathrm{kJ/(kg\,K)}$").text
    '$c = 1\\,\\mathrm{kJ/kg/K}$'
    >>> with_bracketed_divisors("m = 2 kg, x = 3 W/(m K), y = 2 F/(r s)") is None
    True
    """
    rewriter, is_found = Rewriter(text), False
    for match in _DIVISOR.finditer(text):
        if not _is_unit(match, text):
            continue
        start = match.start("above")
        rewriter.replace(start, match.end(), divisors_apart(text[start : match.end()]))
        is_found = True
    return rewriter.finish() if is_found else None


def _is_unit(match: re.Match[str], text: str) -> bool:
    parts = _PARTS.findall(match["above"]) + _PARTS.findall(match["below"])
    parts += [match["twice"]] if match["twice"] else []
    if len(parts) < 3 or any(scale_of(part) is None for part in parts):
        return False
    bare = [re.sub(r"[\^{}0-9²³⁴]", "", part) for part in parts]
    if match["set"]:
        return True
    if _MORE.match(text, match.end()):
        return False
    short = {part for part in bare if len(part) == 1}
    is_long = any(_LONG.fullmatch(part) for part in bare)
    has_own = any(re.search(_VALUE.format(letter=each), text) for each in short)
    return is_long or not has_own
