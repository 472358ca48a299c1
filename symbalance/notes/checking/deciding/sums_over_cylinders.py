"""Sums over the cylinders that a page lists: ΣF_1, and Σ cos(φ + δ_i) with δ_i in words.

A sum without an index is taken as that of what its body comes to with the crank angle θ advanced to each
of the listed angles, θ + δ_1, θ + δ_2, ….
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from math import isclose, pi

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Sum,
    Summation,
    children,
    names,
    walk,
    with_children,
    with_parts_changed,
)
from symbalance.document.letters import is_greek
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.algebra.sums import indexed_letters
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.words.crank_angles_listed import FEWEST, CrankAngles
from symbalance.text import lazy_patterns as re

NO_ANGLES = "a sum over cylinders whose crank angles the page does not list here: say them"
OF_SOME_ORDERS = "it is true of some orders and not of others: say which are meant"
NO_BODY = "a sum over cylinders of what no line gives for one of them"
_MOMENT = re.compile(r"moment|couple|torque|偶力|モーメント", re.IGNORECASE)
_OF_CRANKS = frozenset(
    {"alpha", "beta", "gamma", "delta", "theta", "vartheta", "phi", "varphi", "psi", "epsilon"}
)
"""Letters that Σ cos α_i is of cranks by, where only an engine's name says where these stand."""
_PLACES = frozenset({"z", "x", "y", "l", "a", "b", "d", "s", "L", "ell"})
"""Letters of the cylinders' places along the crank, in the sums of couples."""
_PITCH, _ORIGIN = "Delta_z", "first_of_places"
"""What the places are written in where a page gives them no values."""
SPACED = "the cylinders stand at equal distances Δ_z, in the order of their numbers"
FROM_MIDDLE = "their places are counted from the middle"
_ORDER_LETTERS = frozenset({"n", "k", "p", "m", "i", "j", "h", "nu", "q"})
_FORCES = frozenset("FKPf")
_ORDERS = {"1": 1, "I": 1, "2": 2, "II": 2, "4": 4, "IV": 4, "6": 6, "VI": 6}
MOST_CYLINDERS = 60
"""Terms of a sum over equally spaced cylinders, at most."""
_ANY_ANGLE = "theta"
_INDICES = ("i", "j", "k", "n", "z")
DEEPEST = 12
"""Letters that stand for others, one in the other."""
Decide = Callable[[Formula, Formula], Decision]


def decide_over_cylinders(
    left: Formula, right: Formula, knowledge: Knowledge, decide: Decide
) -> Decision:
    """Decide a relation, the sums over cylinders in it written out by the angles that the page lists.

    Where the words leave two sets of angles open, it is refuted only if it is false for both.
    """
    if is_of_arguments(left) or is_of_arguments(right):
        return Decision(UNDECIDED, "a letter before a bracket of angles: a factor, or a function of them")
    if knowledge.crank_angles is not None:
        left, right = (_with_sums_named(node, knowledge) for node in (left, right))
    left, right = (_with_bounds(node, knowledge) for node in (left, right))
    (left, left_count), (right, right_count) = (_over_one_turn(node, knowledge) for node in (left, right))
    if count := left_count or right_count:
        decision = decide_over_cylinders(left, right, knowledge, decide)
        over_all = f"the sum runs over all {count}, which are spaced equally"
        return replace(decision, assumptions=(*decision.assumptions, over_all))
    return _decide_by_rule(left, right, knowledge, decide) or _decide_by_angles(
        left, right, knowledge, decide
    )


def _decide_by_angles(left: Formula, right: Formula, knowledge: Knowledge, decide: Decide) -> Decision:
    """Decide a relation with its sums written out for each set of angles that the words leave open."""
    is_unsaid = any(_is_without_index(part) for node in (left, right) for part in walk(node))
    listed = knowledge.crank_angles
    last: Decision | None = None
    ways = (
        []
        if listed is None
        else [
            (angles, t)
            for a in (listed, *listed.others)
            for angles in _either_way(a)
            for t in _angles_at(left, right, knowledge)
        ]
    )
    is_ruled = any(_has_own_phases(part, knowledge) for node in (left, right) for part in walk(node))
    for angles, theta in ways:
        known = _with_orders(left, right, angles, knowledge, theta)
        try:
            first, second = (
                _with_own_orders(_written_out(node, angles, known, theta), known, knowledge)
                for node in (left, right)
            )
        except (NoFormError, TooLargeError) as problem:
            return Decision(UNDECIDED, str(problem))
        if first is left and second is right:
            break
        decision = _decide_at_places(first, second, decide)
        is_open = known is not knowledge or _PITCH in names(first) | names(second)
        if is_open and not _is_settled_of_any_size(decision, first, second, decide):
            continue
        decision = replace(decision, assumptions=(*decision.assumptions, angles.text))
        if angles.is_usual and decision.status == REFUTED and _open_order(left, right, knowledge):
            decision = Decision(UNDECIDED, OF_SOME_ORDERS)
        if _PITCH in names(first) | names(second) and decision.status == REFUTED:
            decision = replace(
                decision, reason="; ".join(filter(None, (f"if {SPACED}", decision.reason)))
            )
        if angles.is_usual and not decision.is_proved:
            decision = replace(
                decision, reason="; ".join(filter(None, (f"if {angles.text}", decision.reason)))
            )
        if decision.is_proved and angles.is_against and is_ruled:
            decision = Decision(UNDECIDED, f"true if {angles.text}: say which way they are counted")
        if decision.is_proved:
            return decision
        last = decision if last is None or decision.status == UNDECIDED else last
    if last is not None:
        return last
    decision = decide(left, right)
    is_unsaid = is_unsaid and decision.status == UNDECIDED
    reason = NO_ANGLES if listed is None else f"{NO_BODY} ({listed.text})"
    return replace(decision, reason=reason) if is_unsaid else decision


def _with_sums_named(node: Formula, knowledge: Knowledge) -> Formula:
    """Return a formula with the sums over cylinders put in that letters stand for: S_2 = Σ cos 2α_k."""
    for name in sorted(names(node) & knowledge.definitions.keys()):
        value = knowledge.definitions[name].node
        if any(map(_is_without_index, walk(value))):
            node = substitute(node, name, value)
    return node


def _either_way(angles: CrankAngles) -> tuple[CrankAngles, ...]:
    """Return angles as by how much the cranks are ahead, and behind: cranks at 0°, 90° may be either.

    One way is enough where both are the same set.
    """
    against = replace(angles, is_against=True)
    is_same = sorted(a % 360 for a in angles.degrees) == sorted(-a % 360 for a in angles.degrees)
    return (angles,) if is_same or angles.is_usual or angles.signs else (angles, against)


def _open_order(left: Formula, right: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a sum is of waves of an order that is a letter without a value."""
    orders = {
        factor.name
        for node in (left, right)
        for call in walk(node)
        if isinstance(call, Call) and call.function in ("sin", "cos")
        for part in walk(call.argument)
        if isinstance(part, Product)
        for factor in part.factors
        if isinstance(factor, Name) and factor.name in _ORDER_LETTERS
    }
    return any(name not in knowledge.definitions for name in orders)


def _decide_at_places(left: Formula, right: Formula, decide: Decide) -> Decision:
    """Decide a relation with the cylinders' places evenly spaced, counted from anywhere.

    What is true where they are counted from the middle is so on that condition.
    """
    if _ORIGIN not in names(left) | names(right):
        return decide(left, right)
    anywhere = decide(left, right)
    if anywhere.is_proved:
        return replace(anywhere, assumptions=(*anywhere.assumptions, SPACED))
    zero = Number(Fraction(0))
    middle = decide(*(substitute(node, _ORIGIN, zero) for node in (left, right)))
    if middle.is_proved:
        return replace(middle, assumptions=(*middle.assumptions, SPACED, FROM_MIDDLE))
    return anywhere if anywhere.status == UNDECIDED else middle


def _with_orders(
    left: Formula, right: Formula, angles: CrankAngles, knowledge: Knowledge, theta: Formula | None
) -> Knowledge:
    """Return what is known with the forces of an order that no line defines: F_2 is some F cos 2θ.

    Only where an engine's name says the cranks, of letters that a sum without an index goes over.
    """
    if not angles.is_usual:
        return knowledge
    angle = theta.name if isinstance(theta, Name) else _ANY_ANGLE
    values: dict[str, Formula] = {}
    for part in (p for node in (left, right) for p in walk(node)):
        body = part.body if isinstance(part, Summation) and part.index is None else None
        stem, _, index = body.name.rpartition("_") if isinstance(body, Name) else ("", "", "")
        is_force = stem in _FORCES and index in _ORDERS
        if is_force and isinstance(body, Name) and not knowledge.knows(body.name):
            wave = Call("cos", Product((Number(Fraction(_ORDERS[index])), Name(angle))))
            values[body.name] = Product((Name(f"hat_{body.name}"), wave))
    if not values:
        return knowledge
    return replace(
        knowledge, meaning=replace(knowledge.meaning, values={**knowledge.meaning.values, **values})
    )


def _with_own_orders(node: Formula, known: Knowledge, knowledge: Knowledge) -> Formula:
    """Return a formula with the forces of an order that no line defines written out: 4 F_2."""
    for name in sorted(names(node)) if known is not knowledge else ():
        if name in known.meaning.values and name not in knowledge.meaning.values:
            node = substitute(node, name, known.meaning.values[name])
    return node


def _is_settled_of_any_size(decision: Decision, first: Formula, second: Formula, decide: Decide) -> bool:
    """Tell whether a decision stands whatever the size of the forces: what is 0 is so of any."""
    zero = Number(Fraction(0))
    if decision.is_proved or second == zero:
        return True
    return decide(first, zero).is_proved or decide(second, zero).is_proved


def _angles_at(left: Formula, right: Formula, knowledge: Knowledge) -> list[Formula | None]:
    """Return the crank angle as what a listed angle may be counted from.

    Where none is declared, θ_i of a sum may be θ + δ_i, of a letter θ that is free, or δ_i alone.
    """
    if (own := _turning_in_bodies(left, right, knowledge)) is not None:
        return [own]
    stems = {
        name.rpartition("_")[0]
        for node in (left, right)
        for part in walk(node)
        if isinstance(part, Summation) and part.index is not None
        for name in indexed_letters(part.body, part.index.name)
    }
    beside = names(left) | names(right)
    firsts = [n for stem in sorted(stems) for n in (stem, f"{stem}_1") if n in beside and is_greek(stem)]
    if len(firsts) == 1 and not knowledge.knows(firsts[0]):
        return [Name(firsts[0])]  # Σ cos 2φ_i = 4 cos 2φ, or 4 cos 2φ_1
    if knowledge.crank is not None and knowledge.crank.theta is not None:
        return [knowledge.crank.theta]
    wholes = sorted(stem for stem in stems if is_greek(stem) and not knowledge.knows(stem))
    return [*map(Name, wholes[:1]), None]


def _with_bounds(node: Formula, knowledge: Knowledge) -> Formula:
    """Return a formula, its sums over k alone with the bounds that the page says: k = 1, 2, 3."""
    parts = tuple(_with_bounds(part, knowledge) for part in children(node))
    node = with_children(node, parts) if parts else node
    if not isinstance(node, Summation) or node.index is None or node.lower or node.upper:
        return node
    lower, upper = set[Formula](), set[Formula]()
    for stated in knowledge.ranges:
        if stated.sign == "≤" and stated.right == node.index and isinstance(stated.left, Number):
            lower.add(stated.left)
        if stated.sign == "≤" and stated.left == node.index and isinstance(stated.right, Number):
            upper.add(stated.right)
    is_one = len(lower) == len(upper) == 1
    return replace(node, lower=lower.pop(), upper=upper.pop()) if is_one else node


def _over_one_turn(node: Formula, knowledge: Knowledge) -> tuple[Formula, int]:
    """Return a formula, its sums of cos(θ - k α) over k alone with bounds, and how many terms they have.

    With α = 360°/9 there are nine, whichever k is the first; 0 where there is no such sum.
    """
    parts = [_over_one_turn(part, knowledge) for part in children(node)]
    count = max((number for _, number in parts), default=0)
    node = with_children(node, tuple(part for part, _ in parts)) if count else node
    if not isinstance(node, Summation) or node.index is None or node.lower or node.upper:
        return node, count
    steps = {
        factor
        for product in walk(node.body)
        if isinstance(product, Product) and node.index in product.factors
        for factor in product.factors
        if isinstance(factor, Name) and factor != node.index
    }
    step = steps.pop() if len(steps) == 1 else None
    if step is None or _stands_elsewhere(node.index, node.body, step):
        return node, count
    own = _parts_of_a_turn(step, knowledge)
    if not own:
        return node, count
    return replace(node, lower=Number(Fraction(0)), upper=Number(Fraction(own - 1))), own


def _decide_by_rule(
    left: Formula, right: Formula, knowledge: Knowledge, decide: Decide
) -> Decision | None:
    """Return the proof of a sum over j alone, where a rule spaces its angles: β_j = 120° (j - 1).

    It is taken over one turn. What is not proved so may run over more, and is judged otherwise.
    """
    (first, left_count), (second, right_count) = (_over_rule(node, knowledge) for node in (left, right))
    count = left_count or right_count
    if not count or {left_count, right_count} - {0, count}:
        return None
    there = decide(first, second)
    if not there.is_proved:
        return None
    over_all = f"the sum runs over all {count}, which are spaced equally"
    return replace(there, assumptions=(*there.assumptions, over_all))


def _over_rule(node: Formula, knowledge: Knowledge) -> tuple[Formula, int]:
    """Return a formula, its sums of waves of a ruled letter in bounds, and their number of terms."""
    parts = [_over_rule(part, knowledge) for part in children(node)]
    count = max((number for _, number in parts), default=0)
    node = with_children(node, tuple(part for part, _ in parts)) if count else node
    if not isinstance(node, Summation) or node.index is None or node.lower or node.upper:
        return node, count
    index = node.index.name
    ruled = [
        name
        for name in indexed_letters(node.body, index)
        if name in knowledge.definitions and index in names(knowledge.definitions[name].node)
    ]
    of_index = {index, *indexed_letters(node.body, index)}
    if len(ruled) != 1 or _stands_outside_waves(of_index, node.body):
        return node, count
    rule = knowledge.definitions[ruled[0]].node
    at = [substitute(rule, index, Number(Fraction(n))) for n in (1, 2, 3)]
    steps = [Sum((later, Negative(earlier))) for earlier, later in pairwise(at)]
    own = [_parts_of_a_turn(step, knowledge) for step in steps]
    if not own[0] or own[0] != own[1]:
        return node, count
    return replace(node, lower=Number(Fraction(1)), upper=Number(Fraction(own[0]))), own[0]


def is_of_arguments(node: Formula) -> bool:
    """Tell whether a sum has its angles in brackets behind a letter, perhaps a function: T(θ + φ_j)."""
    for part in walk(node):
        if isinstance(part, Summation) and part.index is not None:
            angles = [n for n in indexed_letters(part.body, part.index.name) if is_greek(n.split("_")[0])]
            if any(_is_argument(part.body, angle) for angle in angles):
                return True
    return False


def _is_argument(node: Formula, angle: str) -> bool:
    """Tell whether an angle stands in a bracket without waves, right behind a letter."""
    if isinstance(node, Call):
        return False
    factors = node.factors if isinstance(node, Product) else ()
    for first, second in pairwise(factors):
        is_bracket = isinstance(second, Sum) and not any(isinstance(p, Call) for p in walk(second))
        if isinstance(first, Name) and is_bracket and angle in names(second):
            return True
    return any(_is_argument(part, angle) for part in children(node))


def _stands_outside_waves(letters: set[str], node: Formula) -> bool:
    """Tell whether one of some letters stands in a formula outside its sines and cosines."""
    if isinstance(node, Call) and node.function in ("sin", "cos"):
        return False
    if isinstance(node, Name):
        return node.name in letters
    return any(_stands_outside_waves(letters, part) for part in children(node))


def _stands_elsewhere(index: Name, node: Formula, step: Name) -> bool:
    """Tell whether an index stands outside the angles k α of sines, cosines and powers of e."""
    if node == index:
        return True
    if isinstance(node, Product) and {index, step} <= {*node.factors}:
        return any(
            _stands_elsewhere(index, part, step) for part in node.factors if part not in (index, step)
        )
    return any(_stands_elsewhere(index, part, step) for part in children(node))


def _parts_of_a_turn(angle: Formula, knowledge: Knowledge) -> int:
    """Return into how many equal parts an angle divides the turn, 0 where it does not."""
    node = _with_values(angle, knowledge)
    points = [] if names(node) else sample_trees([node], knowledge.meaning, 1)
    value = abs(float(points[0][1][0].real)) if points else 0.0
    parts = round(2 * pi / value) if value else 0
    return parts if FEWEST <= parts <= MOST_CYLINDERS and isclose(parts * value, 2 * pi) else 0


def _turning_in_bodies(left: Formula, right: Formula, knowledge: Knowledge) -> Name | None:
    """Return the one free letter that what is summed turns with, where it is not the crank angle known.

    On a page that declares nothing, φ of F_1 = m r ω² cos φ.
    """
    known = names(knowledge.crank.theta) if knowledge.crank is not None else frozenset[str]()
    turning: set[str] = set()
    for part in (p for node in (left, right) for p in walk(node)):
        if not isinstance(part, Summation) or part.index is not None or not names(part.body):
            continue
        body = _with_values(part.body, knowledge)
        turning |= {
            name
            for call in walk(body)
            if isinstance(call, Call) and call.function in ("sin", "cos")
            for name in names(call.argument)
            if is_greek(name)
            and name not in knowledge.letters
            and name.rpartition("_")[2] not in _INDICES
        }
    return Name(next(iter(turning))) if len(turning) == 1 and not turning & known else None


def _with_values(node: Formula, knowledge: Knowledge) -> Formula:
    """Return a formula with the values of its letters put in, as deep as they go."""
    values = {n: d.node for n, d in knowledge.definitions.items()}
    for _ in range(DEEPEST):
        own = [name for name in sorted(names(node)) if name in values and name not in names(values[name])]
        if not own:
            break
        for name in own:
            node = substitute(node, name, values[name])
    return node


def _is_without_index(node: Formula) -> bool:
    return isinstance(node, Summation) and (node.index is None or node.upper is None)


def _written_out(
    node: Formula, angles: CrankAngles, knowledge: Knowledge, theta: Formula | None
) -> Formula:
    """Return a formula with its sums over cylinders as sums of terms, itself where there are none."""
    if isinstance(node, Summation):
        terms = _terms(node, angles, knowledge, theta)
        return node if terms is None else Sum(tuple(terms))
    return with_parts_changed(node, lambda part: _written_out(part, angles, knowledge, theta))


def _terms(
    node: Summation, angles: CrankAngles, knowledge: Knowledge, theta: Formula | None
) -> list[Formula] | None:
    """Return the terms of a sum, one a cylinder; None where it is not one over the listed angles."""
    node = _with_index(node)
    if node.index is not None:
        node = replace(node, body=_with_own_phases(node.body, node.index.name, knowledge))
        return _by_own_values(node, knowledge) or _indexed_terms(node, angles, knowledge, theta)
    if any(_is_moment(name, knowledge) for name in names(node.body)):
        return None  # the lever arms of the cylinders are not listed with their angles
    if angles.signs and isinstance(node.body, Name) and not knowledge.knows(node.body.name):
        return _opposed_terms(node.body, angles)
    is_of_order = isinstance(node.body, Name) and f"hat_{node.body.name}" in _value_names(
        node.body, knowledge
    )
    theta = Name(_ANY_ANGLE) if is_of_order and theta is None else theta
    if not isinstance(theta, Name):
        return None
    body = _in_angle(node.body, theta.name, knowledge)
    if theta.name not in names(body):
        return None
    terms = [substitute(body, theta.name, Sum((theta, angle))) for angle in angles.nodes]
    signs = angles.signs or (1,) * len(terms)
    return [term if sign > 0 else Negative(term) for sign, term in zip(signs, terms, strict=True)]


def _indexed_terms(
    node: Summation, angles: CrankAngles, knowledge: Knowledge, theta: Formula | None
) -> list[Formula] | None:
    assert node.index is not None
    index = node.index.name
    indexed = indexed_letters(node.body, index)
    own = [name for name in indexed if is_greek(name.split("_")[0])]
    places = [name for name in indexed if name not in own]
    is_of_places = len(places) == 1 and places[0].split("_")[0] in _PLACES and not angles.signs
    is_known = any(knowledge.knows(name) for name in (*indexed, _PITCH))
    if len(own) != 1 or is_known or (places and not is_of_places):
        return None
    is_of_cranks = not angles.signs and own[0].split("_")[0] in _OF_CRANKS
    if angles.is_usual and not (is_of_cranks and _turns_with(node.body, own[0])):
        return None
    arms = angles.arms or () if angles.is_usual else _even_arms(len(angles.degrees))
    if places and len(arms) != len(angles.degrees):
        return None
    stem = own[0][: -len(index)]
    first = node.lower.value if isinstance(node.lower, Number) else Fraction(1)
    since = {n for n, d in knowledge.definitions.items() if d.line >= angles.line}  # no others'
    numbers = {n[len(stem) :] for n in since if n.startswith(stem)}
    if any(number.isdecimal() and int(number) >= first for number in numbers):
        return None  # δ_1, δ_2 have values of their own; θ_0 is no cylinder of a sum from 1
    if node.upper is not None and _count(node, knowledge) != len(angles.degrees):
        return None
    # Σ cos θ_i is of whole angles; beside θ, in cos(θ + θ_i), they are those of the cranks
    is_beside = isinstance(theta, Name) and theta.name in names(node.body)
    stem = own[0].split("_")[0]
    is_whole_angle = isinstance(theta, Name) and theta.name in (stem, f"{stem}_1") and not is_beside
    nodes = angles.nodes
    values = [Sum((theta, a)) if is_whole_angle and theta is not None else a for a in nodes]
    bodies = [substitute(node.body, own[0], value) for value in values]
    if places:
        at = [Sum((Name(_ORIGIN), Product((rational_node(arm), Name(_PITCH))))) for arm in arms]
        bodies = [substitute(body, places[0], place) for body, place in zip(bodies, at, strict=True)]
    counts = [Number(first + place) for place in range(len(bodies))]
    return [substitute(b, index, n) for b, n in zip(bodies, counts, strict=True)]


def _by_own_values(node: Summation, knowledge: Knowledge) -> list[Formula] | None:
    """Return the terms of a sum whose letters all have values one by one, δ_1, δ_2, …; else None."""
    assert node.index is not None
    index = node.index.name
    first = int(node.lower.value) if isinstance(node.lower, Number) else 1
    stems = {name: name[: -len(index)] for name in indexed_letters(node.body, index)}
    lists = [
        sorted(
            int(n[len(stem) :])
            for n in knowledge.definitions
            if n.startswith(stem) and n[len(stem) :].isdecimal() and int(n[len(stem) :]) >= first
        )
        for stem in stems.values()
    ]
    numbers = lists[0] if lists else []
    if len(numbers) < FEWEST or any(own != numbers for own in lists):
        return None
    if numbers != list(range(first, first + len(numbers))):
        return None
    if node.upper is not None and _count(node, knowledge) != len(numbers):
        return None
    terms: list[Formula] = []
    for number in numbers:
        term = node.body
        for name, stem in stems.items():
            term = substitute(term, name, Name(f"{stem}{number}"))
        terms.append(substitute(term, index, Number(Fraction(number))))
    return terms


def _has_own_phases(node: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a formula is a sum of angles that a line gives by the phases: θ_i = θ - δ_i."""
    if not isinstance(node, Summation) or node.index is None:
        return False
    return _with_own_phases(node.body, node.index.name, knowledge) != node.body


def _with_own_phases(body: Formula, index: str, knowledge: Knowledge) -> Formula:
    """Return what is summed with the angle of any one cylinder as a line gives it: θ_i = θ - δ_i."""
    for name in indexed_letters(body, index):
        stem = name[: -len(index)]
        rules = [(other, knowledge.definitions.get(stem + other)) for other in (index, *_INDICES)]
        for other, rule in rules:
            if rule is None or not is_greek(stem.split("_")[0]):
                continue
            phases = indexed_letters(rule.node, other)
            if len(phases) == 1 and phases[0] != name and is_greek(phases[0].split("_")[0]):
                phase = Name(phases[0][: -len(other)] + index)
                body = substitute(body, name, substitute(rule.node, phases[0], phase))
            break
    return body


def _count(node: Summation, knowledge: Knowledge) -> Fraction | None:
    """Return how many terms a sum with bounds has, None where these are no numbers."""
    last = None if node.upper is None else _number(node.upper, knowledge)
    is_number = last is not None and isinstance(node.lower, Number)
    return (
        last.value - node.lower.value + 1
        if is_number and last and isinstance(node.lower, Number)
        else None
    )


def _even_arms(count: int) -> tuple[Fraction, ...]:
    """Return the places of so many cylinders from the middle, over their distance."""
    return tuple(Fraction(2 * k - count + 1, 2) for k in range(count))


def _opposed_terms(body: Name, angles: CrankAngles) -> list[Formula] | None:
    """Return forces of which nothing is known, one a cylinder: those at one crank angle are alike.

    None where they do not all cancel, since nothing else is known of them.
    """
    if body.name.split("_")[0] not in _FORCES:
        return None
    sums: dict[Fraction, int] = {}
    for degrees, sign in zip(angles.degrees, angles.signs, strict=True):
        sums[degrees] = sums.get(degrees, 0) + sign
    return None if any(sums.values()) else [Number(Fraction(0))]


def _value_names(node: Name, knowledge: Knowledge) -> frozenset[str] | set[str]:
    value = knowledge.meaning.values.get(node.name)
    return names(value) if value is not None else set()


def _with_index(node: Summation) -> Summation:
    """Return a sum without an index with that of the angles in it: Σ cos 2α_i."""
    if node.index is not None:
        return node
    indices = {
        index
        for name in names(node.body)
        for stem, _, index in [name.rpartition("_")]
        if index in _INDICES and is_greek(stem)
    }
    return replace(node, index=Name(next(iter(indices)))) if len(indices) == 1 else node


def _turns_with(node: Formula, name: str) -> bool:
    """Tell whether an angle stands only in sines and cosines of whole multiples: what a turn repeats."""
    if isinstance(node, Call) and node.function in ("sin", "cos"):
        return _whole_multiple(node.argument, name) is not None
    if isinstance(node, Name):
        return node.name != name
    return all(_turns_with(part, name) for part in children(node))


def _whole_multiple(node: Formula, name: str) -> Fraction | None:
    """Return how many times an angle is in an argument, None where that is no whole number."""
    if name not in names(node):
        return Fraction(0)
    if isinstance(node, Name):
        return Fraction(1)
    parts = [_whole_multiple(part, name) for part in children(node)]
    if isinstance(node, Sum):
        return Fraction(1) if all(part is not None for part in parts) else None
    if isinstance(node, Negative):
        return parts[0]
    if isinstance(node, Product):
        own = [p for p in node.factors if name in names(p)]
        others = [p for p in node.factors if name not in names(p)]
        is_whole = all(
            (isinstance(p, Number) and p.value.denominator == 1)
            or (isinstance(p, Name) and p.name in _ORDER_LETTERS)
            for p in others
        )
        return _whole_multiple(own[0], name) if len(own) == 1 and is_whole else None
    return None


def _is_moment(name: str, knowledge: Knowledge) -> bool:
    """Tell whether a letter is a moment or a couple, by its meaning or by its usual letter."""
    return name.startswith("M") or _MOMENT.search(knowledge.meanings.get(name, "")) is not None


def _number(node: Formula, knowledge: Knowledge) -> Number | None:
    if isinstance(node, Name) and node.name in knowledge.definitions:
        node = knowledge.definitions[node.name].node
    return node if isinstance(node, Number) else None


def _in_angle(node: Formula, theta: str, knowledge: Knowledge) -> Formula:
    """Return a formula with the letters that depend on the crank angle written out in it."""
    values = {**{n: d.node for n, d in knowledge.definitions.items()}, **knowledge.meaning.values}
    for _ in range(DEEPEST):
        depends = [
            name
            for name in sorted(names(node) - {theta})
            if name in values and theta in names_behind(values[name], values)
        ]
        if not depends:
            return node
        for name in depends:
            node = substitute(node, name, values[name])
    raise TooLargeError("definitions nested too deep")
