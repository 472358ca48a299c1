"""Faults planted in the corrected page one at a time, and what the checker makes of each.

A fault counts only if it changes the value, found by `PageValues` at random points. One that only lowers
the order a cut-off series keeps leaves a true line and is told apart; so is one in a definition, which
nothing but a later line can contradict.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from symbalance.bench.check_page import Block, Page, blocks, context, masked, place_of
from symbalance.bench.faults import KINDS
from symbalance.bench.values import PageValues
from symbalance.document.formula import Formula, Name
from symbalance.notes.checking.verdicts import REFUTED, Checked
from symbalance.notes.reading.equations import Chain

STEP, DEFINITION = "step", "definition"
NO_FAULT, LOWERED, UNREAD = "same value", "true to a lower order", "no formula"


@dataclass(frozen=True)
class Fault:
    """One changed side: its kind, where, the text before and after, and what the checker made of it.

    `where` is STEP or DEFINITION, or says why it is no fault. `fix` is the corrected side as the checker
    gives it, `rightly` whether that has the value the side had (or the one before, where it was
    rounded), `other_side` whether it keeps the fault and changes the other side to fit.
    """

    kind: str
    line: int
    before: str
    after: str
    where: str = STEP
    caught: bool = False
    verdicts: tuple[str, ...] = ()
    fix: str = ""
    rightly: bool = False
    other_side: bool = False


@dataclass(frozen=True)
class Place:
    """A side in which faults are planted."""

    chain: Chain
    side: int
    block: Block
    start: int
    end: int


class Planter:
    """Plants faults in a page put right, and asks the checker about each."""

    def __init__(self, page: Page) -> None:
        self.page, self.text = page, page.corrected
        self.document = page.read(self.text)
        self.blocks = blocks(page, self.document)
        self.values = PageValues(page)
        self.checked = page.check(self.text)
        self.false_alarms = [v for v in self.checked.verdicts if v.is_bad]

    def places(self) -> Iterator[Place]:
        """Yield the sides to plant in: all but lone letters, of chains that stand the check unchanged."""
        alarmed = {v.line for v in self.false_alarms}
        for chain in self.document.chains:
            if not chain.relations or alarmed & set(chain.lines):
                continue
            block = next(b for b in self.blocks if chain.lines[0] in b.lines)
            for k, side in enumerate(chain.sides):
                start, end = side.span
                if not isinstance(side.node, Name):
                    start -= 5 if self.text[:start].endswith(r"\left") else 0
                    yield Place(chain, k, block, start, end)

    def known_errors(self) -> tuple[int, int]:
        """Return how many known errors of the page are refuted, and how many of those fixed rightly."""
        sides = {
            place_of(chain, k): chain.sides[k + 1].node
            for chain in self.document.chains
            for k in range(len(chain.relations))
        }
        wrong = {(error.line, error.link) for error in self.page.errors}
        verdicts = self.page.check(self.page.text).verdicts
        found = [v for v in verdicts if (v.line, v.link) in wrong and v.verdict == REFUTED]
        right = [v for v in found if v.fix and self.restores(v.fix.node, sides[v.line, v.link])]
        return len(found), len(right)

    def candidates(self, kind: str) -> list[tuple[Place, str]]:
        """Return all places with the texts a kind of fault makes of them, in the order of the page."""
        found = [(p, t) for p in self.places() for t in KINDS[kind](self.text[p.start : p.end])]
        return [(p, t) for p, t in found if t.strip()]

    def planted(self, each: int, seed: int = 2024) -> Iterator[Fault]:
        """Yield `each` real faults of every kind, and what was drawn with them but is none."""
        for kind in KINDS:
            drawn = self.candidates(kind)
            random.Random(f"{seed} {kind}").shuffle(drawn)
            real = 0
            for place, text in drawn:
                fault = self.one(kind, place, text)
                yield fault
                real += fault.where == STEP
                if real == each:
                    break

    def one(self, kind: str, place: Place, text: str) -> Fault:
        """Return what becomes of one changed side."""
        before = self.text[place.start : place.end]
        fault = Fault(kind, place.chain.lines[0], before, text)
        changed = self.text[: place.start] + text + self.text[place.end :]
        node = self.reading(changed, place)
        if node is None:
            return replace(fault, where=UNREAD)
        where = self.where(place, node)
        if where in (STEP, DEFINITION):
            kept = context([place.block], self.blocks, follow=where == DEFINITION)
            lines = {line for block in kept for line in block.lines}
            before = [b for b in self.blocks if b.lines[0] < place.block.lines[0]]
            seen = frozenset().union(*(b.letters for b in before)) - set(self.page.definitions)
            checked = self.page.check(masked(changed, kept, seen), lines)
            fault = self.with_verdicts(fault, place, node, checked)
        return replace(fault, where=where)

    def reading(self, changed: str, place: Place) -> Formula | None:
        """Return the changed side as read; None if it is no formula any more."""
        found = [c for c in self.page.read(masked(changed, [place.block])).chains if _is(c, place.chain)]
        return found[0].sides[place.side].node if len(found) == 1 else None

    def where(self, place: Place, node: Formula) -> str:
        """Return whether a changed side is a fault, and where it stands."""
        chain, k = place.chain, place.side
        try:
            if self.values.same(node, chain.sides[k].node):
                return NO_FAULT
        except (ZeroDivisionError, ValueError, TypeError, KeyError):
            return UNREAD
        if k < 2 and place_of(chain, 0)[0] in self.page.defining:
            return DEFINITION
        exact = [chain.sides[0].node, *([chain.sides[k - 1].node] if k else [])]
        if k and any(self.values.is_true_to_order(node, other) for other in exact):
            return LOWERED
        return STEP

    def with_verdicts(self, fault: Fault, place: Place, node: Formula, checked: Checked) -> Fault:
        """Return the fault with what the checker says of the changed page."""
        refuted = [v for v in checked.verdicts if v.verdict == REFUTED]
        fixes = [v.fix for v in refuted if v.fix]
        rights = [s.node for s in place.chain.sides[max(place.side - 1, 0) : place.side + 1]]
        back = [f for f in fixes if any(self.restores(f.node, right) for right in rights)]
        here = [v.verdict for v in checked.verdicts if v.line in place.chain.lines]
        chosen = (back or fixes or [None])[0]
        return replace(
            fault,
            caught=bool(refuted),
            verdicts=tuple(dict.fromkeys(here)),
            fix=chosen.text if chosen else "",
            rightly=bool(back),
            other_side=bool(chosen) and not back and self.fits(chosen.node, node),
        )

    def restores(self, fixed: Formula, right: Formula) -> bool:
        """Tell whether a corrected side has the value it should have, through the order it kept."""
        try:
            if self.values.same(fixed, right):
                return True
            kept = self.values.degree(right)
            return bool(kept) and self.values.agreement(fixed, right) > kept
        except (ZeroDivisionError, ValueError, TypeError, KeyError):
            return False

    def fits(self, fixed: Formula, wrong: Formula) -> bool:
        """Tell whether a changed side agrees with the faulty one, through the order it keeps."""
        try:
            return self.values.same(fixed, wrong) or self.values.is_true_to_order(fixed, wrong)
        except (ZeroDivisionError, ValueError, TypeError, KeyError):
            return False


def _is(chain: Chain, other: Chain) -> bool:
    same = [r.sign for r in chain.relations] == [r.sign for r in other.relations]
    return same and chain.lines == other.lines


def tally(faults: Sequence[Fault]) -> dict[str, Counter[str]]:
    """Return, for each kind and for definitions, how many faults were planted, caught and fixed."""
    rows: dict[str, Counter[str]] = {kind: Counter() for kind in (*KINDS, DEFINITION)}
    for fault in faults:
        if fault.where not in (STEP, DEFINITION):
            continue
        row = rows[fault.kind if fault.where == STEP else DEFINITION]
        row["planted"] += 1
        row["caught"] += fault.caught
        row["fixed"] += bool(fault.fix)
        row["rightly"] += fault.rightly
        row["other side"] += fault.other_side
    return rows
