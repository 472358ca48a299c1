"""Certificates of verdicts: trees, premises and a proof that `verify_certificates` retraces alone.

Of a relation that holds, the proof is the identity of both sides once the letters' values are put in; of
one that is refuted, the witness; of one that holds to an order, how fast the difference falls, or the
rounding. A verdict whose proof cannot be retraced so (a derivative, an induction) says what is missing.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Formula, Name, names, walk
from symbalance.document.text_writer import formula_text
from symbalance.notes import verify_certificates
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.harmonics import polynomial_node
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.reports.typeset_relations import Sides, sides_by_span
from symbalance.notes.checking.verdicts import (
    CONDITIONAL,
    HOLDS,
    HOLDS_TO_ORDER,
    REFUTED,
    Checked,
    Verdict,
)

PROVED = (HOLDS, HOLDS_TO_ORDER, CONDITIONAL)
UNPROVED = (
    verify_certificates.Rejected,
    KeyError,
    ValueError,
    TypeError,
    ArithmeticError,
    RecursionError,
)
"""What tells that a proof cannot be retraced: rejected, or a function or letter it does not know."""
MOST_CANDIDATES = 8
"""Sides of a chain that a side may have been compared with, tried in turn."""


def certificates(checked: Checked) -> dict[str, Any]:
    """Return a certificate for each verdict that a proof stands behind, or why there is none."""
    sides = sides_by_span(checked.derivation)
    entries = [
        _certificate(verdict, sides)
        for verdict in checked.verdicts
        if verdict.verdict in (*PROVED, REFUTED)
    ]
    return {"format": 1, "document": checked.derivation.name, "certificates": entries}


def _certificate(verdict: Verdict, sides: Sides) -> dict[str, Any]:
    entry: dict[str, Any] = {
        "line": verdict.line,
        "link": verdict.link,
        "source": verdict.source,
        "verdict": verdict.verdict,
        "premises": [],
    }
    if verdict.sign:
        return entry | {"proof": "nothing", "why": "an arrow: it rests on the relation it leads to"}
    decision = verdict.decision
    if decision is None or verdict.node is None or decision.level is None:
        return entry | {"proof": "nothing", "why": verdict.reason or "no comparison of two sides"}
    if decision.of_matrices:
        return entry | {"proof": "nothing", "why": "matrices are not retraced: products would commute"}
    entry["premises"] = list(decision.assumptions)
    problem = "no proof that can be retraced was found for it"
    for left in _candidates(verdict, decision, sides):
        try:
            both = [_without_dots(each) if verdict.order else each for each in (left, verdict.node)]
            candidate = entry | _trees(both[0], both[1], decision.level.values)
        except NoFormError as unsupported:
            problem = str(unsupported)
            continue
        for proof in _proofs(verdict, decision):
            try:
                verify_certificates.verify(candidate | proof)
            except UNPROVED as why:
                problem = str(why) or problem
            else:
                return candidate | proof
    return entry | {"proof": "nothing", "why": problem}


def _candidates(verdict: Verdict, decision: Decision, sides: Sides) -> list[Formula]:
    """Return what the side may have been compared with: the sides before it, or the exact value."""
    chain, k = sides.get(verdict.span, (None, 0))
    before = [] if chain is None else [side.node for side in reversed(chain.sides[:k])]
    exact: list[Formula] = []
    is_exact_known = bool(verdict.bind) or verdict.verdict == REFUTED
    if decision.left is not None and decision.left.is_polynomial and is_exact_known:
        try:
            exact = [polynomial_node(decision.left.domain, decision.left.numerator)]
        except (NoFormError, TooLargeError):
            exact = []
    return [*before[:MOST_CANDIDATES], *exact]


def _proofs(verdict: Verdict, decision: Decision) -> list[dict[str, Any]]:
    """Return the proofs that a verdict may have, the strongest first."""
    if verdict.verdict == REFUTED:
        witness = dict(verdict.witness)
        values = {name: witness.pop(name, "") for name in ("left", "right")}
        return [{"proof": "witness", "witness": {"point": witness, **values}}]
    identity = {"proof": "identity"}
    printed = verdict.node.last_place if isinstance(verdict.node, formula.Number) else None
    if verdict.verdict == HOLDS_TO_ORDER and printed:
        return [{"proof": "digits", "place": str(printed)}]
    if verdict.verdict != HOLDS_TO_ORDER or decision.through is None:
        return [identity]
    return [identity, *_orders(decision)]


def _orders(decision: Decision) -> list[dict[str, Any]]:
    """Return the order as a proof in each letter that may be the small one: λ great, ρ small."""
    from symbalance.notes.algebra.values import letters, random_point

    if decision.left is None or decision.right is None:
        return []
    there = sorted({*letters(decision.left), *letters(decision.right)})
    point = {name: str(value) for name, value in random_point(there, decision.left.domain, 1).items()}
    return [
        {
            "proof": "order",
            "order": {"letter": name, "power": power, "through": decision.through, "point": point},
        }
        for name in there
        for power in (-1, 1)
    ]


def _without_dots(node: Formula) -> Formula:
    """Return a side without the dots at its end: what it claims to an order are the terms before."""
    if isinstance(node, formula.Sum):
        terms = tuple(_without_dots(term) for term in node.terms if not isinstance(term, formula.Dots))
        if not terms:  # dots alone claim nothing
            return node
        first, *others = terms
        return formula.Sum(terms) if others else first
    parts = formula.children(node)
    return formula.with_children(node, tuple(map(_without_dots, parts))) if parts else node


# Trees as lists


def _trees(left: Formula, right: Formula, values: Mapping[str, Formula]) -> dict[str, Any]:
    """Return both sides and the values of the letters in them, as trees, with what they say in words."""
    needed: dict[str, Any] = {}
    waiting = [*names(left), *names(right)]
    while waiting:
        name = waiting.pop()
        if name in values and name not in needed:
            needed[name] = values[name]
            waiting += names(values[name])
    return {
        "claim": f"{formula_text(left, plain=True)} = {formula_text(right, plain=True)}",
        "letters": {name: formula_text(node, plain=True) for name, node in needed.items()},
        "values": {name: tree(node) for name, node in needed.items()},
        "left": tree(left),
        "right": tree(right),
    }


_KINDS = {
    formula.Sum: "sum",
    formula.Product: "product",
    formula.Quotient: "quotient",
    formula.Power: "power",
}


def tree(node: Formula) -> list[Any]:
    """Return a formula as nested lists; NoFormError for a kind that is not retraced.

    >>> from symbalance.document.formula import number
    >>> tree(Name("r") / number(2))
    ['quotient', ['name', 'r'], ['number', '2']]
    """
    if isinstance(node, formula.Number):
        return ["number", str(node.value)]
    if isinstance(node, Name):
        return ["name", node.name]
    if isinstance(node, formula.Constant) and node.name in ("pi", "e", "i"):
        return ["constant", node.name]
    if isinstance(node, formula.Negative):
        return ["product", ["number", "-1"], tree(node.operand)]
    if isinstance(node, formula.Call) and node.function in verify_certificates.CALLS:
        return ["call", node.function, tree(node.argument)]
    if type(node) in _KINDS and not any(isinstance(part, formula.Dots) for part in walk(node)):
        return [_KINDS[type(node)], *map(tree, formula.children(node))]
    raise NoFormError(f"{type(node).__name__.lower()} is not retraced")
