r"""Tables of two columns that say what quantities are, `| F_1 | 4 m r ω² |`, put as equations.

Only under a heading of quantities, symbols or parameters, and where the first cell is letters and the
second a formula or a number; a column of units or of meanings says nothing of the kind.
"""

from __future__ import annotations

from collections.abc import Iterator

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.signs import RELATION
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_QUANTITY = re.compile(
    r"(?:physical\s)?(?:quantit(?:y|ies)|symbols?|parameters?|variables?|letters?|terms?|expressions?|formulae?s?|sums?"
    r"|größen?|formelzeichen|zeichen|ausdr(?:uck|ücke)|terme?|summen?|bezeichnung|forces?|kräfte?|kraft|moments?"
    r"|momente?|grandeurs?|symboles?|量|物理量|記号|諸元|項目|変数|力)(?:\s?\([^()]{1,20}\))?",
    re.IGNORECASE,
)
_NO_VALUE = re.compile(
    r"units?|einheit(?:en)?|unité|単位|meanings?|bedeutung|description|beschreibung|意味|説明|definition|name|explanation"
    r"|erklärung|remark|bemerkung|dimension",
    re.IGNORECASE,
)
_MARKS = re.compile(r"\*{1,2}|\$|\\[()]|`")
_LETTERS = re.compile(
    r"[+−-]?\s*(?:[0-9]{0,3}\s*)(?:(?:\\(?!text|mathrm|begin|end)[a-zA-Z]+|[^\W\d_])(?:_(?:\{[\w,\\]{1,14}\}|\w{1,8})|[₀-₉]{1,3})?"
    r"(?:\^\{?[0-9]\}?|[²³⁴])?['′]?\s*[·*⋅+−/-]?\s*){1,6}"
)
_WORD = re.compile(r"(?<![\\A-Za-z_{])[A-Za-zäöüß]{3,}")
_VALUE = re.compile(r"[0-9=+*/·⋅²³^√]|\\(?:frac|cdot|sqrt|sin|cos|omega|lambda)|[α-ω]|[A-Za-z]\s[A-Za-z]")
_SEPARATOR = re.compile(r"[ \t]*\|?[ \t]*:?-{2,}:?[ \t]*\|[ \t]*:?-{2,}:?[ \t]*\|?[ \t]*$")
_ROW = re.compile(
    r"^[ \t]*\|(?P<first>[^|\n]{1,80})(?P<bar>\|)(?P<second>[^|\n]{1,200})\|[ \t]*$", re.MULTILINE
)
_TABULAR = re.compile(
    r"\\begin\s?\{tabular\}\s?\{[^{}\n]{2,20}\}(?P<rows>(?:(?!\\begin|\\end).){1,6000}?)\\end\s?\{tabular\}",
    re.DOTALL,
)
_TEX_ROW = re.compile(
    r"(?P<first>[^&\\]*(?:\\[A-Za-z,;][^&\\]*)*)(?P<bar>&)(?P<second>(?:(?!\\\\)[^&])*)(?:\\\\|$)"
)
_RULE = re.compile(r"\\(?:hline|toprule|midrule|bottomrule|cline\{[^{}]*\})")


def with_equations_of_tables(text: str, kind: str) -> Rewritten | None:
    """Return a text with such rows as equations, None where there are none.

    >>> page = "| quantity | value |\\n|---|---|\\n| F_1 | 4 m r ω² |\\n"
    >>> with_equations_of_tables(page, "markdown").text.splitlines()[2]
    '| F_1 = 4 m r ω² |'
    """
    rows = list(_rows_of_tex(text) if kind == "tex" else _rows(text) if kind == "markdown" else ())
    if not rows:
        return None
    rewriter = Rewriter(text)
    for row in rows:
        start, end = row.span("bar")
        first, second = row["first"].rstrip(), row["second"].lstrip()
        if second.startswith("$"):
            end = row.end("second") - len(second) + 1
            if first.endswith("$"):
                start = row.start("first") + len(first) - 1
            else:  # F_1 | $\\cos\\theta$
                rewriter.replace(row.start("first"), row.start("first"), " $")
        rewriter.replace(start, end, "=")
    return rewriter.finish()


def _rows(text: str) -> Iterator[re.Match[str]]:
    is_table, last_end, before = False, -1, ""
    for match in _ROW.finditer(text):
        line = match[0]
        if _SEPARATOR.match(line):
            head = before.strip().strip("|").split("|")
            is_table = len(head) == 2 and _is_heading(*head)
        elif match.start() > last_end + 1:
            is_table = False
        elif is_table and _is_equation(match["first"], match["second"]):
            yield match
        before, last_end = line, match.end()


def _rows_of_tex(text: str) -> Iterator[re.Match[str]]:
    for table in _TABULAR.finditer(text):
        rows = list(_TEX_ROW.finditer(text, *table.span("rows")))
        if not rows or not _is_heading(*(_RULE.sub("", rows[0][name]) for name in ("first", "second"))):
            continue
        for row in rows[1:]:
            if _is_equation(_RULE.sub("", row["first"]), row["second"]):
                yield row


def _is_heading(first: str, second: str) -> bool:
    first, second = (_MARKS.sub("", cell).strip() for cell in (first, second))
    return _QUANTITY.fullmatch(first) is not None and _NO_VALUE.search(second) is None


def _is_equation(first: str, second: str) -> bool:
    """Tell whether a row gives letters a formula or a number."""
    letters, value = (_MARKS.sub("", cell).strip() for cell in (first, second))
    if _LETTERS.fullmatch(letters) is None or _WORD.search(letters) or RELATION.match(value):
        return False
    if _OWN_EQUATION.match(value):
        return False
    return _VALUE.search(value) is not None and scale_of(value) is None and not _says_words(value)


_OWN_EQUATION = re.compile(
    r"(?:\\?[A-Za-z]+|[^\W\d_])(?:_(?:\{[^{}]{1,14}\}|\w{1,8}))?\s*(?:=|≈|\\approx)"
)
"""A cell that names its letter itself, D = 67: it is an equation without the cell before it."""


def _says_words(value: str) -> bool:
    """Tell whether a value begins with words."""
    return re.match(r"[A-Za-zäöüß]{4,}\s", value) is not None
