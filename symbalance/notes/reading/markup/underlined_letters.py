r"""Letters with a line below: \underline{Z} is a phasor beside its size Z, or a letter that is stressed.

It is a letter of its own only on a page of complex numbers that has the bare letter too; elsewhere the
line below says no more than a frame does.
"""

from __future__ import annotations

from functools import lru_cache

from symbalance.text import lazy_patterns as re

_UNDERLINED = re.compile(r"\\underline\s*(?:\{\s*(?P<braced>\\?[A-Za-z]+)\s*\}|(?P<bare>[A-Za-z]))")
_COMPLEX = re.compile(
    r"\\(?:Re|Im|angle|operatorname\{(?:Re|Im)\})(?![A-Za-z])|[|]\s?\\underline|\\underline\{[^{}]{1,12}\}\s*\^\s*\{?\s*(?:\*|\\ast)"
    r"|(?:e|\\mathrm\{e\}|\\e)\s?\^\s?\{?\s?[-+]?(?:\\mathrm\s?\{?)?[ij](?![A-Za-z])|[+-]\s?(?:\\mathrm\s?\{?)?[ij](?![A-Za-z_])"
)
_FEWEST = 2


def is_underlined_letter(text: str, place: int) -> bool:
    r"""Tell whether the \underline at a place makes a letter of its own.

    >>> page = r"$\underline{Z} = R + jX$, so $Z = |\underline{Z}|$"
    >>> is_underlined_letter(page, 1), is_underlined_letter(r"$\underline{F} = 3$ is $F$", 1)
    (True, False)
    """
    match = _UNDERLINED.match(text, place)
    return match is not None and (match["braced"] or match["bare"]) in _letters(text)


@lru_cache(maxsize=8)
def _letters(text: str) -> frozenset[str]:
    """Return the underlined letters of a page of complex numbers that it has without the line too."""
    places = list(_UNDERLINED.finditer(text))
    if len(places) < _FEWEST or _COMPLEX.search(text) is None:
        return frozenset()
    others = _UNDERLINED.sub(" ", text)
    letters = {match["braced"] or match["bare"] for match in places}
    return frozenset(
        letter
        for letter in letters
        if (len(letter) == 1 or letter.startswith("\\"))
        and re.search(rf"(?<![A-Za-z\\]){re.escape(letter)}(?![A-Za-z])", others)
    )
