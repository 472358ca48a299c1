"""The tables of an engine file that hold counterweights and balance shafts, read strictly.

[[counterweight]]        on the crank: angle, station, and unbalance (kg mm) or share;
throw = 1                or on a throw or a web: angle then counts from opposite its pin
overbalance = "1/2"      or, on a throw: its rotating mass and half its reciprocating mass

[[balance_shaft]]        speed, phase, station, x, y, and unbalance or share,
speed = -2               or several: weights = [{ station = 1, share = 2, phase = 180 }]
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NoReturn, Protocol, TypeVar

from symbalance.engine.balancers import BalanceShaft, Counterweight, Weight
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError

TABLES = ("counterweight", "balance_shaft")
_COUNTERWEIGHT = ("throw", "web", "angle", "station", "unbalance", "share", "overbalance")
_WEIGHT = ("station", "unbalance", "share", "phase")
_SHAFT = ("speed", "phase", "station", "unbalance", "share", "x", "y", "weights")
_ALONE = ("station", "unbalance", "share")

T = TypeVar("T")
Balancer = Counterweight | BalanceShaft


class Reader(Protocol):
    """What says of every refusal where in the file it stands."""

    def check_keys(self, table: dict[str, Any], known: Sequence[str], section: str, index: int) -> None:
        """Refuse a key that is unknown."""

    def guarded(self, section: str, key: str, index: int, make: Callable[[], T]) -> T:
        """Return what `make` makes; a refusal says where the key of the table stands."""
        ...

    def refusal(
        self, key: str, value: object, rule: str, remedy: str, section: str = "", index: int = 0
    ) -> SymbalanceError:
        """Return the refusal of a key's value."""
        ...


def with_balancers(reader: Reader, table: dict[str, Any], layout: Engine) -> Engine:
    """Return a layout with the counterweights and shafts that an engine file's table lists."""
    found: list[tuple[str, int, Balancer]] = []
    for section, read in zip(TABLES, (_counterweight, _shaft), strict=True):
        for index, row in enumerate(_rows(reader, table, section)):
            found.append((section, index, read(reader, row, index)))
    if not found:
        return layout
    try:
        return _joined(layout, [balancer for *_, balancer in found])
    except SymbalanceError:
        for section, index, balancer in found:  # what is refused is refused where it stands, if alone
            reader.guarded(section, "", index, lambda one=balancer: _joined(layout, [one]))
        section, index, _ = found[0]
        every = [balancer for *_, balancer in found]
        return reader.guarded(section, "", index, lambda: _joined(layout, every))


def _joined(layout: Engine, balancers: Sequence[Balancer]) -> Engine:
    made = layout.balanced_by(*balancers)
    _ = made.modulus  # refuses angles too fine together
    _ = made.rotors  # refuses what needs masses that are not given
    return made


def _rows(reader: Reader, table: dict[str, Any], section: str) -> list[dict[str, Any]]:
    rows = table.get(section, [])
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        rule = f"must be [[{section}]] tables"
        raise reader.refusal(section, rows, rule, "use double brackets", section)
    return rows


def _counterweight(reader: Reader, row: dict[str, Any], index: int) -> Counterweight:
    reader.check_keys(row, _COUNTERWEIGHT, "counterweight", index)
    return reader.guarded("counterweight", "", index, lambda: Counterweight(**row))


def _shaft(reader: Reader, row: dict[str, Any], index: int) -> BalanceShaft:
    section = "balance_shaft"
    reader.check_keys(row, _SHAFT, section, index)
    if "speed" not in row:
        _refuse(reader, index, "speed", "is missing", "add speed = 2 or -2, - turns against the crank")
    alone = {key: row[key] for key in _ALONE if key in row}
    rows = row.get("weights")
    if (rows is None) == (not alone):
        rule = "takes either weights, or station and unbalance or share"
        _refuse(reader, index, section, rule, "describe its weights one way")
    if rows is None:
        weights = [reader.guarded(section, "", index, lambda: Weight(**alone))]
    else:
        weights = [_weight(reader, each, index) for each in _listed(reader, rows, index)]
    rest = {key: row[key] for key in ("speed", "phase", "x", "y") if key in row}
    return reader.guarded(section, "", index, lambda: BalanceShaft(weights=weights, **rest))


def _listed(reader: Reader, rows: object, index: int) -> list[dict[str, Any]]:
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        remedy = "write weights = [{ station = 1, share = 2, phase = 180 }]"
        raise reader.refusal("weights", rows, "must be a list of tables", remedy, "balance_shaft", index)
    return rows


def _weight(reader: Reader, row: dict[str, Any], index: int) -> Weight:
    reader.check_keys(row, _WEIGHT, "balance_shaft", index)
    return reader.guarded("balance_shaft", "weights", index, lambda: Weight(**row))


def _refuse(reader: Reader, index: int, what: str, rule: str, remedy: str) -> NoReturn:
    error = SymbalanceError(what, rule, remedy)

    def fail() -> None:
        raise error

    reader.guarded("balance_shaft", "", index, fail)
    raise error
