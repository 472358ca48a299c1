"""The author's own page for a browser: typeset, each relation coloured, what is wrong first.

What stands between relations is shown as text, formulas in dollar signs typeset; each relation stands on
a line that opens to its claim, its exact value, a witness, both sides drawn where they part, and the
change that makes it true, in the author's letters.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from symbalance.document.formula import Equation, Formula, names
from symbalance.document.nodes import (
    Block,
    Code,
    Document,
    Facts,
    Figure,
    Heading,
    Inline,
    Jump,
    Marked,
    Paragraph,
    Words,
    blocks,
)
from symbalance.notes.checking.document_table import line_anchor
from symbalance.notes.checking.report_document import (
    difference_words,
    fault_words,
    legend,
    one_line,
    page_title,
    place,
    summary,
    verdict_words,
    witness_words,
)
from symbalance.notes.checking.sides_plot import plot_sides
from symbalance.notes.checking.typeset_relations import is_readable, sides_by_span, typeset, whole_chain
from symbalance.notes.checking.verdicts import FAILING, REFUTED, UNDECIDED, UNREADABLE, Checked, Verdict
from symbalance.notes.reading import ReadingError, read_equation

MOST_PLOTS = 60
"""Of one page: each takes some hundredths of a second."""
MOST_FORMULAS = 2000
"""In the prose of one page that are read to be typeset; the rest stand as they are typed."""
LONGEST_PROSE = 600
"""Characters of a source that stands in the page as it is typed."""
_RIGHT = ("holds", "holds_to_order", "conditional")


def marked_page(checked: Checked) -> Document:
    """Return a page with its summary, what is wrong with links into it, and the page itself."""
    wrong = [v for v in checked.verdicts if v.verdict in FAILING]
    wrong.sort(key=lambda v: (FAILING.index(v.verdict), v.line))
    remarks = tuple(map(Paragraph, checked.remarks))
    if not checked.verdicts:
        return Document(page_title(checked.derivation.name), remarks, summary(checked))
    page = _Page(checked)
    body = tuple(page.blocks())
    return Document(
        page_title(checked.derivation.name),
        blocks(
            remarks,
            Heading("To be mended") if wrong else None,
            Facts(tuple(_entry(verdict) for verdict in wrong)) if wrong else None,
            Heading("The page"),
            body,
            legend(checked.verdicts),
        ),
        summary(checked),
    )


def _entry(verdict: Verdict) -> tuple[Words, Words]:
    """Return a wrong line's place, which leads to it, and what is wrong with it in a few words."""
    where = Jump(f"line {place(verdict)}", _anchor(verdict))
    if verdict.fix is not None and is_readable(verdict.fix.node):
        side = ", on the left side" if verdict.fix.of_left else ""
        return where, (
            f"{verdict_words(verdict)} ({verdict.fix.kind}{side}): should be ",
            verdict.fix.node,
        )
    if verdict.node is not None and is_readable(verdict.node):
        return where, (f"{verdict_words(verdict)}: ", verdict.node)
    return where, (f"{verdict_words(verdict)}: ", Code(one_line(verdict.source, 80)))


def _anchor(verdict: Verdict) -> str:
    return line_anchor(place(verdict))


def _mark(verdict: Verdict) -> str:
    if verdict.verdict in (UNDECIDED, UNREADABLE):
        return "unsure"
    if verdict.verdict in FAILING:
        return "wrong"
    return "right" if verdict.verdict in _RIGHT else "plain"


@dataclass(frozen=True)
class _Piece:
    """A stretch of the page that has verdicts: it stands as their lines, or within a sentence."""

    start: int
    end: int
    verdicts: tuple[Verdict, ...]
    inline: tuple[Formula | Equation, ...] = ()


class _Page:
    """Goes through a page's text: prose as paragraphs, relations as marked lines."""

    def __init__(self, checked: Checked) -> None:
        self.checked, self.text = checked, checked.derivation.text
        self.sides = sides_by_span(checked.derivation)
        self.letters = {n for c in checked.derivation.chains for s in c.sides for n in names(s.node)}
        self.plots = self.formulas = 0
        is_plain = checked.derivation.name.endswith((".txt", ".text"))
        self.is_tex = checked.derivation.name.endswith(".tex")
        self.parting = _LINES if is_plain else _PARAGRAPHS

    def blocks(self) -> Iterator[Block]:
        """Yield the page from top to bottom; verdicts that stand at no place come last."""
        placed, loose = self._pieces()
        at = _body_start(self.text)
        after_inline = False
        waiting: list[Verdict] = []
        words: list[Inline] = []
        for piece in placed:
            between = self.text[at : piece.start] if at < piece.start else ""
            if after_inline:
                between = _CLOSING.sub("", between)
            after_inline = bool(piece.inline)
            if piece.inline:
                between = _OPENING.sub("", between)
                yield from self._prose(between, words, waiting, goes_on=True)
                words += piece.inline
                waiting += piece.verdicts
            else:
                yield from self._prose(between, words, waiting)
                yield from map(self._line, piece.verdicts)
            at = max(at, piece.end)
        end = self.text.find("\\end{document}", at)
        rest = self.text[at : end if end >= 0 else len(self.text)]
        yield from self._prose(_CLOSING.sub("", rest) if after_inline else rest, words, waiting)
        if loose:
            yield Heading("Claims of the symbols file", 3)
            yield from map(self._line, loose)

    def _pieces(self) -> tuple[list[_Piece], list[Verdict]]:
        """Return the stretches that verdicts stand at, in order, and the verdicts that stand at none."""
        stretches: dict[tuple[int, int], list[Verdict]] = {}
        loose: list[Verdict] = []
        for verdict in self.checked.verdicts:
            chain = self.sides.get(verdict.span, (None, 0))[0]
            if verdict.span[1] <= verdict.span[0] or verdict.piece:
                loose.append(verdict)
            elif chain is None:
                stretches.setdefault(verdict.span, []).append(verdict)
            else:
                span = (chain.sides[0].span[0], chain.sides[-1].span[1])
                stretches.setdefault(span, []).append(verdict)
        placed = []
        for chain in self.checked.derivation.chains:  # a formula alone, of which nothing is claimed
            span = (chain.sides[0].span[0], chain.sides[-1].span[1])
            if span not in stretches:
                placed.append(_Piece(*span, (), (whole_chain(chain),)))
        for (start, end), verdicts in stretches.items():
            chain = self.sides.get(verdicts[0].span, (None, 0))[0]
            inline = (whole_chain(chain),) if chain is not None and chain.inline else ()
            placed.append(_Piece(start, end, tuple(verdicts), inline))
        return sorted(placed, key=lambda piece: (piece.start, piece.end)), loose

    def _prose(
        self, text: str, words: list[Inline], waiting: list[Verdict], goes_on: bool = False
    ) -> Iterator[Block]:
        """Yield the paragraphs and headings of a stretch of prose; with `goes_on` the last stays open."""
        paragraphs = self.parting.split(text)
        for k, paragraph in enumerate(paragraphs):
            heading = re.match(r"\s*(?:(#{1,6})\s+(.*)|\\(?:sub)*section\*?\s*\{([^{}]*)\})", paragraph)
            rest = paragraph
            if heading:
                yield from self._closed(words, waiting)
                yield Heading(tuple(self._typeset(self._plain(heading[2] or heading[3] or ""))), 3)
                rest = paragraph[heading.end() :]
            words += self._typeset(self._plain(rest))
            if not (goes_on and k == len(paragraphs) - 1):
                yield from self._closed(words, waiting)

    def _closed(self, words: list[Inline], waiting: list[Verdict]) -> Iterator[Block]:
        """Yield the paragraph gathered so far and the lines of the relations within it."""
        if any(not isinstance(word, str) or word.strip(" .,;:、。$") for word in words):
            yield Paragraph(tuple(words))
        words.clear()
        yield from map(self._line, waiting)
        waiting.clear()

    def _typeset(self, text: str) -> Iterator[Inline]:
        """Yield prose with what stands between dollar signs as formulas."""
        for k, part in enumerate(re.split(r"\$([^$\n]{1,200})\$|\\\((.{1,200}?)\\\)", text)):
            if part is None:
                continue
            if k % 3 == 0:
                if part:
                    yield part.replace("$", "")
                continue
            self.formulas += 1
            yield self._formula(part) if self.formulas <= MOST_FORMULAS else Code(part)

    def _formula(self, source: str) -> Inline:
        letters = self.letters | set(re.findall(r"(?<![A-Za-z\\])[A-Za-z](?![A-Za-z])", source))
        try:
            return whole_chain(read_equation(source, letters))
        except ReadingError:
            return Code(source)

    def _plain(self, text: str) -> str:
        """Return prose without the signs that set it, one space for each run of them."""
        text = _COMMENT.sub("", text) if self.is_tex else text
        text = _DROPPED.sub(" ", text)
        text = _UNWRAPPED.sub(lambda match: match[1] or match[2] or "", text)
        return re.sub(r"[ \t\r\f\v]*\n[ \t]*|[ \t]+", " ", text)

    def _line(self, verdict: Verdict) -> Marked:
        """Return a relation as a line that opens."""
        shown = typeset(verdict, self.sides)
        words: Words = Code(one_line(verdict.source, LONGEST_PROSE)) if shown is None else shown
        return Marked(
            place(verdict),
            words,
            verdict_words(verdict),
            _mark(verdict),
            tuple(self._inside(verdict)),
            _anchor(verdict),
        )

    def _inside(self, verdict: Verdict) -> Iterator[Block]:
        """Yield what is said of a relation: why, what differs, a witness, the sides drawn, the change."""
        entries: list[tuple[Words, Words]] = [("As typed", Code(one_line(verdict.source, LONGEST_PROSE)))]
        if verdict.bind:
            entries.append(("Claims to be", verdict.bind))
        if verdict.reason:
            entries.append(("Why", verdict.reason))
        entries += [("Note", note) for note in verdict.notes]
        entries += [("Differs in", difference_words(each)) for each in verdict.differences]
        if verdict.is_bad and verdict.exact_node is not None and is_readable(verdict.exact_node):
            entries.append(("Exact value", verdict.exact_node))
        if verdict.verdict == REFUTED and verdict.witness:
            words = witness_words(verdict)
            entries.append(("Witness", words[1:] if isinstance(words, tuple) else words))
        if verdict.fix:
            entries.append(("Found", verdict.fix.kind))
            entries += [("Change", fault_words(fault, verdict)) for fault in verdict.fix.faults]
            if is_readable(verdict.fix.node):
                side = "Left side should be" if verdict.fix.of_left else "Should be"
                entries.append((f"{side}, proved", verdict.fix.node))
        yield Facts(tuple(entries))
        if picture := self._picture(verdict):
            yield picture

    def _picture(self, verdict: Verdict) -> Figure | None:
        if verdict.verdict != REFUTED or self.plots >= MOST_PLOTS:
            return None
        self.plots += 1
        return plot_sides(verdict.decision, verdict.witness)


def _body_start(text: str) -> int:
    """Return where a TeX file's own text begins; 0 where there is no preamble."""
    begin = text.find("\\begin{document}")
    return begin + len("\\begin{document}") if begin >= 0 else 0


_LINES = re.compile(r"\n\s*")
_PARAGRAPHS = re.compile(r"\n[ \t]*(?:\n[ \t]*)+|(?=\n[ \t]*(?:#|\\(?:sub)*section|[-*] |\\item))")
"""What parts two paragraphs: in plain text every end of a line, elsewhere an empty line or a mark."""
_COMMENT = re.compile(r"(?<!\\)%[^\n]*")
_OPENING = re.compile(r"(?:\$|\\\()\s*$")
_CLOSING = re.compile(r"^\s*(?:\$|\\\))")
"""The signs around a formula within a sentence that stands typeset."""
_DROPPED = re.compile(
    r"\\(?:begin|end)\s*\{[A-Za-z]+\*?\}|\\(?:displaystyle|\[|\]|\\|item|maketitle|noindent|quad|qquad)"
    r"|\\(?:label|tag)\s*\{[^{}]*\}|\$\$|<!--.*?-->|(?m:^[ \t]*&)|(?<=\s)&(?=\s)",
    re.DOTALL,
)
_UNWRAPPED = re.compile(r"\\(?:text|emph|textbf|textit|textrm|mathrm)\s*\{([^{}]*)\}|\*\*([^*\n]+)\*\*")
