"""SymPy's `simplify` and `equals` on the benchmark derivation's relations, each with a time limit.

A formula as read becomes the expression a user would type. What makes it a fair comparison: every letter
the page defines, and every letter of known meaning, is replaced beforehand by what it stands for
(untimed), positive letters are declared positive, derivatives and sums are written out, and where the
page says ≈ (or ends in dots) SymPy gets the series of lhs - rhs through the order the right side keeps. A
side is compared with the last right one before it, as the checker does. SymPy's cache is kept from one
relation to the next. Relations that give a rounded decimal are left out: SymPy has no say there. Nothing
of the checker is used.
"""

from __future__ import annotations

import multiprocessing
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from time import perf_counter
from typing import Any

import sympy

from symbalance.bench.check_page import Page, place_of
from symbalance.document import formula
from symbalance.notes.reading import canonical_name, read_expression
from symbalance.notes.reading.equations import Chain

LIMIT = 10.0
"""Seconds after which a relation counts as undecided."""
SIMPLIFY, EQUALS = "simplify(lhs - rhs)", "exponentials, expand, equals(0)"
"""The ways to a proof: what a user asks for, and the strongest we know in SymPy: expanding exponentials
proves most identities of sines and cosines, and `equals` refutes by numbers before it simplifies."""
PROVED, DIFFERENT, UNDECIDED = "proved", "shown different", "undecided"
POSITIVE_LETTERS = frozenset({"r", "l", "lambda", "omega", "m", "b", "U", "q"})
_FUNCTIONS = {
    "abs": sympy.Abs, "ln": sympy.log, "log": sympy.log, "sqrt": sympy.sqrt,
    "sin": sympy.sin, "cos": sympy.cos, "tan": sympy.tan, "cot": sympy.cot, "sec": sympy.sec,
    "csc": sympy.csc, "asin": sympy.asin, "acos": sympy.acos, "atan": sympy.atan, "exp": sympy.exp,
    "sinh": sympy.sinh, "cosh": sympy.cosh, "tanh": sympy.tanh,
}  # fmt: skip
_CONSTANTS = {"pi": sympy.pi, "e": sympy.E, "i": sympy.I, "infinity": sympy.oo}


@dataclass(frozen=True)
class SympyConverter:
    """Turns formulas into SymPy: `values` replaces letters by formulas, the other letters are symbols.

    `positive` and `integer` letters get SymPy's assumption of that name, all others `real`.
    A derivative by `time` is one by `angle`, times `speed`.

    >>> from symbalance.notes.reading import read_expression
    >>> cosine, product = (read_expression(text, "xy")[0] for text in ("cos 2x", "3 x y"))
    >>> SympyConverter(values={"y": cosine}).of(product)
    3*x*cos(2*x)
    """

    values: Mapping[str, formula.Formula] = field(default_factory=dict)
    positive: frozenset[str] = frozenset()
    integer: frozenset[str] = frozenset()
    time: str = "t"
    angle: str = "theta"
    speed: str = "omega"
    _letters: dict[str, Any] = field(default_factory=dict)

    def of(self, node: formula.Formula) -> Any:
        """Return a formula as a SymPy expression; dots are left out."""
        rule = getattr(self, f"_{type(node).__name__.lower()}")
        return rule(node)

    def letter(self, name: str) -> Any:
        """Return what a letter stands for, or its symbol."""
        if name not in self._letters:
            has_value = name in self.values
            self._letters[name] = self.of(self.values[name]) if has_value else self.symbol(name)
        return self._letters[name]

    def symbol(self, name: str) -> sympy.Symbol:
        """Return the symbol of a letter."""
        if name in self.positive:
            return sympy.Symbol(name, positive=True)
        return sympy.Symbol(name, integer=True) if name in self.integer else sympy.Symbol(name, real=True)

    def _number(self, node: formula.Number) -> Any:
        return sympy.Rational(node.value.numerator, node.value.denominator)

    def _name(self, node: formula.Name) -> Any:
        return self.letter(node.name)

    def _constant(self, node: formula.Constant) -> Any:
        return _CONSTANTS[node.name]

    def _sum(self, node: formula.Sum) -> Any:
        return sympy.Add(*map(self.of, node.terms))

    def _upright(self, node: formula.Upright) -> Any:
        """Return degrees as a correction prints them."""
        if not node.text.endswith("°"):
            raise ValueError(f"no value: {node.text}")
        return sympy.Rational(node.text[:-1].replace("−", "-")) * sympy.pi / 180

    def _product(self, node: formula.Product) -> Any:
        return sympy.Mul(*map(self.of, node.factors))

    def _quotient(self, node: formula.Quotient) -> Any:
        return self.of(node.numerator) / self.of(node.denominator)

    def _power(self, node: formula.Power) -> Any:
        return self.of(node.base) ** self.of(node.exponent)

    def _negative(self, node: formula.Negative) -> Any:
        return -self.of(node.operand)

    def _call(self, node: formula.Call) -> Any:
        return _FUNCTIONS[node.function](self.of(node.argument))

    def _derivative(self, node: formula.Derivative) -> Any:
        derivative, name = self.of(node.expression), node.variable.name
        for _ in range(node.order):
            if name == self.time:
                derivative = sympy.diff(derivative, self.letter(self.angle)) * self.letter(self.speed)
            else:
                derivative = sympy.diff(derivative, self.symbol(name))
        return derivative

    def _summation(self, node: formula.Summation) -> Any:
        if node.index is None or node.lower is None or node.upper is None:
            raise ValueError("a sum without bounds")
        body, index = self.of(node.body), self.symbol(node.index.name)
        bounds = range(int(self.of(node.lower)), int(self.of(node.upper)) + 1)
        return sympy.Add(*(body.subs(index, value) for value in bounds))

    def _dots(self, _: formula.Dots) -> Any:
        return sympy.S.Zero


def converter(page: Page) -> SympyConverter:
    """Return a converter that replaces the letters of the page by their values."""
    values = {
        canonical_name(letter): read_expression(text, page.letters)[0]
        for letter, text in page.values.items()
    }
    return SympyConverter(values, POSITIVE_LETTERS, frozenset({"n"}))


@dataclass(frozen=True)
class Relation:
    """A relation as SymPy gets it: lhs - rhs, and for ≈ a small letter and its highest power."""

    line: int
    link: int
    difference: Any
    is_true: bool
    small: Any = None
    highest: int = 0


@dataclass(frozen=True)
class Outcome:
    """SymPy's answer to a relation, and after how many seconds."""

    link: Relation
    answer: str
    seconds: float

    @property
    def is_right(self) -> bool:
        """Whether that is the truth."""
        return self.answer == (PROVED if self.link.is_true else DIFFERENT)


def links(page: Page) -> list[Relation]:
    """Return the relations of the page that SymPy can decide; definitions are none."""
    convert = converter(page)
    wrong = {(error.line, error.link) for error in page.errors}
    relations: list[Relation] = []
    for chain in page.read(page.text).chains:
        sound = 0
        for k in range(len(chain.relations)):
            place = place_of(chain, k)
            if not (k == 0 and place[0] in page.defining) and not _has_decimals(chain.sides[k + 1].node):
                relations.append(_link(chain, sound, k, place, convert, place not in wrong))
            sound = sound if place in wrong else k + 1
    return relations


def _link(
    chain: Chain, sound: int, k: int, place: tuple[int, int], convert: SympyConverter, is_true: bool
) -> Relation:
    one, other = chain.sides[sound].node, chain.sides[k + 1].node
    difference = convert.of(one) - convert.of(other)
    dots = any(isinstance(part, formula.Dots) for part in formula.walk(other))
    if chain.relations[k].sign != "≈" and not dots:
        return Relation(*place, difference, is_true)
    large = convert.symbol("lambda")
    if large not in difference.free_symbols:
        small = convert.symbol("u")
        return Relation(*place, difference, is_true, small, _degree(convert.of(other), small))
    small = sympy.Symbol("rho", positive=True)
    highest = _degree(convert.of(other).subs(large, 1 / small), small)
    return Relation(*place, difference.subs(large, 1 / small), is_true, small, highest)


def _degree(expression: Any, letter: sympy.Symbol) -> int:
    return int(sympy.Poly(sympy.expand(expression), letter).degree())


def _has_decimals(node: formula.Formula) -> bool:
    return any(isinstance(p, formula.Number) and p.last_place is not None for p in formula.walk(node))


def decide_links(
    relations: Sequence[Relation], way: str = SIMPLIFY, limit: float = LIMIT
) -> Iterator[Outcome]:
    """Yield SymPy's answer to each relation, from a process of its own that is ended at the limit."""
    worker = _Worker(way)
    try:
        for link in relations:
            yield worker.answer(link, limit)
    finally:
        worker.end()


class _Worker:
    """A process that decides one way; ended and begun anew when a relation takes too long."""

    def __init__(self, way: str) -> None:
        self.way = way
        self.begin()

    def begin(self) -> None:
        context = multiprocessing.get_context("spawn")
        self.pipe, far_end = context.Pipe()
        self.process = context.Process(target=_serve, args=(far_end, self.way), daemon=True)
        self.process.start()
        self.pipe.recv()

    def end(self) -> None:
        self.process.kill()
        self.process.join()

    def answer(self, link: Relation, limit: float) -> Outcome:
        self.pipe.send(link)
        if self.pipe.poll(limit):
            return Outcome(link, *self.pipe.recv())
        self.end()
        self.begin()
        return Outcome(link, UNDECIDED, limit)


def _serve(pipe: Any, way: str) -> None:
    pipe.send("ready")
    while True:
        link = pipe.recv()
        start = perf_counter()
        try:
            answer = decide(link, way)
        except Exception:  # whatever SymPy stumbles over, it has not decided the relation
            answer = UNDECIDED
        pipe.send((answer, perf_counter() - start))


def decide(link: Relation, way: str = SIMPLIFY) -> str:
    """Return what SymPy makes of a relation: 0 is a proof, a number that is not 0 a refutation."""
    difference = link.difference
    if link.small is not None:
        difference = sympy.series(difference, link.small, 0, link.highest + 1).removeO()
    if way == EQUALS:
        return _decide_by_equals(difference)
    rest = sympy.simplify(difference)
    if rest == 0:
        return PROVED
    letters = sorted(rest.free_symbols, key=str)
    point = {letter: sympy.Rational(3 + 2 * k, 7 + k) for k, letter in enumerate(letters)}
    value = sympy.N(rest.subs(point), 30)
    return DIFFERENT if value.is_number and abs(value) > sympy.Float("1e-20") else UNDECIDED


def _decide_by_equals(difference: Any) -> str:
    if sympy.expand(difference.rewrite(sympy.exp)) == 0:
        return PROVED
    is_zero = difference.equals(0)
    return UNDECIDED if is_zero is None else PROVED if is_zero else DIFFERENT
