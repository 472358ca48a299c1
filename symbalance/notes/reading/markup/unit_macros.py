r"""A document's own macros for units put as these: by \newcommand{\mm}{\,\mathrm{mm}} 40\mm is 40 mm.

The text keeps its length, so that all that was read of it keeps its place: a macro whose unit is longer
than its name stays as it is.
"""

from __future__ import annotations

from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_DEFINED = re.compile(
    r"\\(?:(?:re)?newcommand|providecommand|DeclareRobustCommand)\*?\s{0,3}\{?\s{0,3}(?P<name>\\[A-Za-z]{1,20})\s{0,3}\}?"
    r"(?P<argument>\[1\])?\s{0,3}\{(?P<body>(?:[^{}\n]|\{[^{}\n]{0,60}\}|\{[^{}\n]{0,40}\{[^{}\n]{0,40}\}[^{}\n]{0,20}\}){1,80})\}"
    r"|\\def(?P<plain>\\[A-Za-z]{1,20})\{(?P<short>(?:[^{}\n]|\{[^{}\n]{0,60}\}){1,80})\}"
)
_UPRIGHT = re.compile(r"\\(?:mathrm|text|textrm|mbox|rm|operatorname|unit|si|mathsf|upright)(?![A-Za-z])")
_SETTING = re.compile(
    r"\\(?:mathrm|text|textrm|mbox|rm|operatorname|unit|si|mathsf|ensuremath|xspace|nobreak|thinspace)(?![A-Za-z])"
    r"|\\[,;:! ]|[~{}\s]"
)

_DOT = re.compile(r"\s*(?:\{\\cdot\}|\\cdot(?![A-Za-z]))\s*")
_BETWEEN = re.compile(r"(?<=[A-Za-z])\\,(?=[A-Za-z])")
_DEGREES = (r"^\circ", "°", r"\degree", r"\textdegree")
"""What a macro of a page's own stands for that is the sign of degrees."""


def with_units_shown(text: str) -> str:
    r"""Return a text of the same length in which macros of units behind numbers are these units.

    >>> with_units_shown(r"\newcommand{\mm}{\,\mathrm{mm}} $r = 40\mm$")
    '\\newcommand{\\mm}{\\,\\mathrm{mm}} $r = 40 mm$'
    >>> with_units_shown(r"\newcommand{\ein}[1]{\,\mathrm{#1}} $m = 0,5\ein{kg}$")
    '\\newcommand{\\ein}[1]{\\,\\mathrm{#1}} $m = 0,5     kg $'
    >>> with_units_shown(r"\newcommand{\lbin}{\,\mathrm{lb{\cdot}in}} $M = 3\lbin$")
    '\\newcommand{\\lbin}{\\,\\mathrm{lb{\\cdot}in}} $M = 3lb·in$'
    >>> with_units_shown(r"\newcommand{\dg}{^{\circ}} cranks at $0$, $120\dg$ and $240\dg$")
    '\\newcommand{\\dg}{^{\\circ}} cranks at $0$, $120°  $ and $240°  $'
    """
    if "\\newcommand" not in text and "\\def" not in text and "\\providecommand" not in text:
        return text
    for match in _DEFINED.finditer(text):
        name, body = match["name"] or match["plain"], match["body"] or match["short"]
        is_upright = _UPRIGHT.search(body) is not None
        shown = _SETTING.sub("", _DOT.sub("·", body))
        if "\\," in body and scale_of(shown) is None and shown != "in":
            shown = _SETTING.sub("", _DOT.sub("·", _BETWEEN.sub("·", body)))  # in\,lb
        if shown in _DEGREES and not match["argument"]:
            text = re.sub(rf"(?<=[0-9]){re.escape(name)}(?![A-Za-z])", "°".ljust(len(name)), text)
            continue
        if match["argument"]:
            if is_upright and shown == "#1":
                text = _with_argument_shown(text, name)
        elif is_upright and len(shown) <= len(name) and (shown == "in" or scale_of(shown) is not None):
            behind = rf"(?:(?<=[0-9])|(?<=[0-9]\}})){re.escape(name)}(?![A-Za-z])"
            text = re.sub(behind, shown.rjust(len(name)), text)
    return text


def _with_argument_shown(text: str, name: str) -> str:
    r"""Return a text with blanks for a macro of one argument and its braces: 0,5\ein{kg}."""
    used = re.compile(rf"(?<=[0-9]){re.escape(name)}\{{(?P<unit>[^{{}}\n$]{{1,20}})\}}")
    return used.sub(lambda match: f"{' ' * (len(name) + 1)}{match['unit']} ", text)
