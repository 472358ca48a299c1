"""The tables of an engine file that hold counterweights and balance shafts.

[[counterweight]]        on the crank: angle, station, and unbalance (kg mm) or share;
throw = 1                or on a throw or a web: angle then counts from opposite its pin
overbalance = "1/2"      or, on a throw: its rotating mass and half its reciprocating mass

[[balance_shaft]]        speed, phase, station, x, y, and unbalance or share,
speed = -2               or several: weights = [{ station = 1, share = 2, phase = 180 }]
"""

from __future__ import annotations

from collections.abc import Sequence

from symbalance.engine.balancers import BalanceShaft, Counterweight, Weight
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError
from symbalance.text.sections import Section

_ALONE = ("station", "unbalance", "share")
Balancer = Counterweight | BalanceShaft


def with_balancers(file: Section, layout: Engine) -> Engine:
    """Return an engine with the counterweights and shafts that its file lists."""
    tables = [(row, _counterweight(row)) for row in file.sections("counterweight")]
    tables += [(row, _shaft(row)) for row in file.sections("balance_shaft")]
    if not tables:
        return layout
    every = [balancer for _, balancer in tables]
    try:
        return _joined(layout, every)
    except SymbalanceError:
        for row, balancer in tables:  # what is refused is refused where it stands, if alone
            row.guarded(lambda one=balancer: _joined(layout, [one]))
        return tables[0][0].guarded(lambda: _joined(layout, every))


def _joined(layout: Engine, balancers: Sequence[Balancer]) -> Engine:
    made = layout.balanced_by(*balancers)
    _ = made.modulus  # refuses angles too fine together
    _ = made.rotors  # refuses what needs masses that are not given
    return made


def _counterweight(row: Section) -> Balancer:
    values = row.values()
    return row.guarded(lambda: Counterweight(**values))


def _shaft(row: Section) -> Balancer:
    values = row.values()
    alone = {key: values.pop(key) for key in _ALONE if key in values}
    weights = [_weight(each) for each in row.sections("weights")]
    if not weights:
        weights = [row.guarded(lambda: Weight(**alone))]
    return row.guarded(lambda: BalanceShaft(weights=weights, **values))


def _weight(row: Section) -> Weight:
    values = row.values()
    return row.guarded(lambda: Weight(**values))
