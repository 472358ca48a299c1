"""`sympy.simplify(lhs - rhs)` on the relations of the bench's page, each with a limit on its time.

What makes it a fair comparison: every letter the page defines, and every letter of known meaning, is
replaced beforehand by what it stands for (untimed), positive letters are declared positive, derivatives
and sums are written out, and where the page says ≈ (or ends in dots) SymPy is asked for
`simplify(series(lhs - rhs))` through the order the right side keeps. A side is compared with the last
right one before it, as the checker does. SymPy's cache is kept from one relation to the next. Relations
that give a rounded decimal are left out: `simplify` has no say there.
"""

from __future__ import annotations

import multiprocessing
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import sympy

from symbalance.bench.check_page import Page, place_of
from symbalance.bench.in_sympy import InSympy
from symbalance.document import formula
from symbalance.notes.reading.equations import Chain

LIMIT = 10.0
PROVED, DIFFERENT, UNDECIDED = "proved", "shown different", "undecided"


@dataclass(frozen=True)
class Relation:
    """A relation as SymPy is asked for it: lhs - rhs, and for ≈ a small letter and the order kept."""

    line: int
    link: int
    difference: Any
    right: bool
    small: Any = None
    kept: int = 0


@dataclass(frozen=True)
class Outcome:
    """What SymPy said of a relation, and after how many seconds."""

    link: Relation
    said: str
    seconds: float

    @property
    def is_right(self) -> bool:
        """Tell whether that is the truth."""
        return self.said == (PROVED if self.link.right else DIFFERENT)


def links(page: Page) -> list[Relation]:
    """Return the relations of the page that SymPy can be asked for; definitions are none."""
    convert = page.in_sympy()
    wrong = {(error.line, error.link) for error in page.errors}
    found: list[Relation] = []
    for chain in page.read(page.text).chains:
        sound = 0
        for k in range(len(chain.relations)):
            place = place_of(chain, k)
            if not (k == 0 and place[0] in page.defining) and not _has_decimals(chain.sides[k + 1].node):
                found.append(_link(chain, sound, k, place, convert, place not in wrong))
            sound = sound if place in wrong else k + 1
    return found


def _link(
    chain: Chain, sound: int, k: int, place: tuple[int, int], convert: InSympy, right: bool
) -> Relation:
    left, other = chain.sides[sound].node, chain.sides[k + 1].node
    difference = convert.of(left) - convert.of(other)
    dots = any(isinstance(part, formula.Dots) for part in formula.walk(other))
    if chain.relations[k].sign != "≈" and not dots:
        return Relation(*place, difference, right)
    large = convert.symbol("lambda")
    if large not in difference.free_symbols:
        small = convert.symbol("u")
        return Relation(*place, difference, right, small, _degree(convert.of(other), small))
    small = sympy.Symbol("rho", positive=True)
    kept = _degree(convert.of(other).subs(large, 1 / small), small)
    return Relation(*place, difference.subs(large, 1 / small), right, small, kept)


def _degree(expression: Any, letter: sympy.Symbol) -> int:
    return int(sympy.Poly(sympy.expand(expression), letter).degree())


def _has_decimals(node: formula.Formula) -> bool:
    return any(isinstance(p, formula.Number) and p.last_place is not None for p in formula.walk(node))


def simplified(chosen: Sequence[Relation], limit: float = LIMIT) -> Iterator[Outcome]:
    """Yield what SymPy says of each relation, in a process of its own that is ended at the limit."""
    worker = _Worker()
    try:
        for link in chosen:
            yield worker.asked(link, limit)
    finally:
        worker.end()


class _Worker:
    """A process that simplifies; ended and begun anew when a question takes too long."""

    def __init__(self) -> None:
        self.begin()

    def begin(self) -> None:
        context = multiprocessing.get_context("spawn")
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_serve, args=(theirs,), daemon=True)
        self.process.start()
        self.pipe.recv()

    def end(self) -> None:
        self.process.kill()
        self.process.join()

    def asked(self, link: Relation, limit: float) -> Outcome:
        self.pipe.send(link)
        if self.pipe.poll(limit):
            return Outcome(link, *self.pipe.recv())
        self.end()
        self.begin()
        return Outcome(link, UNDECIDED, limit)


def _serve(pipe: Any) -> None:
    pipe.send("ready")
    while True:
        link = pipe.recv()
        start = perf_counter()
        try:
            said = decided(link)
        except Exception:  # whatever SymPy stumbles over, it has not decided the relation
            said = UNDECIDED
        pipe.send((said, perf_counter() - start))


def decided(link: Relation) -> str:
    """Return what `simplify` makes of a relation: 0 is a proof, a number that is not 0 a refutation."""
    difference = link.difference
    if link.small is not None:
        difference = sympy.series(difference, link.small, 0, link.kept + 1).removeO()
    found = sympy.simplify(difference)
    if found == 0:
        return PROVED
    letters = sorted(found.free_symbols, key=str)
    point = {letter: sympy.Rational(3 + 2 * k, 7 + k) for k, letter in enumerate(letters)}
    value = sympy.N(found.subs(point), 30)
    return DIFFERENT if value.is_number and abs(value) > sympy.Float("1e-20") else UNDECIDED
