"""Engine files: TOML in the units of a data sheet, read strictly, refused with file, line and remedy.

Decimals are read exactly. Unknown keys are errors. Keys of later kinds of engine (unlike cylinders,
link rods, offset) are recognised and refused by name.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Iterable
from decimal import Decimal
from difflib import get_close_matches
from fractions import Fraction
from pathlib import Path
from typing import Any, TypeVar

from symbalance.builders import from_firing_order
from symbalance.errors import SymbalanceError, shown
from symbalance.layout import CrankTrain, Cylinder, Layout
from symbalance.rational import exact
from symbalance.slider_crank import checked_ratio

T = TypeVar("T")
LARGEST_FILE = 1_000_000

_TOP = ("name", "description", "source", "strokes", "crank_train", "layout", "cylinder")
_CRANK_TRAIN = ("stroke", "rod", "pitch", "reciprocating_mass", "rotating_mass", "ratio", "offset")
_LAYOUT = ("strokes", "banks", "cylinders", "firing_order", "firing_intervals", "stagger")
_CYLINDER = ("number", "throw", "bank", "station", "fires")
_LATER = (
    "stroke",
    "rod",
    "reciprocating_mass",
    "rotating_mass",
    "offset",
    "master",
    "link_angle",
    "link_radius",
)


def read_engine_file(path: str | Path) -> Layout:
    """Return the layout an engine file describes; every refusal names the file and the line."""
    text = read_text(path)
    return parse_engine(text, str(path), default_name=Path(path).stem)


def read_text(path: str | Path) -> str:
    """Return a file's text, or refuse what is missing, a directory, too large or not UTF-8."""
    place = str(path)
    try:
        with open(path, "rb") as stream:
            data = stream.read(LARGEST_FILE + 1)
    except IsADirectoryError:
        raise SymbalanceError(place, "is a directory", "name an engine file in it") from None
    except (OSError, ValueError) as problem:
        reason = getattr(problem, "strerror", None) or "not a usable path"
        raise SymbalanceError(place, f"cannot be read ({reason})", "check the path") from None
    if len(data) > LARGEST_FILE:
        raise SymbalanceError(place, f"is larger than {LARGEST_FILE} bytes", "name an engine file")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        line = data[: problem.start].count(b"\n") + 1
        raise SymbalanceError(f"{place}:{line}", "is not UTF-8 text", "save it as UTF-8") from None


def parse_engine(text: str, place: str, default_name: str = "engine") -> Layout:
    """Return the layout that the text of an engine file describes; `place` is what errors call it."""
    try:
        # TOML calls every line ending a newline; tomllib takes only \n and \r\n.
        table = tomllib.loads(text.replace("\r\n", "\n"), parse_float=Decimal)
    except tomllib.TOMLDecodeError as problem:
        found = re.search(r"\(at line (\d+), column (\d+)\)", str(problem))
        where = f"{place}:{found[1]}:{found[2]}" if found else f"{place}:{text.count(chr(10)) + 1}"
        message = re.sub(r"\s*\(at .*\)$", "", str(problem))
        raise SymbalanceError(where, f"is not valid TOML ({message})", "correct the line") from None
    except (ValueError, RecursionError):
        raise SymbalanceError(
            place, "holds a number or a nesting beyond all bounds", "write plain numbers and lists"
        ) from None
    return _Reader(text, place).engine(table, default_name)


class _Reader:
    """Turns a parsed table into a layout, saying of every refusal where it stands."""

    def __init__(self, text: str, place: str) -> None:
        self.lines, self.place = text.split("\n"), place

    def engine(self, table: dict[str, Any], default_name: str) -> Layout:
        self.check_keys(table, _TOP, "", 0)
        for key in ("name", "description", "source"):
            if not isinstance(table.get(key, ""), str):
                raise self.refusal(key, table[key], "must be text", "write it in quotes", "", 0)
        if ("layout" in table) == ("cylinder" in table):
            raise SymbalanceError(
                self.place,
                "must hold either a [layout] table or [[cylinder]] tables",
                "describe the engine one way",
            )
        about = {
            "name": table.get("name", default_name),
            "crank_train": self.crank_train(self.subtable(table, "crank_train")),
        }
        if "layout" in table:
            if "strokes" in table:
                raise self.refusal(
                    "strokes", table["strokes"], "belongs into [layout] here", "move it", "", 0
                )
            return self.layout(self.subtable(table, "layout"), about)
        return self.cylinders(table, about)

    def crank_train(self, table: dict[str, Any]) -> CrankTrain:
        self.check_keys(table, _CRANK_TRAIN, "crank_train", 0)
        sizes = {
            key: self.guarded("crank_train", key, 0, lambda key=key: self.size(key, table[key]))
            for key in _CRANK_TRAIN
            if key in table
        }
        if sizes.pop("offset", Fraction(0)):
            raise self.refusal(
                "offset",
                table["offset"],
                "offset cylinders are not supported yet",
                "leave it at 0",
                "crank_train",
                0,
            )
        given = sizes.pop("ratio", None)
        train = CrankTrain(**sizes, given_ratio=given)
        if given is not None and (train.rod is not None or train.stroke is not None):
            raise self.refusal(
                "ratio",
                table["ratio"],
                "is 2*rod/stroke already",
                "give either ratio, or stroke and rod",
                "crank_train",
                0,
            )
        if train.ratio is not None:
            key = "ratio" if given is not None else "rod"
            self.guarded(
                "crank_train",
                key,
                0,
                lambda: checked_ratio(train.ratio, "2*rod/stroke" if key == "rod" else key),
            )
        return train

    def size(self, key: str, value: object) -> Fraction:
        number = exact(value, key)
        may_be_zero = key in ("offset", "reciprocating_mass", "rotating_mass")
        if (number < 0 and key != "offset") or (not number and not may_be_zero):
            raise SymbalanceError(f"{key} = {shown(value)}", "must be positive", "sizes are in mm and kg")
        return number

    def layout(self, table: dict[str, Any], about: dict[str, Any]) -> Layout:
        self.check_keys(table, _LAYOUT, "layout", 0)
        if "firing_order" not in table:
            raise SymbalanceError(
                f"{self.place}:{self.line_of('layout', 0)}: [layout]",
                "needs firing_order",
                "write it like firing_order = [1, 3, 4, 2]",
            )
        for key in ("banks", "cylinders", "firing_order", "firing_intervals", "stagger"):
            self.check_list(table, key)
        arguments = {k: v for k, v in table.items() if k != "firing_order"}
        return self.guarded(
            "layout", "", 0, lambda: from_firing_order(table["firing_order"], **arguments, **about)
        )

    def check_list(self, table: dict[str, Any], key: str) -> None:
        value = table.get(key, [])
        if key == "cylinders":
            good = isinstance(value, list) and all(
                isinstance(bank, list) and all(_whole(n) for n in bank) for bank in value
            )
            rule, remedy = (
                "must be a list of lists of numbers",
                "write it like [[1, 3, 5], [2, 4, 6]]",
            )
        elif key == "firing_order":
            good = isinstance(value, list) and all(_whole(n) for n in value)
            rule, remedy = "must be a list of cylinder numbers", "write it like [1, 3, 4, 2]"
        else:
            good = isinstance(value, list) and not any(isinstance(v, list | dict) for v in value)
            rule, remedy = "must be a list of numbers or fractions", 'write it like [-30, "61/2"]'
        if not good:
            raise self.refusal(key, value, rule, remedy, "layout", 0)

    def cylinders(self, table: dict[str, Any], about: dict[str, Any]) -> Layout:
        rows = table["cylinder"]
        if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
            raise self.refusal(
                "cylinder", rows, "must be [[cylinder]] tables", "use double brackets", "", 0
            )
        cylinders = [self.cylinder(row, i) for i, row in enumerate(rows)]
        strokes = table.get("strokes", 4)
        return self.guarded("", "strokes", 0, lambda: Layout(cylinders, strokes=strokes, **about))

    def cylinder(self, row: dict[str, Any], index: int) -> Cylinder:
        for key in _LATER:
            if key in row:
                raise self.refusal(
                    key,
                    row[key],
                    "unlike cylinders and link rods are not supported yet",
                    "leave it out",
                    "cylinder",
                    index,
                )
        self.check_keys(row, _CYLINDER, "cylinder", index)
        for key in ("number", "throw"):
            if key not in row:
                raise SymbalanceError(
                    f"{self.place}:{self.line_of('cylinder', index)}: [[cylinder]]",
                    f"needs {key}",
                    f"add {key} = ...",
                )
        return self.guarded("cylinder", "", index, lambda: Cylinder(**row))

    # Where a refusal stands ---------------------------------------------------------------------

    def subtable(self, table: dict[str, Any], key: str) -> dict[str, Any]:
        value = table.get(key, {})
        if not isinstance(value, dict):
            raise self.refusal(
                key, value, "must be a table", f"write [{key}] on a line of its own", "", 0
            )
        return value

    def check_keys(self, table: dict[str, Any], known: Iterable[str], section: str, index: int) -> None:
        known = list(known)
        for key in table:
            if key not in known:
                near = get_close_matches(key, known, 1)
                remedy = f"did you mean {near[0]}?" if near else f"known keys: {', '.join(known)}"
                line = self.line_of(section, index, key)
                name = f"{section}.{key}" if section else key
                raise SymbalanceError(f"{self.place}:{line}: {shown(name)}", "is an unknown key", remedy)

    def guarded(self, section: str, key: str, index: int, make: Callable[[], T]) -> T:
        try:
            return make()
        except SymbalanceError as problem:
            named = re.match(r"\w+", problem.what)
            line = self.line_of(section, index, key or (named[0] if named else ""))
            raise problem.within(f"{self.place}:{line}") from None

    def refusal(
        self, key: str, value: object, rule: str, remedy: str, section: str, index: int
    ) -> SymbalanceError:
        place = f"{self.place}:{self.line_of(section, index, key)}"
        return SymbalanceError(f"{key} = {shown(value)}", rule, remedy, place)

    def line_of(self, section: str, index: int, key: str = "") -> int:
        """Return the line of a key in the index-th table of a section, or of the table's head."""
        head = re.compile(rf"\s*\[\[?\s*{re.escape(section)}\s*\]")
        key_line = re.compile(rf"""\s*["']?{re.escape(key)}["']?\s*=""") if key else None
        seen, start, inside = -1, 1, not section
        for number, line in enumerate(self.lines, 1):
            if re.match(r"\s*\[", line) and "=" not in line:
                inside = bool(section) and bool(head.match(line))
                if inside:
                    seen += 1
                    start = number if seen == index else start
            elif inside and key_line and (seen == index or not section) and key_line.match(line):
                return number
        return start


def _whole(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)
