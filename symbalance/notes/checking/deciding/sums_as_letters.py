"""Identities of sums whose terms nobody lists: Σ cos n(θ + α_i) = Re(e^{jnθ} Σ e^{jnα_i}).

Each sum is multiplied out, and what does not carry its index is put before it. What is left within, as
Σ cos nα_i and Σ z_i sin nα_i, are then letters of their own: what holds for any values of these holds for
any cylinders. An identity that fails so is refuted where both sides have such sums: no number of one of
them could make it true.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import product

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Summation,
    children,
    names,
    walk,
    with_children,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.number_formulas import rational_of
from symbalance.notes.algebra.sums import indexed_letters
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute

Decide = Callable[[Formula, Formula, Knowledge], Decision]
MOST_TERMS = 200
"""Of one product multiplied out: a square of the couple of ten throws has a hundred."""
MOST_PUT_IN = 12
"""Letters for sums that stand in one another."""
_Factors = tuple[tuple[Formula, ...], tuple[Formula, ...]]
"""Factors of a term: those that do not carry the index, and those that do."""
_NONE: tuple[Formula, ...] = ()
_I = Constant("i")
_ZERO, _ONE = Number(Fraction(0)), Number(Fraction(1))


def decide_sums_as_letters(
    left: Formula, right: Formula, knowledge: Knowledge, decide: Decide
) -> Decision | None:
    """Return the decision on a relation with its sums as letters; None where that says nothing."""
    of_sums = {n: d.node for n, d in knowledge.definitions.items() if _has_sum(d.node)}
    of_sums |= {f"bar_{n}": Call("conj", node) for n, node in of_sums.items()}
    sums = _Sums()
    try:
        sides = [sums.replaced(_written_out(node, of_sums)) for node in (left, right)]
    except (NoFormError, TooLargeError):
        return None
    own = [{letter for letter in sums.letters if letter in names(side)} for side in sides]
    if not own[0] | own[1]:
        return None
    rest = {n: d for n, d in knowledge.definitions.items() if n not in of_sums}
    decision = decide(sides[0], sides[1], replace(knowledge, definitions=rest))
    if decision.is_proved:
        return decision
    if decision.status == REFUTED and all(own):
        shown = ", ".join(f"{letter} is {sums.letters[letter]}" for letter in sorted(own[0] | own[1]))
        return Decision(REFUTED, f"whatever the cylinders are: {shown}", witness=decision.witness)
    return None


def _has_sum(node: Formula) -> bool:
    return any(isinstance(part, Summation) for part in walk(node))


def _written_out(node: Formula, values: dict[str, Formula]) -> Formula:
    for _ in range(MOST_PUT_IN):
        own = sorted(names(node) & values.keys())
        if not own:
            return node
        for name in own:
            node = substitute(node, name, values[name])
    raise TooLargeError("sums that stand in one another")


@dataclass
class _Sums:
    """The letters that stand for sums, by what these are of."""

    letters: dict[str, str] = field(default_factory=dict)

    def replaced(self, node: Formula) -> Formula:
        """Return a formula with its sums of indexed letters multiplied out, each a letter."""
        if isinstance(node, Summation):
            return self._as_letters(node)
        parts = children(node)
        return with_children(node, tuple(map(self.replaced, parts))) if parts else node

    def _as_letters(self, node: Summation) -> Formula:
        if node.index is None or _has_sum(node.body) or not indexed_letters(node.body, node.index.name):
            raise NoFormError("a sum without index or of none that carries it")
        index = node.index.name
        terms: list[Formula] = []
        for free, carrying in _single_waves(_expanded(node.body, index), index):
            letter = Name(self._letter(carrying, node))
            terms.append(Product((*free, letter)) if free else letter)
        return Sum(tuple(terms)) if len(terms) > 1 else terms[0] if terms else _ZERO

    def _letter(self, carrying: tuple[Formula, ...], node: Summation) -> str:
        assert node.index is not None
        bounds = [formula_text(b, plain=True) for b in (node.lower, node.upper) if b is not None]
        body = " ".join(sorted(formula_text(factor, plain=True) for factor in carrying)) or "1"
        text = f"Σ {body} over {node.index.name} {' to '.join(bounds)}".rstrip()
        for letter, known in self.letters.items():
            if known == text:
                return letter
        letter = f"S_{len(self.letters) + 1}"
        self.letters[letter] = text
        return letter


def _carries(node: Formula, index: str) -> bool:
    return index in names(node) or bool(indexed_letters(node, index))


def _expanded(node: Formula, index: str) -> list[_Factors]:
    """Return the terms of a formula multiplied out, what carries the index apart in each."""
    if not _carries(node, index):
        return [((node,), ())]
    expanded: list[_Factors]
    match node:
        case Sum(terms=terms):
            expanded = [term for part in terms for term in _expanded(part, index)]
        case Negative(operand=operand):
            minus = Number(Fraction(-1))
            expanded = [((minus, *free), carrying) for free, carrying in _expanded(operand, index)]
        case Product(factors=factors):
            expanded = _multiplied([_expanded(factor, index) for factor in factors])
        case Quotient(numerator=above, denominator=below) if not _carries(below, index):
            over = Quotient(_ONE, below)
            expanded = [((*free, over), carrying) for free, carrying in _expanded(above, index)]
        case Power(base=base, exponent=Number(value=value)) if value in (2, 3, 4):
            expanded = _multiplied([_expanded(base, index)] * int(value))
        case Call():
            expanded = _of_wave(node, index)
        case Name():
            expanded = [(_NONE, (node,))]
        case _:
            raise NoFormError("a sum of what is not multiplied out")
    return expanded


def _multiplied(factors: list[list[_Factors]]) -> list[_Factors]:
    count = 1
    for each in factors:
        count *= len(each)
    if count > MOST_TERMS:
        raise TooLargeError("a product of too many terms")
    return [
        (tuple(f for free, _ in term for f in free), tuple(c for _, carrying in term for c in carrying))
        for term in product(*factors)
    ]


def _single_waves(terms: list[_Factors], index: str) -> list[_Factors]:
    """Return terms with one wave each: cos A cos B is half of cos(A - B) and half of cos(A + B).

    Without that one sum would have several letters, and what holds would seem not to.
    """
    done: list[_Factors] = []
    waiting = list(terms)
    while waiting:
        if len(done) + len(waiting) > MOST_TERMS:
            raise TooLargeError("a product of too many waves")
        free, carrying = waiting.pop()
        waves = [part for part in carrying if isinstance(part, Call)]
        if len(waves) < 2:
            done.append((free, carrying))
            continue
        first, second = waves[:2]
        rest = list(carrying)
        rest.remove(first)
        rest.remove(second)
        names_of = first.function + second.function
        name, sign = _OF_TWO_WAVES[names_of]
        minus = Sum((first.argument, Negative(second.argument)))
        plus = Sum((first.argument, second.argument))
        for angle, half in ((minus, sign), (plus, -1 if names_of == "sinsin" else 1)):
            factor = Number(Fraction(half, 2))
            for own, wave in _of_wave(Call(name, angle), index):
                waiting.append(((*free, factor, *own), (*rest, *wave)))
    return done[::-1]


_OF_TWO_WAVES = {"coscos": ("cos", 1), "sinsin": ("cos", 1), "sincos": ("sin", 1), "cossin": ("sin", -1)}
"""The wave that a product of two comes down to, and the sign of the one of their difference."""


def _of_wave(node: Call, index: str) -> list[_Factors]:
    """Return cos(U + V), sin(U + V) and e^{i(U + V)} with what carries the index, V, apart."""
    if node.function == "exp":
        angle = _without_i(node.argument)
        cosine, sine = Call("cos", angle), Call("sin", angle)
        return [*_of_wave(cosine, index), *(((_I, *f), c) for f, c in _of_wave(sine, index))]
    if node.function not in ("cos", "sin"):
        raise NoFormError("a sum of a function that is no wave")
    terms = _expanded(node.argument, index)
    free = [Product(f) for f, carrying in terms if not carrying]
    sign, within = _angle([term for term in terms if term[1]])
    if within is None and not free:
        return [(_NONE, _NONE)] if node.function == "cos" else []
    if within is None:
        return [((Call(node.function, Sum(tuple(free))),), _NONE)]
    cosine, sine = Call("cos", within), Call("sin", within)
    if not free:
        wave = cosine if node.function == "cos" else sine
        is_turned = sign < 0 and node.function == "sin"
        return [((Number(Fraction(-1)),) if is_turned else (), (wave,))]
    before = Sum(tuple(free))
    turned = Number(Fraction(sign))
    if node.function == "cos":
        minus = Number(Fraction(-sign))
        return [((Call("cos", before),), (cosine,)), ((minus, Call("sin", before)), (sine,))]
    return [((Call("sin", before),), (cosine,)), ((turned, Call("cos", before)), (sine,))]


def _angle(terms: list[_Factors]) -> tuple[int, Formula | None]:
    """Return the sign of an angle and its formula in one way of writing, however typed; None for zero."""
    sums: dict[tuple[str, ...], tuple[Fraction, tuple[Formula, ...]]] = {}
    apart = [(own, carrying) for free, carrying in terms for own in _multiplied_out(free)]
    for free, carrying in apart:
        number, factors = Fraction(1), list(carrying)
        for factor in free:
            value = rational_of(factor)
            number, factors = (
                (number * value, factors) if value is not None else (number, [*factors, factor])
            )
        factors.sort(key=lambda each: formula_text(each, plain=True))
        key = tuple(formula_text(each, plain=True) for each in factors)
        sums[key] = (sums[key][0] + number if key in sums else number, tuple(factors))
    rows = [(key, *sums[key]) for key in sorted(sums) if sums[key][0]]
    if not rows:
        return 1, None
    sign = 1 if rows[0][1] > 0 else -1
    parts = [Product((Number(sign * number), *factors)) for _, number, factors in rows]
    return sign, parts[0] if len(parts) == 1 else Sum(tuple(parts))


def _multiplied_out(factors: tuple[Formula, ...]) -> list[tuple[Formula, ...]]:
    """Return the products of factors whose sums are multiplied out: α and -k α of (1 - k) α."""
    done: list[tuple[Formula, ...]] = [()]
    for factor in factors:
        parts = _terms(factor)
        if len(done) * len(parts) > MOST_TERMS:
            raise TooLargeError("a product of too many terms")
        done = [(*before, *part) for before in done for part in parts]
    return done


def _terms(node: Formula) -> list[tuple[Formula, ...]]:
    match node:
        case Sum(terms=terms):
            return [part for term in terms for part in _terms(term)]
        case Negative(operand=operand):
            return [(Number(Fraction(-1)), *part) for part in _terms(operand)]
        case Product(factors=factors):
            return _multiplied_out(factors)
        case _:
            return [(node,)]


def _without_i(argument: Formula) -> Formula:
    """Return the angle φ of e^{iφ}; what is raised to another power is not read."""
    if argument == _I:
        return _ONE
    if isinstance(argument, Negative):
        return Negative(_without_i(argument.operand))
    if isinstance(argument, Quotient):
        return Quotient(_without_i(argument.numerator), argument.denominator)
    if isinstance(argument, Sum):
        return Sum(tuple(map(_without_i, argument.terms)))
    if isinstance(argument, Product) and list(argument.factors).count(_I) == 1:
        return Product((_ONE, *(factor for factor in argument.factors if factor != _I)))
    raise NoFormError("a power that is no turned unit")
