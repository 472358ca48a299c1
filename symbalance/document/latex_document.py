r"""Documents as LaTeX: a fragment for an article, or a document that compiles alone.

A fragment needs amsmath and booktabs (graphicx or tikz where it has a picture), which its first line
says. It is measured for a line of 345 pt at 10 pt, the default article's, so nothing runs off a page
there, nor in the document of its own. pdflatex and lualatex both compile it; Chinese, Japanese and Korean
need lualatex with luatexja: pdflatex writes their codes, and says on the page and in its log that it
does.
"""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import ceil

from symbalance.document import nodes
from symbalance.document.document_writer import DocumentWriter
from symbalance.document.fitting import Fitted, LeftOut, fit_table, plain_words
from symbalance.document.formula import Equation, Formula, Upright
from symbalance.document.latex_characters import east_asian, escaped
from symbalance.document.latex_writer import LatexWriter, formula_latex, latex_width
from symbalance.document.line_breaking import break_sum, display_lines, expand_radicals
from symbalance.document.nodes import UNKNOWN, inlines
from symbalance.errors import SymbalanceError, brief

ROOM = 66.0
"""How many digits wide a line may be: 345 pt hold 69 at 10 pt, and an estimate may be short by some."""
FULL_PAGE, FOOTNOTES, SMALL_PAGE = 45, 58, 80
"""Lines that a page of its own holds, from which it needs yet smaller letters, and the most it holds."""
PICTURE_SCALE, PICTURE_WIDTH = 0.8, 335.0
"""Of a drawing, at its largest, and the points of a line that it may take."""
ROWS = 30
"""Of a table on one page."""
_GAP = 2.4
"""Between two columns: 2 tabcolsep, 12 pt."""
_INDENT = 2.0
"""Of a line that continues a bracket: \\quad."""
_QUAD = r"\quad "
_BREAKS = re.compile(r"(?<=.)(?=\\)|(?<=[=+,}/_])(?=.)", re.DOTALL)
_SIZES = (
    (1.0, 12.0, ""),
    (0.925, 11.0, r"\small"),
    (0.85, 10.0, r"\footnotesize"),
    (0.8, 8.0, r"\scriptsize"),
    (0.685, 6.0, r"\tiny"),
)
"""How wide a digit is beside one at 10 pt, the gap between columns in pt, and the size's command.

Digits of Computer Modern shrink less than their size: one of \\tiny, 5 pt, is 3.4 pt wide and not 2.5.
"""
_SMALLEST = 0.85
"""A table is fitted as for this size, \\footnotesize: smaller ones are for what cannot give way."""
_OWN_PAGE = 0.8
"""The same on a page of the document's own."""
_PARTED = 4
"""Sizes that are tried before a table is parted into several, which are then in the largest that fits."""
_DIGIT = 5.0
"""Width of a digit at 10 pt, in pt."""
_CELL, _CELL_LINE = 0.75, 0.7
"""Of a line: a formula wider than the first stands in its cell over lines of the second."""
_POINT = 0.56
"""How wide a decimal point is, in digits."""
_LETTER, _TYPED = 0.95, 1.15
"""How wide a letter is on average, and one of a typewriter, in digits."""
_HIGH = 1.1
"""What the ragged ends of a paragraph's lines add to it."""
_WORDS_ROOM = 24.0
"""A column of words wider than this may be set as a paragraph."""

_CLASS = r"""\documentclass[10pt]{article}
\usepackage[a4paper,margin=18mm,top=12mm,bottom=12mm,nofoot]{geometry}
\usepackage{amsmath}
\usepackage{booktabs}
"""
_EIGHT_BITS = r"""\usepackage{iftex}
\iftutex\else
  \usepackage[T1]{fontenc}
  \usepackage[utf8]{inputenc}
  \usepackage{lmodern}
\fi
"""
_SETTINGS = r"""\setlength{\parindent}{0pt}
\setlength{\parskip}{3pt}
\setlength{\emergencystretch}{3em}
\setlength{\jot}{6pt}
\allowdisplaybreaks
\begin{document}
"""
_SMALL = r"""\setlength{\parskip}{1pt}
\setlength{\medskipamount}{3pt}
"""
_EAST_ASIAN = r"""\iftutex
  \usepackage{luatexja}
\else
CODES  \AtBeginDocument{\noindent\textbf{Characters are written by their codes (U+...):
    compile with lualatex, which has their signs.}\par\medskip}
  \AtEndDocument{\PackageWarningNoLine{symbalance}{East Asian characters are written by
    their codes; compile with lualatex}}
\fi
"""


def document_latex(
    document: nodes.Document, *, standalone: bool = False, label: str | None = None
) -> str:
    """Return a document as LaTeX: a fragment, or with `standalone` one that compiles alone.

    With a `label` each table floats, under a caption and a label of its own: tab:LABEL-force.
    """
    writer = _Writer() if label is None else _LabellingWriter(checked_label(label))
    writer.on_own_page = standalone
    body = writer.document(document)
    if label is not None and r"\label{" not in body:
        body = "% No table stands here, so nothing has a label.\n" + body
    needs = ["amsmath", "booktabs", *_pictures(body)]
    signs = east_asian(body)
    if not standalone:
        also = "; compile with lualatex and luatexja" if signs else ""
        return f"% Needs \\usepackage{{{','.join(needs)}}}{also}\n{body}"
    parts = [_CLASS, *(f"\\usepackage{{{package}}}\n" for package in needs[2:])]
    parts.append(character_settings(body))
    lines = _lines(document.blocks)
    small = _SMALL if FULL_PAGE < lines <= SMALL_PAGE else ""
    small += ("\\small\n" if lines < FOOTNOTES else "\\footnotesize\n") if small else ""
    return "".join([*parts, _SETTINGS, small, body, "\\end{document}\n"])


def character_settings(body: str) -> str:
    """Return the lines of a preamble by which either TeX sets a body's characters."""
    signs = east_asian(body)
    if not signs:
        return _EIGHT_BITS
    code = r"  \DeclareUnicodeCharacter{%s}{\texttt{U+%s}\allowbreak}" + "\n"
    codes = "".join(code % (f"{ord(sign):04X}", f"{ord(sign):04X}") for sign in signs)
    return _EIGHT_BITS + _EAST_ASIAN.replace("CODES", codes)


def _pictures(body: str) -> list[str]:
    """Return the packages that a document's pictures need."""
    signs = {"graphicx": r"\includegraphics", "tikz": r"\begin{tikzpicture}"}
    return [package for package, sign in signs.items() if sign in body]


def _lines(blocks: tuple[nodes.Block, ...]) -> int:
    """Return about how many lines blocks take on paper."""
    lines = 0
    for block in blocks:
        if isinstance(block, nodes.Table):
            lines += len(block.rows) + 3
        elif isinstance(block, nodes.Facts):
            lines += len(block.entries) + 1
        else:
            lines += _lines(block.blocks) + 2 if isinstance(block, nodes.Details) else 1
    return lines


class _Writer(DocumentWriter):
    on_own_page = False
    """Whether the page is the document's own, whose lines hold half as much again: no table is parted."""

    def document(self, document: nodes.Document) -> str:
        title = self.words(document.title)
        parts = [rf"\section*{{\raggedright {title}}}"]
        if inlines(document.lead):
            parts.append(self.words(document.lead) + r"\par")
        parts += [self.block(block) for block in document.blocks]
        return "\n".join(parts) + "\n"

    # Upright --------------------------------------------------------------------------------------

    def string(self, text: str) -> str:
        return escaped(text)

    def code(self, text: str) -> str:
        """Return text taken literally, which may be broken before a command and after signs that join."""
        printed = r"\allowbreak{}".join(map(escaped, _BREAKS.split(text)))
        # Two hyphens would be set as a dash, and an option named that nobody can type.
        return rf"\texttt{{{printed.replace('--', '-{}-')}}}"

    def strong(self, text: str) -> str:
        return rf"\textbf{{{escaped(text)}}}"

    def math(self, value: Formula | Equation) -> str:
        return f"${formula_latex(value, inline=True)}$"

    # Blocks -------------------------------------------------------------------------------------

    def heading(self, block: nodes.Heading) -> str:
        command = "subsection" if block.level == 2 else "subsubsection"
        return rf"\{command}*{{{self.words(block.words)}}}"

    def paragraph(self, block: nodes.Paragraph) -> str:
        return self.words(block.words) + r"\par"

    def formulas(self, block: nodes.Formulas) -> str:
        return _aligned(block.equations)

    def source(self, block: nodes.Source) -> str:
        return "\n".join(map(self.source_line, block.lines))

    def details(self, block: nodes.Details) -> str:
        head = rf"\subsubsection*{{{escaped(block.summary)}}}"
        return "\n".join([head, *map(self.block, block.blocks)])

    def facts(self, block: nodes.Facts) -> str:
        """Return facts as paragraphs with their name before them, hung below it."""
        lines = [rf"\textbf{{{self.words(block.title)}}}\par\nobreak"] if inlines(block.title) else []
        for name, value in block.entries:
            meaning = f": {self.words(value)}" if inlines(value) else ""
            lines.append(rf"{{\hangindent=1.5em\hangafter=1 {self.words(name)}{meaning}\par}}")
        return "\n".join(lines)

    def figure(self, block: nodes.Figure) -> str:
        if (drawing := block.drawing()) is not None:
            from symbalance.document.tikz_writer import POINT, drawing_tikz

            scale = min(PICTURE_SCALE, PICTURE_WIDTH / (POINT * drawing.width))
            caption = rf"\par {self.words(block.caption)}" if inlines(block.caption) else ""
            picture = drawing_tikz(drawing, scale=scale) + caption
            return _kept_together("\n".join([r"\centering", picture + r"\par"]))
        if not isinstance(block.picture, bytes):
            return rf"{escaped(block.shows)} (\texttt{{{escaped(block.name)}}})\par"
        caption = rf"\\{self.words(block.caption)}" if inlines(block.caption) else ""
        picture = rf"\includegraphics[width=\linewidth]{{{block.name}}}"
        return "\n".join([r"\begin{center}", picture + caption, r"\end{center}"])

    def source_line(self, line: nodes.SourceLine) -> str:
        verdict = escaped(line.verdict)
        verdict = rf"\fbox{{\textsc{{{verdict.lower()}}}}}" if line.bad else rf"\textit{{{verdict}}}"
        head = rf"\textbf{{{escaped(line.place)}}}\quad {verdict}"
        if line.typeset is None:
            head += rf"\quad {{\small {self.code(line.text)}}}"
        parts = [rf"{{\raggedright\hangindent=2em\hangafter=1 {head}\par}}"]
        if line.typeset is not None:
            shown = line.typeset
            equation = shown if isinstance(shown, Equation) else Equation(Upright(""), (("", shown),))
            rows = r" \\".join(_rows([equation], ROOM - 4.0))
            parts.append(rf"{{\leftskip=2em$\begin{{aligned}}{rows}\end{{aligned}}$\par}}")
        below = r"\small\raggedright\leftskip=2em "
        parts += [rf"{{{below}{self.words(note)}\par}}" for note in line.notes]
        formulas = [each for each in line.formulas if line.typeset is None or each[0] != "stands"]
        if formulas:  # what stands is above already, typeset
            equations = [Equation(Upright(f"{name}:"), (("", value),)) for name, value in formulas]
            rows = r" \\".join(_rows(equations, ROOM - 6.0, r"\quad "))
            parts.append(rf"{{\leftskip=2em$\begin{{aligned}}{rows}\end{{aligned}}$\par}}")
        return _kept_together("\\parskip=2pt\n" + "\n".join(parts), "smallskip")

    # Tables -------------------------------------------------------------------------------------

    def table(self, block: nodes.Table) -> str:
        title = f"{self.words(block.title)}" if inlines(block.title) else ""
        if not block.rows:
            return rf"{title}: {escaped(block.empty)}.\par" if title else rf"{escaped(block.empty)}.\par"
        fit = fit_table(block, _width, ROOM / (_OWN_PAGE if self.on_own_page else _SMALLEST), _GAP)
        columns, whole = _columns(fit)
        keys = sum(column in fit.columns for column in block.columns[: block.keys])
        parts = []
        everything = [list(range(len(columns)))]
        for places in everything if self.on_own_page else _parted(columns, whole, keys):
            shown = [columns[i] for i in places]
            width = whole if len(shown) == len(columns) else _whole(shown)
            for rows in _pages([tuple(row[i] for i in places) for row in fit.rows], shown):
                head = f"{title} (continued)" if title and parts else title
                parts.append(self.tabular(head, shown, width, rows))
        remark = [rf"{self.words(fit.remark)}.\par"] if inlines(fit.remark) else []
        return "\n".join([*parts, *_left_out(fit.left_out), *remark])

    def tabular(
        self,
        title: str,
        columns: Sequence[_Column],
        whole: float,
        rows: Sequence[tuple[nodes.Words, ...]],
    ) -> str:
        """Return a part of a table that fits a page, under its title."""
        return _kept_together(self.rules(title, columns, whole, rows))

    def rules(
        self,
        title: str,
        columns: Sequence[_Column],
        whole: float,
        rows: Sequence[tuple[nodes.Words, ...]],
    ) -> str:
        """Return a table's rows between rules, in the largest size that fits a line."""
        fits = (each for each in _SIZES if _set_width(columns, whole, each) <= ROOM)
        _, gap, size = next(fits, _SIZES[-1])
        shape = rf"@{{\hspace{{{gap:g}pt}}}}".join(column.shape for column in columns)
        lines = [rf"\textbf{{{title}}}\par\nobreak\smallskip" if title else ""]
        lines += [rf"{{{size}", rf"\begin{{tabular}}{{@{{}}{shape}@{{}}}}", r"\toprule"]
        heads = [c.head(self.words(c.title), gap, last=c is columns[-1]) for c in columns]
        lines.append(" & ".join(heads) + r" \\")
        lines.append(r"\midrule")
        body = [" & ".join(c.cell(self, row[i]) for i, c in enumerate(columns)) for row in rows]
        stretch = max(map(_stretch, body), default="")
        if stretch:
            lines.insert(-4, rf"\renewcommand{{\arraystretch}}{{{stretch}}}")
        lines += [rf"{line} \\" for line in body]
        lines += [r"\bottomrule", r"\end{tabular}}"]
        return "\n".join(line for line in lines if line)


def _stretch(row: str) -> str:
    """Return how much higher than a line a row is set: bars need room, one over the other more of it."""
    if "aligned" in row or r"\frac{\sqrt{\frac" in row or r"\sqrt{\frac" in row:
        return "1.5"
    return "1.3" if r"\frac" in row else ""


_LABEL = re.compile(r"[A-Za-z0-9][A-Za-z0-9.:+-]*")
"""What is safe in a label in every package that writes it somewhere else: no signs that TeX obeys."""
_WORDS_IN_LABEL = 4


def checked_label(label: object) -> str:
    """Return the beginning of labels, or refuse what LaTeX would not take as one."""
    if isinstance(label, str) and _LABEL.fullmatch(label):
        return label
    rule = "must begin with a letter or a digit, and hold letters, digits and . : + - alone"
    raise SymbalanceError(f"label = {brief(label)}", rule, "write it like v8-90")


class _LabellingWriter(_Writer):
    """LaTeX for a report: tables float, and have captions and labels that a text refers to."""

    def __init__(self, label: str) -> None:
        self.label = label
        self.about = ""
        self.topics: Counter[str] = Counter()
        self.topic = ""
        self.head = ""

    def document(self, document: nodes.Document) -> str:
        self.about = self.words(document.title)
        return super().document(document)

    def table(self, block: nodes.Table) -> str:
        self.topic = block.topic or _topic(block.title)
        if plain_words(block.title)[:1].islower():  # it goes on from the table above, as its title does
            words = inlines(block.title)
            return super().table(replace(block, title=(f"{self.head} ", *words) if self.head else words))
        self.head = re.split(r"[,(:;=]", plain_words(block.title))[0].strip()
        return super().table(block)

    def tabular(
        self,
        title: str,
        columns: Sequence[_Column],
        whole: float,
        rows: Sequence[tuple[nodes.Words, ...]],
    ) -> str:
        self.topics[self.topic] += 1
        number = self.topics[self.topic]
        name = f"tab:{self.label}-{self.topic}" + (f"-{number}" if number > 1 else "")
        caption = rf"\caption{{{title or self.about}}}\label{{{name}}}\par\smallskip"
        lines = [r"\begin{table}[htbp]", r"\centering", caption]
        return "\n".join([*lines, self.rules("", columns, whole, rows), r"\end{table}"])


def _topic(title: nodes.Words) -> str:
    """Return what a table is about, by the first words of its title.

    >>> _topic("Coefficients of one cylinder (the value is exact)"), _topic("")
    ('coefficients-of-one-cylinder', 'table')
    """
    head = re.split(r"[,(:;=]", plain_words(title))[0]
    plain = unicodedata.normalize("NFKD", head).encode("ascii", "ignore").decode().lower()
    return "-".join(re.findall(r"[a-z0-9]+", plain)[:_WORDS_IN_LABEL]) or "table"


class _Column:
    """A column of a table: how wide it is, its letter in the table's shape, and its cells."""

    def __init__(self, fit: Fitted, place: int) -> None:
        self.title, cells, numeric = fit.columns[place].head, fit.cells(place), fit.numeric[place]
        self.splits = numeric and any("." in plain_words(cell) for cell in cells)
        self.width = max(map(_width, (self.title, *cells)))
        if self.splits:  # whole parts end, and fractions begin, at one place
            halves = [
                formula_latex(part).partition(".")
                for cell in cells
                for part in inlines(cell)[:1]
                if isinstance(part, Formula)
            ]
            widths = (max((latex_width(half[i]) for half in halves), default=0.0) for i in (0, 2))
            self.width = max(self.width, sum(widths) + _POINT)
        self.room = 0.0
        """Of a paragraph's lines; 0 where cells are one line each."""
        self.shape = "r@{}l" if self.splits else "r" if numeric else "l"
        parts = (part for cell in cells for part in inlines(cell))
        self.is_words = all(isinstance(part, str | nodes.Code | nodes.Strong) for part in parts)

    def as_paragraph(self, width: float) -> None:
        """Set the column's cells over several lines of so many digits."""
        self.shape = rf"p{{{width * 0.5:.1f}em}}"
        self.room = width

    def lines(self, words: nodes.Words) -> int:
        """Return how many lines a cell takes, an estimate on the high side."""
        return ceil(_HIGH * _width(words) / self.room) if self.room else 1

    def head(self, printed: str, gap: float, *, last: bool) -> str:
        """Return a column's head, over both halves of a column that is parted at its points."""
        space = "" if last else rf"\hspace{{{gap:g}pt}}"
        return rf"\multicolumn{{2}}{{@{{}}l@{{{space}}}}}{{{printed}}}" if self.splits else printed

    def cell(self, writer: _Writer, words: nodes.Words) -> str:
        """Return a cell; a decimal is parted at its point, so that points stand in line."""
        parts = inlines(words)
        if self.splits:
            if not parts or parts[0] == UNKNOWN:
                return f"{escaped(UNKNOWN) if parts else ''} & "
            printed = formula_latex(parts[0])  # type: ignore[arg-type]
            whole, point, fraction = printed.partition(".")
            return rf"${whole}$ & ${point}{fraction}$" if point else rf"${printed}$ & "
        if len(parts) == 1 and isinstance(parts[0], Formula):
            return f"${_in_cell(parts[0])}$"
        return "".join(
            f"${formula_latex(part)}$" if isinstance(part, Formula) else writer.inline(part)
            for part in parts
        )


def _in_cell(value: Formula) -> str:
    """Return a formula for a cell, over several lines where it is wider than a line."""
    if latex_width(formula_latex(value)) <= ROOM * _CELL:
        return formula_latex(value)
    equation = Equation(Upright(""), (("", value),))
    lines = [
        line.printed for line in display_lines([equation], LatexWriter(), ROOM * _CELL_LINE, _INDENT)
    ]
    return r"\begin{aligned}[t]&" + r" \\ &".join(lines) + r"\end{aligned}"


def _columns(fit: Fitted) -> tuple[list[_Column], float]:
    """Return a table's columns, the widest one of words as a paragraph where it must, and their width."""
    columns = [_Column(fit, i) for i in range(len(fit.columns))]
    gaps = _GAP * (len(columns) - 1)
    whole = sum(column.width for column in columns) + gaps
    paragraph = _paragraph(columns, whole)
    if paragraph is None:
        return columns, whole
    rest = sum(c.width for i, c in enumerate(columns) if i != paragraph)
    columns[paragraph].as_paragraph(ROOM / _SMALLEST - rest - gaps)
    return columns, ROOM / _SMALLEST


def _whole(columns: Sequence[_Column]) -> float:
    """Return how wide columns are with the gaps between them, in digits."""
    return sum(column.width for column in columns) + _GAP * (len(columns) - 1)


def _set_width(columns: Sequence[_Column], whole: float, size: tuple[float, float, str]) -> float:
    """Return how wide a table is set in a size, in digits at 10 pt."""
    gaps = len(columns) - 1
    scale, gap, _ = size
    return (whole - _GAP * gaps) * scale + gaps * gap / _DIGIT


def _parted(columns: Sequence[_Column], whole: float, keys: int) -> list[list[int]]:
    """Return the places of the columns of each part of a table: all, where a readable size holds them.

    Every part begins with the columns that name a row. A table with a paragraph has been fitted.
    """
    everything = list(range(len(columns)))
    fits = any(_set_width(columns, whole, size) <= ROOM for size in _SIZES[:_PARTED])
    if fits or any(column.room for column in columns) or not 0 < keys < len(columns):
        return [everything]
    for count in range(2, len(columns) - keys + 1):
        share = ceil((len(columns) - keys) / count)
        parts = [everything[:keys] + everything[i : i + share] for i in range(keys, len(columns), share)]
        chosen = [[columns[i] for i in part] for part in parts]
        if all(_set_width(each, _whole(each), _SIZES[_PARTED - 1]) <= ROOM for each in chosen):
            return parts
    return [everything]


def _pages(
    rows: Sequence[tuple[nodes.Words, ...]], columns: Sequence[_Column]
) -> Iterator[list[tuple[nodes.Words, ...]]]:
    """Yield the rows in groups of at most `ROWS` lines, each of which fits a page."""
    page: list[tuple[nodes.Words, ...]] = []
    lines = 0
    for row in rows:
        tall = max(column.lines(row[i]) for i, column in enumerate(columns))
        if page and lines + tall > ROWS:
            yield page
            page, lines = [], 0
        page.append(row)
        lines += tall
    yield page


def _paragraph(columns: Sequence[_Column], whole: float) -> int | None:
    """Return the column of words to be set as a paragraph in a table too wide for a line, or None."""
    wordy = [i for i, c in enumerate(columns) if c.is_words and c.width > _WORDS_ROOM]
    if whole * _SMALLEST <= ROOM or not wordy:
        return None
    return max(wordy, key=lambda i: columns[i].width)


def _left_out(forms: Sequence[LeftOut]) -> list[str]:
    """Return the exact forms that have no room in a table, below it."""
    if not forms:
        return []
    lines = " \\\\\n".join(map(_left_out_line, forms))
    return [r"exactly:\par\nobreak", f"\\begin{{align*}}\n{lines}\n\\end{{align*}}"]


def _left_out_line(form: LeftOut) -> str:
    """Return a form after its name; one too wide for a line without the root or bar over it."""
    power, value = 1, form.value
    label = rf"\text{{{escaped(f'{form.place} {form.name}')}}}"
    room = ROOM - 2 * _INDENT
    first = room - _width(f"{form.place} {form.name} = ")
    if latex_width(formula_latex(value)) > first:
        power, value = expand_radicals(value)
    head = rf"&{label}{'^2' if power == 2 else ''} = "
    lines = [line.printed for line in break_sum(value, LatexWriter(), room, first, _INDENT)]
    return head + r" \\ &\qquad ".join(line.rstrip() for line in lines)


def _aligned(equations: Sequence[Equation]) -> str:
    return "\\begin{align*}\n" + " \\\\\n".join(_rows(equations, ROOM)) + "\n\\end{align*}"


def _rows(equations: Sequence[Equation], room: float, gap: str = "") -> list[str]:
    """Return the lines of equations, parted before the first relation, or where `gap` stands for none."""
    lines = display_lines(equations, LatexWriter(), room, _INDENT)
    return [f"{name} &{gap}{_QUAD * depth}{line}".strip() for name, depth, line in lines]


def _width(words: nodes.Words) -> float:
    """Return how wide words are set, in digits."""
    total = 0.0
    for part in inlines(words):
        if isinstance(part, Formula | Equation):
            total += latex_width(formula_latex(part))
        elif isinstance(part, str):
            total += _LETTER * len(part)
        else:
            total += _TYPED * len(part.text)
    return total


def _kept_together(body: str, skip: str = "medskip") -> str:
    """Return lines that stay on one page."""
    begin = rf"\par\{skip}\noindent\begin{{minipage}}{{\linewidth}}"
    return f"{begin}\n{body}\n\\end{{minipage}}\\par\\{skip}"
