"""Reading of documents, equations and expressions, from their text to chains of formulas.

A chain a = b = c may go over several lines and past a little prose. A letter that stands alone on the
left of a chain declares itself, and is a letter from there on. What cannot be read is reported with its
place and a remedy.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice
from pathlib import PurePath
from typing import NamedTuple

from symbalance.document.formula import Formula, children, with_children
from symbalance.document.letters import ACCENTS, TIME_DOTS, is_greek, plain_letter
from symbalance.notes.reading.accounting import Account
from symbalance.notes.reading.equations import (
    Chain,
    Explained,
    Passed,
    ReadNotes,
    Relation,
    Side,
    Unreadable,
)
from symbalance.notes.reading.failures import ReadingError, UndeclaredError
from symbalance.notes.reading.formulas.brace_labels import (
    COUNT_OR_VALUE,
    numbers_its_braces,
    with_equality_at_brace,
)
from symbalance.notes.reading.formulas.differentials import with_differentials
from symbalance.notes.reading.formulas.free_letters import is_plain, with_real_letters
from symbalance.notes.reading.formulas.lexer import (
    AT,
    CLOSER,
    LONGEST_ANNOTATED,
    LONGEST_EQUATION,
    Token,
    lex,
)
from symbalance.notes.reading.formulas.parser import is_extreme, other_form, read_tokens
from symbalance.notes.reading.formulas.result_units import (
    as_printed,
    in_unit_of_result,
    value_of,
    with_rounded_results,
)
from symbalance.notes.reading.formulas.second_values import with_second_values
from symbalance.notes.reading.formulas.unit_places import (
    with_unit_of_range,
    with_unit_of_whole,
    with_units_of_divisors,
)
from symbalance.notes.reading.left_aside import signs_left_aside
from symbalance.notes.reading.letters.letter_names import matching_brace
from symbalance.notes.reading.markup.type_settings import with_styles_blank
from symbalance.notes.reading.passages.continued_lines import goes_on_below, goes_on_from
from symbalance.notes.reading.passages.segmentation import Item, ItemFinder, has_relation
from symbalance.notes.reading.rewriting import Piece, Rewritten, rewritten
from symbalance.notes.reading.signs import CELLS, relation_at_start
from symbalance.notes.reading.sources import Source, prepare, to_half_width
from symbalance.notes.reading.spellings.wrapped_lines import ENDS
from symbalance.notes.reading.units import explained_letters
from symbalance.text import lazy_patterns as re

LONGEST_DOCUMENT = 1_000_000  # characters
MOST_LINES_OF_PROSE = 2  # that a chain may go past: "= …" further down is an equation of its own
EQUALITIES = ("=", "≈", "≡")
LONGEST_RANGE = 8
"""Sides, with room to spare: 1 ≤ n ≤ 4 has three."""


class Motions(NamedTuple):
    """Letters that move, and what they move with: x(-θ) is x at another angle, and no product."""

    letters: frozenset[str] = frozenset()
    arguments: frozenset[str] = frozenset()


NO_MOTIONS = Motions()


def read_document(
    text: str,
    name: str,
    names_at: Callable[[int], Collection[str]],
    motions_at: Callable[[int], Motions] = lambda _: NO_MOTIONS,
    *,
    imaginary_j: bool = False,
) -> ReadNotes:
    """Return the equations of a text; `names_at` tells the letters declared at each line.

    `motions_at` tells which of them are functions of an angle or of time, `imaginary_j` whether j is
    declared the imaginary unit.

    >>> document = read_document("where F = m a holds", "", lambda line: {"m", "a"})
    >>> document.source(document.chains[0].sides[1].span)
    'm a'
    """
    if len(text) > LONGEST_DOCUMENT:
        what = f"a document of more than {LONGEST_DOCUMENT} characters"
        return ReadNotes(name, text, (), (Unreadable(1, 1, what, "split it", (0, 0)),))
    text = with_styles_blank(text)
    cache: dict[int, frozenset[str]] = {}

    def names(line: int) -> frozenset[str]:
        if line not in cache:
            cache[line] = frozenset(names_at(line))
        return cache[line]

    def is_letter(letter: str, line: int) -> bool:
        return letter in names(line)

    source = prepare(text, PurePath(name).suffix.lower(), is_letter, imaginary_j=imaginary_j)
    assembler = Assembler(ItemFinder(source, names), names, motions_at)
    assembler.free_letters |= {name: 1 for name in source.own_letters if name not in names(1)}
    assembler.run()
    chains, unreadable, passed = assembler.chains, assembler.unreadable, assembler.not_mathematics
    explained = assembler.explained
    if source.origin is not None:
        chains = [_chain_in_place(chain, source.origin) for chain in chains]
        passed = [_passed_in_place(part, source.origin, text) for part in passed]
        explained = [_explained_in_place(part, source.origin, text) for part in explained]
    if source.origin is not None or source.refusals:
        unreadable = [_unreadable_in_place(part, source, text) for part in unreadable]
    chains.sort(key=lambda chain: chain.sides[0].span)
    unreadable.sort(key=lambda part: (part.line, part.column))
    read = {line for chain in chains for line in chain.lines}
    passed += signs_left_aside(text, read | {part.line for part in (*unreadable, *passed, *explained)})
    free = tuple(sorted(set(assembler.free_letters) - assembler.defined_letters))
    notes = source.notes
    if free:
        letters = ", ".join(map(plain_letter, free))
        notes = (*notes, f"not declared: {letters}")
    return ReadNotes(
        name,
        text,
        tuple(chains),
        tuple(unreadable),
        notes,
        tuple(passed),
        free,
        source.own_letters,
        tuple(explained),
    )


def _chain_in_place(chain: Chain, origin: Rewritten) -> Chain:
    """Return a chain with every span that of the document."""
    sides = tuple(
        Side(tuple(_in_place(node, origin) for node in side.readings), origin.span(side.span))
        for side in chain.sides
    )
    return replace(chain, sides=sides)


def _in_place(node: Formula, origin: Rewritten) -> Formula:
    parts = children(node)
    moved = with_children(node, tuple(_in_place(part, origin) for part in parts)) if parts else node
    return replace(moved, span=origin.span(node.span))


def _passed_in_place(part: Passed, origin: Rewritten, text: str) -> Passed:
    span = origin.span(part.span)
    return Passed(part.line, max(span[0] - text.rfind("\n", 0, span[0]), 1), part.why, span)


def _explained_in_place(part: Explained, origin: Rewritten, text: str) -> Explained:
    span = origin.span(part.span)
    column = max(span[0] - text.rfind("\n", 0, span[0]), 1)
    return replace(part, column=column, span=span)


def _unreadable_in_place(part: Unreadable, source: Source, text: str) -> Unreadable:
    """Return a refusal at its place in the document, with the reason of a macro that was not replaced."""
    origin = source.origin or rewritten((Piece(text, 0, len(text), True),))
    ends = islice(re.finditer(f"[{ENDS}]", source.text), part.line - 1)
    begin = max((match.end() for match in ends), default=0)
    offset = origin.offset(begin + part.column - 1)
    what, remedy = dict(source.refusals).get(offset, (part.what, part.remedy))
    line = text.count("\n", 0, offset) + 1
    column = offset - (text.rfind("\n", 0, offset) + 1) + 1
    return Unreadable(line, column, what, remedy, origin.span(part.span))


def read_expression(text: str, names: Collection[str], offset: int = 0) -> tuple[Formula, ...]:
    """Return every reading of one expression, the usual one first; spans count from `offset`.

    >>> len(read_expression("1/2λ", {"lambda"})), len(read_expression("1/λ", {"lambda"}))
    (2, 1)
    """
    chain = read_equation(text, names, offset)
    if chain.relations:
        raise ReadingError(offset, "an equation where an expression belongs", "write one side only")
    return chain.sides[0].readings


def read_equation(text: str, names: Collection[str], offset: int = 0) -> Chain:
    """Return one chain a = b = c; a lone undeclared letter on the left declares itself."""
    item = Item(0, len(text), "display", True, 1, 1 + text.count("\n"))
    draft = Draft(item, set(names))
    source = to_half_width(text)
    try:
        draft.add(item, without_aside(lex(source, 0, len(text), names, "tex" if "\\" in source else "")))
        draft.finish_alone()
        return _chain(draft, source, names, offset)
    except ReadingError as failure:
        failure.offset += offset
        raise


def _chain(draft: Draft, source: str, names: Collection[str], offset: int) -> Chain:
    letters = frozenset(names) | draft.own_letter()
    sides: list[Side] = []
    for tokens in draft.sides:
        in_place = [token.moved(offset) for token in tokens]
        readings, notes = _read_side(in_place, letters, offset, "\\" in source)
        draft.notes.extend(note for note in notes if note not in draft.notes)
        sides.append(Side(readings, (in_place[0].start, in_place[-1].end)))
    relations = tuple(Relation(t.value, source.count("\n", 0, t.start) + 1) for t in draft.signs)
    lines = tuple(range(1, draft.item.last_line + 1))
    return Chain(tuple(sides), relations, lines, notes=tuple(draft.notes))


def _read_side(
    tokens: list[Token], letters: frozenset[str], offset: int, latex: bool
) -> tuple[tuple[Formula, ...], tuple[str, ...]]:
    try:
        return read_tokens(tokens, letters, tokens[-1].end, latex)
    except ReadingError as failure:
        failure.offset -= offset
        raise


class Assembler:
    """Reads the items of a document in order; letters defined on the way are letters from there on."""

    def __init__(
        self,
        finder: ItemFinder,
        names_at: Callable[[int], Collection[str]],
        motions_at: Callable[[int], Motions],
    ) -> None:
        self.finder, self.names_at, self.motions_at = finder, names_at, motions_at
        self.text = finder.text
        self.defined_letters: set[str] = set()
        self.chains: list[Chain] = []
        self.unreadable: list[Unreadable] = []
        self.not_mathematics: list[Passed] = []
        self.explained: list[Explained] = []
        self.account = Account(self.text, finder.source.codes)
        self.draft: Draft | None = None
        self._refused_item: Item | None = None
        self.phrases: dict[str, int] = {}
        self.functions: dict[str, str] = {}  # defined as R(α) = …, and of what
        self.free_letters: dict[str, int] = {}  # not declared, and the line where each is first

    def run(self) -> None:
        """Fill `chains` and `unreadable`."""
        for item in self.finder.run():
            self._add_item(item)
        self._finish_chain()
        for failure in self.finder.failures:
            self._report(failure, (failure.offset, failure.offset + 1))
        names = frozenset(self.names_at(1)) | self.defined_letters
        more, self.not_mathematics, self.explained = self.account.settle(
            self.unreadable, names, self._place_of
        )
        self.unreadable += more

    def _place_of(self, offset: int) -> tuple[int, int]:
        offset = min(max(offset, 0), len(self.text))
        line = self.finder.line_of(offset)
        return line, offset - self.finder.line_start(line) + 1

    def _add_item(self, item: Item) -> None:
        """Add an item to the chain so far, or begin a chain with it; what explains stands alone."""
        if item.aside and self.draft is not None:
            outer, self.draft = self.draft, None
            self._add_item(item)
            self._finish_chain()
            self.draft = outer
            return
        known = frozenset(self.names_at(item.first_line)) | self.defined_letters
        names = known | (self.draft.own_letter() if self.draft else frozenset())
        try:
            tokens = without_aside(lex(self.text, item.start, item.end, names, self._setting(item)))
            if item.head:
                tokens = [*self._head_tokens(item.head, names), *tokens]
        except ReadingError as failure:
            self._give_up_item(item, failure)
            return
        if not tokens:
            return
        if not self._continues(item, tokens):
            if not self._is_formula(tokens, item, names):
                return
            self._finish_chain()
            tokens = tokens[1:] if self._follows_refused(item, tokens) else tokens
            known = frozenset(self.names_at(item.first_line)) | self.defined_letters
            self.draft = self._new_draft(item, known) if tokens else None
        if self.draft:
            self.draft.names |= known
            self.draft.add(item, tokens)
            for part, equation in self._annotations(item, names):
                outer, self.draft = self.draft, self._new_draft(part, names)
                self.draft.add(part, equation)
                self._finish_chain()
                self.draft = outer

    def _new_draft(self, item: Item, names: Collection[str]) -> Draft:
        draft = Draft(item, set(names), self.motions_at(item.first_line))
        draft.functions, draft.page_letters = self.functions, self.free_letters
        return draft

    def _annotations(self, item: Item, names: frozenset[str]) -> list[tuple[Item, list[Token]]]:
        """Return the relations below braces: `\\underbrace{1 + 1}_{= 2}` claims that 1 + 1 = 2."""
        result: list[tuple[Item, list[Token]]] = []
        for match in _BRACE.finditer(self.text, item.start, item.end):
            try:
                after = matching_brace(self.text, match.end() - 1, item.end, LONGEST_ANNOTATED)
                mark = _NOTE[match[1]].match(self.text, after, item.end)
                if mark is None:
                    continue
                end = matching_brace(self.text, mark.end() - 1, item.end, LONGEST_ANNOTATED) - 1
                part = replace(
                    item, start=match.end(), end=end, aside=True, doubt=None, head=None, tag=""
                )
                note = lex(self.text, mark.end(), end, names, self._setting(item))
                if not note:
                    continue
                body = lex(self.text, match.end(), after - 1, names, self._setting(item))
                is_numbered = numbers_its_braces(self.text[item.start : item.end])
                note = with_equality_at_brace(body, note, is_numbered=is_numbered)
                if note[0].kind != "rel" or len(note) < 2:
                    continue
            except ReadingError as failure:
                is_number = failure.what == COUNT_OR_VALUE
                if is_number or relation_at_start(
                    self.text[failure.offset : failure.offset + 20].lstrip("_^{ ")
                ):
                    self._report(failure, (match.start(), item.end))
                continue
            result.append((part, [*body, *note]))
        return result

    def _setting(self, item: Item) -> str:
        """Return "code" for an item in program code, "tex" for one in a display or between dollars."""
        if any(a <= item.start < b for a, b in self.finder.source.codes):
            return "code"
        return "tex" if item.kind in ("display", "inline") else ""

    def _head_tokens(self, head: tuple[int, int], names: frozenset[str]) -> list[Token]:
        """Return the letter that stands left of an item: a letter, or words that stand for one.

        The same words once more are another letter: "force = 3" on two lines is no contradiction.
        """
        written = self.text[slice(*head)]
        if (
            "/" not in written
            and len(written.split()) == 1
            and (len(written) < 2 or not written[1:].isalpha() or written in names)
        ):
            return lex(self.text, *head, names)
        name = name_of_words(written)
        self.phrases[name] = self.phrases.get(name, 0) + 1
        is_own = len(written.split()) > 1 or "/" in written
        if is_own and self.phrases[name] > 1:
            name = f"{name}_{self.phrases[name]}"
        return [Token("name", name, *head)]

    def _follows_refused(self, item: Item, tokens: list[Token]) -> bool:
        """Tell whether `= c` continues an equation that could not be read; c then starts a chain."""
        before, self._refused_item = self._refused_item, None
        follows = tokens[0].kind == "rel" and before is not None and self._is_near(before, item)
        if follows:
            sign = tokens[0]
            failure = ReadingError(sign.start, "the side before it is not read", "mend that side first")
            self.account.refused.append(((sign.start, sign.end), failure))
        return follows

    def _give_up_item(self, item: Item, failure: ReadingError) -> None:
        source = self.text[item.start : item.end].lstrip(" \n\t&")
        if self._continues_unreadable(item, source, failure):
            return
        lone = item.kind == "inline" and not any(sign in source for sign in "=<>≈≤≥")
        if not item.strict or lone:
            self.account.refused.append(((item.start, item.end), failure))
            return
        before, self._refused_item = self._refused_item, item
        goes_on = source[:1] == "=" or self._is_term(source)
        if not (before and before.block == item.block >= 0 and goes_on):
            self._finish_chain()
            self._report(failure, (item.start, item.end))

    def _continues_unreadable(self, item: Item, source: str, failure: ReadingError) -> bool:
        """Give up a side of the chain above where the line that cannot be read belongs to it."""
        if self.draft is None or item.kind not in ("display", "bare"):
            return False
        relation = relation_at_start(source)
        if relation and self._is_near(self.draft.last, item):
            self.draft.add(item, [Token("rel", relation, item.start, item.start + 1)])
        elif self._is_term(source) and self._is_next(item):
            self.draft.items.append(item)
        else:
            return False
        self.draft.fail(failure)
        return True

    def _is_term(self, source: str) -> bool:
        """Tell whether a line that cannot be read is `+ a` or `- a`, without a relation of its own."""
        return source[:1] in ("+", "-", "−") and not has_relation(source, 0, len(source))

    def _is_formula(self, tokens: list[Token], item: Item, names: frozenset[str]) -> bool:
        """Tell whether an item says something: in prose or without LaTeX, not every one does."""
        if any(token.kind == "rel" for token in tokens) or item.kind == "display":
            return True
        if goes_on_below(self.text, item.end):
            return True
        if item.kind in ("inline", "prose"):
            return False
        if "\\" in self.text[item.start : item.end]:
            return len(tokens) > 1
        has_letter = any(token.kind == "name" and token.value in names for token in tokens)
        return has_letter and any(t.kind in ("function", "sup") or t.is_op("+*/") for t in tokens)

    def _continues(self, item: Item, tokens: list[Token]) -> bool:
        """Tell whether an item goes on with the chain: by its first sign, or as a side is unfinished."""
        draft = self.draft
        if draft is None:
            return False
        first = tokens[0]
        if first.kind == "rel":
            return self._goes_on_with_relation(draft, item)
        is_in_line = not {"inline", "prose"}.isdisjoint((item.kind, draft.last.kind))
        if is_in_line or not self._is_next(item):
            return False
        if first.is_op("+-") or (first.is_op("*/") and item.block == draft.last.block >= 0):
            return self._goes_on_with_operator(draft, item, tokens)
        if not draft.is_unfinished or item.block != draft.last.block:
            return False
        return not (draft.open_brackets and is_equation(tokens))

    def _goes_on_with_relation(self, draft: Draft, item: Item) -> bool:
        """Tell whether `= c` goes on with the chain: on a line of its own, or right behind it."""
        if item.kind in ("inline", "prose"):
            return item.head is None and goes_on_from(self.text, draft.last.end, item.start)
        return self._is_near(draft.last, item)

    def _goes_on_with_operator(self, draft: Draft, item: Item, tokens: list[Token]) -> bool:
        """Tell whether a row that begins with an operator goes on with the row above."""
        if item.block == draft.last.block >= 0 and (tokens[0].is_op("*/") or not draft.is_whole):
            return True
        is_other_block = -1 not in (item.block, draft.last.block) and item.block != draft.last.block
        return not is_other_block and not has_own_relation(tokens)

    def _is_next(self, item: Item) -> bool:
        """Tell whether an item stands on the line or row right below the chain so far."""
        last = self.draft.last if self.draft else None
        if last is None:
            return False
        if item.block >= 0 and item.block == last.block:
            return True
        return 0 < item.first_line - last.last_line <= 1

    def _is_near(self, last: Item, item: Item) -> bool:
        """Tell whether no heading and at most two lines of prose stand between."""
        prose = 0
        between = range(last.last_line + 1, item.first_line)
        if len(between) > 40:
            return False
        for line in between:
            if self._line_text(line).strip().strip("$[]\\"):
                prose += 1
                if prose > MOST_LINES_OF_PROSE or self._is_heading(line):
                    return False
        return True

    def _line_text(self, line: int) -> str:
        start, end = self.finder.line_span(line)
        return self.text[start:end]

    def _is_heading(self, line: int) -> bool:
        words = self._line_text(line).strip()
        if words.startswith(("#", "\\section", "\\subsection", "\\chapter", "\\paragraph")):
            return True
        alone = not self._line_text(line - 1).strip() and not self._line_text(line + 1).strip()
        return alone and len(words) <= 40 and words[-1:] not in "。.、,:：;"

    def _finish_chain(self) -> None:
        draft, self.draft = self.draft, None
        if draft is None:
            return
        draft.finish()
        own_letter = draft.own_letter()
        names = frozenset(draft.names) | own_letter | draft.own_index()
        sides = self._read_sides(draft, names)
        self._store_chain(draft, sides, names)
        if sum(side is not None for side in sides) > 1 and sides[0] is not None:
            self.defined_letters |= own_letter
            if draft.own_argument:
                is_matrix = any(token.value in CELLS.values() for token in draft.sides[1])
                letter = lone_letter(draft.sides[0])
                is_declared = letter in draft.names and letter not in draft.motions.letters
                functions = own_letter or ({letter} if is_matrix or is_declared else ())
                self.functions |= dict.fromkeys(functions, draft.own_argument)

    def _read_sides(self, draft: Draft, names: frozenset[str]) -> list[Side | None]:
        """Return the sides of a chain, None for one that cannot be read."""
        sides: list[Side | None] = []
        latex = any("\\" in self.text[item.start : item.end] for item in draft.items)
        letters = [t.value for side in draft.sides for t in side if t.kind == "name"]
        has_letter = any(letter in names for letter in letters) or (
            all(draft.sides) and bool(letters) and all(map(is_plain, letters))  # m_A a = m_B b
        )
        has_function = any(t.kind in ("function", "cmd", "sup") for side in draft.sides for t in side)
        is_formula = any(item.strict for item in draft.items) or (
            (has_letter or has_function) and bool(draft.signs)
        )
        free: set[str] | None = set(self.free_letters) if is_formula else None
        explained = self._explained_letters(draft, names) if is_formula else frozenset[str]()
        if free is not None:
            free |= explained
        typed_sides = with_unit_of_range(draft.sides, [sign.value for sign in draft.signs])
        for place, typed in enumerate(typed_sides):
            sides.append(None)
            tokens = with_units_of_divisors(typed)
            if place in draft.failures:
                continue
            try:
                _refuse_too_long(tokens)
                readings, notes = read_tokens(tokens, names | explained, tokens[-1].end, latex, free)
            except ReadingError as failure:
                draft.failures[place] = failure
                continue
            draft.notes.extend(note for note in notes if note not in draft.notes)
            span = draft.sides[place][0].start, draft.sides[place][-1].end
            sides[-1] = as_printed(Side(readings, span), tokens)
        sides, notes = in_unit_of_result(sides, draft.sides, self.text)
        sides = with_unit_of_whole(
            sides,
            draft.sides,
            self.text,
            lambda tokens: read_tokens(list(tokens), names, tokens[-1].end, latex, free)[0],
            value_of,
        )
        sides = with_rounded_results(sides, draft.sides, [sign.value for sign in draft.signs])
        sides = with_real_letters(sides, [sign.value for sign in draft.signs])
        draft.notes.extend(note for note in notes if note not in draft.notes)
        for letter in free or ():
            self.free_letters.setdefault(letter, draft.item.first_line)
        return sides

    def _explained_letters(self, draft: Draft, names: frozenset[str]) -> frozenset[str]:
        """Return the letters of a chain that words explain, though they are units too: N revolutions."""
        used = {token.value for tokens in draft.sides for token in tokens if token.kind == "name"}
        return (explained_letters(self.text) & used) - names

    def _store_chain(self, draft: Draft, sides: list[Side | None], names: frozenset[str]) -> None:
        """Store what was read of a chain; a side that was not is reported and skipped."""
        strict = any(item.strict for item in draft.items)
        if draft.failures and not strict:
            if draft.signs:
                self._report_undeclared(draft, names)
                failure = next(iter(draft.failures.values()))
                self.account.refused.append(((draft.item.start, draft.last.end), failure))
            return
        sides_read = _without_gaps(draft, sides)
        whole = len(sides_read) >= (2 if draft.signs else 1)
        for failure in list(draft.failures.values())[: None if whole else 1]:
            self._report(failure, (draft.item.start, draft.last.end))
        if not whole:
            return
        demands = {token.start for token in draft.signs if token.is_demanded}
        relations = tuple(
            Relation(sign, self.finder.line_of(at), at in demands) for _, sign, at in sides_read[1:]
        )
        lines = sorted({n for i in draft.items for n in range(i.first_line, i.last_line + 1)})
        tag = next((item.tag for item in reversed(draft.items) if item.tag), "")
        inline = draft.item.kind in ("inline", "prose")
        notes = tuple(dict.fromkeys(draft.notes))
        chain = Chain(
            tuple(side for side, _, _ in sides_read), relations, tuple(lines), tag, inline, notes
        )
        if draft.signs or len(draft.sides[0]) > 1:
            self.chains.append(chain)
            self.account.read.update(at for _, _, at in sides_read[1:])
            spans = {side.span for side, _, _ in sides_read}
            for tokens in draft.sides:  # the conditions of cases are read with their side
                if tokens and (tokens[0].start, tokens[-1].end) in spans:
                    self.account.read.update(t.start for t in tokens if t.kind == "rel")

    def _report_undeclared(self, draft: Draft, names: frozenset[str]) -> None:
        """Report prose with a relation only where one undeclared letter is all that is wrong."""
        wrong = list(draft.failures.values())
        letters = {failure.letter for failure in wrong if isinstance(failure, UndeclaredError)}
        if len(letters) != 1 or not all(isinstance(failure, UndeclaredError) for failure in wrong):
            return
        has_known_letter = any(
            t.kind == "name" and t.value in names for side in draft.sides for t in side
        )
        try:
            for tokens in draft.sides:
                read_tokens(tokens, names | letters, tokens[-1].end)
        except ReadingError:
            return
        if has_known_letter:
            self._report(wrong[0], (draft.item.start, draft.last.end))

    def _report(self, failure: ReadingError, span: tuple[int, int]) -> None:
        offset = min(max(failure.offset, 0), len(self.text))
        self.unreadable.append(Unreadable(*self._place_of(offset), failure.what, failure.remedy, span))


def _refuse_too_long(tokens: list[Token]) -> None:
    if len(tokens) > LONGEST_EQUATION or tokens[-1].end - tokens[0].start > 4 * LONGEST_EQUATION:
        what = f"an equation of more than {LONGEST_EQUATION} characters"
        raise ReadingError(tokens[0].start, what, "write it in parts")


def _without_gaps(draft: Draft, sides: list[Side | None]) -> list[tuple[Side, str, int]]:
    """Return the sides read, each with the relation before it; a gap leaves an equality an equality."""
    sides_read: list[tuple[Side, str, int]] = []
    weakest = "="
    for place, side in enumerate(sides):
        sign = draft.signs[place - 1] if place else None
        if sign is not None:
            if sign.value not in EQUALITIES and None in sides:
                break
            weakest = "≈" if "≈" in (weakest, sign.value) and sides[place - 1] is None else sign.value
        if side is not None:
            sides_read.append((side, weakest, sign.start if sign else 0))
    return sides_read


@dataclass(slots=True)
class Draft:
    """A chain while its lines are being gathered."""

    item: Item
    names: set[str]
    motions: Motions = NO_MOTIONS
    sides: list[list[Token]] = field(default_factory=lambda: [[]])
    signs: list[Token] = field(default_factory=list)
    items: list[Item] = field(default_factory=list)
    open_brackets: list[Token] = field(default_factory=list)
    failures: dict[int, ReadingError] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    function_letters: list[str] = field(default_factory=list)
    functions: Mapping[str, str] = field(default_factory=dict)
    """The letters that lines above define as functions, and of what: R(α) = …"""
    own_argument: str = ""
    page_letters: Collection[str] = ()
    """Letters of lines above that nobody declared."""

    @property
    def last(self) -> Item:
        """The item added last."""
        return self.items[-1]

    @property
    def is_unfinished(self) -> bool:
        """Tell whether the last side wants more: an open bracket, an operator or relation at its end."""
        side = self.sides[-1]
        return bool(self.open_brackets) or not side or side[-1].kind == "op"

    @property
    def is_whole(self) -> bool:
        """Tell whether a relation stands here and wants no more: x = a, not a + b nor x = a +."""
        return bool(self.signs) and not self.is_unfinished

    def add(self, item: Item, tokens: list[Token]) -> None:
        """Take the tokens of one more item; a sign at a line's end is set again on the next: a +, + b."""
        last = self.sides[-1][-1] if self.sides[-1] else None
        if (
            self.items
            and tokens
            and last is not None
            and last.is_op("+-*")
            and tokens[0].is_op(last.value)
        ):
            tokens = tokens[1:]
        self.items.append(item)
        if tokens and tokens[0].kind == "rel" and self.open_brackets:
            self._leave_open()
        for place, token in enumerate(tokens):
            if token.kind == "rel" and not self.open_brackets:
                self.signs.append(token)
                self.sides.append([])
            elif self._fits(token, place == len(tokens) - 1):
                self.sides[-1].append(token)
        if item.doubt is not None:
            self.fail(item.doubt)
        if self.signs:
            self._without_argument(0)

    def _without_argument(self, place: int) -> None:
        """Read x(θ), all of the left side, as x, and x(0) as x at 0; on later sides too."""
        side = self.sides[place]
        if place in self.failures or not (parts := head_and_argument(side)):
            return
        head, inside = parts
        name = "".join(token.value for token in head)
        if (place and name not in self.function_letters) or (name == "O" and name not in self.names):
            return  # O(λ) is an order, no letter
        if name in self.functions and not _is_own(inside, self.functions[name]):
            return  # R(β), where R(α) = … stands above
        if place and is_variable(inside) and self.own_argument and not _is_own(inside, self.own_argument):
            self.sides[place] = letter_at_a_place(side)  # g(α) = g(β)
            return
        if is_variable(inside):
            self.own_argument = self.own_argument if place else inside[0].value
            self.sides[place], note = letter_without_argument(head, inside, side[-1])
            self.notes += [note] if note not in self.notes else []
        elif is_value(inside):
            self.sides[place] = letter_at_a_place(side)
        else:
            return
        self.function_letters.append(name)

    def own_letter(self) -> frozenset[str]:
        """Return the undeclared letter that stands alone on the left: it declares itself."""
        if not self.signs:
            return frozenset()
        if self.signs[0].value not in EQUALITIES:
            return self._running_letter()
        name = lone_letter(self.sides[0])
        is_declared = name is not None and (name in self.names or other_form(name) in self.names)
        return frozenset({name} if name and not is_declared and name != "pi" else ())

    def own_index(self) -> frozenset[str]:
        """Return the index that the letter on the left carries and the right side is written in.

        In ψ_j = 2πj/N the j is a number that counts, in this equation.
        """
        name = lone_letter(self.sides[0]) if self.signs else ""
        index = name.rpartition("_")[2] if "_" in name else ""
        is_letter = len(index) == 1 and index.isalpha() and index not in self.names
        others = {token.value for side in self.sides[1:] for token in side if token.kind == "name"}
        return frozenset({index} if is_letter and index in others else ())

    def _running_letter(self) -> frozenset[str]:
        """Return the undeclared letter of 1 ≤ n ≤ 4 or k ≥ 0, whose other sides hold no letter."""
        if len(self.sides) > LONGEST_RANGE:
            return frozenset()
        letters = [lone_letter(side) for side in self.sides]
        others = [side for side, name in zip(self.sides, letters, strict=True) if not name]
        alone = [name for name in letters if name]
        plain = all(token.kind != "name" or token.value == "pi" for side in others for token in side)
        is_new = len(alone) == 1 and plain and all(others) and alone[0] not in self.names
        return frozenset(alone if is_new and alone[0] != "pi" else ())

    def finish_alone(self) -> None:
        """Finish a chain of its own and raise the first failure."""
        self.finish()
        for failure in self.failures.values():
            raise failure

    def _leave_open(self) -> None:
        opener = self.open_brackets[-1]
        self.fail(ReadingError(opener.start, f"bracket {opener.value} is never closed", "close it"))
        self.open_brackets.clear()

    def fail(self, error: ReadingError) -> None:
        """Give up the last side."""
        self.failures.setdefault(len(self.sides) - 1, error)

    def _fits(self, token: Token, last: bool) -> bool:
        if token.kind == "open":
            self.open_brackets.append(token)
        elif token.kind == "close" and not self.open_brackets:
            if last and token.value != "}":
                self.notes.append(f"stray {token.value} dropped")
            else:
                what = f"bracket {token.value} was never opened"
                self.fail(ReadingError(token.start, what, "open it or remove it"))
            return False
        elif token.kind == "close":
            self._close(token)
        return True

    def _close(self, token: Token) -> None:
        opener = self.open_brackets.pop()
        if CLOSER[opener.value] != token.value:
            what = f"bracket {opener.value} is closed by {token.value}"
            self.fail(ReadingError(token.start, what, "make them a pair"))

    def finish(self) -> None:
        """Note what is missing at the end."""
        if self.open_brackets:
            self._leave_open()
        if not self.failures:
            self.sides, self.signs = with_second_values(self.sides, self.signs)
        self.sides = with_differentials(self.sides, {*self.names, *self.page_letters})
        self.sides = with_functions_at_places(self.sides, self.motions, self.functions)
        for place, side in enumerate(self.sides):
            if not side and place not in self.failures:
                self.failures[place] = self._missing(place)
            elif place:
                self._without_argument(place)

    def _missing(self, place: int) -> ReadingError:
        if not self.signs:
            return ReadingError(self.item.start, "an empty formula", "write one")
        sign = self.signs[place - 1] if place else self.signs[0]
        what = f"nothing stands {'right' if place else 'left'} of {sign.value}"
        return ReadingError(sign.start, what, "complete the equation")


_BRACE = re.compile(r"\\(under|over)brace\s*\{")
_NOTE = {"under": re.compile(r"\s*_\s*\{"), "over": re.compile(r"\s*\^\s*\{")}


def has_own_relation(tokens: list[Token]) -> bool:
    """Tell whether a relation stands outside the brackets opened among the tokens."""
    depth = 0
    for token in tokens:
        depth += {"open": 1, "close": -1}.get(token.kind, 0)
        if depth < 0 or (token.kind == "rel" and depth == 0):
            return depth == 0
    return False


def is_equation(tokens: list[Token]) -> bool:
    """Tell whether tokens hold a relation outside brackets and all brackets are paired."""
    depth, holds_relation = 0, False
    for token in tokens:
        depth += {"open": 1, "close": -1}.get(token.kind, 0)
        holds_relation = holds_relation or (token.kind == "rel" and depth == 0)
        if depth < 0:
            return False
    return holds_relation and depth == 0


def without_aside(tokens: list[Token]) -> list[Token]:
    """Read `m (= n/2)` as m = n/2: drop the brackets around a relation at the end."""
    last = tokens[-1] if tokens else None
    if last is None or last.kind != "close" or last.value != ")":
        return tokens
    for place, token in enumerate(tokens[1:-2], 1):
        if token.kind == "open" and token.value == "(" and tokens[place + 1].kind == "rel":
            aside = tokens[place + 1 : -1]
            return [*tokens[:place], *aside] if is_equation(aside) else tokens
    return tokens


def name_of_words(written: str) -> str:
    """Return the letter that some words stand for.

    >>> name_of_words("mittlere Geschwindigkeit für 2 Hübe")
    'mittlere_Geschwindigkeit_fur_2_Hube'
    """
    bare = unicodedata.normalize("NFKD", written.strip()).encode("ascii", "ignore").decode()
    return "_".join(re.findall("[A-Za-z0-9]+", bare)) or "quantity"


def lone_letter(side: Sequence[Token]) -> str:
    """Return the letter that is all of a side, accent and all; "" if something else stands there."""
    tokens = [token for token in side if token.kind not in ("open", "close")]
    if len(tokens) == 1 and len(side) == 1 and tokens[0].kind == "name":
        return tokens[0].value
    is_dotted = len(tokens) == 2 and tokens[0].is_cmd(*TIME_DOTS) and is_extreme(tokens[1].value)
    if is_dotted:
        return f"{tokens[0].value}_{tokens[1].value}"
    is_accented = len(tokens) in (2, 3) and tokens[0].is_cmd(*ACCENTS) and tokens[1].kind == "name"
    if not is_accented or (len(side) > len(tokens) and side[1].value != "{"):
        return ""
    script = tokens[2].value if len(tokens) == 3 else ""
    if script and tokens[2].kind != "sub":
        return ""
    return f"{ACCENTS[tokens[0].value]}_{tokens[1].value}" + (f"_{script}" if script else "")


# A letter written as a function, x(θ), on the left of a relation


def head_and_argument(side: Sequence[Token]) -> tuple[list[Token], list[Token]] | None:
    """Return a letter, perhaps with dots above, and what stands in the brackets right after it."""
    place = next((n for n, token in enumerate(side) if token.kind == "open" and token.value == "("), 0)
    is_closed = bool(side) and side[-1].kind == "close" and side[-1].value == ")"
    head, inside = list(side[:place]), list(side[place + 1 : -1])
    if not is_closed or not inside or not _is_letter(head) or _has_outer_closer(inside):
        return None
    return head, inside


def _has_outer_closer(tokens: Sequence[Token]) -> bool:
    """Tell whether a bracket closes that was not opened among the tokens."""
    depth = 0
    for token in tokens:
        depth += {"open": 1, "close": -1}.get(token.kind, 0)
        if depth < 0:
            return True
    return False


def _is_letter(head: Sequence[Token]) -> bool:
    letters = [token for token in head if token.kind == "name"]
    if len(letters) != 1 or letters[0].value == "pi":
        return False
    has_dots = head[0].is_cmd(*TIME_DOTS)
    rest = [token for token in head[has_dots:] if token.kind != "name"]
    return not rest or (has_dots and [t.value for t in rest] == ["{", "}"])


def is_variable(inside: Sequence[Token]) -> bool:
    """Tell whether brackets hold one angle, or time: x(θ) is x."""
    return len(inside) == 1 and inside[0].kind == "name" and _is_running(inside[0].value)


def _is_running(name: str) -> bool:
    return name == "t" or is_greek(name)


def is_value(inside: Sequence[Token]) -> bool:
    """Tell whether brackets hold a number or an angle in π or degrees: x(0) is a value of x."""
    if len(inside) == 1 and inside[0].kind in ("number", "vulgar"):
        return True
    letters = [token.value for token in inside if token.kind == "name"]
    angle = "pi" in letters or any(token.kind == "degree" for token in inside)
    has_call = any(token.kind == "function" for token in inside)
    return angle and not has_call and all(name == "pi" or _is_running(name) for name in letters)


def letter_without_argument(
    head: list[Token], inside: Sequence[Token], last: Token
) -> tuple[list[Token], str]:
    """Return x for x(θ), in the place of the whole, and the remark."""
    name = tokens_text(head)
    return [*head[:-1], replace(head[-1], end=last.end)], f"{name}({tokens_text(inside)}) read as {name}"


def letter_at_a_place(side: Sequence[Token]) -> list[Token]:
    """Return the tokens of x(π) with a bracket that says that it holds no factor."""
    return [replace(t, value=AT) if t.kind == "open" and t.value == "(" else t for t in side]


def with_functions_at_places(
    sides: list[list[Token]], motions: Motions, known: Mapping[str, str]
) -> list[list[Token]]:
    """Return the sides with F(2ω) = 4 F(ω) as one function at two places, and no product.

    One letter before two brackets, each with one running letter alone or with numbers, is a function, and
    one that a line above defines as R(α) = … is; a letter that moves is one before every bracket that
    shifts or stretches what it moves with. R(α) alone is R, if nothing is R of another letter.
    """
    uses: dict[str, set[str]] = {}
    variables: dict[str, set[str]] = {}
    for side in sides:
        for start, stop in _calls(side, known):
            name, inside = side[start - 1].value, side[start + 1 : stop]
            uses.setdefault(name, set()).add(tokens_text(inside))
            if is_variable(inside):
                variables.setdefault(name, set()).add(inside[0].value)
    functions = {name: "" for name, insides in uses.items() if len(insides) > 1 or name in known}
    for name in functions:
        own = variables.get(name, set())
        functions[name] = known.get(name) or (next(iter(own)) if len(own) == 1 else "")
    if functions:
        sides = [_with_places(side, functions) for side in sides]
    return [_with_moved_places(side, motions) for side in sides] if motions.letters else sides


def _with_moved_places(side: list[Token], motions: Motions) -> list[Token]:
    """Return a side whose x(-θ), \\dot{x}(ωt) and v(θ + π/2) are values at a place; x(θ) is x."""
    done = list(side)
    for start in range(len(side) - 1, 0, -1):
        token = side[start]
        if token.value != "(" or token.kind != "open" or side[start - 1].end != token.start:
            continue
        is_braced = side[start - 1].value == "}" and start > 3 and side[start - 4].is_cmd(*TIME_DOTS)
        name = side[start - 2 if is_braced else start - 1]
        stop = _closing(side, start)
        if name.kind != "name" or name.value not in motions.letters or stop is None:
            continue
        inside = side[start + 1 : stop]
        if not _is_moved(inside, motions.arguments):
            continue
        if is_variable(inside):
            done[start - 1 : stop + 1] = [replace(side[start - 1], end=side[stop].end)]
        else:
            done[start] = replace(token, value=AT)
    return done


def _closing(side: Sequence[Token], start: int) -> int | None:
    depth = 0
    for place in range(start, len(side)):
        depth += {"open": 1, "close": -1}.get(side[place].kind, 0)
        if depth == 0:
            return place if side[place].value == ")" else None
    return None


def _is_moved(inside: Sequence[Token], arguments: frozenset[str]) -> bool:
    """Tell whether brackets hold an angle or time, shifted or stretched, and no function of it."""
    plain = all(
        token.kind in ("number", "vulgar", "degree", "name", "op", "open", "close")
        or token.is_cmd("frac", "tfrac", "dfrac")
        for token in inside
    )
    return plain and any(token.kind == "name" and token.value in arguments for token in inside)


_MULTIPLIERS = frozenset({"pi", "i", "j", "e", "k", "n", "m", "N"})
"""Letters before a bracket that are factors of an angle, and no functions: e^{i(θ + π)}, n(θ + h)."""


def _calls(side: Sequence[Token], functions: Collection[str] = ()) -> list[tuple[int, int]]:
    """Return where brackets stand tightly behind a letter with one running letter in them.

    Behind one of the `functions` there may be several.
    """
    result: list[tuple[int, int]] = []
    for start, token in enumerate(side):
        before = side[start - 1] if start else None
        if token.value not in ("(", AT) or before is None or before.kind != "name":
            continue
        if _is_shifted(side, start, functions) or _is_at_root(side, start, functions):
            result.append((start, _closing(side, start) or start))
            continue
        stop = next((n for n in range(start + 1, len(side)) if side[n].kind in ("open", "close")), None)
        if stop is None or side[stop].value != ")" or before.end != token.start:
            continue
        inside = side[start + 1 : stop]
        letters = {t.value for t in inside if t.kind == "name"} - {"pi"}
        plain = all(t.kind in ("number", "vulgar", "degree", "name", "op") for t in inside)
        ahead = side[start - 2] if start > 1 else None
        is_function = before.value in functions
        is_term = is_function or ahead is None or ahead.kind in ("op", "open", "number", "close")
        is_call = is_term and before.value not in _MULTIPLIERS
        is_one = len(letters) == 1 or (is_function and letters)
        if plain and is_call and is_one and all(map(_is_running, letters)):
            result.append((start, stop))
    return result


def _is_shifted(side: Sequence[Token], start: int, functions: Collection[str]) -> bool:
    """Tell whether a function stands before a bracket with its own letter in a sum: T(θ + 2πk/3)."""
    own = functions.get(side[start - 1].value, "") if isinstance(functions, Mapping) else ""
    stop = _closing(side, start)
    if not own or stop is None:
        return False
    inside = side[start + 1 : stop]
    return not is_variable(inside) and _is_moved(inside, frozenset({own}))


def _is_at_root(side: Sequence[Token], start: int, functions: Collection[str]) -> bool:
    r"""Tell whether a function stands tightly before a root in brackets: H(\sqrt{c/J})."""
    stop = _closing(side, start)
    is_function = side[start - 1].value in functions and side[start - 1].end == side[start].start
    return stop is not None and is_function and side[start + 1].is_cmd("sqrt")


def _with_places(side: list[Token], functions: Mapping[str, str]) -> list[Token]:
    """Return a side with R(α) as R and R(β) as R at β, where the functions are those of α."""
    done = list(side)
    for start, stop in reversed(_calls(side, functions)):
        if side[start - 1].value not in functions:
            continue
        if _is_own(side[start + 1 : stop], functions[side[start - 1].value]):
            done[start - 1 : stop + 1] = [replace(side[start - 1], end=side[stop].end)]
        else:
            done[start] = replace(side[start], value=AT)
    return done


def _is_own(inside: Sequence[Token], own: str) -> bool:
    """Tell whether brackets hold what a function is one of, or time: x(t) is x(θ)."""
    return is_variable(inside) and own != "" and (inside[0].value == own or "t" in (inside[0].value, own))


def tokens_text(tokens: Sequence[Token]) -> str:
    """Return tokens as text: names by their signs, commands by name."""
    signs = {"cmd": lambda word: f"\\{word} ", "name": plain_letter}
    pieces = (signs.get(token.kind, str)(token.value) for token in tokens)
    return "".join(pieces).replace(" {", "{")
