r"""Superscripts that are no powers: F^{tot}_2 is the letter F_{2,tot}, and r^2_1 is r_1^2 turned.

TeX sets a subscript and a superscript above each other, in whichever order they are typed. A word above
a letter tells letters apart, as one below it does: \mathrm{max}, tot, II. A single letter may be a power.
"""

from __future__ import annotations

from symbalance.document.letters import GREEK_SIGN
from symbalance.document.wordlists import word_set
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_GREEK = "|".join(sorted(GREEK_SIGN, key=len, reverse=True))
_GROUP = r"\{(?:[^{}\n]|\{[^{}\n]{0,40}\}){1,60}\}"
_SET = r"\\(?:mathrm|text|textrm|mathsf|textsf|operatorname|rm)"
_WORD_SET = rf"{_SET}\s?\{{[^{{}}\n]{{1,20}}\}}"
_ABOVE = rf"{_GROUP}|{_WORD_SET}|[A-Za-z0-9*]"
_BELOW = rf"{_GROUP}|{_WORD_SET}|\\(?:max|min|{_GREEK})(?![A-Za-z])|[A-Za-z0-9]"
_ACCENTED = r"\\(?:dot|ddot|bar|hat|tilde|vec|mathbf|bm)\s?\{[A-Za-z]\}"
_SCRIPTS = re.compile(
    rf"(?P<letter>\\(?:{_GREEK})(?![A-Za-z])|(?<![A-Za-z\\])[A-Za-z](?![A-Za-z])|{_ACCENTED})\s?"
    rf"(?:\^\s?(?P<raised>{_ABOVE})(?:\s?_\s?(?P<lowered>{_BELOW}))?"
    rf"|_\s?(?P<first>{_BELOW})\s?\^\s?(?P<second>{_ABOVE}))"
)
_UPRIGHT = re.compile(rf"\{{?\s?{_SET}\s?\{{?\s?(?P<word>[A-Za-z]{{2,12}}\.?|[A-SU-Z])\s?\}}?\s?\}}?")
_WORD = re.compile(
    r"\{\s?(?:\\(?=max|min|lim))?(?P<word>(?=[a-z]*[aeou])[a-z]{3,8}|max|min|lim|kin|ind|lin|I{2,3}|IV|VI{0,2})\s?\}"
)
_ORDINALS = word_set("th st nd rd te ten er e eme")


def with_scripts_in_order(text: str) -> Rewritten | None:
    r"""Return a text with each subscript before its power, and words above letters below them.

    None where nothing changes.

    >>> with_scripts_in_order(r"$F^{tot}_{2,\max} = r^2_1 + \omega^2$").text
    '$F_{2,\\max,tot} = r_1^2 + \\omega^2$'
    >>> with_scripts_in_order(r"$F^\mathrm{osc} + e^{ik} + x^n$").text
    '$F_{osc} + e^{ik} + x^n$'
    >>> with_scripts_in_order(r"$\varepsilon^{\kappa} + x^{kappa}$") is None
    True
    """
    if "^" not in text:
        return None
    rewriter, changed = Rewriter(text), False
    for match in _SCRIPTS.finditer(text):
        raised, lowered = ("raised", "lowered") if match["raised"] else ("second", "first")
        word = _word_above(match, raised)
        if word is None and (raised == "second" or not match["lowered"]):
            continue
        below = match[lowered] or ""
        if word is None:
            script = f"_{below}^{match[raised]}"
        else:
            inside = below[1:-1] if below.startswith("{") else below
            script = f"_{{{inside},{word}}}" if inside else f"_{{{word}}}"
        rewriter.replace(*match.span(), match.span("letter"), script)
        changed = True
    return rewriter.finish() if changed else None


def _word_above(match: re.Match[str], group: str) -> str | None:
    """Return the word that a letter has above it, None for a power."""
    raised = _UPRIGHT.fullmatch(match[group]) or _WORD.fullmatch(match[group])
    if raised is None or match["letter"] == "e":
        return None
    if raised["word"] in _ORDINALS or raised["word"] in GREEK_SIGN:  # ε^κ is a power, typed in any way
        return None
    return raised["word"]
