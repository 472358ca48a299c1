"""Documents as Markdown with formulas between dollar signs, as notebooks and code hosts show it."""

from __future__ import annotations

import re
from typing import assert_never

from symbalance.document import nodes
from symbalance.document.fitting import fitted, plain_words
from symbalance.document.formula import Decimal, Equation, Formula, Number
from symbalance.document.latex_writer import formula_latex
from symbalance.document.nodes import Inline, inlines

ROOM = 160.0
"""How many characters wide a table may be before exact forms give way to decimals."""
_SPECIAL = re.compile(r"([\\`*_{}\[\]<>#|$])")


def document_markdown(document: nodes.Document) -> str:
    """Return a document as Markdown."""
    parts = [f"# {_words(document.title)}"]
    if inlines(document.lead):
        parts.append(_words(document.lead))
    return "\n\n".join([*parts, *map(_block, document.blocks)]) + "\n"


def _block(block: nodes.Block) -> str:
    match block:
        case nodes.Heading():
            return f"{'#' * block.level} {_words(block.words)}"
        case nodes.Paragraph():
            return _words(block.words)
        case nodes.Facts():
            lines = [f"- {_words(n)}{f': {_words(v)}' if inlines(v) else ''}" for n, v in block.entries]
            head = [_words(block.title), ""] if inlines(block.title) else []
            return "\n".join([*head, *lines])
        case nodes.Table():
            return _table(block)
        case nodes.Formulas():
            return "\n\n".join(f"$${formula_latex(each)}$$" for each in block.equations)
        case nodes.Figure():
            return f"![{_escaped(block.shows)}]({block.name})"
        case nodes.Source():
            return _source(block)
        case nodes.Details():
            inner = "\n\n".join(map(_block, block.blocks))
            return f"**{_escaped(block.summary)}**\n\n{inner}"
    assert_never(block)


def _words(words: nodes.Words) -> str:
    return "".join(map(_inline, inlines(words)))


def _inline(inline: Inline) -> str:
    match inline:
        case str():
            return _escaped(inline)
        case nodes.Code():
            return _code(inline.text)
        case nodes.Strong():
            return f"**{_escaped(inline.text)}**"
        case Decimal() | Number():
            return plain_words(inline)
        case Formula() | Equation():
            return f"${formula_latex(inline, inline=True)}$"
    assert_never(inline)


def _escaped(text: str) -> str:
    return _SPECIAL.sub(r"\\\1", text)


def _code(text: str) -> str:
    """Return text between backticks, more of them than the text holds in a row."""
    flat = " ".join(text.split()).replace("|", "\\|")
    ticks = "`" * (max(map(len, re.findall("`+", flat)), default=0) + 1)
    pad = " " if flat.startswith("`") or flat.endswith("`") else ""
    return f"{ticks}{pad}{flat}{pad}{ticks}"


def _table(table: nodes.Table) -> str:
    title = _words(table.title)
    if not table.rows:
        return f"{title}: {_escaped(table.empty)}" if title else _escaped(table.empty)
    fit = fitted(table, lambda words: len(plain_words(words)), ROOM, 3)
    heads = [_words(column.head) for column in fit.columns]
    shape = ["---:" if _is_number_column([row[i] for row in fit.rows]) else "---" for i in range(len(heads))]
    rows = [heads, shape, *([_words(cell) for cell in row] for row in fit.rows)]
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    below = [f"- {_escaped(f'{e.place} {e.name}')} = ${formula_latex(e.value)}$" for e in fit.left_out]
    head = [f"**{title}**" if "$" not in title else title, ""] if title else []
    return "\n".join([*head, *lines, *(["", "exactly:", "", *below] if below else [])])


def _is_number_column(cells: list[nodes.Words]) -> bool:
    parts = [inlines(cell) for cell in cells]
    return all(not p or (len(p) == 1 and isinstance(p[0], Decimal | Number)) for p in parts)


def _source(source: nodes.Source) -> str:
    lines = ["| line | as it stands | verdict |", "|---|---|---|"]
    for line in source.lines:
        word = f"**{_escaped(line.verdict)}**" if line.bad else _escaped(line.verdict)
        notes = [_words(note) for note in line.notes]
        notes += [f"{_escaped(name)}: ${formula_latex(value)}$" for name, value in line.formulas]
        said = "<br>".join([word, *notes])
        lines.append(f"| {_escaped(line.place)} | {_code(line.text)} | {said} |")
    return "\n".join(lines)
