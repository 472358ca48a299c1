"""The author's own page for a browser: typeset, each relation coloured, what is wrong first.

What stands between relations is shown as text (`page_prose`), formulas typeset; each relation stands on
a line that opens to its claim, its exact value, a witness, both sides drawn where they part, and the
change that makes it true, in the author's letters.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import PurePath

from symbalance.document.formula import names
from symbalance.document.nodes import (
    Block,
    Code,
    Column,
    Details,
    Document,
    Facts,
    Figure,
    Heading,
    Inline,
    Jump,
    Marked,
    Paragraph,
    Strong,
    Table,
    Words,
    blocks,
)
from symbalance.notes.checking.reports.document_table import line_anchor
from symbalance.notes.checking.reports.page_prose import DISPLAY, END, INLINE, OWN_SIGNS, Prose, Stretch
from symbalance.notes.checking.reports.report_document import (
    arrow_source,
    difference_words,
    fault_words,
    legend,
    needs_witness,
    one_line,
    page_title,
    place,
    summary,
    verdict_words,
    witness_words,
)
from symbalance.notes.checking.reports.sides_plot import plot_sides
from symbalance.notes.checking.reports.typeset_relations import (
    formula_of,
    is_readable,
    sides_by_span,
    typeset,
    whole_chain,
)
from symbalance.notes.checking.verdicts import (
    CONTRADICTION,
    FAILING,
    REFUTED,
    TO_ITS_RIGHT,
    UNDECIDED,
    UNREADABLE,
    Checked,
    Verdict,
)
from symbalance.text import lazy_patterns as re

TOP = "top"
"""The head of a web page, by its name in HTML."""
MOST_PLOTS = 60
"""Of one page: each takes some hundredths of a second."""
MOST_FORMULAS = 2000
"""In the prose of one page that are read to be typeset; the rest stand as they are typed."""
MOST_CODE = 200
"""Lines of program code that are shown."""
LONGEST_VERDICT = 56
"""Characters of a verdict beside its formula; what it assumes stands whole where the line opens."""
LONGEST_PROSE = 600
"""Characters of a source that stands in the page as it is typed."""
_LISTS = (
    ("To be mended", (REFUTED, CONTRADICTION)),
    ("Not decided", (UNDECIDED,)),
    ("Not read", (UNREADABLE,)),
)
_RIGHT = ("holds", "holds_to_order", "conditional")


def marked_page(checked: Checked) -> Document:
    """Return a page with its summary, what is wrong with links into it, and the page itself."""
    failing = (v for v in checked.verdicts if v.verdict in FAILING)
    wrong = [v for v in failing if not (v.sign and v.reason.startswith(TO_ITS_RIGHT))]
    wrong.sort(key=lambda v: (FAILING.index(v.verdict), v.line, v.link))
    remarks = tuple(map(Paragraph, checked.remarks))
    if not checked.verdicts:
        return Document(page_title(checked.derivation.name), remarks, summary(checked))
    page = _Page(checked)
    body = tuple(page.blocks())
    return Document(
        page_title(checked.derivation.name),
        blocks(
            tuple(remark for remark in remarks if _is_of_verdicts(remark)),
            tuple(_lists(wrong, page)),
            Heading("The page"),
            body,
            legend(checked.verdicts),
            tuple(_to_be_declared(remarks)),
        ),
        summary(checked),
        _as_tex_shows(checked.derivation.text),
    )


def _as_tex_shows(text: str) -> dict[int, int]:
    r"""Return the signs of \varphi and \phi as TeX shows them, φ and ϕ, for a page that types only these.

    Elsewhere φ is the letter phi, as its name says.
    """
    is_tex = "\\varphi" in text or "\\phi" in text
    return str.maketrans("φϕ", "ϕφ") if is_tex and not {"φ", "ϕ"} & {*text} else {}


def _is_of_verdicts(remark: Paragraph) -> bool:
    """Tell whether a remark says what all verdicts rest on, and not what might be declared."""
    return isinstance(remark.words, tuple) and isinstance(remark.words[0], Strong)


def _to_be_declared(remarks: tuple[Paragraph, ...]) -> Iterator[Block]:
    """Yield what is to be done by who declares the letters, who may be another than the page's author."""
    rest = tuple(remark for remark in remarks if not _is_of_verdicts(remark))
    if rest:
        yield Heading("For who declares the letters")
        yield from rest


def _lists(wrong: list[Verdict], page: _Page) -> Iterator[Block]:
    """Yield what is wrong, then what was not decided and what was not read, which may be right."""
    for title, verdicts in _LISTS:
        entries = tuple(_entry(verdict, page) for verdict in wrong if verdict.verdict in verdicts)
        if entries:
            yield Heading(title)
            yield Facts(entries)


def _entry(verdict: Verdict, page: _Page) -> tuple[Words, Words]:
    """Return a wrong line's place, which leads to it, and what is wrong with it in a few words."""
    where = Jump(f"line {place(verdict)}", _anchor(verdict))
    if verdict.fix is not None and is_readable(verdict.fix.node):
        side = ", on the left side" if verdict.fix.of_left else ""
        return where, (
            f"{verdict_words(verdict)} ({verdict.fix.words or verdict.fix.kind}{side}): should be ",
            verdict.fix.node,
        )
    if (relation := typeset(verdict, page.sides, page.text)) is not None:
        return where, (f"{verdict_words(verdict)}: ", relation)
    return where, (f"{verdict_words(verdict)}: ", Code(one_line(_typed(verdict), 80)))


def _typed(verdict: Verdict) -> str:
    return arrow_source(verdict) if verdict.sign else verdict.source


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
    inline: tuple[Inline, ...] = ()
    is_inline: bool = False


class _Page:
    """Goes through a page's text: prose as paragraphs, relations as marked lines."""

    def __init__(self, checked: Checked) -> None:
        self.checked = checked
        self.sides = sides_by_span(checked.derivation)
        self.letters = {n for c in checked.derivation.chains for s in c.sides for n in names(s.node)}
        self.plots = self.formulas = 0
        self.text = OWN_SIGNS.sub("\ufffd", checked.derivation.text)
        self.pieces, self.loose = self._pieces()
        suffix = PurePath(checked.derivation.name).suffix.lower()
        self.prose = Prose(_with_marks(self.text, self.pieces), suffix)

    def blocks(self) -> Iterator[Block]:
        """Yield the page from top to bottom; verdicts that stand at no place come last."""
        placed: set[int] = set()
        for stretch in self.prose.stretches():
            yield from self._stretch(stretch, placed)
        rest = [piece for k, piece in enumerate(self.pieces) if k not in placed and piece.verdicts]
        for piece in rest:  # in markup that is left out, such as a macro's definition
            yield from map(self._line, piece.verdicts)
        if self.loose:
            yield Heading("Claims of the symbols file", 3)
            yield from map(self._line, self.loose)

    def _stretch(self, stretch: Stretch, placed: set[int]) -> Iterator[Block]:
        """Yield a block of the page, then the lines of the relations that stand within it."""
        waiting: list[Verdict] = []

        def words(text: str) -> tuple[Inline, ...]:
            return tuple(self._words(text, waiting, placed))

        if stretch.kind == "relation":
            placed.add(int(stretch.text))
            piece = self.pieces[int(stretch.text)]
            if not piece.verdicts:
                yield Paragraph(piece.inline)
            yield from map(self._line, piece.verdicts)
        elif stretch.kind == "code":
            lines = stretch.text.split("\n")
            shown = Paragraph(Code("\n".join(lines[:MOST_CODE])))
            title = f"Program code, {len(lines)} {'line' if len(lines) == 1 else 'lines'}"
            yield Details(title, (shown,))
        elif stretch.kind == "table":
            cells = tuple(tuple(map(words, row)) for row in stretch.rows)
            head = cells[0] if stretch.has_head else ("",) * len(cells[0])
            yield Table("", tuple(map(Column, head)), cells[1:] if stretch.has_head else cells)
        elif stretch.kind == "heading":
            yield Heading(words(stretch.text), 3)
        else:
            inside = words(stretch.text)
            if any(not isinstance(word, str) or word.strip(_ONLY_SIGNS) for word in inside):
                yield Paragraph(inside)
        yield from map(self._line, waiting)

    def _words(self, text: str, waiting: list[Verdict], placed: set[int]) -> Iterator[Inline]:
        """Yield a text with its formulas typeset; verdicts on relations within it are to follow it."""
        for kind, content in self.prose.inline(text):
            if kind == "relation":
                piece = self.pieces[int(content)]
                placed.add(int(content))
                yield from piece.inline
                waiting += piece.verdicts
            elif kind == "formula":
                self.formulas += 1
                yield from self._formulas(content) if self.formulas <= MOST_FORMULAS else [Code(content)]
            elif kind == "text":
                yield content
            else:
                yield Code(content) if kind == "code" else Strong(content)

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
                placed.append(_Piece(*span, (), (whole_chain(chain, self.text),), chain.inline))
        for (start, end), verdicts in stretches.items():
            chain = self.sides.get(verdicts[0].span, (None, 0))[0]
            if chain is None:  # an arrow; or not read: it stands in its sentence as it was typed
                sign = verdicts[0].sign
                typed = sign or Code(one_line(verdicts[0].source, LONGEST_PROSE))
                words: tuple[Inline, ...] = (typed,)
                placed.append(_Piece(start, end, tuple(verdicts), words, verdicts[0].inline))
            else:
                placed.append(
                    _Piece(start, end, tuple(verdicts), (whole_chain(chain, self.text),), chain.inline)
                )
        return sorted(placed, key=lambda piece: (piece.start, piece.end)), loose

    def _formula(self, source: str) -> Inline:
        formula = formula_of(source, self.letters)
        return Code(source) if formula is None else formula

    def _formulas(self, source: str) -> Iterator[Inline]:
        r"""Yield a formula, or several that commas part: `0, \pi, 2\pi`."""
        whole = self._formula(source)
        pieces = re.split(r"(\s*(?:,(?![0-9])|;|\\ldots|\\dots)\s*)", source)
        if not isinstance(whole, Code) or len(pieces) == 1:
            yield whole
            return
        for k, piece in enumerate(pieces):
            if k % 2:
                yield "…" if "dots" in piece else f"{piece.strip()} "
            elif piece:
                yield self._formula(piece)

    def _line(self, verdict: Verdict) -> Marked:
        """Return a relation as a line that opens."""
        shown = typeset(verdict, self.sides, self.text)
        words: Words = Code(one_line(_typed(verdict), LONGEST_PROSE)) if shown is None else shown
        if verdict.sign:
            words = (self._formula(verdict.left), f" {verdict.sign} ", self._formula(verdict.source))
        return Marked(
            place(verdict),
            words,
            one_line(verdict_words(verdict), LONGEST_VERDICT),
            _mark(verdict),
            tuple(self._inside(verdict)),
            _anchor(verdict),
        )

    def _inside(self, verdict: Verdict) -> Iterator[Block]:
        """Yield what is said of a relation: why, what differs, a witness, the sides drawn, the change."""
        entries: list[tuple[Words, Words]] = [
            ("As typed", Code(one_line(_typed(verdict), LONGEST_PROSE)))
        ]
        if len(verdict_words(verdict)) > LONGEST_VERDICT:
            entries.append(("Holds if", verdict.assumption))
        if verdict.bind:
            entries.append(("Claims to be", verdict.bind))
        if verdict.fix:
            entries.append(("Found", verdict.fix.words or verdict.fix.kind))
            entries += [("Change", fault_words(fault, verdict)) for fault in verdict.fix.faults]
            if is_readable(verdict.fix.node):
                side = "Left side should be" if verdict.fix.of_left else "Should be"
                entries.append((f"{side}, proved", verdict.fix.node))
        if verdict.reason:
            entries.append(("Why", verdict.reason))
        entries += [("Note", note) for note in verdict.notes]
        entries += [("Differs in", difference_words(each)) for each in verdict.differences]
        is_said = verdict.fix is not None and verdict.fix.text == verdict.exact
        if verdict.is_bad and verdict.exact_node is not None and is_readable(verdict.exact_node):
            entries += [] if is_said else [("Exact value", verdict.exact_node)]
        if needs_witness(verdict):
            words = witness_words(verdict)
            entries.append(("Witness", words[1:] if isinstance(words, tuple) else words))
        if verdict.verdict in FAILING:
            entries.append(("Back", Jump("to the head of this report", TOP)))
        yield Facts(tuple(entries))
        if picture := self._picture(verdict):
            yield picture

    def _picture(self, verdict: Verdict) -> Figure | None:
        if verdict.verdict != REFUTED or self.plots >= MOST_PLOTS:
            return None
        self.plots += 1
        return plot_sides(verdict.decision, verdict.witness)


def _with_marks(text: str, pieces: list[_Piece]) -> str:
    """Return a page with a mark for each stretch that has verdicts; those that overlap stand in a row."""
    parts: list[str] = []
    at = 0
    for k, piece in enumerate(pieces):
        before = text[at : max(piece.start, at)]
        is_closed_within = text.count("</math", piece.start, piece.end) > text.count(
            "<math", piece.start, piece.end
        )
        if is_closed_within or text.count("$", piece.start, piece.end) % 2:
            before = _OPENING.sub("", before)  # $x = 6.71$ in: it opens before its relation
        parts.append(before)
        parts.append(f"{INLINE if piece.inline and piece.is_inline else DISPLAY}{k}{END}")
        at = max(at, piece.end)
    return "".join([*parts, text[at:]])


_OPENING = re.compile(r"(?:(?<!\\)\$|<math\b[^<>]{0,80}>)[ \t]*$")
_ONLY_SIGNS = " \u00a0.,;:、。$&\\"
