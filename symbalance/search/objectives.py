"""What a search asks of a crank: forces, couples, bending, bearing loads, torsional sums, firing.

An objective of a star is the largest of some groups, each the sum of one or two sizes |sum of w_p
zeta^...| over the pins: both halves of a couple of a vee, every section of a crank that bends. One of a
firing order is such a sum over the moments of a cycle, or a count.

    force.n, couple.n   the largest over a turn, F_n and F_n a; the couple about the stations' mean
    bending             the largest bending moment of the rotating forces, m r omega^2 a; the crank is a
                        beam on two supports, half a pitch before its first and behind its last throw
    bearing             the largest load of a main bearing by the throws beside it, half of each
    torsion.q           |sum of a_j e^(i q t_j)|: a_j the mode shape at cylinder j, t_j when it fires; the
                        k-th mode given is torsion.q:k
    adjacent            how often two neighbours of a bank fire one after the other
    evenness            the longest interval between firings less the shortest, degrees
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

from symbalance.errors import SymbalanceError, brief
from symbalance.search.problem import SearchProblem, Seat
from symbalance.text.numbers import as_list, exact

HIGHEST_ORDER = 100
UNITS = {
    "force": "Fₙ",
    "couple": "Fₙ a",
    "bending": "m r ω² a",
    "bearing": "m r ω²",
    "torsion": "",
    "adjacent": "",
    "evenness": "°",
}
MEANINGS = {
    "force": "the free force of order n, largest over a turn, in Fₙ",
    "couple": "the free couple of order n, largest over a turn, in Fₙ a, about the stations' mean",
    "bending": "the largest bending moment of the rotating forces along the crank, in m r ω² a",
    "bearing": "the largest load of a main bearing, half of each throw beside it, in m r ω²",
    "torsion": "the vector sum of torsional order q: mode shape times e^(i q t) of each firing",
    "adjacent": "how often two neighbours in a bank fire one after the other, in a cycle",
    "evenness": "the longest interval between firings less the shortest, degrees",
}
_NAME = re.compile(r"(force|couple)\.([0-9]{1,3})|torsion\.([0-9]{1,3}(?:\.5)?)(?::([0-9]{1,2}))?|[a-z]+")
_CONDITION = re.compile(r"\s*([^<>=\s]+)\s*(<=|=)\s*([^<>=]+)")


@dataclass(frozen=True)
class Form:
    """A weighted sum over cylinders: weight times e^(2 pi i turns) of each on its ray, then |.|.

    `weights` holds for each seat (by its cylinder's number) a rational, a fixed angle in turns, and the
    multiple of the throw that turns it.
    """

    weights: dict[int, tuple[Fraction, Fraction, Fraction]]


@dataclass(frozen=True)
class Objective:
    """One quantity of a star or of its firing order: groups of sums, or a count."""

    name: str
    kind: str
    order: Fraction = Fraction(0)
    groups: tuple[tuple[Form, ...], ...] = ()
    by_firing: bool = False
    """Whether it depends on the firing order, not on the star alone."""

    @property
    def is_count(self) -> bool:
        """Whether it is a rational counted from the firing order."""
        return self.kind in ("adjacent", "evenness")


@dataclass(frozen=True)
class Condition:
    """What an objective must be: at most `limit`, or equal to it."""

    name: str
    limit: Fraction
    exactly: bool = False

    def words(self) -> str:
        """Return the condition as it is written."""
        return f"{self.name}{'=' if self.exactly else '<='}{self.limit}"


@dataclass(frozen=True)
class After:
    """What has been balanced beforehand: the crank by counterweights, some orders by shafts."""

    counterweights: bool = False
    orders: tuple[int, ...] = ()

    def words(self) -> str:
        """Return it in words, empty where there is nothing."""
        parts = ["counterweights"] if self.counterweights else []
        parts += [f"balance shafts of order {', '.join(map(str, self.orders))}"] if self.orders else []
        return " and ".join(parts)


def read_after(after: object) -> After:
    """Return what `after` says: "counterweights", ("balance-shafts", 1, 2), or None."""
    if after is None:
        return After()
    words = [str(word) for word in as_list([after] if isinstance(after, str) else after, "after")]
    orders, counterweights, shafts = [], False, False
    for word in (part for text in words for part in re.split(r"[\s,]+", text) if part):
        if word == "counterweights":
            counterweights = True
        elif word == "balance-shafts":
            shafts = True
        elif shafts and word.isascii() and word.isdigit() and 1 <= int(word[:4]) <= HIGHEST_ORDER:
            orders.append(int(word))
        else:
            rule = "must be counterweights, or balance-shafts and their orders"
            raise SymbalanceError(f"after = {brief(word)}", rule, "as balance-shafts 1")
    if shafts and not orders:
        raise SymbalanceError("after = balance-shafts", "names no order", "as balance-shafts 1")
    return After(counterweights, tuple(sorted(set(orders))))


def read_conditions(require: Sequence[str], limit: Sequence[str]) -> tuple[Condition, ...]:
    """Return conditions such as couple.1=0 (`require`) and couple.2<=0.5 (`limit`)."""
    conditions = []
    for texts, sign, example in ((require, "=", "couple.1=0"), (limit, "<=", "couple.2<=0.5")):
        for text in texts:
            match = _CONDITION.fullmatch(text)
            if match is None or match[2] != sign:
                raise SymbalanceError(
                    f"condition {brief(text)}", f"must have the form NAME{sign}VALUE", f"as {example}"
                )
            value = exact(match[3].strip(), match[1], 10**9)
            if value < 0:
                raise SymbalanceError(
                    f"condition {brief(text)}", "can never hold: no size is negative", "take 0 or more"
                )
            conditions.append(Condition(match[1], value, sign == "="))
    return tuple(conditions)


def read_modes(modes: Sequence[Sequence[object]], count: int) -> tuple[tuple[Fraction, ...], ...]:
    """Return mode shapes, one value for each cylinder by its number; without any, all are 1."""
    shapes = []
    for mode in modes:
        shape = tuple(exact(value, "mode", 10**6) for value in as_list(mode, "mode", "[1, 0.8, 0.3]"))
        if len(shape) != count:
            raise SymbalanceError(
                f"mode of {len(shape)} values", f"must have {count}", "one for each cylinder"
            )
        shapes.append(shape)
    return tuple(shapes)


def read_objective(
    name: str, problem: SearchProblem, after: After, modes: tuple[tuple[Fraction, ...], ...]
) -> Objective:
    """Return the quantity that a name means, for the cylinders of a problem.

    >>> from symbalance.search.problem import search_problem
    >>> read_objective("couple.1", search_problem(4), After(), ()).kind
    'couple'
    """
    match = _NAME.fullmatch(name)
    kind = name.partition(".")[0]
    if match is None or kind not in MEANINGS or (kind != name and not (match[2] or match[3])):
        names = "force.N, couple.N, bending, bearing, torsion.Q, adjacent, evenness"
        raise SymbalanceError(f"quantity {brief(name)}", f"is none of {names}", "as couple.1")
    if kind in ("force", "couple", "torsion") and kind == name:
        raise SymbalanceError(f"quantity {name}", "needs an order", f"as {name}.1")
    seats = [seat for pin in problem.seats for seat in pin]
    if kind in ("force", "couple"):
        order = int(match[2])
        if not 1 <= order <= HIGHEST_ORDER:
            raise SymbalanceError(f"quantity {name}", f"must have an order of 1 to {HIGHEST_ORDER}")
        return Objective(name, kind, Fraction(order), _halves(kind, order, seats, problem, after))
    if kind == "torsion":
        return _torsion(name, match[3], match[4], seats, problem, modes)
    if kind == "bending":
        return Objective(name, kind, Fraction(1), _sections(seats))
    if kind == "bearing":
        return Objective(name, kind, Fraction(1), _bearings(seats))
    return Objective(name, kind, by_firing=True)


def _halves(
    kind: str, order: int, seats: list[Seat], problem: SearchProblem, after: After
) -> tuple[tuple[Form, ...], ...]:
    """Return the two halves of an order, which turn with and against the crank: their sizes add up.

    In one bank they are conjugate, and one sum has the size of both.
    """
    if order in after.orders:
        return ()
    half = Fraction(1, 2)
    levers = {s.number: Fraction(1) if kind == "force" else s.station for s in seats}
    forward = {s.number: (levers[s.number] * half, (1 - order) * s.bank, Fraction(order)) for s in seats}
    backward = {
        s.number: (levers[s.number] * half, (-1 - order) * s.bank, Fraction(order)) for s in seats
    }
    if after.counterweights and order == 1:
        return ((Form(backward),),)
    if len(problem.banks) == 1:
        whole = {number: (2 * w, Fraction(0), turn) for number, (w, _, turn) in forward.items()}
        return ((Form(whole),),)
    return ((Form(forward), Form(backward)),)


def _torsion(
    name: str,
    order_text: str,
    mode_text: str | None,
    seats: list[Seat],
    problem: SearchProblem,
    modes: tuple[tuple[Fraction, ...], ...],
) -> Objective:
    order, mode = Fraction(order_text), int(mode_text or 1)
    shapes = modes or ((Fraction(1),) * problem.cylinders,)
    if not 1 <= mode <= len(shapes):
        raise SymbalanceError(
            f"quantity {name}", f"names mode {mode} of {len(shapes)}", "give it with --mode"
        )
    if not 0 < order <= HIGHEST_ORDER or (order.denominator > 1 and problem.strokes == 2):
        rule = "must have a whole order" if problem.strokes == 2 else "must have an order above 0"
        raise SymbalanceError(f"quantity {name}", rule, "half orders are of four-strokes")
    shape = shapes[mode - 1]
    # A cylinder fires when its bank less its throw has passed; conjugate, so that throws count forward.
    weights = {s.number: (shape[s.number - 1], -order * s.bank, order) for s in seats}
    return Objective(name, "torsion", order, ((Form(weights),),), order.denominator > 1)


def _sections(seats: list[Seat]) -> tuple[tuple[Form, ...], ...]:
    """Return the bending moment at every throw: between two it is never larger than at one of them."""
    stations = sorted({s.station for s in seats})
    rear, length = stations[0] - Fraction(1, 2), stations[-1] - stations[0] + 1

    def influence(at: Fraction, load: Fraction) -> Fraction:
        u, v = sorted(((at - rear) / length, (load - rear) / length))
        return length * u * (1 - v)

    return tuple(
        (Form({s.number: (influence(at, s.station), Fraction(0), Fraction(1)) for s in seats}),)
        for at in stations
    )


def _bearings(seats: list[Seat]) -> tuple[tuple[Form, ...], ...]:
    """Return the load of every main bearing between two rows, and of the two at the ends."""
    rows: dict[Fraction, list[Seat]] = {}
    for seat in seats:
        rows.setdefault(seat.station, []).append(seat)
    ordered = [rows[station] for station in sorted(rows)]
    beside = [ordered[0], *(front + rear for front, rear in pairwise(ordered)), ordered[-1]]
    half = Fraction(1, 2)
    return tuple((Form({s.number: (half, Fraction(0), Fraction(1)) for s in some}),) for some in beside)
