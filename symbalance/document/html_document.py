"""Documents as HTML: headings, tables and lists that say what they are, formulas as MathML.

A fragment is one `<article>` to put into a page; a page of its own states its language and character
set, and holds its few lines of style, so that it needs nothing beside it.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Sequence
from html import escape
from itertools import count
from typing import assert_never

from symbalance.document import nodes
from symbalance.document.fitting import Fitted, fitted, plain_words
from symbalance.document.formula import Decimal, Equation, Formula, Number
from symbalance.document.mathml_writer import formula_mathml
from symbalance.document.nodes import Inline, inlines

ROOM = 130.0
"""How many characters wide a table may be before exact forms give way to decimals."""

_STYLE = """
.symbalance{max-width:60rem;font:1rem/1.45 system-ui,sans-serif}
.symbalance table{border-collapse:collapse;margin:0 0 1rem}
.symbalance caption{text-align:left;font-weight:bold;padding:.3rem 0}
.symbalance th,.symbalance td{padding:.15rem .8rem .15rem 0;text-align:left;vertical-align:baseline}
.symbalance thead th{border-bottom:1px solid}
.symbalance .number{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
.symbalance .pad{visibility:hidden}
.symbalance .wide{overflow-x:auto}
.symbalance dt{float:left;clear:left;margin-right:.6rem;font-weight:bold}
.symbalance dd{margin-left:1.5rem}
.symbalance .bad{font-weight:bold}
.symbalance img,.symbalance svg{max-width:100%;height:auto}
"""
_PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>{style}</style>
</head>
<body>
<main>
{body}</main>
</body>
</html>
"""


def document_html(document: nodes.Document, *, standalone: bool = False) -> str:
    """Return a document as HTML: an article to put into a page, or with `standalone` a whole page."""
    body = _Writer().document(document, top=1 if standalone else 2)
    if not standalone:
        return f"<style>{_STYLE}</style>\n{body}"
    return _PAGE.format(title=escape(plain_words(document.title)), style=_STYLE, body=body)


class _Writer:
    def __init__(self) -> None:
        self.top = 1
        self.names = count(1)

    def document(self, document: nodes.Document, top: int) -> str:
        self.top = top
        parts = ['<article class="symbalance">', self.heading(document.title, top)]
        if inlines(document.lead):
            parts.append(f"<p>{self.words(document.lead)}</p>")
        parts += [self.block(block) for block in document.blocks]
        return "\n".join([*parts, "</article>"]) + "\n"

    def heading(self, words: nodes.Words, level: int) -> str:
        return f"<h{level}>{self.words(words)}</h{level}>"

    def block(self, block: nodes.Block) -> str:
        match block:
            case nodes.Heading():
                return self.heading(block.words, self.top + block.level - 1)
            case nodes.Paragraph():
                return f"<p>{self.words(block.words)}</p>"
            case nodes.Facts():
                return self.facts(block)
            case nodes.Table():
                return self.table(block)
            case nodes.Formulas():
                return "\n".join(f"<p>{formula_mathml(each, display=True)}</p>" for each in block.equations)
            case nodes.Figure():
                return self.figure(block)
            case nodes.Source():
                return self.source(block)
            case nodes.Details():
                inner = "\n".join(map(self.block, block.blocks))
                return f"<details>\n<summary>{escape(block.summary)}</summary>\n{inner}\n</details>"
        assert_never(block)

    def words(self, words: nodes.Words) -> str:
        return "".join(map(self.inline, inlines(words)))

    def inline(self, inline: Inline) -> str:
        match inline:
            case str():
                return escape(inline, quote=False)
            case nodes.Code():
                return f"<code>{escape(inline.text, quote=False)}</code>"
            case nodes.Strong():
                return f"<strong>{escape(inline.text, quote=False)}</strong>"
            case Decimal():
                return formula_mathml(inline) if "e" in inline.text else escape(plain_words(inline))
            case Formula() | Equation():
                return formula_mathml(inline)
        assert_never(inline)

    def facts(self, facts: nodes.Facts) -> str:
        head = f"<p>{self.words(facts.title)}</p>\n" if inlines(facts.title) else ""
        if all(value == "" for _, value in facts.entries):
            items = [f"<li>{self.words(name)}</li>" for name, _ in facts.entries]
            return f"{head}<ul>\n{chr(10).join(items)}\n</ul>"
        items = [f"<dt>{self.words(n)}</dt>\n<dd>{self.words(v)}</dd>" for n, v in facts.entries]
        return f"{head}<dl>\n{chr(10).join(items)}\n</dl>"

    def figure(self, figure: nodes.Figure) -> str:
        if isinstance(figure.picture, bytes):
            data = b64encode(figure.picture).decode("ascii")
            shown = f'<img src="data:image/png;base64,{data}" alt="{escape(figure.shows)}">'
        else:
            shown = figure.picture
        caption = f"<figcaption>{self.words(figure.caption)}</figcaption>" if inlines(figure.caption) else ""
        return f"<figure>\n{shown}\n{caption}</figure>"

    def source(self, source: nodes.Source) -> str:
        rows = []
        for line in source.lines:
            word = f'<strong class="bad">{escape(line.verdict)}</strong>' if line.bad else escape(line.verdict)
            notes = [f"<li>{self.words(note)}</li>" for note in line.notes]
            notes += [f"<li>{escape(name)}: {self.inline(value)}</li>" for name, value in line.formulas]
            below = f"<ul>{''.join(notes)}</ul>" if notes else ""
            rows.append(
                f'<tr><th scope="row">{escape(line.place)}</th><td><code>{escape(line.text, quote=False)}'
                f"</code></td><td>{word}{below}</td></tr>"
            )
        head = '<tr><th scope="col">line</th><th scope="col">as it stands</th><th scope="col">verdict</th></tr>'
        return self.scrolling("Lines with their verdicts", head, rows, "<caption>Lines with their verdicts</caption>")

    # Tables -------------------------------------------------------------------------------------

    def table(self, table: nodes.Table) -> str:
        if not table.rows:
            title = f"{self.words(table.title)}: " if inlines(table.title) else ""
            return f"<p>{title}{escape(table.empty)}</p>"
        fit = fitted(table, lambda words: len(plain_words(words)), ROOM, 2)
        columns = [_padding([row[i] for row in fit.rows]) for i in range(len(fit.columns))]
        heads = "".join(
            f'<th scope="col"{_number_class(pad)}>{self.words(column.head)}</th>'
            for column, pad in zip(fit.columns, columns, strict=True)
        )
        rows = [self.row(row, [c and c[k] for c in columns], table.keys) for k, row in enumerate(fit.rows)]
        caption = f"<caption>{self.words(table.title)}</caption>" if inlines(table.title) else ""
        shown = self.scrolling(plain_words(table.title) or "table", f"<tr>{heads}</tr>", rows, caption)
        return shown + self.left_out(fit)

    def row(self, row: Sequence[nodes.Words], pads: Sequence[str | None], keys: int) -> str:
        cells = []
        for i, (words, pad) in enumerate(zip(row, pads, strict=True)):
            hidden = f'<span class="pad" aria-hidden="true">{pad}</span>' if pad else ""
            tag = 'th scope="row"' if i < keys and inlines(words) else "td"
            cells.append(f"<{tag}{_number_class(pad)}>{self.words(words)}{hidden}</{tag.split()[0]}>")
        return f"<tr>{''.join(cells)}</tr>"

    def scrolling(self, name: str, head: str, rows: Sequence[str], caption: str) -> str:
        """Return a table in a region that scrolls where the window is narrow, by keyboard too."""
        body = "\n".join(rows)
        label = f"{escape(name)} ({next(self.names)})"
        return (
            f'<section class="wide" tabindex="0" aria-label="{label}">\n<table>\n{caption}'
            f"<thead>\n{head}\n</thead>\n<tbody>\n{body}\n</tbody>\n</table>\n</section>"
        )

    def left_out(self, fit: Fitted) -> str:
        """Return the exact forms that have no room in the table."""
        items = [
            f"<li>{escape(each.place)} {escape(each.name)} = {formula_mathml(each.value)}</li>"
            for each in fit.left_out
        ]
        return f"\n<p>exactly:</p>\n<ul>\n{chr(10).join(items)}\n</ul>" if items else ""


def _padding(cells: Sequence[nodes.Words]) -> list[str] | None:
    """Return what is missing behind each number of a column so that points stand in line, or None."""
    parts = [inlines(cell) for cell in cells]
    if not all(not p or (len(p) == 1 and isinstance(p[0], Decimal | Number)) for p in parts):
        return None
    tails = [plain_words(cell).partition(".")[1:] for cell in cells]
    if any("e" in tail for _, tail in tails):
        return ["" for _ in tails]
    longest = max((point + tail for point, tail in tails), key=len, default="")
    return [longest[len(point + tail) :] for point, tail in tails]


def _number_class(pad: object) -> str:
    return "" if pad is None else ' class="number"'
