"""Mutation test of the checker: faults planted in a correct derivation, and how many it catches.

A fault counts only if it changes the value, by `PageValues` at random points: SymPy and mpmath, nothing
of the checker. One that only lowers the order a cut-off series keeps leaves a true line and is counted
apart; so is one in a definition, which nothing but a later line can contradict.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import mpmath
import sympy

from symbalance.bench.check_page import Block, Page, blocks, context, place_of, with_blocks_alone
from symbalance.bench.fault_kinds import KINDS
from symbalance.bench.sympy_decisions import converter
from symbalance.document.formula import Dots, Formula, Name, walk
from symbalance.notes.checking.verdicts import REFUTED, Checked
from symbalance.notes.reading.equations import Chain

STEP, DEFINITION = "step", "definition"
NO_FAULT, LOWERED, UNREAD = "same value", "true to a lower order", "no formula"
POINTS, DIGITS, MANY_DIGITS = 3, 30, 150
TINY = -12
"""The power of ten of the small letter where an order is looked for."""
NO_VALUE = (ZeroDivisionError, ValueError, TypeError, KeyError)
"""What a changed formula without a value raises."""


@dataclass
class PageValues:
    """Values of formulas of a page at a few random points, and the orders through which they agree."""

    page: Page
    seed: int = 1
    _values: dict[Formula, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        chance = random.Random(self.seed)
        self.convert = converter(self.page)
        self.free = sorted(self.page.letters - set(self.page.values))
        self.points = [{name: _random_value(name, chance) for name in self.free} for _ in range(POINTS)]

    def of(self, node: Formula) -> Sequence[Any]:
        """Return a formula's values at the points."""
        if node not in self._values:
            function = self._function(self.convert.of(node))
            with mpmath.workdps(DIGITS):
                self._values[node] = [function(point) for point in self.points]
        return self._values[node]

    def same(self, one: Formula, other: Formula) -> bool:
        """Tell whether two formulas have one value at all points."""
        pairs = zip(self.of(one), self.of(other), strict=True)
        return all(abs(a - b) <= 1e-15 * max(abs(a), abs(b), 1e-6) for a, b in pairs)

    def degree(self, node: Formula) -> int | None:
        """Return the highest power of the small letter in a formula; None if it is no polynomial."""
        small = sympy.Symbol("small", positive=True)
        polynomial = sympy.expand(
            self.convert.of(node).subs(self._large, 1 / small).subs(self._small, small)
        )
        is_polynomial = polynomial != 0 and polynomial.is_polynomial(small)
        return int(sympy.Poly(polynomial, small).degree()) if is_polynomial else None

    def agreement(self, one: Formula, other: Formula) -> float:
        """Return the power of the small letter with which two formulas begin to differ."""
        function = self._function(self.convert.of(one) - self.convert.of(other))
        with mpmath.workdps(MANY_DIGITS):
            tiny = mpmath.mpf(10) ** TINY
            point = dict(self.points[0]) | {"u": tiny, "lambda": 1 / tiny}
            difference = abs(function(point))
            if difference < mpmath.mpf(10) ** (20 - MANY_DIGITS):
                return float("inf")
            return int(mpmath.nint(mpmath.log10(difference) / TINY))

    def is_true_to_order(self, one: Formula, exact: Formula) -> bool:
        """Tell whether a formula equals another through the highest power of the small letter it keeps.

        That is claimed only of a cut-off series: where the other is no polynomial, or dots end one.
        """
        degree = self.degree(one)
        is_cut = any(isinstance(part, Dots) for part in walk(one))
        if degree is None or not (is_cut or self.degree(exact) is None):
            return False
        return self.agreement(one, exact) > degree

    @property
    def _large(self) -> sympy.Symbol:
        return self.convert.symbol("lambda")

    @property
    def _small(self) -> sympy.Symbol:
        return self.convert.symbol("u")

    def _function(self, expression: Any) -> Any:
        symbols = [self.convert.symbol(name) for name in self.free]
        function = sympy.lambdify(symbols, expression, "mpmath", dummify=True)
        return lambda point: mpmath.mpmathify(function(*(point[name] for name in self.free)))


def _random_value(name: str, chance: random.Random) -> Any:
    """Return a random value: a whole number for n and k, a rod ratio above 2, u below 1."""
    if name in ("n", "k"):
        return chance.randint(2, 5)
    low = {"lambda": 2.0, "u": 0.1}.get(name, 0.3)
    return mpmath.mpf(round(chance.uniform(low, low + (0.7 if name == "u" else 1.1)), 6))


@dataclass(frozen=True)
class Fault:
    """One changed side: its kind, where, the text before and after, and the checker's answer.

    `where` is STEP or DEFINITION, or says why it is no fault. `fix` is the corrected side as the checker
    gives it, `is_right` whether that has the value the side had (or the one before, where it was
    rounded), `fits_fault` whether it leaves the fault and changes the other side to fit.
    """

    kind: str
    line: int
    before: str
    after: str
    where: str = STEP
    is_caught: bool = False
    verdicts: tuple[str, ...] = ()
    fix: str = ""
    is_right: bool = False
    fits_fault: bool = False


@dataclass(frozen=True)
class Place:
    """A side in which faults are planted."""

    chain: Chain
    side: int
    block: Block
    start: int
    end: int


class Planter:
    """Plants faults in the corrected page, and has the checker judge each."""

    def __init__(self, page: Page) -> None:
        self.page, self.text = page, page.corrected
        self.document = page.read(self.text)
        self.blocks = blocks(page, self.document)
        self.values = PageValues(page)
        self.judgement = page.check(self.text)
        self.false_alarms = [v for v in self.judgement.verdicts if v.is_bad]

    def places(self) -> Iterator[Place]:
        """Yield the sides to plant in: all but lone letters, of chains that stand the check unchanged."""
        alarm_lines = {v.line for v in self.false_alarms}
        for chain in self.document.chains:
            if not chain.relations or alarm_lines & set(chain.lines):
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
        refutations = [v for v in verdicts if (v.line, v.link) in wrong and v.verdict == REFUTED]
        right = [v for v in refutations if v.fix and self.restores(v.fix.node, sides[v.line, v.link])]
        return len(refutations), len(right)

    def candidates(self, kind: str) -> list[tuple[Place, str]]:
        """Return all places with the texts a kind of fault makes of them, in the order of the page."""
        pairs = [(p, t) for p in self.places() for t in KINDS[kind](self.text[p.start : p.end])]
        return [(p, t) for p, t in pairs if t.strip()]

    def plant(self, each: int, seed: int = 2024) -> Iterator[Fault]:
        """Yield `each` real faults of every kind, and the draws among them that are none."""
        for kind in KINDS:
            draws = self.candidates(kind)
            random.Random(f"{seed} {kind}").shuffle(draws)
            real = 0
            for place, text in draws:
                fault = self.judge(kind, place, text)
                yield fault
                real += fault.where == STEP
                if real == each:
                    break

    def judge(self, kind: str, place: Place, text: str) -> Fault:
        """Return what becomes of one changed side."""
        before = self.text[place.start : place.end]
        fault = Fault(kind, place.chain.lines[0], before, text)
        faulty = self.text[: place.start] + text + self.text[place.end :]
        node = self.reading(faulty, place)
        if node is None:
            return replace(fault, where=UNREAD)
        where = self.where(place, node)
        if where in (STEP, DEFINITION):
            paragraphs = context([place.block], self.blocks, follow=where == DEFINITION)
            lines = {line for block in paragraphs for line in block.lines}
            previous = [b for b in self.blocks if b.lines[0] < place.block.lines[0]]
            earlier = frozenset().union(*(b.letters for b in previous)) - set(self.page.definitions)
            judgement = self.page.check(with_blocks_alone(faulty, paragraphs, earlier), lines)
            fault = self.with_verdicts(fault, place, node, judgement)
        return replace(fault, where=where)

    def reading(self, faulty: str, place: Place) -> Formula | None:
        """Return the changed side as read; None if it is no formula any more."""
        text = with_blocks_alone(faulty, [place.block])
        chains = [c for c in self.page.read(text).chains if _is_same_place(c, place.chain)]
        return chains[0].sides[place.side].node if len(chains) == 1 else None

    def where(self, place: Place, node: Formula) -> str:
        """Return whether a changed side is a fault, and where it stands."""
        chain, k = place.chain, place.side
        try:
            if self.values.same(node, chain.sides[k].node):
                return NO_FAULT
        except NO_VALUE:
            return UNREAD
        if k < 2 and place_of(chain, 0)[0] in self.page.defining:
            return DEFINITION
        exact = [chain.sides[0].node, *([chain.sides[k - 1].node] if k else [])]
        if k and any(self.values.is_true_to_order(node, other) for other in exact):
            return LOWERED
        return STEP

    def with_verdicts(self, fault: Fault, place: Place, node: Formula, judgement: Checked) -> Fault:
        """Return the fault with the checker's verdicts on the changed page."""
        refutations = [v for v in judgement.verdicts if v.verdict == REFUTED]
        fixes = [v.fix for v in refutations if v.fix]
        rights = [s.node for s in place.chain.sides[max(place.side - 1, 0) : place.side + 1]]
        back = [f for f in fixes if any(self.restores(f.node, right) for right in rights)]
        on_chain = [v.verdict for v in judgement.verdicts if v.line in place.chain.lines]
        fix = (back or fixes or [None])[0]
        return replace(
            fault,
            is_caught=bool(refutations),
            verdicts=tuple(dict.fromkeys(on_chain)),
            fix=fix.text if fix else "",
            is_right=bool(back),
            fits_fault=bool(fix) and not back and self.fits(fix.node, node),
        )

    def restores(self, fix: Formula, right: Formula) -> bool:
        """Tell whether a corrected side has the value it should have, through the order it kept."""
        try:
            if self.values.same(fix, right):
                return True
            degree = self.values.degree(right)
            return bool(degree) and self.values.agreement(fix, right) > degree
        except NO_VALUE:
            return False

    def fits(self, fix: Formula, wrong: Formula) -> bool:
        """Tell whether a changed side agrees with the faulty one, through the order it keeps."""
        try:
            return self.values.same(fix, wrong) or self.values.is_true_to_order(fix, wrong)
        except NO_VALUE:
            return False


def _is_same_place(chain: Chain, other: Chain) -> bool:
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
        row["caught"] += fault.is_caught
        row["fixed"] += bool(fault.fix)
        row["rightly"] += fault.is_right
        row["other side"] += fault.fits_fault
    return rows
