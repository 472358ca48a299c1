"""Documents as Markdown with formulas between dollar signs, as notebooks and code hosts show it."""

from __future__ import annotations

import re

from symbalance.document import nodes
from symbalance.document.document_writer import DocumentWriter
from symbalance.document.fitting import fit_table, plain_words
from symbalance.document.formula import Decimal, Equation, Formula, Number
from symbalance.document.latex_writer import formula_latex
from symbalance.document.nodes import inlines

ROOM = 160.0
"""How many characters wide a table may be before exact forms give way to decimals."""
_SPECIAL = re.compile(r"([\\`*_{}\[\]<>#|$])")


def document_markdown(document: nodes.Document) -> str:
    """Return a document as Markdown."""
    writer = _Writer()
    parts = [f"# {writer.words(document.title)}", writer.words(document.lead)]
    return "\n\n".join(part for part in (*parts, *map(writer.block, document.blocks)) if part) + "\n"


class _Writer(DocumentWriter):
    # Words --------------------------------------------------------------------------------------

    def string(self, text: str) -> str:
        return _SPECIAL.sub(r"\\\1", text)

    def code(self, text: str) -> str:
        """Return text between backticks, more of them than the text holds in a row."""
        flat = " ".join(text.split()).replace("|", "\\|")
        ticks = "`" * (max(map(len, re.findall("`+", flat)), default=0) + 1)
        pad = " " if flat.startswith("`") or flat.endswith("`") else ""
        return f"{ticks}{pad}{flat}{pad}{ticks}"

    def strong(self, text: str) -> str:
        return f"**{self.string(text)}**"

    def math(self, value: Formula | Equation) -> str:
        if isinstance(value, Decimal | Number):
            return plain_words(value)
        return f"${formula_latex(value, inline=True)}$"

    # Blocks -------------------------------------------------------------------------------------

    def heading(self, block: nodes.Heading) -> str:
        return f"{'#' * block.level} {self.words(block.words)}"

    def paragraph(self, block: nodes.Paragraph) -> str:
        return self.words(block.words)

    def facts(self, block: nodes.Facts) -> str:
        entries = [(self.words(name), self.words(value)) for name, value in block.entries]
        lines = [f"- {name}: {value}" if value else f"- {name}" for name, value in entries]
        head = [f"**{self.words(block.title)}**", ""] if inlines(block.title) else []
        return "\n".join([*head, *lines])

    def formulas(self, block: nodes.Formulas) -> str:
        return "\n\n".join(f"$${formula_latex(each)}$$" for each in block.equations)

    def figure(self, block: nodes.Figure) -> str:
        # A drawing in its words: code hosts show no picture that stands within the text.
        if (drawing := block.drawing()) is not None:
            return self.string(drawing.shows)
        return f"![{self.string(block.shows)}]({block.name})"

    def details(self, block: nodes.Details) -> str:
        return "\n\n".join([f"**{self.string(block.summary)}**", *map(self.block, block.blocks)])

    def table(self, block: nodes.Table) -> str:
        title = self.words(block.title)
        if not block.rows:
            return f"{title}: {self.string(block.empty)}" if title else self.string(block.empty)
        fit = fit_table(block, lambda words: len(plain_words(words)), ROOM, 3)
        heads = [self.words(column.head) for column in fit.columns]
        rows = [heads, ["---:" if numeric else "---" for numeric in fit.numeric]]
        rows += [[self.words(cell) for cell in row] for row in fit.rows]
        lines = ["| " + " | ".join(row) + " |" for row in rows]
        below = [f"- {self.string(f'{e.place} {e.name}')} = {self.math(e.value)}" for e in fit.left_out]
        below = ["", "exactly:", "", *below] if below else []
        below += ["", self.words(fit.remark)] if inlines(fit.remark) else []
        head = [title if "$" in title else f"**{title}**", ""] if title else []
        return "\n".join([*head, *lines, *below])

    def source(self, block: nodes.Source) -> str:
        lines = ["| line | as it stands | verdict |", "|---|---|---|"]
        for line in block.lines:
            word = self.strong(line.verdict) if line.bad else self.string(line.verdict)
            notes = [self.words(note) for note in line.notes]
            notes += [f"{self.string(name)}: ${formula_latex(value)}$" for name, value in line.formulas]
            cells = (self.string(line.place), self.code(line.text), "<br>".join([word, *notes]))
            lines.append(f"| {' | '.join(cells)} |")
        return "\n".join(lines)
