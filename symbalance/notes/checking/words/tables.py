"""The tables of a page as rows of cells, in every markup: Markdown, wiki, HTML, LaTeX, AsciiDoc, columns.

A table of plain text has its cells apart by three spaces or more, in at least three lines that follow.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from symbalance.document.formula import Span
from symbalance.text import lazy_patterns as re

_RULE = re.compile(r"(?=[\s:|]*+-)[\s:|-]++$|\s*\\(?:hline|toprule|midrule|bottomrule|cline)\b.*")
_HTML_ROW = re.compile(r"<tr\b[^>]*>(?P<row>.*?)(?=</tr>|<tr\b|</table>)", re.IGNORECASE | re.DOTALL)
_HTML_CELL = re.compile(r"<t[dh]\b[^>]*>(.*?)(?=</t[dh]>|<t[dh]\b|\Z)", re.IGNORECASE | re.DOTALL)
_HTML_TABLE = re.compile(r"<table\b.*?</table>", re.IGNORECASE | re.DOTALL)
_TABULAR = re.compile(r"\\begin\{(tabular[xy*]?|array|longtable)\}(?P<rows>.*?)\\end\{\1\}", re.DOTALL)
_WIKI_TABLE = re.compile(r"^\{\|.*?^\|\}", re.MULTILINE | re.DOTALL)
_ASCIIDOC_TABLE = re.compile(
    r"(?:^\[(?P<options>[^\]\n]*)\]\n)?^\|===\n(?P<rows>.*?)^\|===[ ]*$", re.MULTILINE | re.DOTALL
)
_COLUMNS = re.compile(r"cols\s*=\s*\"?(?:(?P<times>[0-9]+)\*|(?P<list>[^\"\n]*))")
_BAR = re.compile(r"(?<!\\)\|")
_GAP = re.compile(r"[ ]{3,}|[ ]*\t\s*")
FEWEST_LINES = 3
"""Of plain text, that stand below each other in columns."""


@dataclass(frozen=True, slots=True)
class Cell:
    """A cell of a table: its text and its place in the page."""

    text: str
    span: Span


Table = list[list[Cell]]


def tables_of(text: str) -> Iterator[Table]:
    """Yield the tables of a page in Markdown, a wiki's markup, HTML, LaTeX and AsciiDoc."""
    rest = text
    for match in _ASCIIDOC_TABLE.finditer(text):
        rest = rest[: match.start()] + re.sub(r"[^\n]", " ", match[0]) + rest[match.end() :]
        yield _asciidoc_table(text, *match.span("rows"), match["options"] or "")
    yield from _piped_tables(rest)
    for match in _WIKI_TABLE.finditer(text):
        yield _wiki_table(text, *match.span())
    for match in _HTML_TABLE.finditer(text):
        yield [
            [Cell(cell[1], cell.span(1)) for cell in _HTML_CELL.finditer(text, *row.span("row"))]
            for row in _HTML_ROW.finditer(text, *match.span())
        ]
    for match in _TABULAR.finditer(text):
        yield _tabular(text, *match.span("rows"))


def columns_of(text: str) -> Iterator[Table]:
    """Yield the tables that plain text sets in columns.

    >>> [[cell.text for cell in row] for row in next(columns_of("A      k\\n 0    1.2\\n90   -0.2\\n"))]
    [['A', 'k'], ['0', '1.2'], ['90', '-0.2']]
    """
    table: Table = []
    offset = 0
    for line in [*text.split("\n"), ""]:
        row = list(_split(text, offset, offset + len(line), _GAP))
        row = [cell for cell in row if cell.text]
        offset += len(line) + 1
        if re.fullmatch(r"\s*[-=─_ ]{3,}", line):
            continue
        if len(row) > 1 and (not table or len(row) == len(table[-1])):
            table.append(row)
            continue
        if len(table) >= FEWEST_LINES:
            yield table
        table = [row] if len(row) > 1 else []


def _piped_tables(text: str) -> Iterator[Table]:
    table: Table = []
    offset, is_wiki = 0, False
    for line in [*text.split("\n"), ""]:
        is_wiki = (is_wiki or line.startswith("{|")) and not line.startswith("|}")
        if line.lstrip().startswith("|") and not is_wiki and not line.startswith(("|}", "|-", "|+")):
            if not _RULE.fullmatch(line):
                begin = offset + line.index("|") + 1
                stop = offset + len(line.rstrip().removesuffix("|"))
                table.append(list(_split(text, begin, stop, _BAR)))
        elif not line.startswith("|-"):
            if table:
                yield table
            table = []
        offset += len(line) + 1


def _asciidoc_table(text: str, start: int, end: int, options: str) -> Table:
    """Return the rows of a table whose cells begin with a bar each, on as many lines as one likes."""
    cells = list(_split(text, start, end, _BAR))[1:]
    columns = _COLUMNS.search(options)
    first = text[start:end].lstrip("\n").split("\n")[0].count("|")
    count = int(columns["times"] or columns["list"].count(",") + 1) if columns else max(first, 1)
    return [cells[k : k + count] for k in range(0, len(cells) - count + 1, count)]


def _wiki_table(text: str, start: int, end: int) -> Table:
    table: Table = [[]]
    offset = start
    for line in text[start:end].split("\n"):
        if line.startswith("|-"):
            table.append([])
        elif line[:1] in ("|", "!") and not line.startswith(("|+", "|}")):
            table[-1] += _split(text, offset + 1, offset + len(line), re.compile(r"\|\||!!"))
        offset += len(line) + 1
    return [row for row in table if row]


def _tabular(text: str, start: int, end: int) -> Table:
    rows = _split(text, start, end, re.compile(r"\\\\(?:\[[^\]]*\])?"))
    rules = re.compile(r"^(?:\s*\{[^}]*\}|\s*\\(?:hline|toprule|midrule|bottomrule))+")
    table: Table = []
    for row in rows:
        rule = rules.match(row.text)
        begin = row.span[0] + (rule.end() if rule else 0)
        if text[begin : row.span[1]].strip():
            table.append(list(_split(text, begin, row.span[1], re.compile(r"(?<!\\)&"))))
    return table


def _split(text: str, start: int, end: int, gap: re.Pattern[str]) -> Iterator[Cell]:
    """Yield the cells between gaps, without the space around them."""
    for match in [*gap.finditer(text, start, end), None]:
        stop = match.start() if match else end
        inside = text[start:stop]
        begin = start + len(inside) - len(inside.lstrip())
        yield Cell(inside.strip(), (begin, begin + len(inside.strip())))
        start = match.end() if match else end
