"""Documents as plain text, to the terminal's width or 80 columns."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from textwrap import wrap

from symbalance.document import nodes
from symbalance.document.document_writer import DocumentWriter
from symbalance.document.fitting import Fitted, fit_table
from symbalance.document.formula import INFINITY, Equation, Formula, Matrix
from symbalance.document.line_breaking import display_lines
from symbalance.document.nodes import UNKNOWN, Words, inlines
from symbalance.document.text_writer import TextWriter, formula_text

WIDTH = 80
_INDENT = "  "
_GAP = 2
_HARD = "\u00a0"
_NARROWEST = 12
"""No column of words is wrapped to less."""
_LONGEST_VERDICT = 20
"""Of those that have their lines' texts beside them."""
_POINT = re.compile(r"[+−-]?\d+")

Spelled = Callable[[str], str]


def document_text(document: nodes.Document, width: int = WIDTH, quoted: Spelled = str) -> str:
    """Return a document as text of at most `width` columns, where its words allow.

    `quoted` spells what is taken literally, `Code` and the lines of a `Source`.
    """
    return _Writer(width, quoted).document(document)


class _Writer(DocumentWriter):
    def __init__(self, width: int, quoted: Spelled) -> None:
        self.width = width - 1
        """The last column stays free: some terminals wrap a line that fills it."""
        self.quoted = quoted

    def document(self, document: nodes.Document) -> str:
        """Return a whole document."""
        head = self.wrapped(document.title)
        if any(isinstance(block, nodes.Heading) for block in document.blocks):
            head.append("=" * max(map(len, head)))
        if inlines(document.lead):
            head += self.wrapped(document.lead)
        parts = ["\n".join(head), *map(self.block, document.blocks)]
        return "\n\n".join(part for part in parts if part) + "\n"

    # Words --------------------------------------------------------------------------------------

    def string(self, text: str) -> str:
        return text

    def code(self, text: str) -> str:
        return self.quoted(text)

    def strong(self, text: str) -> str:
        return text

    def math(self, value: Formula | Equation) -> str:
        return formula_text(value).replace(" ", _HARD)

    def plain(self, words: Words) -> str:
        """Return words as one line."""
        return self.words(words).replace(_HARD, " ")

    def wrapped(self, words: Words, first: str = "", rest: str = "", width: int = 0) -> list[str]:
        """Return words as lines; a formula wider than a line is broken before a sign."""
        text = self.words(words)
        room = width or self.width
        if any(len(piece) > room - len(rest) for piece in text.split(" ")):
            text = _SIGNS.sub(" ", text)
        lines = wrap(
            text,
            room,
            initial_indent=first,
            subsequent_indent=rest,
            break_long_words=False,
            break_on_hyphens=False,
        )
        return [line.replace(_HARD, " ") for line in lines or [first.rstrip()]]

    # Blocks -------------------------------------------------------------------------------------

    def heading(self, block: nodes.Heading) -> str:
        lines = self.wrapped(block.words)
        return "\n".join([*lines, "-" * max(map(len, lines))])

    def paragraph(self, block: nodes.Paragraph) -> str:
        return "\n".join(self.wrapped(block.words))

    def figure(self, block: nodes.Figure) -> str:
        caption = f"{self.plain(block.caption)}: " if inlines(block.caption) else ""
        if (drawing := block.drawing()) is not None:
            return "\n".join(self.wrapped(drawing.shows))
        return "\n".join(self.wrapped(f"{caption}[{block.name}] {block.shows}"))

    def source(self, block: nodes.Source) -> str:
        longest = max((len(line.verdict) for line in block.lines), default=0)
        column = min(longest, _LONGEST_VERDICT)
        return "\n".join(line for each in block.lines for line in self.source_line(each, column))

    def details(self, block: nodes.Details) -> str:
        return "\n\n".join([self.heading(nodes.Heading(block.summary)), *map(self.block, block.blocks)])

    def facts(self, block: nodes.Facts) -> str:
        """Return facts, names in a column of their own."""
        head = self.wrapped(block.title) if inlines(block.title) else []
        column = max((len(self.plain(name)) for name, value in block.entries if value != ""), default=0)
        lines = []
        for name, value in block.entries:
            if value == "":
                lines += self.wrapped(name, _INDENT, 2 * _INDENT)
                continue
            lead = f"{_INDENT}{self.plain(name):<{column}}  "
            lines += self.wrapped(value, lead, " " * len(lead))
        return "\n".join([*head, *lines])

    def source_line(self, line: nodes.SourceLine, column: int) -> list[str]:
        """Return a line's place, verdict and text, never shortened: beside, or below where it is long."""
        text = self.quoted(line.text)
        head = f"{line.place:>6}  {line.verdict:<{column}}{' ' * _GAP}{text}".rstrip()
        if len(head) <= self.width and len(line.verdict) <= column and "\n" not in text:
            lines = [head]
        else:
            lines = self.wrapped(line.verdict, f"{line.place:>6}  ", " " * 10)
            lines += wrap(text, self.width, initial_indent=" " * 8, subsequent_indent=" " * 10)
        below = [part for note in line.notes for part in self.wrapped(note, " " * 8, " " * 10)]
        for name, formula in line.formulas:
            below += self.wrapped((f"{name}: ", formula), " " * 8, " " * 10)
        return [*lines, *below]

    # Formulas -----------------------------------------------------------------------------------

    def formulas(self, block: nodes.Formulas) -> str:
        left = max((len(formula_text(each.left)) for each in block.equations), default=0)
        room = self.width - len(_INDENT)
        lines: list[str] = []
        for each in block.equations:
            over_lines = _with_matrices(each, left)
            if over_lines and max(map(len, over_lines)) <= room:
                lines += ["", *over_lines] if lines else over_lines
                continue
            indented = display_lines([each], TextWriter(), room, len(_INDENT), left)
            lines += [f"{name:>{left}} {_INDENT * depth}{line}" for name, depth, line in indented]
        return "\n".join(f"{_INDENT}{line}".rstrip() for line in lines)

    # Tables -------------------------------------------------------------------------------------

    def table(self, block: nodes.Table) -> str:
        title = self.wrapped(block.title) if inlines(block.title) else []
        if not block.rows:
            return "\n".join([*title, *self.wrapped(block.empty, _INDENT, _INDENT)])
        room = self.width - len(_INDENT)
        fit = self.fitted(block, room)
        lines = self.grid(fit, room)
        if max(map(len, lines)) > self.width:  # numbers alone fill the line: they take the margin too
            lines = [line.removeprefix(_INDENT) for line in lines]
        return "\n".join([*title, *lines, *self.left_out(fit)])

    def fitted(self, block: nodes.Table, room: int) -> Fitted:
        """Return a table whose columns fit with their points in line, which makes some of them wider."""
        fit = fit_table(block, lambda words: len(self.cell(words)), room, _GAP)
        over = _spare(self.columns(fit), room)
        if over < 0:
            narrower = fit_table(block, lambda words: len(self.cell(words)), room + over, _GAP)
            if _spare(self.columns(narrower), room) >= 0:
                return narrower
        return fit

    def columns(self, fit: Fitted) -> list[list[str]]:
        """Return the cells of each column of a table under its head."""
        return [self.column(fit, i) for i in range(len(fit.columns))]

    def grid(self, fit: Fitted, room: int) -> list[str]:
        columns = self.columns(fit)
        widths = [max(map(len, column)) for column in columns]
        spare = _spare(columns, room)
        if spare < 0:
            widths = self.narrowed(fit, columns, -spare)
        rows = []
        for i in range(len(fit.rows) + 1):
            words = [column.head for column in fit.columns] if i == 0 else fit.rows[i - 1]
            cells = [
                [column[i]] if len(column[i]) <= width else self.wrapped(words[k], "", "", width)
                for k, (column, width) in enumerate(zip(columns, widths, strict=True))
            ]
            rows.append(_side_by_side(cells, widths))
        rule = _INDENT + "─" * (max(len(line) for row in rows for line in row) - len(_INDENT))
        return [*rows[0], rule, *(line for row in rows[1:] for line in row)]

    def column(self, fit: Fitted, place: int) -> list[str]:
        """Return a column's head and cells; where all cells are numbers, their points stand in line."""
        head, body = self.cell(fit.columns[place].head), list(map(self.cell, fit.cells(place)))
        if not fit.numeric[place]:
            return [head, *body]
        before = max(len(_whole(cell)) for cell in body)
        body = [" " * (before - len(_whole(cell))) + cell if cell else "" for cell in body]
        if all(cell.strip().lstrip("+−-").isdecimal() for cell in body if cell.strip() not in _WORDLESS):
            head = head.rjust(before)
            body = [cell.rjust(len(head)) for cell in body]
        return [head, *body]

    def cell(self, words: Words) -> str:
        """Return a cell as one line, a decimal's power of ten in short: 7.4379e−5."""
        return _POWER.sub(lambda power: "e" + power[1].translate(_UNRAISED), self.plain(words))

    def narrowed(self, fit: Fitted, columns: Sequence[Sequence[str]], over: int) -> list[int]:
        """Return widths that fit, the widest columns giving way: words, and the heads of numbers."""
        narrow = [max(map(len, column)) for column in columns]
        numbers = {i: max(map(len, columns[i][1:])) for i, numeric in enumerate(fit.numeric) if numeric}
        words = [numbers.get(i) or self.longest_piece(fit, i) for i in range(len(columns))]
        least = [numbers.get(i, _NARROWEST) for i in range(len(columns))]
        # A column narrower than a word of its own stands out of line: that comes last.
        for limits in (list(map(max, words, least)), words, least):
            while over > 0 and (open_columns := [i for i, w in enumerate(narrow) if w > limits[i]]):
                narrow[max(open_columns, key=lambda i: narrow[i])] -= 1
                over -= 1
        return narrow

    def longest_piece(self, fit: Fitted, place: int) -> int:
        """Return the length of the longest part of a column that is not broken: a word, a term."""
        texts = [self.words(words) for words in (fit.columns[place].head, *fit.cells(place))]
        return max(len(piece) for text in texts for piece in _SIGNS.sub(" ", text).split(" "))

    def left_out(self, fit: Fitted) -> list[str]:
        """Return the exact forms that have no room in the table, a line each."""
        lines = [
            part
            for each in fit.left_out
            for part in self.wrapped(
                (f"{each.place} {each.name} = ", each.value), _INDENT, _INDENT + "    "
            )
        ]
        remark = self.wrapped(fit.remark, _INDENT, _INDENT) if inlines(fit.remark) else []
        return [*([f"{_INDENT}exactly:", *lines] if lines else []), *remark]


def _spare(columns: Sequence[Sequence[str]], room: int) -> int:
    """Return how many characters of a line a table's columns leave; below 0 it is too wide."""
    return room - sum(max(map(len, column)) for column in columns) - _GAP * (len(columns) - 1)


_POWER = re.compile(" × 10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)")
_UNRAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "−0123456789")
_WORDLESS = ("", UNKNOWN, formula_text(INFINITY))
_SIGNS = re.compile(f"{_HARD}(?=[+−=≈] ?)")
"""Where a formula too wide for a line may be broken."""


def _with_matrices(equation: Equation, left: int) -> list[str] | None:
    """Return an equation with its matrices drawn over several lines, None if it has none.

    >>> from symbalance.document.formula import Matrix, Name, number
    >>> a, b = Name("a"), Name("b")
    >>> print(*_with_matrices(Equation(Name("X"), (("=", Matrix(((a, -b), (b, a)))),)), 1), sep="\\n")
    X = [ a  −b ]
        [ b   a ]
    """
    if not any(isinstance(right, Matrix) for _, right in equation.links):
        return None
    parts = [[f"{formula_text(equation.left):>{left}}"]]
    for sign, right in equation.links:
        parts += [[sign], _matrix_lines(right) if isinstance(right, Matrix) else [formula_text(right)]]
    height = max(map(len, parts))
    columns = []
    for part in parts:
        above = (height - len(part)) // 2
        padded = [""] * above + part + [""] * (height - len(part) - above)
        columns.append([line.ljust(max(map(len, part))) for line in padded])
    return [" ".join(line) for line in zip(*columns, strict=True)]


def _matrix_lines(node: Matrix) -> list[str]:
    """Return a matrix row by row between brackets, its columns flush right."""
    columns = [[formula_text(entry) for entry in column] for column in zip(*node.rows, strict=True)]
    columns = [[cell.rjust(max(map(len, column))) for cell in column] for column in columns]
    return [f"[ {'  '.join(row)} ]" for row in zip(*columns, strict=True)]


def _whole(cell: str) -> str:
    """Return what stands before a number's point."""
    point = _POINT.match(cell)
    return point[0] if point else cell


def _side_by_side(cells: Sequence[Sequence[str]], widths: Sequence[int]) -> list[str]:
    """Return the lines of a row whose cells may have several lines."""
    lines = []
    for k in range(max(map(len, cells))):
        parts = [
            (cell[k] if k < len(cell) else "").ljust(width)
            for cell, width in zip(cells, widths, strict=True)
        ]
        lines.append((_INDENT + (" " * _GAP).join(parts)).rstrip())
    return lines
