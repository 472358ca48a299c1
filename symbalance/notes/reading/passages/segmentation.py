"""Splitting of a document into the parts that may be equations, in order.

What is no mathematics is blank by now (`sources`). Delimited mathematics ($ $, \\( \\), \\[ \\],
environments) is cut into rows and these at
separators, and the lines outside are searched for equations in prose (`prose`).
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from itertools import islice, pairwise

from symbalance.document.letters import WORDS
from symbalance.document.wordlists import word_set, words
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.formulas.lexer import Vocabulary, vocabulary
from symbalance.notes.reading.passages.continued_lines import goes_on_below, is_first_side
from symbalance.notes.reading.passages.meanings_in_words import is_explained_by_text, is_meaning
from symbalance.notes.reading.passages.numbers_behind_commas import before_next_number
from symbalance.notes.reading.passages.prose import (
    line_rules,
    parts_at_lone_brackets,
    segments,
    trim_segment,
)
from symbalance.notes.reading.passages.set_words import doubt_of_words_set
from symbalance.notes.reading.passages.whole_formulas import (
    JOINING,
    MARGIN,
    OPERATION,
    cut_error,
    doubt_around,
)
from symbalance.notes.reading.signs import CELLS, ENVIRONMENTS, RELATION, relation_at_start
from symbalance.notes.reading.sources import CELL_END, Source
from symbalance.notes.reading.spellings.wrapped_lines import ENDS
from symbalance.notes.reading.units import (
    follows_number,
    is_quantity,
    is_unit_of_letter,
    scale_of,
    unit_set_at,
)
from symbalance.text import lazy_patterns as re

_COMMAND = re.compile(r"\\[A-Za-z]+")
_ITEM = r"(?:[a-h]|i{1,3}|i?v)\)"
_BULLET = re.compile(rf"\s*(?:\(?(?:[0-9]{{1,3}}[.)]|{_ITEM})(?=\s))?\s*")
_LISTED = re.compile(r"(?<!\S)\((?:[a-h]|i{1,3}|i?v)\)(?=[ \t])")
"""Letters that count the answers of a line: (a) 2 + 3 = 5   (b) 7 - 2 = 5."""
_NUMBER_IN_COLUMN = re.compile(
    r"[ \t]*[-−]?[0-9]+(?:[.,][0-9]+)?(?:[ ]?(?:°|deg\.?|rpm))?(?:[ ]{3,}|[ ]*\t\s*)"
    r"(?=[^\W\d_][\w']{0,8}(?:\([^()\s]{1,8}\))?[ ]*[=≈]|[0-9][0-9.,]*[ ]?[*·×/]\s?[0-9(])"
)
"""A number at the beginning of a line, in a column of its own: 30    k = 0.966, 4    60*261/4 = 3915."""
_NEXT_COLUMN = re.compile(
    r"(?<=[\w°%).²³])[ ]{3,}(?=(?:\.{3}|…)[a-z]|(?![^=≈\n]{0,40}[^\W\d_]{3})[0-9(][^=≈\n]{1,40}[=≈])"
)
"""Between two formulas of one line in columns, and before a remark: 0.45 x 13578 = 6110 N    0.30 x …"""
_MARKDOWN_BULLET = re.compile(
    r"\s*(?:>\s*)*(?:#{1,6}[ \t]+)?(?:\*\*|__)?(?:[-*+]\s+|[0-9]{1,3}[.)]\s+)?"
    rf"(?:\(?{_ITEM}(?=\s))?\s*"
)
_DASH = re.compile(r"[-*•]\s+(?=[^\s=])")
_EXPLAINED = re.compile(
    r"\s*(?:[-*•]\s+)?([^\W\d_](?:_?[A-Za-z0-9]{1,3})?)\s*[:：]\s*([^:=0-9+*/]{2,60})$"
)
_NAMED_BY_WORDS = re.compile(
    r"(?:^|[,;:(]|(?<![^\W\d_])(?:where|with|and|mit|und|wo))\s*(?:[-*•]\s+)?"
    r"([^\W\d_](?:_?[A-Za-z0-9]{1,4})?)\s*=\s*([^\W\d_][\w'’ -]{2,60})$",
    re.MULTILINE,
)
"""A letter with its meaning before the sign that gives its value: A = piston area = π d²/4."""
_DEFINED = re.compile(r"(?<![A-Za-z\\_^{\"'.])([A-Za-z])(?:_\w{1,4})?[ \t]*=(?![=>])")
_NAMED = re.compile(
    r"(?:(?<=[^\W\d_]{3})[ \t]+(?=[*_`]?(?![AEIOUaeiouyY])|[*_`]?[A-Z][,;:)])|[\u3040-\u9fff][ \t]?)"
    r"[*_`]?([A-Za-z])[*_`]?(?=[ ]?[,;:.)、。，]|[ \t]+[^\W\d_]{2}|\s*$)",
    re.MULTILINE,
)
"""A letter that words name, the mass m and the radius r; a vowel between words may be one itself.

The word is looked for behind its end: from each of its letters, a long one would take its square.
"""
_PHRASE = re.compile(
    r"(?:^|[.;:,(。、：|\ue000]|(?<=[.;:,])\s|[-*•]\s)\s*(?:(?:The|the|Die|Der|Das|die|der|das|A|An|Our)\s+)?"
    r"(?P<words>[^\W\d_][\w'’-]+(?:[ ]{1,2}[^\W\d_][\w'’-]*){0,6})\s*$",
    re.MULTILINE,
)
_VERBS = word_set(
    "is are was be gives give yields yield ist sind ergibt gilt where wo so thus also hence then and or"
    " that we get have has folgt dann und oder times plus minus half if when wenn using let take set sei"
    " since because da weil say means obtain find finds equals therefore somit daher damit wird becomes"
    " not less more than hat it which this i"
)
_PARTICLES = word_set(
    "with mit for für by of to from at bei as on in oben unten the a an der die das ein eine per and im"
)
_ONE_NUMBER = re.compile(
    r"[=≈]\s*[-−]?[0-9]+(?:[.,][0-9]+)?\s*(?:$|[.;,)](?:\s|$)|[^\W\d_]{2,}\b)", re.MULTILINE
)
_ONE_QUANTITY = re.compile(
    r"[=≈]\s*[0-9]+(?:[.,][0-9]+)?[ ]"
    r"(?P<unit>(?!in\b|as\b|at\b|min\b|us\b)[A-Za-z]{2,4}(?:/[a-z]{1,3}[²2]?)?)"
    r"(?=\s*(?:$|[.,;)](?:\s|$)))",
    re.MULTILINE,
)
_WORD_BELOW = re.compile(r"/(?P<word>[^\W\d_]+(?:_\{\w{1,6}\})?)[ \t]*(?=[=≈])")
_WORD_ABOVE = re.compile(r"(?<![\w$\\}])(?<![0-9][ ])(?P<word>[^\W\d_]{3,})$")
_CONJUNCTIONS = re.compile(
    r"(?:(?:hence|so|thus|then|therefore|also|where|and|or|but|with|for|if|when|since|because|also|somit|daher"
    r"|damit|und|mit|bei|donc|alors|the|its|a|an|der|die|das|dann)\s+)+",
    re.IGNORECASE,
)
_WORD_OF_OPERATION = re.compile(r"\b(?:plus|minus|times|mal|over|durch|divided|squared)\b")
_WORDS_ALONE = re.compile(
    r"(?:\\\\|\$|\\\[|\\\(|\}|^|&|\n)\s*\\(?:text|mathrm|textrm|textit|mbox|textbf|textnormal)\s*\{\s*"
    r"(?P<words>[^\W\d_][\w'’ -]+?)\s*\}\s*&?\s*$"
)
_LONG_WORD = re.compile(r"(?<!\\)\b(?<!\\)[A-Za-z]{4,}")
_CJK = re.compile("[\u2e80-\u9fff\uac00-\ud7af\uf900-\ufaff]")
_ROW_OF_TABLE = re.compile(r"[ \t]*\|")
_QUANTITY_LAST = re.compile(r"(?<![A-Za-z0-9_.,])[0-9][0-9.,]*[ ~]?(?P<unit>[A-Za-zµ/²³·]{1,8})$")
_QUANTITY_LENGTH = 32
_RULE = re.compile(r"\s*([-=_*~#+])\1{2,}\s*")
# Limits for text that is no derivation, so that its cost stays in proportion to its length.
LONGEST_LINE = 20_000
MOST_ITEMS = 20_000


@dataclass(frozen=True, slots=True)
class Item:
    """A stretch that may be an equation: display, inline (in $ $), bare (a line) or prose (in a line).

    `block` numbers the display it belongs to; `strict` tells that a refusal is to be reported. `doubt` is
    what goes on behind it, or before it, and was not taken: what is left is not to be judged alone.
    `head` is the letter that `l: rod length = λ s` is about, where the item is `= λ s`, or the words that
    stand for one, `mean speed = 2 s n`. `aside` tells that it explains the row it stands in, behind
    "since" or within \\intertext: the next row goes on with the row's own equation.
    """

    start: int
    end: int
    kind: str
    strict: bool
    first_line: int
    last_line: int
    tag: str = ""
    block: int = -1
    doubt: ReadingError | None = None
    head: tuple[int, int] | None = None
    aside: bool = False


class ItemFinder:
    """Finds the items of one document."""

    def __init__(self, source: Source, names_at: Callable[[int], Collection[str]]) -> None:
        self.source, self.names_at = source, names_at
        self.kind, self.fences, self.text = source.kind, source.formulas, source.text
        self.breaks = [place for place, sign in enumerate(self.text) if sign in ENDS]
        self._hard_breaks = [place for place in self.breaks if self.text[place] == "\n"]
        self.own_letters = frozenset(_DEFINED.findall(self.text) + _NAMED.findall(self.text))
        self._vocabularies: dict[int, Vocabulary] = {}
        self.failures: list[ReadingError] = []

    def line_of(self, offset: int) -> int:
        """Return the line, from 1, of an offset."""
        return bisect_right(self.breaks, offset - 1) + 1

    def line_start(self, line: int) -> int:
        """Return where a line begins, be its formula begun above or not."""
        return self.breaks[line - 2] + 1 if line > 1 else 0

    def line_span(self, line: int) -> tuple[int, int]:
        """Return where a line begins and ends; lines that a formula goes over are one."""
        before = bisect_right(self._hard_breaks, self.line_start(line) - 1)
        start = self._hard_breaks[before - 1] + 1 if before else 0
        return start, self._hard_breaks[before] if before < len(self._hard_breaks) else len(self.text)

    def run(self) -> list[Item]:
        """Return the items, in order."""
        finder = RegionFinder(self.text, self.kind == "tex")
        finder.run()
        self.failures += finder.failures
        regions = [region for region in finder.regions if not self._in_fence(region)]
        regions += [Region(a, a, b, b, True) for a, b in self.fences]
        regions.sort(key=lambda region: region.first)
        items = list(islice(self._items(regions), MOST_ITEMS + 1))
        if len(items) > MOST_ITEMS:
            what = f"more than {MOST_ITEMS} stretches of mathematics"
            self.failures.append(ReadingError(items.pop().start, what, "split the document"))
        return sorted(items, key=lambda item: item.start)

    def _items(self, regions: list[Region]) -> Iterator[Item]:
        for number, region in enumerate(regions):
            if region.start < region.end:
                yield from self._items_of_region(region, number)
        yield from self._items_outside(regions)

    def _words_at(self, line: int) -> Vocabulary:
        """Return the letters declared at a line, and those that the document gives a value itself."""
        if line not in self._vocabularies:
            self._vocabularies[line] = vocabulary(frozenset(self.names_at(line)) | self.own_letters)
        return self._vocabularies[line]

    def _in_fence(self, region: Region) -> bool:
        return any(
            a < region.first < b or (a == region.first and region.start > a) for a, b in self.fences
        )

    def _items_of_region(self, region: Region, block: int) -> Iterator[Item]:
        alone = region.display or self._is_alone(region)
        is_first = not alone and goes_on_below(self.text, region.last)
        if not alone and not is_first and not has_any_relation(self.text, region.start, region.end):
            return
        kind = "display" if alone else "inline"
        end = self._before_constant(region)
        pieces = pieces_of(self.text, region.start, end, region.environment)
        pieces = [p for p in pieces if end == region.end or has_any_relation(self.text, p.start, p.end)]
        around = self._doubt_around_region(region) if pieces and not region.display else None
        for piece in pieces:
            if is_unit_of_letter(self.text, piece.start, piece.end):
                continue
            lines = self.line_of(piece.start), self.line_of(piece.end - 1)
            doubt = piece.doubt or (around if piece is pieces[-1] else None)
            head = self._words_before(piece.start, region.start)
            yield Item(
                piece.start, piece.end, kind, True, *lines, piece.tag, block, doubt, head, piece.aside
            )
        for inner in formulas_in_words(self.text, region.start, region.end):
            lines = self.line_of(inner.start), self.line_of(inner.end - 1)
            yield Item(inner.start, inner.end, "inline", True, *lines, block=block, aside=True)

    def _before_constant(self, region: Region) -> int:
        """Return where $n =$ const. ends before its sign, for other formulas where they end."""
        inside = self.text[region.start : region.end].rstrip()
        if not inside.endswith("=") or _CONSTANT_BEHIND.match(self.text, region.last) is None:
            return region.end
        return region.start + len(inside) - 1

    def _words_before(self, place: int, start: int) -> tuple[int, int] | None:
        """Return the words of \\text{mean speed} = 2 s n that stand alone left of a relation."""
        if not relation_at_start(self.text[place : place + 20]):
            return None
        match = _WORDS_ALONE.search(self.text, max(start - 1, place - MARGIN), place)
        return match.span("words") if match else None

    def _doubt_around_region(self, region: Region) -> ReadingError | None:
        """Return why $a = b$ in a line is not whole: the line goes on with it in words or signs."""
        words = vocabulary(self.names_at(self.line_of(region.first)))
        return doubt_around(self.text, region.first, region.last, words)

    def _is_alone(self, region: Region) -> bool:
        before = self.text[max(0, region.first - MARGIN) : region.first].rpartition("\n")
        after = self.text[region.last : region.last + MARGIN].partition("\n")
        edges = (before[1] or region.first < MARGIN) and (
            after[1] or region.last + MARGIN > len(self.text)
        )
        return bool(edges) and not (before[2] + after[0]).strip(" \t.,;。、")

    def _items_outside(self, regions: list[Region]) -> Iterator[Item]:
        """Yield the items of lines and parts of lines outside delimiters."""
        place = 0
        for region in [*regions, None]:
            stop = region.first if region else len(self.text)
            if place < stop:
                yield from self._items_of_stretch(place, stop)
            place = max(place, region.last) if region else stop

    def _items_of_stretch(self, start: int, stop: int) -> Iterator[Item]:
        line = self.line_of(start)
        while start < stop:
            first, last = self.line_span(line)
            end = min(last, stop)
            whole = start == first and end == last
            for first, last_of_cell in self._cells(start, end):
                if self.text[first:last_of_cell].strip():
                    is_whole = whole and first == start and last_of_cell == end
                    yield from self._items_of_line(first, last_of_cell, line, is_whole)
            start = last + 1
            line = self.line_of(start)

    def _cells(self, start: int, end: int) -> list[tuple[int, int]]:
        """Return the cells of a line that is a row of a table, else the line."""
        gaps = [CELL_END]
        if self.kind == "tex":
            gaps += ["&", "\\\\"]
        elif self.kind == "markdown" and self._is_row_of_table(self.line_of(start)):
            gaps.append("|")
        cells, first = [], start
        pattern = "|".join(map(re.escape, gaps))
        if self.kind != "tex" and (number := _NUMBER_IN_COLUMN.match(self.text, start, end)):
            start = first = number.end()
        if len(_LISTED.findall(self.text, start, end)) > 1:
            pattern += f"|{_LISTED.pattern}"
        if self.kind != "tex":
            pattern += f"|{_NEXT_COLUMN.pattern}"
        for match in re.finditer(pattern, self.text[start:end]):
            is_column = match[0].isspace() and len(match[0]) > 1
            if is_column and not has_relation(self.text, first, start + match.start()):
                continue
            cells.append((first, start + match.start()))
            first = start + match.end()
        return [*cells, (first, end)]

    def _is_row_of_table(self, line: int) -> bool:
        """Tell a row, whose line ends with a bar or stands next to another, from |F| ≤ 3."""
        start, end = self.line_span(line)
        if _ROW_OF_TABLE.match(self.text, start) is None:
            return False
        around = [self.line_span(n)[0] for n in (line - 1, line + 1) if 0 < n <= len(self.breaks) + 1]
        return self.text[start:end].rstrip().endswith("|") or any(
            _ROW_OF_TABLE.match(self.text, place) for place in around
        )

    def _items_of_line(self, start: int, end: int, line: int, whole: bool) -> Iterator[Item]:
        """Yield the items of a line, or of a part of it, outside delimiters."""
        source = self.text[start:end]
        if self.kind == "markdown" and (heading := re.match(r"\s*#+", source)):
            start += heading.end()
        if _RULE.fullmatch(source):
            return
        words = self._words_at(line)
        if whole:
            start = self._after_bullet(start, end)
        command = _COMMAND.search(self.text, start, end)
        lenient = self._is_lenient(start, end)
        spans = segments(self.text, start, end, line_rules(self.text, start, end, words, lenient))
        is_display = self.text.startswith("\\displaystyle", start) and not _CJK.search(
            self.text, start, end
        )
        if (
            self.kind != "tex"
            and whole
            and (is_display or (len(spans) == 1 and self._covers(spans[0], start, end)))
        ):
            yield from self._items_of_bare_line(start, end, line, command is not None)
            return
        for span in spans:
            if not self._is_argument_of_word(span[0], start):
                yield from self._items_of_segment(span, line, lenient, words)

    def _after_bullet(self, start: int, end: int) -> int:
        """Return where a line begins after its number or bullet; `- a` alone may be a term."""
        bullet = _MARKDOWN_BULLET if self.kind == "markdown" else _BULLET
        match = bullet.match(self.text, start, end)
        start = match.end() if match else start
        dash = _DASH.match(self.text, start, end)
        closing = self.text.count(")", start, end) > self.text.count("(", start, end)
        plain = "\\" not in self.text[start:end] and has_relation(self.text, start, end) and not closing
        return dash.end() if dash and plain else start

    def _is_lenient(self, start: int, end: int) -> bool:
        if self.text.find("\\displaystyle", start, end) >= 0:
            return True
        source = self.text[start:end]
        if not _COMMAND.search(source) or _CJK.search(source):
            return False
        return not _LONG_WORD.search(_COMMAND.sub(" ", source))

    def _covers(self, span: tuple[int, int], start: int, end: int) -> bool:
        around = self.text[start : span[0]] + self.text[span[1] : end]
        return not around.strip(" \t.,;∴⇒")

    def _items_of_bare_line(self, start: int, end: int, line: int, command: bool) -> Iterator[Item]:
        if end - start > LONGEST_LINE:
            yield Item(start, end, "bare", command, line, line)
            return
        start, end = self._without_brackets(start, end)
        for piece in pieces_of(self.text, start, end):
            strict = command or has_relation(self.text, piece.start, piece.end)
            yield Item(piece.start, piece.end, "bare", strict, line, line, piece.tag, doubt=piece.doubt)

    def _without_brackets(self, start: int, end: int) -> tuple[int, int]:
        """Return a line without the brackets around the whole of an equation: (a = b)."""
        inner = re.fullmatch(r"\s*\(([^()]*(?:\([^()]*\)[^()]*)*)\)\s*[.,;]?\s*", self.text[start:end])
        if inner is None or not has_relation(self.text, start + inner.start(1), start + inner.end(1)):
            return start, end
        return start + inner.start(1), start + inner.end(1)

    def _is_argument_of_word(self, place: int, start: int) -> bool:
        """Tell f(x) with a word for f from brackets after a word and a space, or a unit, 5 kg(m = …)."""
        before = self.text[place - 1] if place > start else " "
        if self.text[place] not in "([" or not (before.isascii() and before.isalnum()):
            return False
        quantity = _QUANTITY_LAST.search(self.text, max(start, place - _QUANTITY_LENGTH), place)
        return quantity is None or scale_of(quantity["unit"]) is None

    def _items_of_segment(
        self, span: tuple[int, int], line: int, lenient: bool, words: Vocabulary
    ) -> Iterator[Item]:
        """Yield the equations in a stretch of a line without prose."""
        is_long = span[1] - span[0] > LONGEST_LINE
        if is_long or not (has_any_relation(self.text, *span) or goes_on_below(self.text, span[1])):
            return
        display = self.text.find("\\displaystyle", *span)
        if display >= 0:
            span = (display, span[1])
        parts = parts_at_lone_brackets(self.text, *span)
        if len(parts) > 1:
            for part in parts:
                yield from self._items_of_segment(part, line, lenient, words)
            return
        start, end = trim_segment(self.text, *span, words)
        start = _sign_behind_arrow(self.text, span[0], start)
        if not has_relation(self.text, start, end):
            if is_first_side(self.text, start, end):
                yield Item(start, end, "prose", False, self.line_of(start), self.line_of(end - 1))
            return
        for piece in pieces_of(self.text, start, end):
            if has_relation(self.text, piece.start, piece.end):
                inner = trim_segment(self.text, piece.start, piece.end, words)
                inner = _sign_behind_arrow(self.text, piece.start, inner[0]), inner[1]
                inner = _behind_label(self.text, *inner), inner[1]
                inner = _behind_named_letter(self.text, *inner), _before_next_letter(self.text, *inner)
                inner = inner[0], before_next_number(self.text, *inner)
                inner = inner[0], _before_words(self.text, *inner, words)
                ratio = self._ratio_of_words(*inner)
                inner = (ratio[1], inner[1]) if ratio else inner
                doubt = piece.doubt or doubt_around(self.text, *inner, words)
                head = ratio[0] if ratio else None
                head = (
                    head
                    or self._letter_explained(inner[0], line)
                    or self._named_in_words(inner[0], line, words)
                )
                lines = self.line_of(inner[0]), self.line_of(inner[1] - 1)
                yield Item(*inner, "prose", display >= 0, *lines, piece.tag, doubt=doubt, head=head)

    def _ratio_of_words(self, place: int, end: int) -> tuple[tuple[int, int], int] | None:
        """Return the words of stroke/bore = 0.84 that stand for a letter, and where the sign stands."""
        below = _WORD_BELOW.match(self.text, place, end)
        above = _WORD_ABOVE.search(self.text, max(place - MARGIN, 0), place) if below else None
        if below is None or above is None or above["word"].lower() in _VERBS | _PARTICLES:
            return None
        return (above.start("word"), below.end("word")), below.end()

    def _letter_explained(self, place: int, line: int) -> tuple[int, int] | None:
        """Return the letter of `l: rod length = λ s` before the relation at a place."""
        if not relation_at_start(self.text[place : place + 20]):
            return None
        begin = self.line_span(line)[0]
        match = _EXPLAINED.match(self.text, begin, place)
        if match is None:
            match = _NAMED_BY_WORDS.search(self.text, max(begin, place - MARGIN), place)
            match = match if match and _is_long_meaning(match[2], ()) else None
        return match.span(1) if match else None

    def _named_in_words(self, place: int, line: int, words: Vocabulary) -> tuple[int, int] | None:
        """Return the words that stand for a letter in `amax = 3` and `mean piston speed = 2 s n`."""
        if self.text[place : place + 1] not in ("=", "≈"):
            return None
        begin = max(self.line_span(line)[0], place - MARGIN)
        match = _PHRASE.search(self.text, begin, place)
        if match is None:
            return None
        leading = _CONJUNCTIONS.match(match["words"])
        start = match.start("words") + (leading.end() if leading else 0)
        phrase = self.text[start : match.end("words")]
        named = phrase.lower().split()
        if not named or _VERBS & set(named) or named[0] in _PARTICLES or named[-1] in _PARTICLES:
            return None
        if len(phrase) < 2 or _WORD_OF_OPERATION.search(phrase) or phrase in words.names:
            return None
        if _ONE_NUMBER.match(self.text, place) and not self._is_quantity(place):
            return None  # cost = 4
        return start, match.end("words")

    def _is_quantity(self, place: int) -> bool:
        """Tell whether a number with a unit of its own is all that a sign gives: stroke = 67 mm."""
        match = _ONE_QUANTITY.match(self.text, place)
        return match is not None and scale_of(match["unit"]) is not None


_NEXT_LETTER = re.compile(r",\s+(?!π)[^\W\d](?:_\{[^{}]{1,12}\}|_?\w{1,3}|[₀-₉]+)?\s*$")


_NEXT_CLAUSE = re.compile(
    r";\s+(?!π)[^\W\d](?:_\{[^{}]{1,12}\}|_?\w{1,3}|[₀-₉]+)?(?:\s*,\s+[^\W\d](?:_\{[^{}]{1,12}\}|_?\w{1,3}|[₀-₉]+)?){1,6}\s*$"
)
_NAMED_LETTER = re.compile(r"((?!π)[^\W\d](?:_\{[^{}]{1,12}\}|_?\w{1,3}|[₀-₉]+)?)\s*,\s+")
_WORD_BEFORE = re.compile(r"([^\W\d_]{3,})\s+$")


def _behind_named_letter(text: str, start: int, end: int) -> int:
    """Return where λ = l/r begins in "crank radius r, λ = l/r" and "r is the radius, l, λ = r/l".

    The letter before it is the noun's, or one that its right side is made of. In x, y = 0 both are 0.
    """
    listed, place = [], start
    while match := _NAMED_LETTER.match(text, place, end):
        listed.append(match[1])
        place = match.end()
    if not listed or not has_relation(text, place, end):
        return start
    word = _WORD_BEFORE.search(text, max(start - MARGIN, 0), start)
    if len(listed) == 1 and word is not None and word[1].lower() not in _VERBS | _PARTICLES:
        return place
    relation = RELATION.search(text, place, end)
    right = text[relation.end() : end] if relation else ""
    is_made_of = all(re.search(rf"(?<![^\W\d]){re.escape(name)}(?![^\W\d])", right) for name in listed)
    return place if is_made_of else start


_LABEL = re.compile(r"(?:(?<=[a-z][ ])pins?[ ]+|[a-z]{3,}[ ]{3,})(?=[^\W\d_]\w*[ ]*[=≈])")
"""A word in a column before its letter, and a pin behind another word, which is not π n."""


def _behind_label(text: str, start: int, end: int) -> int:
    """Return where d = 50 mm begins in "crank pin      d = 50 mm"."""
    match = _LABEL.match(text, start, end)
    return start if match is None else match.end()


def _before_next_letter(text: str, start: int, end: int) -> int:
    """Return where λ = r/l ends in "λ = r/l, m the mass": the words behind the comma are about m."""
    clause = _NEXT_CLAUSE.search(text, start, end)
    if clause and has_relation(text, start, clause.start()):
        return clause.start()  # λ = r/l; a, b and c are …
    match = _NEXT_LETTER.search(text, start, end)
    follows = re.match(r"\s+(?!(?:and|or|are|und|oder|sind|bzw)\b)[^\W\d_]{2}", text[end : end + 40])
    return match.start() if match and follows and has_relation(text, start, match.start()) else end


# Delimited mathematics

_NAMES = "|".join(sorted(ENVIRONMENTS | {"cases", "array", "dcases"}, key=len, reverse=True))
_OPENER = re.compile(rf"\\\\|\\\$|\$\$|\$|\\\(|\\\[|\\begin\s*\{{((?:{_NAMES})\*?)\}}")
_ENVIRONMENT_NAME = re.compile(r"\s*\{([A-Za-z]+)\*?\}")
_COLUMNS = re.compile(r"\s*\{\s*[0-9]+\s*\}")
_IN_BRACES = re.compile(r"\\[A-Za-z]+|\{[^{}]*\}")
_WORD_OF_PROSE = re.compile(r"[A-Za-z]{4,}")
_DOLLAR = re.compile(r"(?<!\\)\$")


@dataclass(frozen=True, slots=True)
class Region:
    """Mathematics from `start` to `end`; with its delimiters from `first` to `last`."""

    first: int
    start: int
    end: int
    last: int
    display: bool
    environment: str = ""


class RegionFinder:
    """Finds delimited mathematics; `tex` takes every dollar as a delimiter."""

    def __init__(self, text: str, tex: bool) -> None:
        self.text, self.tex = text, tex
        self.regions: list[Region] = []
        self.failures: list[ReadingError] = []
        self._missing: set[str] = set()

    def run(self) -> None:
        """Fill `regions` and `failures`."""
        place = 0
        while match := _OPENER.search(self.text, place):
            place = self._region_from(match)

    def _region_from(self, match: re.Match[str]) -> int:
        """Add the region that an opener begins; return where to go on."""
        opener = match.group()
        if opener in ("\\\\", "\\$"):
            return match.end()
        if opener == "$":
            return self._region_from_dollar(match)
        environment = match.group(1) or ""
        closer = {"$$": "$$", "\\(": "\\)", "\\[": "\\]"}.get(opener) or f"\\end{{{environment}}}"
        end = -1 if closer in self._missing else self.text.find(closer, match.end())
        if end < 0:
            self._note_unclosed(match, closer)
            return match.end()
        whole = environment.rstrip("*") in ("cases", "array", "dcases")
        columns = _COLUMNS.match(self.text, match.end()) if "alignat" in environment else None
        start, stop = (columns.end() if columns else match.end()), end
        if whole:
            start, stop = match.start(), end + len(closer)
        display = opener != "\\("
        last = end + len(closer)
        self.regions.append(Region(match.start(), start, stop, last, display, environment.rstrip("*")))
        return last

    def _note_unclosed(self, match: re.Match[str], closer: str) -> None:
        if closer not in self._missing:
            what = f"{match.group()} without {closer}"
            self.failures.append(ReadingError(match.start(), what, "close the mathematics"))
        self._missing.add(closer)

    def _region_from_dollar(self, match: re.Match[str]) -> int:
        """A dollar opens where a dollar closes before the next empty line; elsewhere it is money."""
        start = match.end()
        closing = _DOLLAR.search(self.text, start) if "$" not in self._missing else None
        if closing is None:
            if self.tex:
                self._note_unclosed(match, "$")
            self._missing.add("$")
            return start
        inside = self.text[start : closing.start()]
        if "\n\n" in inside or (not self.tex and not _is_mathematics(inside, self.text, closing.end())):
            if self.tex:
                self._note_unclosed(match, "$")
            return start
        self.regions.append(Region(match.start(), start, closing.start(), closing.end(), False))
        return closing.end()


def _is_mathematics(inside: str, text: str, after: int) -> bool:
    """Tell dollars around mathematics from two sums of money."""
    if not inside.strip() or "\n" in inside.strip("\n"):
        return inside.count("\n") <= 3 and bool(inside.strip())
    if text[after : after + 1].isdecimal() or inside[0].isspace() != inside[-1].isspace():
        return False
    return len(_WORD_OF_PROSE.findall(_IN_BRACES.sub(" ", inside))) < 2


# A stretch of mathematics to single equations: rows, separators, tags, punctuation

_WORDS = "|".join(sorted(WORDS | {"intertext", "shortintertext"}, key=len, reverse=True))
_ROW = re.compile(
    r"\\(begin|end)\s*\{([A-Za-z]*)\*?\}|\\\\(?:\*?[ \t]*\[[^\]\n]{0,20}\])?|\\.|[{}&]", re.DOTALL
)
_PIECE = re.compile(
    rf"\\(?:{_WORDS})\s*(?=\{{)|\\q?quad(?![A-Za-z])|\\[A-Za-z]+|\\.|[{{}}()\[\],;、，∴∵⇒⇔⟹⟺→⟶]",
    re.DOTALL,
)
_ARROW_COMMANDS = words(
    "therefore Rightarrow implies Longrightarrow Leftrightarrow Longleftrightarrow iff leadsto rightarrow"
    " longrightarrow to hence Leftarrow because"
)
_ARROWS = (*(f"\\{name}" for name in _ARROW_COMMANDS), *"∴∵⇒⇔⟹⟺→⟶")
_SCAN = re.compile(rf"{RELATION.pattern}|\\[A-Za-z]+|\\.|[{{}}()\[\]]", re.DOTALL)
_TAG = re.compile(
    r"(?:\\tag\*?\s*\{([^{}]{1,20})\}|\\(?:l|r)?eqno\s*\(([^()]{1,12})\)"
    r"|(?P<lead>\\q?quad|\\hfill|\\hspace\*?\{[^{}]*\}|\\cdots|\\dots|\\ldots|…+|\.{3,}|[・･]{3,}|⋯|\s{2,}|\t)"
    r"\s*(?:\\q?quad\s*)*[-–—−]?\s*\((?P<tag>[0-9A-Za-z.\-']{1,8})\)"
    r"|\s\((?P<numbered>[0-9]{1,2}\.[0-9]{1,2}[-–][0-9]{1,3}[a-z]?)\))\s*$"
)
_GAP_IN_TEX = r"(?:\s|~|\\[,;:! ]|\\(?:text\w*|math(?:rm|bf))\s*\{)*"
_MARKS = re.compile(
    rf"(?:\\q?quad|\\hfill|\\hspace\*?\{{[^{{}}]*\}}){_GAP_IN_TEX}(?P<open>[\[(])\s*[0-9]{{1,2}}(?:\s*\+\s*[0-9]{{1,2}})*"
    rf"(?P<unit>{_GAP_IN_TEX}(?:marks?|M|pts?\.?|points?|P\.?|Pkte?\.?|Punkte?|punti|puntos|点))?\s*\}}?\s*[\])]\}}?\s*$"
)
"""What a formula of an examination is worth, behind it: \\qquad [3], \\hfill (2 marks)."""
_TRAILING = re.compile(
    rf"(?:\s|[.,;:。、&]|\\end\s*\{{(?!(?:{'|'.join(CELLS)})\*?\}})[A-Za-z]*\*?\}}"
    r"|\\[,;:! ]|\\q?quad|\\nonumber|\\notag"
    r"|\\label\s*\{[^{}]*\}|\\\\|\\hfill|[∴∵⇒⇔⟹⟺→⟶]|\\(?:" + "|".join(_ARROW_COMMANDS) + r"))\Z"
)
_LEADING = re.compile(
    r"(?:\s|[、。,;&]|\\[,;:! ]|\\q?quad(?![A-Za-z])|[∴∵⇒⇔⟹⟺→⟶]|\\(?:"
    + "|".join(_ARROW_COMMANDS)
    + r")(?![A-Za-z]))+"
)
_END_OF_ROWS = re.compile(rf"\\end\s*\{{(?!(?:{'|'.join(CELLS)})\*?\}})[A-Za-z]+\*?\}}\Z")
_BOXED = re.compile(r"\\(?:boxed|fbox|framebox)\s*\{")
_ALIGNED = word_set("align aligned alignat alignedat flalign")
_BRACKETS = {"{": 1, "(": 1, "[": 1, "}": -1, ")": -1, "]": -1}


@dataclass(frozen=True, slots=True)
class Passage:
    """One equation, or a part of one, from `start` to `end`; `row` counts the rows of its display."""

    start: int
    end: int
    tag: str = ""
    row: int = 0
    doubt: ReadingError | None = None
    aside: bool = False


def pieces_of(text: str, start: int, end: int, environment: str = "") -> list[Passage]:
    """Cut a stretch of mathematics into rows and these at separators."""
    pieces: list[Passage] = []
    for row, (first, end_of_row) in enumerate(_rows(text, start, end, environment)):
        last, tag = without_tag(text, first, end_of_row)
        last = _without_constant(text, first, last)
        parts = [part for span in _separate(text, first, last) for part in _with_conditions(text, *span)]
        spans = [_without_box(text, *trim(text, *span)) for span in parts]
        spans = [span for span in spans if span[0] < span[1]]
        doubts: dict[tuple[int, int], ReadingError] = {}
        if len(spans) > 1:
            doubts = _doubts(text, spans)
            spans = [span for span in spans if has_any_relation(text, *span)] or spans[:1]
        spans = [span for span in spans if not is_explained_by_text(text, *span)]
        for span in spans:
            if span not in doubts and (doubt := doubt_of_words_set(text, *span, last)):
                doubts[span] = doubt
        for place, span in enumerate(spans):
            last_tag = tag if place == len(spans) - 1 else ""
            aside = place > 0 and _explains(text[spans[0][1] : span[0]])
            pieces.append(Passage(*span, last_tag, row, doubts.get(span), aside))
    return pieces


def formulas_in_words(text: str, start: int, end: int) -> list[Passage]:
    """Return the formulas between dollars in the words of a display, \\intertext{as $a = b$}."""
    inner: list[Passage] = []
    for words_ in _WORDS_WITH_DOLLARS.finditer(text, start, end):
        for match in _DOLLARS.finditer(text, words_.start(1), words_.end(1)):
            if has_any_relation(text, *match.span(1)):
                inner += pieces_of(text, *match.span(1))
    return inner


_CONDITION = re.compile(
    r"(?:\\q?quad|\\[,;: ]|~|\s)+[\[(](?P<inside>[^()\[\]]{1,80})[)\]]"
    r"[\s.,;]*(?:\\q?quad|\\[,;: ]|[\s.,;~])*$"
)


_SET_WORDS = re.compile(r"\\(?:text[a-z]{0,6}|mbox)\s*\{[^{}]*(?:[^\W\d_]{5}|[^\W\d_]{2}\s+[^\W\d_]{3})")
"""Words, and no unit: (\\text{no multiple of } N)."""


def _with_conditions(text: str, start: int, end: int) -> list[tuple[int, int]]:
    """Return an equation and what the brackets behind it hold, λ = r/l (r = 40 mm, l = 150 mm), apart."""
    first, *inside = _with_condition(text, start, end)
    return [first, *(part for span in inside for part in _separate(text, *span))]


def _with_condition(text: str, start: int, end: int) -> list[tuple[int, int]]:
    """Return an equation and the condition in brackets behind it, = 0 (N ≥ 2), as two.

    Words in the brackets are left out.
    """
    match = _CONDITION.search(text, start, end)
    if match is None:
        return [(start, end)]
    if not has_relation(text, *match.span("inside")):
        return [(start, match.start() if _SET_WORDS.search(match["inside"]) else end)]
    if relation_at_start(match["inside"].lstrip()) or not has_relation(text, start, match.start()):
        return [(start, end)]
    return [(start, match.start()), match.span("inside")]


def _without_constant(text: str, start: int, end: int) -> int:
    """Return where a row ends before `= const.`, which says that it does not change."""
    match = _CONSTANT.search(text, start, end)
    return match.start() if match else end


_CONSTANT = re.compile(
    r"\s*(?:=|\\approx)\s*(?:\\(?:text|mathrm|mbox|textrm|textit|operatorname)\s*\{\s*)?[ckCK]onst"
    r"(?:ant|\.)?(?:\s*\.?\s*\})?[\s.,;]*$"
)


_CONSTANT_BEHIND = re.compile(r"\s*\(?[ckCK]onst(?:ant|ante|\.)?(?![A-Za-z])")


def _explains(between: str) -> bool:
    """Tell whether words between two equations of a row say that the second explains the first."""
    prose = " ".join(re.sub(r"\\[A-Za-z]+\s*|[{}&~,;]", " ", between).split()).lower()
    return prose.startswith("(") or any(
        prose.startswith(f"{word} ") or prose == word for word in _EXPLAINING
    )


_EXPLAINING = words(
    "since because as by using with where if note recall cf see from via for here da weil wegen mit wobei"
    " für denn nach aus wo siehe hier ただし なぜなら here, car avec où"
)
_WORDS_WITH_DOLLARS = re.compile(
    r"\\(?:short)?(?:intertext|text|mbox|textrm|textnormal|textit)\s*"
    r"\{((?:[^{}$]|\$[^$]{1,400}\$|\{[^{}]{0,80}\}){1,1000})\}"
)
_DOLLARS = re.compile(r"\$([^$]{1,400})\$")


def _doubts(text: str, spans: list[tuple[int, int]]) -> dict[tuple[int, int], ReadingError]:
    """Return the equations of a display behind which words, and then more of the formula, stand."""
    result: dict[tuple[int, int], ReadingError] = {}
    for before, after in pairwise(spans):
        if not has_any_relation(text, *before) or has_any_relation(text, *after):
            continue
        between = text[before[1] : after[0]]
        prose = re.sub(r"\\[A-Za-z]+\s*\{|[{}]", " ", between)
        if OPERATION.match(text, *after) or JOINING.search(prose):
            result[before] = cut_error(after[0], text[before[1] : after[1]])
    return result


def _without_box(text: str, start: int, end: int) -> tuple[int, int]:
    """Return what stands in a frame, \\boxed{...}, where that is the whole span."""
    match = _BOXED.match(text, start, end)
    if not match or text[end - 1] != "}" or _after_words(text, match.end() - 1, end) != end:
        return start, end
    return _without_box(text, *trim(text, match.end(), end - 1))


def _rows(text: str, start: int, end: int, environment: str) -> list[tuple[int, int]]:
    """Return the rows of a display, cut at \\\\ outside inner environments; an aligned row by columns."""
    rows: list[tuple[int, int]] = []
    cells, first, depth = [start], start, 0
    is_aligned = environment in _ALIGNED
    for match in [*_ROW.finditer(text, start, end), None]:
        sign = match.group() if match else "\\\\"
        if sign.startswith("\\\\") and (depth <= 0 or not match):
            stop = match.start() if match else end
            rows.extend(_cells(cells, stop) if is_aligned else [(first, stop)])
            first = match.end() if match else end
            cells, depth = [first], 0
        elif sign == "&" and depth <= 0 and match:
            cells.append(match.end())
        elif match and match.group(1):
            is_transparent = match.group(2) in ENVIRONMENTS
            is_aligned = is_aligned or match.group(2) in _ALIGNED
            depth += 0 if is_transparent else (1 if match.group(1) == "begin" else -1)
        else:
            depth += {"{": 1, "}": -1}.get(sign, 0)
    return rows


def _cells(cells: list[int], stop: int) -> list[tuple[int, int]]:
    """Join the columns of an aligned row in pairs: left and right of an alignment point."""
    starts = cells[::2] if len(cells) > 2 else cells[:1]
    return list(zip(starts, [*starts[1:], stop], strict=True))


def _separate(text: str, start: int, end: int) -> list[tuple[int, int]]:
    """Cut at prose, and at commas and wide spaces where an equation of its own follows."""
    cuts: list[tuple[int, int, bool]] = []
    depth, place = 0, start
    while match := _PIECE.search(text, place, end):
        sign, place = match.group(), match.end()
        depth = max(depth + _BRACKETS.get(sign, 0) + _level_of_cells(text, sign, place), 0)
        if depth:
            continue
        if sign[0] == "\\" and text[start : match.start()].rstrip()[-1:] in ("_", "^"):
            place = max(place, match.end())  # the words of a script, m_\text{rec}
        elif unit := _unit_at(text, start, match.start(), end):
            place = unit
        elif sign.rstrip().lstrip("\\") in WORDS | {"intertext", "shortintertext"}:
            place = _after_words(text, place, end)
            cuts.append((match.start(), place, True))
        elif sign == "," and (speed := _speed_behind(text, start, place, end)):
            cuts.append((match.start(), speed, True))
            place = speed
        elif sign in (",", ";", "、", "，", "\\quad", "\\qquad") or sign in _ARROWS:
            last = cuts[-1] if cuts else (start, start, True)
            introduces = sign in _ARROWS and last[2] and not text[last[1] : match.start()].strip(" \t\n&")
            cuts.append((match.start(), match.end(), introduces))
    return _join_spans(text, start, end, cuts)


def _speed_behind(text: str, start: int, place: int, end: int) -> int:
    """Return where a speed without a letter ends behind an equation's comma, m = 3 kg, 900 rpm; or 0."""
    match = _SPEED_BEHIND.match(text, place, end)
    scale = scale_of(match["unit"].strip()) if match else None
    if match is None or scale is None or not scale[1] or not has_relation(text, start, place - 1):
        return 0
    return match.end()


_SPEED_BEHIND = re.compile(
    r"(?:[ ~]|\\[,;: ])+[0-9][0-9.,]*(?:[ ~]|\\[,;: ])*"
    r"(?P<unit>[A-Za-z1/.]{3,6}(?:\^\{?-1\}?|⁻¹)?)(?=[.\s]*(?:[,;]|\Z|$))"
)


def _level_of_cells(text: str, sign: str, place: int) -> int:
    """Return 1 where a matrix or cases begin, -1 where they end: what parts cells cuts no equation."""
    if sign not in ("\\begin", "\\end"):
        return 0
    match = _ENVIRONMENT_NAME.match(text, place)
    if match is None or match.group(1) not in CELLS:
        return 0
    return 1 if sign == "\\begin" else -1


def _unit_at(text: str, start: int, place: int, end: int) -> int:
    """Return where a unit such as \\text{mm} behind a number ends, 0 where it is none."""
    if text[place] != "\\" or not follows_number(text, start, place):
        return 0
    unit = unit_set_at(text, place, end)
    return unit[1] if unit and scale_of(unit[0]) else 0


def _after_words(text: str, place: int, end: int) -> int:
    depth = 0
    for at in range(place, end):
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0:
            return at + 1
    return end


def _join_spans(
    text: str, start: int, end: int, cuts: list[tuple[int, int, bool]]
) -> list[tuple[int, int]]:
    """Cut where what follows is an equation of its own; a label before a wide space is dropped."""
    spans: list[tuple[int, int]] = []
    first, before, cut = start, start, start
    for at, after, prose in [*cuts, (end, end, True)]:
        behind_arrow = text[cut:before].strip() in _ARROWS
        if before > first and _stands_alone(text, before, at, behind_arrow=behind_arrow):
            if has_relation(text, first, cut):
                spans.append((first, cut))
                first = before
            elif text[cut] == "\\" or is_quantity(text[first:cut]) or _ends_order_named(text, first, cut):
                first = before
        if prose:
            spans.append((first, at))
            first = after
        before, cut = after, at
    return spans


_ORDER_NAMED = re.compile(
    r"(?:(?:orders?|powers?|terms|Ordnung|Potenz|Glieder|ordre|orden|ordine)\s(?:in|of|en|von)|up\sto|through"
    r"|neglecting|ignoring|dropping|omitting|bis(?:\szu)?|Vernachlässigung\svon|jusqu['’]à|négligeant)\s\Z",
    re.IGNORECASE,
)
_LETTER_OR_POWER = re.compile(r"\s*[A-Za-zα-ωϑϕ](?:\s?\^\s?\{?[1-9]\}?|[²³⁴⁵⁶])?\s*")


def _ends_order_named(text: str, start: int, end: int) -> bool:
    """Tell whether words that name an order end in a letter or power: to second order in x, cos x ≈ 1."""
    is_lone = _LETTER_OR_POWER.fullmatch(text, start, end) is not None
    return is_lone and _ORDER_NAMED.search(text[max(start - 40, 0) : start]) is not None


def _before_words(text: str, start: int, end: int, words: Vocabulary) -> int:
    """Return where an equation ends whose last sign leads to words: λ = r/l = rod ratio."""
    own = text[start:end].rstrip()
    before = start + len(own[:-1].rstrip())
    if not own.endswith("=") or not has_relation(text, start, before):
        return end
    phrase = _WORDS_BEHIND.match(text, end)
    return before if phrase and _is_long_meaning(phrase["words"], words.names) else end


def _is_long_meaning(phrase: str, names: Collection[str]) -> bool:
    """Tell whether words are a meaning by more than short ones, which may be a product: = mrw."""
    is_long = _LONG_WORD.search(phrase) is not None or not phrase.isascii()
    return is_long and is_meaning(phrase.strip(), names)


_WORDS_BEHIND = re.compile(r"\s*(?P<words>[^\W\d_][\w'’ -]{2,80})(?=[.,;:()]|\n|\Z)")


def _sign_behind_arrow(text: str, start: int, trimmed: int) -> int:
    """Return where an equation begins whose first sign was taken for a dash: ⇒ - b = c."""
    before = text[max(start - MARGIN, 0) : start].rstrip(" \t&$")
    sign = text[start:trimmed].strip()
    is_sign = len(sign) == 1 and sign in "-−" and (before.endswith(_ARROWS) or before.endswith("=>"))
    return text.index(sign, start) if is_sign else trimmed


def _stands_alone(text: str, start: int, end: int, *, behind_arrow: bool) -> bool:
    """Tell whether an equation of its own begins at a cut: with a sign only behind an arrow, ⇒ -y = 3."""
    begin = text[start:end].lstrip(" \t\n&")
    if (
        not begin
        or (begin[0] in "+-−" and not behind_arrow)
        or begin[0] in "=<>"
        or RELATION.match(begin)
    ):
        return False
    return has_relation(text, start, end)


def has_any_relation(text: str, start: int, end: int) -> bool:
    """Tell whether a relation stands anywhere."""
    return RELATION.search(text, start, end) is not None


def has_relation(text: str, start: int, end: int) -> bool:
    """Tell whether a relation stands outside all brackets."""
    depth = 0
    for match in _SCAN.finditer(text, start, end):
        sign = match.group()
        if sign in _BRACKETS:
            depth += _BRACKETS[sign]
        elif depth <= 0 and RELATION.match(text, match.start()):
            return True
    return False


def without_tag(text: str, start: int, end: int) -> tuple[int, str]:
    """Return where an equation ends before its number, and the number.

    >>> without_tag(r"a = b \\quad - (1)", 0, 17), without_tag(r"a = b \\quad [3]", 0, 15)
    ((6, '1'), (6, ''))
    """
    while start < end:
        if text[end - 1] in " \t\n,.;" and text[max(start, end - 3) : end] != "...":
            end -= 1
        elif match := _END_OF_ROWS.search(text[max(start, end - 40) : end]):
            end -= len(match.group())  # a number may stand before \\end{aligned}
        else:
            break
    offset = max(start, end - 120)
    marks = _MARKS.search(text[offset:end])
    if marks and (marks["open"] == "[" or marks["unit"]):
        end, offset = offset + marks.start(), max(start, offset + marks.start() - 120)
    match = _TAG.search(text[offset:end])
    if not match:
        return end, ""
    stop = offset + match.start()
    tag = match.group(1) or match.group(2) or match.group("tag") or match.group("numbered")
    lead = match.group("lead") or ""
    if lead.strip() and not lead.startswith(("\\q", "\\h")):
        before = text[start:stop].rstrip()
        if before[-1:] in "+-−·*/=" or not before:
            stop += len(lead)
    elif (
        lead
        and len(lead) < 4
        and not lead.strip()
        and not tag.rstrip("abc'").replace(".", "").replace("-", "").isdecimal()
    ):
        return end, ""
    return stop, tag


def trim(text: str, start: int, end: int) -> tuple[int, int]:
    """Return a span without the space and punctuation at its edges."""
    if lead := _LEADING.match(text, start, end):
        start = lead.end()
    while start < end:
        if text[max(start, end - 3) : end] == "..." or text[end - 1] == "…":
            break
        match = _TRAILING.search(text[max(start, end - 80) : end])
        if not match:
            break
        end -= len(match.group())
    return start, end
