"""Items to chains: what continues what, sides and relations, and what cannot be read."""

from __future__ import annotations

from collections.abc import Callable, Collection

from symbalance.notes.reading.drafts import (
    EQUALITIES,
    Draft,
    has_own_relation,
    is_equation,
    without_aside,
)
from symbalance.notes.reading.equations import Chain, Relation, Side, Unreadable
from symbalance.notes.reading.failures import ReadingError, UndeclaredError
from symbalance.notes.reading.items import Item, ItemFinder
from symbalance.notes.reading.lexer import LONGEST_EQUATION, lex
from symbalance.notes.reading.pieces import has_relation, relation_at_start
from symbalance.notes.reading.readings import read_tokens
from symbalance.notes.reading.tokens import Token

MOST_LINES_OF_PROSE = 2


class Assembler:
    """Reads the items of a document in order; letters defined on the way are letters from there on."""

    def __init__(self, finder: ItemFinder, names_at: Callable[[int], Collection[str]]) -> None:
        self.finder, self.names_at = finder, names_at
        self.text = finder.text
        self.defined: set[str] = set()
        self.chains: list[Chain] = []
        self.unreadable: list[Unreadable] = []
        self.draft: Draft | None = None
        self._refused: Item | None = None

    def run(self) -> None:
        """Fill `chains` and `unreadable`."""
        for item in self.finder.run():
            self._item(item)
        self._finish()
        for failure in self.finder.failures:
            self._report(failure, (failure.offset, failure.offset + 1))

    def _item(self, item: Item) -> None:
        names = frozenset(self.names_at(item.first_line)) | self.defined
        if self.draft:
            names |= self.draft.own_letter()
        try:
            tokens = without_aside(lex(self.text, item.start, item.end, names))
        except ReadingError as failure:
            self._unlexed(item, failure)
            return
        if not tokens:
            return
        if not self._continues(item, tokens):
            if not self._is_formula(tokens, item, names):
                return
            self._finish()
            tokens = tokens[1:] if self._follows_refused(item, tokens) else tokens
            self.draft = Draft(item, set(names)) if tokens else None
        if self.draft:
            self.draft.names |= names
            self.draft.add(item, tokens)

    def _follows_refused(self, item: Item, tokens: list[Token]) -> bool:
        """Tell whether `= c` continues an equation that could not be read; c then starts a chain."""
        before, self._refused = self._refused, None
        return tokens[0].kind == "rel" and before is not None and self._is_near(before, item)

    def _unlexed(self, item: Item, failure: ReadingError) -> None:
        source = self.text[item.start : item.end].lstrip(" \n\t&")
        if self._continues_unlexed(item, source, failure):
            return
        lone = item.kind == "inline" and not any(sign in source for sign in "=<>≈≤≥")
        if not item.strict or lone:
            return
        before, self._refused = self._refused, item
        goes_on = source[:1] == "=" or self._is_term(source)
        if not (before and before.block == item.block >= 0 and goes_on):
            self._finish()
            self._report(failure, (item.start, item.end))

    def _continues_unlexed(self, item: Item, source: str, failure: ReadingError) -> bool:
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
        if item.kind == "inline":
            return False
        if "\\" in self.text[item.start : item.end]:
            return len(tokens) > 1
        declared = any(token.kind == "name" and token.value in names for token in tokens)
        return declared and any(t.kind in ("function", "sup") or t.is_op("+*/") for t in tokens)

    def _continues(self, item: Item, tokens: list[Token]) -> bool:
        draft = self.draft
        if draft is None or item.kind in ("inline", "prose"):
            return False
        first = tokens[0]
        if first.kind == "rel":
            return self._is_near(draft.last, item)
        if draft.last.kind in ("inline", "prose") or not self._is_next(item):
            return False
        if first.is_op("+-"):
            closed = -1 not in (item.block, draft.last.block) and item.block != draft.last.block
            return not closed and not has_own_relation(tokens)
        if not draft.is_unfinished or item.block != draft.last.block:
            return False
        return not (draft.opened and is_equation(tokens))

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
            if self._line(line).strip().strip("$[]\\"):
                prose += 1
                if prose > MOST_LINES_OF_PROSE or self._is_heading(line):
                    return False
        return True

    def _line(self, line: int) -> str:
        start, end = self.finder.line_span(line)
        return self.text[start:end]

    def _is_heading(self, line: int) -> bool:
        words = self._line(line).strip()
        if words.startswith(("#", "\\section", "\\subsection", "\\chapter", "\\paragraph")):
            return True
        alone = not self._line(line - 1).strip() and not self._line(line + 1).strip()
        return alone and len(words) <= 40 and words[-1:] not in "。.、,:：;"

    def _finish(self) -> None:
        draft, self.draft = self.draft, None
        if draft is None:
            return
        draft.finish()
        own = draft.own_letter()
        names = frozenset(draft.names) | own
        sides = self._sides(draft, names)
        self._keep(draft, sides, names)
        if sum(side is not None for side in sides) > 1 and sides[0] is not None:
            self.defined |= own

    def _sides(self, draft: Draft, names: frozenset[str]) -> list[Side | None]:
        sides: list[Side | None] = []
        latex = any("\\" in self.text[item.start : item.end] for item in draft.items)
        for place, tokens in enumerate(draft.sides):
            sides.append(None)
            if place in draft.failures:
                continue
            try:
                _refuse_too_long(tokens)
                readings, notes = read_tokens(tokens, names, tokens[-1].end, latex)
            except ReadingError as failure:
                draft.failures[place] = failure
                continue
            draft.notes.extend(note for note in notes if note not in draft.notes)
            sides[-1] = Side(readings, (tokens[0].start, tokens[-1].end))
        return sides

    def _keep(self, draft: Draft, sides: list[Side | None], names: frozenset[str]) -> None:
        """Keep what was read of a chain; a side that was not is reported and skipped."""
        strict = any(item.strict for item in draft.items)
        if draft.failures and not strict:
            if draft.signs:
                self._maybe_report(draft, names)
            return
        kept = _without_gaps(draft, sides)
        whole = len(kept) >= (2 if draft.signs else 1)
        for failure in list(draft.failures.values())[: None if whole else 1]:
            self._report(failure, (draft.item.start, draft.last.end))
        if not whole:
            return
        relations = tuple(Relation(sign, self.finder.line_of(at)) for _, sign, at in kept[1:])
        lines = sorted({n for i in draft.items for n in range(i.first_line, i.last_line + 1)})
        tag = next((item.tag for item in reversed(draft.items) if item.tag), "")
        inline = draft.item.kind in ("inline", "prose")
        notes = tuple(dict.fromkeys(draft.notes))
        chain = Chain(tuple(side for side, _, _ in kept), relations, tuple(lines), tag, inline, notes)
        if draft.signs or len(draft.sides[0]) > 1:
            self.chains.append(chain)

    def _maybe_report(self, draft: Draft, names: frozenset[str]) -> None:
        """Report prose with a relation only where one undeclared letter is all that is wrong."""
        wrong = list(draft.failures.values())
        letters = {failure.letter for failure in wrong if isinstance(failure, UndeclaredError)}
        if len(letters) != 1 or not all(isinstance(failure, UndeclaredError) for failure in wrong):
            return
        known = any(t.kind == "name" and t.value in names for side in draft.sides for t in side)
        try:
            for tokens in draft.sides:
                read_tokens(tokens, names | letters, tokens[-1].end)
        except ReadingError:
            return
        if known:
            self._report(wrong[0], (draft.item.start, draft.last.end))

    def _report(self, failure: ReadingError, span: tuple[int, int]) -> None:
        offset = min(max(failure.offset, 0), len(self.text))
        line = self.finder.line_of(offset)
        column = offset - self.finder.line_span(line)[0] + 1
        self.unreadable.append(Unreadable(line, column, failure.what, failure.remedy, span))


def _refuse_too_long(tokens: list[Token]) -> None:
    if len(tokens) > LONGEST_EQUATION or tokens[-1].end - tokens[0].start > 4 * LONGEST_EQUATION:
        what = f"an equation of more than {LONGEST_EQUATION} characters"
        raise ReadingError(tokens[0].start, what, "write it in parts")


def _without_gaps(draft: Draft, sides: list[Side | None]) -> list[tuple[Side, str, int]]:
    """Return the sides read, each with the relation before it; a gap leaves an equality an equality."""
    kept: list[tuple[Side, str, int]] = []
    weakest = "="
    for place, side in enumerate(sides):
        sign = draft.signs[place - 1] if place else None
        if sign is not None:
            if sign.value not in EQUALITIES and None in sides:
                break
            weakest = "≈" if "≈" in (weakest, sign.value) and sides[place - 1] is None else sign.value
        if side is not None:
            kept.append((side, weakest, sign.start if sign else 0))
    return kept
