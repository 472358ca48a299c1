r"""Abbreviations that engineers write as letters: BMEP = 4πT/V, \mathrm{bmep}, B.P. = 2πNT, IHP.

So are rpm and HP between the signs of a formula typed without TeX, T = 5252*HP/rpm.

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
_BARE = re.compile(
    r"(?P<rate>(?<=[A-Za-z0-9)][*·×])(?:rpm|RPM)(?![A-Za-z0-9_^.])"
    r"|(?<=[A-Za-z)]/)(?<![0-9] [a-zA-Z]/)(?<![0-9] [a-zA-Z]{2}/)(?:rpm|RPM)(?![A-Za-z0-9_^])"
    r"|(?<![A-Za-z0-9_. ])(?:rpm|RPM)(?=[*·×][A-Za-z0-9(]))"
    r"|(?P<horses>(?<=[*·×/(])(?:HP|hp)(?![A-Za-z0-9_^.])(?=[ \t]?[-+*·×/=)])"
    r"|(?<![A-Za-z0-9_.])HP(?=[ \t]?=[ \t]?[A-Za-z0-9(]))"
)
"""Words that stand as factors beside a typed sign: 5252*HP/rpm, T*rpm/5252; or a power left of =."""
_TYPED = re.compile(r"[A-Za-z0-9)]\*[A-Za-z0-9(]")
_HORSES = re.compile(r"[0-9][ \t]?(?:hp|HP)(?![A-Za-z])|horse[\s-]?power", re.IGNORECASE)
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
    rewriter = Rewriter(text)
    bare = list(_BARE.finditer(text)) if _TYPED.search(text) else []
    has_horses = _HORSES.search(text) is not None
    written = {
        match.start(): (match.end(), "n_{rpm}" if match["rate"] else "P_{hp}")
        for match in bare
        if match["rate"] or has_horses
    }
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
        written[match.start()] = match.end(), f"{letter}_{{{word.replace('.', '').lower()}}}"
    for start, (end, name) in sorted(written.items()):
        rewriter.replace(start, end, name)
    return rewriter.finish() if written else None
