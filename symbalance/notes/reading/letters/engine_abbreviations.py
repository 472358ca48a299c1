r"""Abbreviations that engineers write as letters: BMEP = 4πT/V, \mathrm{bmep}, B.P. = 2πNT, IHP.

Letter by letter they would be products. They are read as one name each, p_{bmep} or P_{bp}: the mean
effective pressures wherever they stand in a formula, the powers where the page speaks of such a power.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_SETTING = r"\\(?:mathrm|text|textrm|mathit|textit|operatorname|mathsf)\s*\{\s*"
_PRESSURE = r"(?:[bifp]?mep|[BIFP]?MEP)"
_POWER = r"[BIF]\.?H?\.?P\.?"
_END = r"(?![A-Za-z0-9_^])"
_WORD = re.compile(
    rf"{_SETTING}(?:(?P<set_pressure>{_PRESSURE})|(?P<set_power>{_POWER}|H\.?P\.?(?=\s*\}}\s*&?=)))\s*\}}"
    rf"|(?<![A-Za-z0-9\\_^{{.])(?:(?P<pressure>{_PRESSURE})|(?P<power>{_POWER})){_END}"
)
_NAMES_POWER = re.compile(
    r"(?:indicated|brake|friction|shaft)\s+(?:horse[\s-]?)?power|horse[\s-]?power", re.IGNORECASE
)
_BEFORE = re.compile(r"(?:[=≈+−*·/(]|\\(?:frac|cdot|times)\b.{0,2}|\{|\s-|\$)\s?$")
_BEHIND = re.compile(r"\s?(?:[=≈*·/−)]|\+|\}|\s-\s|-\s|\\(?:approx|cdot|times|,)|\$)")
_LOOK = 12


def with_abbreviations(text: str) -> Rewritten | None:
    r"""Return a text with its abbreviations as letters with subscripts, None where there are none.

    >>> with_abbreviations(r"so $\mathrm{BMEP} = 4\pi T/V$; the bmep is high").text
    'so $p_{bmep} = 4\\pi T/V$; the bmep is high'
    >>> with_abbreviations("brake power B.P. = 2 pi N T, eta = BP/IP").text
    'brake power P_{bp} = 2 pi N T, eta = P_{bp}/P_{ip}'
    """
    speaks_of_power = _NAMES_POWER.search(text) is not None
    rewriter, changed = Rewriter(text), False
    for match in _WORD.finditer(text):
        word = match["set_pressure"] or match["pressure"] or match["set_power"] or match["power"]
        is_power = bool(match["set_power"] or match["power"])
        before, behind = (
            text[max(0, match.start() - _LOOK) : match.start()],
            text[match.end() : match.end() + _LOOK],
        )
        is_in_formula = _BEHIND.match(behind) or _BEFORE.search(before)
        if not is_in_formula or (is_power and not speaks_of_power):
            continue
        letter = "P" if is_power else "p"
        rewriter.replace(*match.span(), f"{letter}_{{{word.replace('.', '').lower()}}}")
        changed = True
    return rewriter.finish() if changed else None
