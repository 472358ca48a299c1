"""The acceleration of gravity where no line gives it: T = 2π √(J/(m g b)) = 0.791 s with 9.81 m/s².

Pages seldom define g. Beside a mass, or below a weight, it is that of gravity, in metres or, where the
page has them, in feet: W N² (2π/60)²/g is 0.00034 W N² with 32.2. What is right with
one of its usual values holds with that; a number that none of them gives is wrong.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from math import prod

from symbalance.document.formula import Call, Formula, Name, Number, Product, Quotient, names, walk
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

GRAVITIES = ("9.81", "9.80665", "9.8", "9.807", "10", "32.2", "32.17", "32.16", "32.174", "386", "386.4")
"""Its usual values, in m/s², ft/s² and in/s²."""
_FEET, _POUND = (Fraction(3048, 10000), Fraction(254, 10000)), Fraction(45359237, 100000000)
GRAVITY_UNIT = "m/s^2"
METRIC = ("9.81", "9.80665")
"""Those that need not be said."""
_WEIGHT = re.compile(r"[WGPQ](?:_.*)?$|[mM](?:_.*)?[0-9]?$")

_NO_FACTOR = r"(?![0-9]|\s*(?:\^|\*\*|<sup>|[⁻⁰¹²³⁴-⁹]))"
"""Behind a number that is no power of ten: of 5·10⁻³ nobody has g = 10."""
_MEANING = re.compile(
    r"gravit|free fall|Erdbeschleunigung|Fallbeschleunigung|Schwere|重力|pesanteur|zwaartekracht",
    re.IGNORECASE,
)


Decide = Callable[[Side, Side, Decision, Knowledge], Decision]
"""Returns the decision on two sides by what is known, after another decision."""


def by_definitions(left: Side, right: Side, decision: Decision, knowledge: Knowledge) -> Decision:
    """Return the decision on two sides by the letters' values alone."""
    return decide(left, right, "=", knowledge)


def decide_with_gravity(
    chain: Chain,
    k: int,
    decision: Decision,
    text: str,
    knowledge: Knowledge,
    decide_with: Decide = by_definitions,
) -> Decision | None:
    """Return the decision on a relation that is open but for g, with the g that is meant."""
    if decision.status not in (REFUTED, UNDECIDED) or not stands_for_gravity(chain, k, knowledge):
        return None
    left, right = chain.sides[k], _in_feet(chain.sides[k + 1])
    last: Decision | None = None
    for size in GRAVITIES:
        is_printed = re.search(rf"(?<![0-9.,]){re.escape(size).replace('[.]', '[.,]')}{_NO_FACTOR}", text)
        if size not in METRIC and not is_printed:
            continue
        value = Number(Fraction(size))
        known = knowledge.with_definition("g", Definition(value, chain.lines[0], numeric=True))
        last = decide_with(left, right, decision, known)
        if last.is_proved:
            unit = "ft/s²" if value.value > 30 else "m/s²"
            return replace(last, assumptions=(*last.assumptions, f"g = {size} {unit}"))
    if last is None or last.status != REFUTED or last.left is None or _is_in_feet(knowledge):
        return None  # with the page's own g its units may be meant otherwise: lb as a force
    is_number = is_lone_number(right.node) and not letters(last.left)
    return replace(last, reason="with no usual value of g") if is_number else None


def stands_for_gravity(chain: Chain, k: int, knowledge: Knowledge) -> bool:
    """Tell whether g stands behind a relation, has no value there, and goes with a mass or a weight."""
    meaning = knowledge.meanings.get("g", "")
    is_declared = _MEANING.search(meaning) is not None
    if _is_in_feet(knowledge):
        is_declared = True
    elif knowledge.knows("g") or (meaning and not is_declared):
        return False
    values = {n: d.node for n, d in knowledge.definitions.items()} | dict(knowledge.meaning.values)
    sides = [chain.sides[n].node for n in (k, k + 1)]
    behind = {n for node in sides for n in names_behind(node, values)}
    nodes = [*sides, *(values[n] for n in sorted(behind) if n in values)]
    if "g" not in behind:
        return False
    return is_declared or any(_is_of_gravity(part) for node in nodes for part in walk(node))


def has_unit_of_gravity(chain: Chain, text: str, knowledge: Knowledge) -> bool:
    """Tell whether a bare g is in m/s²: by its value, by words, or beside a length below a root.

    In √(g/δ) with a deflection δ = 2 mm it is nothing else. A g with another meaning is not meant.
    """
    sides = [side.node for side in chain.sides]
    if not any("g" in names(node) for node in sides) or "g" in knowledge.meanings:
        return False
    definition = knowledge.definitions.get("g")
    if definition is not None and not definition.solved:
        node = definition.node
        return isinstance(node, Number) and node.value in {
            Fraction(size) for size in (*METRIC, "9.8", "9.807")
        }
    roots = [
        part
        for node in sides
        for part in walk(node)
        if isinstance(part, Call) and part.function == "sqrt"
    ]
    return _MEANING.search(text) is not None or any(
        _has_length(root.argument, knowledge) for root in roots
    )


def _has_length(node: Formula, knowledge: Knowledge) -> bool:
    """Tell whether one letter beside g in a formula has a number, as δ of √(g/δ)."""
    others = names(node) - {"g"}
    values = (knowledge.definitions.get(name) for name in others)
    return "g" in names(node) and len(others) == 1 and all(d is not None and d.numeric for d in values)


def _is_in_feet(knowledge: Knowledge) -> bool:
    """Tell whether a page gives g in feet or inches: a constant that it computes is for feet then."""
    definition = knowledge.definitions.get("g")
    node = None if definition is None else definition.node
    factors = node.factors if isinstance(node, Product) else (node,)
    numbers = [factor.value for factor in factors if isinstance(factor, Number)]
    value = prod(numbers) if len(numbers) == len(factors) else Fraction(0)
    return any(value == Fraction(size) * foot for size in GRAVITIES for foot in _FEET)


def _in_feet(side: Side) -> Side:
    """Return a formula without the pounds, feet or inches behind it, which its constant is for."""
    if not isinstance(side.node, Product):
        return side
    *formula, unit = side.node.factors
    is_imperial = isinstance(unit, Number) and unit.value in (*_FEET, _POUND)
    if not is_imperial or not names(side.node):
        return side
    return replace(side, readings=(formula[0] if len(formula) == 1 else Product(tuple(formula)),))


def _is_of_gravity(part: Formula) -> bool:
    """Tell whether a product has a mass beside g, or a quotient a weight above it."""
    if isinstance(part, Quotient):
        below = part.denominator
        is_below = below == Name("g") or (isinstance(below, Product) and Name("g") in below.factors)
        return is_below and any(_WEIGHT.match(name) for name in names(part.numerator))
    if not isinstance(part, Product) or Name("g") not in part.factors:
        return False
    return any(isinstance(f, Name) and _WEIGHT.match(f.name) for f in part.factors)
