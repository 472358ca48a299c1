"""Documents as HTML: headings, tables and lists that say what they are, formulas as MathML.

A fragment is one `<article>` to put into a page; a page of its own states its language and character
set, and holds its few lines of style, so that it needs nothing beside it.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Sequence
from html import escape
from itertools import count
from textwrap import shorten
from urllib.parse import quote

from symbalance.document import nodes
from symbalance.document.document_writer import DocumentWriter
from symbalance.document.fitting import Fitted, fit_table, plain_words
from symbalance.document.formula import Decimal, Equation, Formula, Negative, Number
from symbalance.document.mathml_writer import formula_mathml
from symbalance.document.nodes import inlines

ROOM = 130.0
"""How many characters wide a table may be before exact forms give way to decimals."""

LONGEST_TITLE = 70
"""Of a page in a browser's tab and in the results of a search."""

_STYLE = """
.symbalance{max-width:60rem;font:1rem/1.45 system-ui,sans-serif}
.symbalance table{border-collapse:collapse;margin:0 0 1rem}
.symbalance caption,.symbalance .title{text-align:left;font-weight:bold;padding:.3rem 0}
.symbalance caption{white-space:nowrap}
.symbalance th,.symbalance td{padding:.15rem .8rem .15rem 0;text-align:left;vertical-align:baseline}
.symbalance thead th{border-bottom:1px solid}
.symbalance tbody th{font-weight:normal}
.symbalance h1{font-size:1.5rem}
.symbalance h2{font-size:1.25rem}
.symbalance h3{font-size:1.1rem}
.symbalance .number{font-variant-numeric:tabular-nums;white-space:nowrap}
.symbalance .pad{visibility:hidden}
.symbalance .wide{overflow-x:auto}
.symbalance .spoken{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}
.symbalance dt{float:left;clear:left;margin-right:.6rem;font-weight:bold}
.symbalance dd{margin-left:1.5rem}
.symbalance .bad{font-weight:bold}
.symbalance td code,.symbalance dd code{overflow-wrap:anywhere}
.symbalance pre{overflow-x:auto}
@media(max-width:40rem){
.symbalance th,.symbalance td{padding-right:.4rem}
.symbalance table{font-size:.9rem}
}
@media print{.symbalance h2,.symbalance h3,.symbalance caption,.symbalance dt{break-after:avoid}}
.symbalance img,.symbalance svg{max-width:100%;height:auto}
"""
_MARKS = """
.symbalance h1{overflow-wrap:anywhere}
.symbalance .marked{border-left:.35rem solid;margin:.25rem 0;padding:.1rem .6rem}
.symbalance .marked summary{cursor:pointer;display:grid;grid-template-columns:3.2rem 1fr auto;gap:.6rem}
.symbalance .marked .line{overflow-x:auto;overflow-y:hidden;padding:.15rem 0}
.symbalance .marked .place{color:#555;font-variant-numeric:tabular-nums}
.symbalance .marked .word{font-size:.85rem;white-space:nowrap}
.symbalance .marked.right{border-color:#1a7f37;background:#f1f9f3}
.symbalance .marked.wrong{border-color:#b3261e;background:#fdeeec}
.symbalance .marked.wrong .word{color:#9a1b14;font-weight:bold}
.symbalance .marked.unsure{border-color:#9a6700;background:#fff8e5}
.symbalance .marked.plain{border-color:#5b6b82;background:#f3f5f8}
.symbalance .marked .inside{padding:.2rem 0 .4rem 3.8rem;overflow-x:auto}
.symbalance svg text{font:11px system-ui,sans-serif}
@media(max-width:40rem){
.symbalance .marked summary{grid-template-columns:1fr auto}
.symbalance .marked .line{grid-column:1/-1;grid-row:2}
.symbalance .marked .inside{padding-left:.2rem}
}
@media print{
.symbalance .wrong::details-content,.symbalance .unsure::details-content{content-visibility:visible}
.symbalance .marked .inside{padding-left:.8rem}
.symbalance .marked summary,.symbalance figure,.symbalance dd{break-inside:avoid}
}
.symbalance .marked{color:#1b1b1b}
.symbalance figure svg{background:#fff;color:#1b1b1b}
"""
_DARK_PAGE = """
:root{color-scheme:light dark}
@media(prefers-color-scheme:dark){
.symbalance .marked{color:inherit}
.symbalance .marked .place{color:#aaa}
.symbalance .marked.right{background:#10261a;border-color:#3fb950}
.symbalance .marked.wrong{background:#33171a;border-color:#f85149}
.symbalance .marked.wrong .word{color:#ff9d94}
.symbalance .marked.unsure{background:#2e2610;border-color:#d29922}
.symbalance .marked.plain{background:#1d232c;border-color:#8b9bb4}
}
"""
"""Of a page of its own: within somebody else's, light stays light, whatever is around it."""
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
    body = _Writer().document(document, top=1 if standalone else 2).translate(document.signs)
    style = _STYLE + _MARKS if '<details class="marked ' in body else _STYLE
    if '<svg class="sbd"' in body:
        from symbalance.document import svg_writer

        style += svg_writer.style() + "\n"
    if not standalone:
        return f"<style>{style}</style>\n{body}"
    style += _DARK_PAGE if _MARKS in style else ""
    title = shorten(plain_words(document.title), LONGEST_TITLE, placeholder="…")
    return _PAGE.format(title=escape(title), style=style, body=body)


class _Writer(DocumentWriter):
    def __init__(self) -> None:
        self.top = 1
        self.names = count(1)

    def document(self, document: nodes.Document, top: int) -> str:
        self.top = top
        parts = ['<article class="symbalance">', self.title(document.title, top)]
        if inlines(document.lead):
            parts.append(f"<p>{self.words(document.lead)}</p>")
        parts += [self.block(block) for block in document.blocks]
        return "\n".join([*parts, "</article>"]) + "\n"

    def title(self, words: nodes.Words, level: int) -> str:
        return f"<h{level}>{self.words(words)}</h{level}>"

    # Words --------------------------------------------------------------------------------------

    def string(self, text: str) -> str:
        return escape(text, quote=False)

    def code(self, text: str) -> str:
        return f"<code>{escape(text, quote=False)}</code>"

    def strong(self, text: str) -> str:
        return f"<strong>{escape(text, quote=False)}</strong>"

    def math(self, value: Formula | Equation) -> str:
        size = value.operand if isinstance(value, Negative) else value
        whole = isinstance(size, Number) and size.value.denominator == 1
        return plain_words(value) if whole or isinstance(size, Decimal) else formula_mathml(value)

    # Blocks -------------------------------------------------------------------------------------

    def heading(self, block: nodes.Heading) -> str:
        return self.title(block.words, self.top + block.level - 1)

    def paragraph(self, block: nodes.Paragraph) -> str:
        if isinstance(block.words, nodes.Code) and "\n" in block.words.text:
            return f"<pre>{self.code(block.words.text)}</pre>"
        return f"<p>{self.words(block.words)}</p>"

    def formulas(self, block: nodes.Formulas) -> str:
        return "\n".join(f"<p>{formula_mathml(each, display=True)}</p>" for each in block.equations)

    def details(self, block: nodes.Details) -> str:
        inner = "\n".join(map(self.block, block.blocks))
        return f"<details>\n<summary>{escape(block.summary)}</summary>\n{inner}\n</details>"

    def head(self, column: nodes.Column) -> str:
        """Return a column's head; of a formula alone also in words, for checkers hear none in MathML."""
        words = self.words(column.head)
        if not words or any(isinstance(each, str) and each.strip() for each in inlines(column.head)):
            return words
        spoken = escape(plain_words(column.head))
        return f'<span class="spoken">{spoken}</span><span aria-hidden="true">{words}</span>'

    def jump(self, jump: nodes.Jump) -> str:
        place = quote(jump.file) + (f"#{jump.anchor}" if jump.anchor else "")
        return f'<a href="{escape(place)}">{escape(jump.text, quote=False)}</a>'

    def marked(self, block: nodes.Marked) -> str:
        """Return a line that opens, by a click or the keyboard, to what is said of it."""
        anchor = f' id="{escape(block.anchor)}"' if block.anchor else ""
        cells = [
            f'<span class="place">{escape(block.place)}</span>',
            f'<span class="line">{_displayed(self.words(block.words))}</span>',
            f'<span class="word">{escape(block.verdict)}</span>',
        ]
        inside = "\n".join(map(self.block, block.blocks))
        below = f'<div class="inside">\n{inside}\n</div>\n' if inside else ""
        return (
            f'<details class="marked {block.mark}"{anchor}>\n<summary>{"".join(cells)}</summary>\n'
            f"{below}</details>"
        )

    def facts(self, block: nodes.Facts) -> str:
        title = self.words(block.title)
        head = f'<p class="title">{title}</p>\n' if title else ""
        if all(value == "" for _, value in block.entries):
            items = [f"<li>{self.words(name)}</li>" for name, _ in block.entries]
            return f"{head}<ul>\n{chr(10).join(items)}\n</ul>"
        items = [f"<dt>{self.words(n)}</dt>\n<dd>{self.words(v)}</dd>" for n, v in block.entries]
        return f"{head}<dl>\n{chr(10).join(items)}\n</dl>"

    def figure(self, block: nodes.Figure) -> str:
        if (drawing := block.drawing()) is not None:
            from symbalance.document.svg_writer import drawing_svg

            picture = drawing_svg(drawing, styled=False)
        elif isinstance(block.picture, bytes):
            data = b64encode(block.picture).decode("ascii")
            picture = f'<img src="data:image/png;base64,{data}" alt="{escape(block.shows)}">'
        else:
            picture = str(block.picture)
        caption = (
            f"<figcaption>{self.words(block.caption)}</figcaption>" if inlines(block.caption) else ""
        )
        return f"<figure>\n{picture}\n{caption}</figure>"

    def source(self, block: nodes.Source) -> str:
        name = "Lines with their verdicts"
        heads = "".join(f'<th scope="col">{head}</th>' for head in ("line", "as it stands", "verdict"))
        rows = [self.source_line(line) for line in block.lines]
        return self.scrolling(name, f"<tr>{heads}</tr>", rows, f"<caption>{name}</caption>")

    def source_line(self, line: nodes.SourceLine) -> str:
        verdict = escape(line.verdict)
        verdict = f'<strong class="bad">{verdict}</strong>' if line.bad else verdict
        notes = [f"<li>{self.words(note)}</li>" for note in line.notes]
        notes += [f"<li>{escape(name)}: {self.inline(value)}</li>" for name, value in line.formulas]
        below = f"<ul>{''.join(notes)}</ul>" if notes else ""
        place = f'<th scope="row">{escape(line.place)}</th>'
        return f"<tr>{place}<td>{self.code(line.text)}</td><td>{verdict}{below}</td></tr>"

    # Tables -------------------------------------------------------------------------------------

    def table(self, block: nodes.Table) -> str:
        if not block.rows:
            title = f"{self.words(block.title)}: " if inlines(block.title) else ""
            return f"<p>{title}{escape(block.empty)}</p>"
        fit = fit_table(block, lambda words: len(plain_words(words)), ROOM, 2)
        columns = [_padding(fit.cells(i)) if each else None for i, each in enumerate(fit.numeric)]
        heads = "".join(
            f'<th scope="col"{_number_class(pad)}>{head}</th>' if head else "<td></td>"
            for head, pad in zip(map(self.head, fit.columns), columns, strict=True)
        )
        pads = [[None if c is None else c[k] for c in columns] for k in range(len(fit.rows))]
        rows = [self.row(row, pad, block.keys) for row, pad in zip(fit.rows, pads, strict=True)]
        caption = f"<caption>{self.words(block.title)}</caption>" if inlines(block.title) else ""
        html = self.scrolling(plain_words(block.title) or "table", f"<tr>{heads}</tr>", rows, caption)
        remark = f"\n<p>{self.words(fit.remark)}</p>" if inlines(fit.remark) else ""
        return html + self.left_out(fit) + remark

    def row(self, row: Sequence[nodes.Words], pads: Sequence[str | None], keys: int) -> str:
        cells = []
        for i, (words, pad) in enumerate(zip(row, pads, strict=True)):
            hidden = f'<span class="pad" aria-hidden="true">{pad}</span>' if pad else ""
            tag = 'th scope="row"' if i < keys and inlines(words) else "td"
            cells.append(
                f"<{tag}{_number_class(pad)}>{hidden}{self.words(words)}</{tag.split(maxsplit=1)[0]}>"
            )
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


def _displayed(printed: str) -> str:
    """Return a line's formula with fractions as high as in a display, in the line's own place."""
    return printed.replace("<math>", '<math displaystyle="true">', 1)


def _padding(cells: Sequence[nodes.Words]) -> list[str]:
    """Return what is missing before each number of a column so that points stand in line."""
    wholes = [_WHOLE.match(plain_words(cell)) for cell in cells]
    heads = [whole[0] if whole else "" for whole in wholes]
    longest = max(heads, key=len, default="")
    return [longest[: len(longest) - len(head)] for head in heads]


_WHOLE = re.compile("[+−]?[0-9]+")
"""What stands before a number's point."""


def _number_class(pad: object) -> str:
    return "" if pad is None else ' class="number"'
