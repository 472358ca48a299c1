"""Table of overbalance: what each share of the reciprocating mass leaves of the first order.

At a share k the counterweights on the throws balance all of the rotating and k of the reciprocating mass
(`symbalance.design.balancing.overbalance`). Amplitudes are in units of m r omega^2 of cylinder 1, couples
times the pitch; at a speed they are in N and N m too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar, Unpack

from symbalance.design.balancing.overbalance import (
    FirstOrderParts,
    amplitudes,
    best_overbalance,
    first_order,
)
from symbalance.document.decimals import short_decimal
from symbalance.document.expressions import formula_of
from symbalance.document.formula import Decimal, Formula, Name
from symbalance.document.nodes import Column, Document, Facts, Table, Words
from symbalance.document.result import SequenceResult
from symbalance.document.text_writer import formula_text
from symbalance.engine.engine import Engine, checked_engine
from symbalance.engine.engine_document import degrees_text
from symbalance.errors import SymbalanceError, brief
from symbalance.forces.balance_data import KEYS
from symbalance.forces.balance_document import SHOWN, operating_facts
from symbalance.forces.operating_point import OperatingPoint, Sizes, operating_point, sized
from symbalance.text.numbers import as_list, decimal_text, exact, short_text
from symbalance.text.reals import Real

if TYPE_CHECKING:
    import sympy

USUAL = tuple(Fraction(k, 10) for k in range(11))
"""0 to 100 per cent."""
MOST_SHARES = 1001
DIGITS = 20
KINDS = ("force", "couple")
_M, _R, _A = Name("m"), Name("r"), Name("a")
_MR = _M * _R * Name("omega") ** 2


@dataclass(frozen=True)
class Overbalance:
    """A share of the reciprocating mass, and what it leaves: vertical and lateral amplitudes."""

    share: Fraction
    force: tuple[Real, Real]
    couple: tuple[Real, Real]


@dataclass(frozen=True, repr=False, eq=False)
class OverbalanceTable(SequenceResult[Overbalance]):
    """What shares of the reciprocating mass on every throw leave of an engine's first order.

    `best` holds the share with the least sum of squares, exactly, of force and of couple; None where no
    share makes a difference.
    """

    engine: Engine
    items: tuple[Overbalance, ...]
    best: tuple[tuple[str, sympy.Expr | None], ...]
    operating_point: OperatingPoint | None = None
    """The speed and sizes that values in N and N m are for; None where none is asked for."""
    kind: ClassVar[str] = "overbalance"

    def at(self, *, rpm: object, **sizes: Unpack[Sizes]) -> OverbalanceTable:
        """Return the same table in N and N m at a speed.

        `stroke`, `rod`, `pitch`, `bore` (mm) and `mass` (kg, of one cylinder's reciprocating parts) are
        sizes that the engine lacks.

        >>> from symbalance.engine.builders import inline
        >>> table = tabulate_overbalance(inline("1"), ["1/2"]).at(rpm=6000, stroke=80, mass="0.5")
        >>> [round(float(x), 1) for x in table.in_newtons(table[0], "force")]
        [3947.8, 3947.8]
        """
        if sizes:
            engine, shares = sized(self.engine, sizes), [row.share for row in self]
            return tabulate_overbalance(engine, shares).at(rpm=rpm)
        needs_pitch = any(any(row.couple) for row in self)
        return replace(self, operating_point=operating_point(self.engine, rpm, needs_pitch=needs_pitch))

    def in_newtons(self, row: Overbalance, kind: str) -> tuple[Real, Real]:
        """Return the vertical and the lateral amplitude in N, of a "couple" in N m, at the speed."""
        point = self.operating_point
        if point is None:
            remedy = "put the table at one: tabulate_overbalance(engine).at(rpm=6000)"
            raise SymbalanceError("the table", "has no operating point", remedy)
        # Without a pitch no couple is free: the operating point sees to that.
        unit = point.force if kind == "force" else point.couple or Real(0)
        vertical, lateral = row.force if kind == "force" else row.couple
        return vertical * unit, lateral * unit

    def summary(self) -> str:
        """Return what is balanced, in one line."""
        first, last = (_percent(self.items[i].share) for i in (0, -1))
        return f"First order of {self.engine.name} at an overbalance of {first} to {last} %"

    def document(self) -> Document:
        """Return a table of shares, then the best."""
        kinds = [kind for kind in KINDS if any(any(getattr(row, kind)) for row in self)]
        columns = [Column("overbalance, %")]
        for kind in kinds or ["force"]:
            columns += [Column(f"{kind}, vertical"), Column(f"{kind}, lateral")]
        rows = tuple(
            (
                Decimal(_percent(row.share)),
                *(self._cell(x) for kind in kinds or ["force"] for x in self._values(row, kind)),
            )
            for row in self
        )
        title: Words = ("Amplitudes of order 1, forces in ", _MR, ", couples in ", _MR * _A)
        point = self.operating_point
        if point is not None:
            title = f"Amplitudes of order 1 at {short_text(point.rpm)} rpm, forces in N, couples in N m"
        entries: list[tuple[Words, Words]] = [
            (
                "overbalance",
                "share of the reciprocating mass that counterweights on every throw balance, "
                "beside all of the rotating mass",
            ),
            (
                (_M, ", ", _R, ", ", _A),
                "reciprocating mass and crank radius of cylinder 1, cylinder pitch",
            ),
        ]
        for kind, share in self.best:
            words: Words = (
                "no share makes a difference: counterweights on the throws cancel"
                if share is None
                else (*_best_share(share), " %, least sum of squares of both")
            )
            entries.append((f"best, {kind}", words))
        at = () if point is None else (operating_facts(point, engine=self.engine),)
        table = Table(title, tuple(columns), rows)
        return Document(self.summary(), (*at, table, Facts(tuple(entries), "How to read it")))

    def _values(self, row: Overbalance, kind: str) -> tuple[Real, Real]:
        """Return the vertical and the lateral amplitude as the table has them."""
        if self.operating_point is None:
            return row.force if kind == "force" else row.couple
        return self.in_newtons(row, kind)

    def _cell(self, value: Real) -> Decimal:
        digits = () if self.operating_point is None else (SHOWN,)
        return Decimal(short_decimal(value, *digits))

    def data(self) -> dict[str, Any]:
        """Return every share and what it leaves, to 20 digits."""
        return {
            "engine": self.engine.name,
            **({"operating_point": point.data()} if (point := self.operating_point) else {}),
            "shares": [
                {"share": str(row.share), **{kind: _pair(getattr(row, kind)) for kind in KINDS}}
                | ({KEYS[kind]: _pair(self.in_newtons(row, kind)) for kind in KINDS} if point else {})
                for row in self
            ],
            "best": {kind: None if share is None else str(share) for kind, share in self.best},
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each share; at a speed N and N m too."""
        return [
            {
                "overbalance_percent": float(100 * row.share),
                "force_vertical": float(row.force[0]),
                "force_lateral": float(row.force[1]),
                "couple_vertical": float(row.couple[0]),
                "couple_lateral": float(row.couple[1]),
                **(self._value_record(row) if self.operating_point else {}),
            }
            for row in self
        ]

    def _value_record(self, row: Overbalance) -> dict[str, float]:
        """Return the rest of a row at a speed."""
        return {
            f"{kind}_{direction}_{KEYS[kind]}": float(value)
            for kind in KINDS
            for direction, value in zip(("vertical", "lateral"), self.in_newtons(row, kind), strict=True)
        }


def _percent(share: Fraction) -> str:
    return degrees_text(100 * share)


LONGEST_SHARE = 24
"""Characters of the exact best share, in per cent, that are read; a longer one is rounded."""


def _best_share(share: sympy.Expr) -> tuple[str | Formula, ...]:
    """Return a share in per cent, exact where it is short; JSON has the exact one whatever its length."""
    percent = formula_of(100 * share)
    if len(formula_text(percent)) <= LONGEST_SHARE:
        return (percent,)
    return ("≈ ", Decimal(short_decimal(100 * Real(str(share.evalf(DIGITS))))))


def _pair(pair: tuple[Real, Real]) -> dict[str, str]:
    return dict(zip(("vertical", "lateral"), (decimal_text(x, DIGITS) for x in pair), strict=True))


def tabulate_overbalance(engine: Engine, shares: Sequence[object] = USUAL) -> OverbalanceTable:
    """Return what shares of the reciprocating mass, balanced on every throw, leave of the first order.

    Refused for an engine that has counterweights, or angles that are symbols: `best_overbalance` takes
    those.

    >>> from symbalance.engine.builders import inline
    >>> table = tabulate_overbalance(inline("1"), [0, "1/2", 1])
    >>> [[float(x) for x in row.force] for row in table], table.best[0]
    ([[1.0, 0.0], [0.5, 0.5], [0.0, 1.0]], ('force', 1/2))
    """
    checked_engine(engine)
    if engine.has_symbols:
        rule, remedy = "has angles that are symbols", "give numbers, or take design.best_overbalance"
        raise SymbalanceError(f"engine {engine.name!r}", rule, remedy)
    if engine.balancers.counterweights:
        rule = "has counterweights already, and overbalance counts all there are"
        raise SymbalanceError(f"engine {engine.name!r}", rule, "leave its [[counterweight]] tables out")
    several = as_list(shares, "shares", '[0, "1/2", 1]')
    if not 1 <= len(several) <= MOST_SHARES:
        rule = f"must be 1 to {MOST_SHARES} shares"
        raise SymbalanceError(f"shares = {brief(several)}", rule, "0, 1/2 and 1, say")
    parts = {kind: first_order(engine, kind) for kind in KINDS}
    items = tuple(
        Overbalance(share, *(amplitudes(parts[kind], share) for kind in KINDS))
        for share in (exact(one, "share") for one in several)
    )
    return OverbalanceTable(
        engine, items, tuple((kind, _best(engine, kind, parts[kind])) for kind in KINDS)
    )


def _best(engine: Engine, kind: str, parts: FirstOrderParts) -> sympy.Expr | None:
    return None if parts.per_share.is_zero() else best_overbalance(engine, kind=kind)
