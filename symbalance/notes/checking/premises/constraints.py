"""Relations that are assumptions, not steps, such as l sin β = r sin θ, solved for a letter.

A relation fixes a letter if the letter is new in the document, stands in it once, and can be reached by
undoing sums, products, powers and functions. Both sides must hold letters of their own: in
r sin²θ + r cos²θ = 2r nothing is stated, it is just false.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import (
    Call,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue, derivative_name
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import polynomial_node
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.sums import indexed_letters
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.algebra.values import context, letters
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.reading.equations import Chain

_INVERSE = {
    "sin": "asin",
    "cos": "acos",
    "tan": "atan",
    "asin": "sin",
    "acos": "cos",
    "atan": "tan",
    "exp": "ln",
}


_OWN = frozenset({"e"})
"""Letters that a page has to give as lengths, or they are numbers: an equation fixes another first."""


@dataclass(frozen=True, slots=True)
class Constraint:
    """A letter and the formula that a relation gives it, on each branch with its condition."""

    name: str
    node: Formula
    branch: str = ""
    alternatives: tuple[tuple[Formula, str], ...] = ()
    is_circular: bool = False
    """Whether it fixes the letter only together with an equation before: two fix two letters."""


Solution = tuple[Formula, tuple[str, ...]]
"""A value, and the conditions under which the letter lies on its branch."""


def letter_counts(node: Formula) -> Counter[str]:
    """Return how often each letter stands in a formula."""
    return Counter(part.name for part in formula.walk(node) if isinstance(part, Name))


def constraint_of(
    chain: Chain,
    k: int,
    letters_in_use: Collection[str],
    letters_used_at_all: Collection[str],
    knowledge: Knowledge,
) -> Constraint | None:
    """Return what the k-th relation of a chain states, or None where it must be a step.

    A letter is new if it was not in use before the relation's paragraph; preferred is one that was not
    used there either.
    """
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if k == 0 and isinstance(left, Name) and knowledge.knows(left.name):
        definition = knowledge.definitions.get(left.name)
        if definition is None or not definition.numeric:
            return None  # a value that is not the same; with F = 100, F = m a says what a is
    if chain.relations[k].sign != "=" or any(map(_hides_letters, _parts(left, right))):
        return None
    first, second = letter_counts(left), letter_counts(right)
    earlier = {*letters_in_use} | {n for side in chain.sides[:k] for n in formula.names(side.node)}
    if right == Number(Fraction(0)):
        pairs = [(_apart_from_others(left), left, right)] if k == 0 else []
    elif set(first) - set(second) and set(second) - set(first):
        splits = [(set(first) - set(second), left, right), (set(second) - set(first), right, left)]
        pairs = splits if k == 0 else splits[:1]
    elif k == 0 and not second and len(first) == 1:
        pairs = [(set(first), left, right)]  # tan δ = 1/3
    else:
        return None
    candidates = [(name, node, other) for own, node, other in pairs for name in sorted(own)]
    rod = _rod_angle(left, right)
    by_use = sorted(
        candidates,
        key=lambda c: (c[0] in letters_used_at_all, c[0] != rod, c[0] in _OWN & knowledge.letters),
    )
    for name, node, other_side in by_use:
        is_new = name not in earlier and (
            not knowledge.has_meaning(name)
            or (not isinstance(left, Name) and _is_sought(name, {*first, *second}, knowledge))
        )
        if is_new and (first + second)[name] == 1 and not _inside_derivative(node, name):
            constraint = _constraint(node, other_side, name, knowledge)
            if constraint is not None and not (k and _has_rate(constraint.node)):
                return constraint  # J_0 φ̇²/2 + m ẋ²/2 = J φ̇²/2 does not say that J_0 changes
    derivative = _lone_derivative(left, right, knowledge)
    return Constraint(derivative, right) if derivative else None


def _is_sought(name: str, letters: set[str], knowledge: Knowledge) -> bool:
    """Tell whether a usual letter of a crank is sought from numbers: l² = a² + b², a = 30 and b = 40."""
    is_usual = knowledge.measures(name) and not knowledge.knows(name) and name not in knowledge.universal
    known = [knowledge.definitions.get(n) for n in letters - {name}]
    is_declared = name in knowledge.meanings or not known
    return is_usual and not is_declared and all(d is not None and d.numeric for d in known)


def _has_rate(node: Formula) -> bool:
    return any(isinstance(part, Derivative) for part in formula.walk(node))


_ANGLE_OF_CRANK = {"theta": 2, "vartheta": 2, "phi": 1, "varphi": 1, "alpha": 1}
"""Letters of the crank angle on most pages, the likelier the higher; a rod's angle has another."""


def _rod_angle(left: Formula, right: Formula) -> str:
    """Return the rod's angle of r sin φ = l sin β, which it fixes on either side; "" for others."""
    angles: list[str] = []
    for side in (left, right):
        sines = [p for p in formula.walk(side) if isinstance(p, Call) and p.function == "sin"]
        lone = [p.argument.name for p in sines if isinstance(p.argument, Name)]
        if len(sines) != 1 or len(lone) != 1:
            return ""
        angles += lone
    ranks = [_ANGLE_OF_CRANK.get(name, 0) for name in angles]
    return "" if ranks[0] == ranks[1] else angles[ranks.index(min(ranks))]


def _hides_letters(part: Formula) -> bool:
    """Tell whether a part stands for more letters than it shows: dots, and a sum of m_i over i."""
    if isinstance(part, formula.Summation) and part.index is not None:
        return bool(indexed_letters(part.body, part.index.name))
    return isinstance(part, formula.Dots)


def _constraint(node: Formula, other: Formula, name: str, knowledge: Knowledge) -> Constraint | None:
    """Return what a relation fixes a letter to; None if that is circular, or no such value exists."""
    values = {**{n: d.node for n, d in knowledge.definitions.items()}, **knowledge.meaning.values}
    plain_values = {n: v for n, v in values.items() if n not in knowledge.definitions}
    plain_values |= {n: d.node for n, d in knowledge.definitions.items() if not d.solved}
    real: list[Solution] = []
    for value, conditions in solutions(node, other, name, knowledge.meaning.positive):
        if name in names_behind(value, plain_values):
            return None
        if name in names_behind(value, values):
            return Constraint(name, value, is_circular=True)
        if _satisfies(node, other, name, value, replace(knowledge.meaning, values=values)):
            real.append((value, conditions))
    if not real:
        return None
    (value, conditions), *others = real
    alternatives = tuple((v, " and ".join(texts)) for v, texts in others)
    return Constraint(name, value, " and ".join(conditions), alternatives)


def _satisfies(node: Formula, other: Formula, name: str, value: Formula, meaning: SymbolValue) -> bool:
    """Tell whether a value solves the relation somewhere: √x = -2 is not solved by x = (-2)².

    What cannot be evaluated in numbers (an unknown derivative) is taken as solved.
    """
    row = [node, other, value]  # the value too has to be real
    if any(isinstance(p, Derivative | formula.Summation) for p in _parts(*row)):
        return True
    points = sample_trees(row, replace(meaning, values={**meaning.values, name: value}))
    return any(
        abs(left - right) <= max(abs(left), abs(right), 1) * context().mpf(10) ** -20
        for _, (left, right, _) in points
    )


def _parts(*nodes: Formula) -> Iterator[Formula]:
    for node in nodes:
        yield from formula.walk(node)


def _apart_from_others(node: Formula) -> set[str]:
    """Return the letters of F_1 + F_2 = 0: each in a term of its own beside terms with other letters."""
    terms = node.terms if isinstance(node, Sum) else (node,)
    letters = [formula.names(term) for term in terms]
    if len(letters) < 2:
        return set()
    return {
        n
        for k, own in enumerate(letters)
        for n in own
        if all(own - o and o - own for o in letters[:k] + letters[k + 1 :])
    }


def _inside_derivative(node: Formula, name: str) -> bool:
    return any(isinstance(p, Derivative) and name in formula.names(p) for p in formula.walk(node))


def _lone_derivative(left: Formula, right: Formula, knowledge: Knowledge) -> str:
    """Return a name for the derivative of an unknown letter, which a relation states."""
    if not (isinstance(left, Derivative) and isinstance(left.expression, Name)):
        return ""
    name = left.expression.name
    is_known = knowledge.has_meaning(name) or name in formula.names(right)
    is_known = is_known or name == left.variable.name  # dx/dx is 1
    lower = (derivative_name(replace(left, order=order)) for order in range(1, left.order))
    is_known = is_known or any(map(knowledge.knows, lower))  # of a velocity that is known
    return "" if is_known or _is_behind(left, right, knowledge) else derivative_name(left)


def _is_behind(derivative: Derivative, value: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a value comes down to a derivative that it would give: J/M after M = J φ̈."""
    values = {name: d.node for name, d in knowledge.definitions.items() if not d.numeric}
    behind = [values[name] for name in names_behind(value, values) if name in values]
    return any(part == derivative for node in behind for part in formula.walk(node))


def size_of(left: Formula, right: Formula, name: str, knowledge: Knowledge) -> Formula | None:
    """Return the size that a letter stands for if left = right: a monomial without angles, else None."""
    if (letter_counts(left) + letter_counts(right))[name] != 1:
        return None
    node, other = (left, right) if name in formula.names(left) else (right, left)
    value = solve_for(node, other, name)
    if value is None:
        return None
    evaluator = FormEvaluator(knowledge.meaning.domain(), knowledge.meaning)
    try:
        form = evaluator.form(value)
        size = form if form.is_polynomial else _as_monomial(form)
    except (NoFormError, TooLargeError):
        return None
    if size is None or len(size.numerator) != 1 or not letters(size):
        return None
    has_angle = not knowledge.angles.isdisjoint(letters(size))
    return None if has_angle else polynomial_node(size.domain, size.numerator)


def _as_monomial(form: Form) -> Form | None:
    """Return a quotient as a single term if it is one: (r/l) sin θ / sin θ, which no division finds."""
    below = next(iter(form.denominator.items()))
    for above in list(form.numerator.items())[:8]:
        ratio = Form.of(form.domain, dict([above])).over(Form.of(form.domain, dict([below])))
        if form.equals(ratio):
            return ratio
    return None


def solve(left: Formula, right: Formula) -> tuple[str, Formula] | None:
    """Return (letter, formula) from an equality, the left side's letters first."""
    for node, other in ((left, right), (right, left)):
        for name, count in letter_counts(node).items():
            if count == 1 and name not in formula.names(other):
                value = solve_for(node, other, name)
                if value is not None:
                    return name, value
    return None


def solve_for(node: Formula, other: Formula, name: str) -> Formula | None:
    """Return what `name` equals if node = other, where it stands once in node; None if not reachable."""
    return next((value for value, _ in solutions(node, other, name)), None)


def solutions(
    node: Formula, other: Formula, name: str, positive: Collection[str] = ()
) -> Iterator[Solution]:
    """Yield what `name` may equal if node = other, the usual branch first."""
    if isinstance(node, Name):
        yield other, ()
        return
    parts = [p for p in formula.children(node) if name in formula.names(p)]
    if len(parts) != 1:
        return
    inner = parts[0]
    for outside, condition in _branches(node, inner, other, positive):
        for value, conditions in solutions(inner, outside, name, positive):
            yield value, (*conditions, condition) if condition else conditions


def _branches(
    node: Formula, inner: Formula, other: Formula, positive: Collection[str]
) -> Iterator[tuple[Formula, str]]:
    """Yield what the part `inner` of `node` may equal if node = other, and on which condition."""
    rule = _RULES.get(type(node))
    main = None if rule is None else rule(node, inner, other)
    if main is None:
        return
    text, pi = formula_text(inner, plain=True), formula.Constant("pi")
    function = node.function if isinstance(node, Call) else ""
    if function == "sin":
        yield main, f"|{text}| ≤ π/2"
        yield Sum((pi, Negative(main))), f"|{text}| ≥ π/2"
    elif function == "cos":
        yield main, f"0 ≤ {text} ≤ π"
        yield Negative(main), f"{text} ≤ 0"
    elif function == "tan":
        yield main, f"|{text}| < π/2"
        yield Sum((main, pi)), f"|{text}| > π/2"
    elif isinstance(node, Power) and not (isinstance(inner, Name) and inner.name in positive):
        yield main, f"{text} ≥ 0"
        yield Negative(main), f"{text} ≤ 0"
    else:
        yield main, ""


def _solve_sum(node: Sum, inner: Formula, other: Formula) -> Formula | None:
    if any(isinstance(t, formula.Dots) for t in node.terms):
        return None
    return Sum((other, *(Negative(t) for t in node.terms if t is not inner)))


def _solve_product(node: Product, inner: Formula, other: Formula) -> Formula | None:
    rest = tuple(f for f in node.factors if f is not inner)
    return Quotient(other, rest[0] if len(rest) == 1 else Product(rest))


def _solve_quotient(node: Quotient, inner: Formula, other: Formula) -> Formula | None:
    return (
        Product((other, node.denominator)) if inner is node.numerator else Quotient(node.numerator, other)
    )


def _solve_call(node: Call, inner: Formula, other: Formula) -> Formula | None:
    if node.function == "sqrt":
        return Power(other, Number(Fraction(2)))
    return Call(_INVERSE[node.function], other) if node.function in _INVERSE else None


def _solve_power(node: Power, inner: Formula, other: Formula) -> Formula | None:
    square = inner is node.base and node.exponent == Number(Fraction(2))
    return Call("sqrt", other) if square else None


_RULES: dict[type[Formula], Callable[[Any, Formula, Formula], Formula | None]] = {
    Negative: lambda node, inner, other: Negative(other),
    Sum: _solve_sum,
    Product: _solve_product,
    Quotient: _solve_quotient,
    Call: _solve_call,
    Power: _solve_power,
}
