"""Table of the bank angles at which a vee on shared pins fires evenly, and the offsets others need."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar

from symbalance.document.nodes import Column, Document, Facts, Table, Words
from symbalance.document.result import SequenceResult
from symbalance.engine.engine import checked_strokes
from symbalance.engine.engine_document import degrees_text
from symbalance.engine.stars.banks import Crank, even_interval, natural_bank_angles, pin_offsets
from symbalance.exact.angles import degrees
from symbalance.text.numbers import as_list


@dataclass(frozen=True)
class BankAngle:
    """A bank angle, in degrees, and the offsets of right pins from left ones with which a vee is even."""

    angle: Fraction
    offsets: tuple[Fraction, ...]

    @property
    def is_natural(self) -> bool:
        """Whether a vee of this angle fires evenly on shared pins."""
        return 0 in self.offsets


@dataclass(frozen=True, repr=False, eq=False)
class BankAngles(SequenceResult[BankAngle]):
    """Bank angles of a vee of so many `cylinders`, or on given `pins`, and the pin offsets they need."""

    cylinders: int
    pins: tuple[str, ...]
    strokes: int
    items: tuple[BankAngle, ...]
    kind: ClassVar[str] = "bank-angles"

    def summary(self) -> str:
        """Return what the vee is, in one line."""
        crank = f"with pins at {', '.join(self.pins)}°" if self.pins else "on any crank"
        return f"Even firing of a {self.strokes}-stroke vee of {self.cylinders} cylinders {crank}"

    def document(self) -> Document:
        """Return a table of bank angles, natural ones first named so."""
        columns = (Column("bank angle, °"), Column("shared pins"), Column("pin offsets, °"))
        rows = tuple(
            (
                degrees_text(one.angle),
                "even" if one.is_natural else "uneven",
                ", ".join(degrees_text(offset).replace("-", "−") for offset in one.offsets) or "none",
            )
            for one in self
        )
        interval = degrees_text(even_interval(self.cylinders, self.strokes))
        legend: tuple[tuple[Words, Words], ...] = (
            ("even", f"a firing every {interval}° of the crank"),
            (
                "pin offsets",
                "of right cylinders' pins from left ones', + in the sense of rotation: with "
                "each of these it fires evenly; 0 is a shared pin",
            ),
        )
        empty = "no bank angle to 180° fires evenly on shared pins: ask for one, as --vee 90"
        return Document(
            self.summary(), (Table("", columns, rows, empty=empty), Facts(legend, "How to read it"))
        )

    def data(self) -> dict[str, Any]:
        """Return every bank angle and its offsets, degrees as exact fractions."""
        return {
            "cylinders": self.cylinders,
            "pins": list(self.pins) or None,
            "strokes": self.strokes,
            "bank_angles": [
                {
                    "angle": str(one.angle),
                    "natural": one.is_natural,
                    "offsets": [str(offset) for offset in one.offsets],
                }
                for one in self
            ],
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each bank angle and offset."""
        return [
            {
                "bank_angle_degrees": float(one.angle),
                "natural": one.is_natural,
                "pin_offset_degrees": float(offset),
            }
            for one in self
            for offset in one.offsets
        ]


def bank_angles(crank: Crank, angles: Sequence[object] = (), strokes: int = 4) -> BankAngles:
    """Return the bank angles at which a vee fires evenly, and the offsets that other `angles` need.

    `crank` is the number of cylinders (any crank), or the throws of the pins that two cylinders share.

    >>> for one in bank_angles(6, [60, 90]):
    ...     print(one.angle, one.is_natural, [int(offset) for offset in one.offsets])
    60 False [-60, 60, 180]
    90 False [-30, 90, -150]
    120 True [0, -120, 120]
    """
    checked_strokes(strokes)
    natural = natural_bank_angles(crank, strokes)
    more = [degrees(one, "bank_angle").in_degrees() for one in as_list(angles, "angles", "[60, 90]")]
    items = tuple(
        BankAngle(angle, pin_offsets(crank, angle, strokes)) for angle in sorted({*natural, *more})
    )
    pins = () if isinstance(crank, int) else tuple(str(pin) for pin in crank)
    count = crank if isinstance(crank, int) else 2 * len(pins)
    return BankAngles(count, pins, strokes, items)
