r"""Letters told apart by a mark: \mathcal{F}_1 beside F_1, and θ^* that the page gives a value.

A font makes another letter only where the page has the plain one too; a star is the conjugate's
unless the page sets the starred letter equal to something and has no complex numbers.
"""

from __future__ import annotations

from symbalance.document.letters import GREEK_SIGN
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_SCRIPT = r"(?:_(?:\{(?P<in>[\w,]{1,8})\}|(?P<one>[A-Za-z0-9])))?"
_FONT = re.compile(
    rf"\\(?:mathcal|mathscr|mathfrak)\s?(?:\{{\s?(?P<braced>[A-Za-z])\s?\}}|(?P<bare>[A-Za-z])(?![A-Za-z])){_SCRIPT}"
)
_GREEK = "|".join(sorted(GREEK_SIGN, key=len, reverse=True))
_STAR = re.compile(
    rf"(?P<letter>\\(?:{_GREEK})(?![A-Za-z])|(?<![A-Za-z\\])[A-Za-z]){_SCRIPT}\s?\^\s?(?:\{{\s?)?(?:\*|\\ast(?![A-Za-z]))(?:\s?\}})?"
)
_HEAD_BEFORE = re.compile(r"(?:[$({;,.:]|\\\\|\\\[|\\q?quad|\n|^|\\\()\s*$")
_VALUE_BEHIND = re.compile(r"\s?&?\s?(?:=|≈|\\approx|:=|\\coloneqq)")
_COMPLEX = re.compile(
    r"(?:e|\\mathrm\{e\})\s?\^\s?\{?\s?[-+]?\s?(?:\\mathrm\s?\{?)?[ij](?![A-Za-z])|\\(?:Re|Im|overline|bar)(?![A-Za-z])"
    r"|[+-]\s?(?:\\mathrm\s?\{?)?[ij](?![A-Za-z_])|\bconjugate|\bkomplex|\bcomplex|konjugiert|複素|共役"
)


def with_marked_letters(text: str) -> Rewritten | None:
    r"""Return a text in which such letters have their mark as a subscript, None where there are none.

    >>> with_marked_letters(r"$\mathcal{F}_1 = F_1/F$").text, with_marked_letters(r"$\mathcal{F}_1$")
    ('$F_{1,cal} = F_1/F$', None)
    >>> with_marked_letters(r"$\theta^* = 3$ and $x + \theta^\ast$").text
    '$\\theta_{*} = 3$ and $x + \\theta_{*}$'
    """
    changes: dict[int, tuple[int, str]] = {}
    fonts = list(_FONT.finditer(text))
    if fonts:
        others = _FONT.sub(" ", text)
        for match in fonts:
            letter = match["braced"] or match["bare"]
            if re.search(rf"(?<![A-Za-z\\{{]){letter}(?![A-Za-z])", others):
                changes[match.start()] = match.end(), f"{letter}_{{{_script(match, 'cal')}}}"
    stars = list(_STAR.finditer(text)) if _COMPLEX.search(text) is None else []
    defined = {match["letter"] for match in stars if _is_defined(text, match)}
    for match in stars:
        if match["letter"] in defined:
            changes[match.start()] = match.end(), f"{match['letter']}_{{{_script(match, '*')}}}"
    changes |= _starred_in_plain_text(text)
    if not changes:
        return None
    rewriter = Rewriter(text)
    for start, (end, written) in sorted(changes.items()):
        rewriter.replace(start, end, written)
    return rewriter.finish()


_PLAIN_STAR = re.compile(r"(?<![\w\\*^{}$`])(?P<letter>[A-Za-z\u03b1-\u03c9])(?P<star>\*)(?![\w*`(\[\\])")
_SET_EQUAL = re.compile(r"[ ]?(?:=(?!=)|≈)")
_OPERATION_BEFORE = re.compile(r"[+\-−*/·×=≈<>(^][ ]?$")


def _starred_in_plain_text(text: str) -> dict[int, tuple[int, str]]:
    """Return the stars of letters typed J* = J + m r², where one of them is set equal to something."""
    stars = list(_PLAIN_STAR.finditer(text))
    defined = {
        match["letter"]
        for match in stars
        if _SET_EQUAL.match(text, match.end())
        and _OPERATION_BEFORE.search(text, max(match.start() - 2, 0), match.start()) is None
    }
    return {m.start("star"): (m.end(), "_{*}") for m in stars if m["letter"] in defined}


def _script(match: re.Match[str], mark: str) -> str:
    own = match["in"] or match["one"]
    return f"{own},{mark}" if own else mark


def _is_defined(text: str, match: re.Match[str]) -> bool:
    """Tell whether a starred letter is all that stands left of an equals sign."""
    before = text[max(match.start() - 12, 0) : match.start()]
    return _VALUE_BEHIND.match(text, match.end()) is not None and _HEAD_BEFORE.search(before) is not None
