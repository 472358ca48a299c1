"""Engine files: TOML in the units of a data sheet, read strictly, refused with file, line and remedy.

Decimals are read exactly. Unknown keys are errors. A cylinder's own sizes override the engine's.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Callable, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Any, TypeVar

from symbalance.engine.balancer_tables import TABLES, with_balancers
from symbalance.engine.builders import from_cylinders, from_firing_order
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine, checked_name, checked_strokes
from symbalance.engine.trains import OWN, ROD, CrankTrain, Link, checked_size
from symbalance.errors import SymbalanceError, encodable_name, shown
from symbalance.kinematics.slider_crank import checked_ratio
from symbalance.text.files import read_text, toml_table

T = TypeVar("T")

_TOP = ("name", "description", "source", "strokes", "crank_train", "layout", "cylinder", *TABLES)
_ROOMS = ("crankshaft", "bearings", "running")
"""Tables that rooms of their own read: `symbalance.crankshaft.files`."""
_CRANK_TRAIN = ("stroke", "rod", "pitch", "reciprocating_mass", "rotating_mass", "ratio", "offset", *ROD)
_LAYOUT_LISTS = ("banks", "cylinders", "firing_order", "firing_intervals", "stagger", "offset")
_LAYOUT = ("strokes", *_LAYOUT_LISTS, "firing_at", "pin_step")
_LINK = ("master", "link_angle", "link_radius")
_CYLINDER = ("number", "throw", "bank", "station", "fires", *OWN, *_LINK)


def read_engine_file(path: str | Path) -> Engine:
    """Return the layout an engine file describes; every refusal names the file and the line."""
    text = read_text(path)
    return parse_engine(text, str(path), default_name=encodable_name(Path(path).stem))


def parse_engine(text: str, place: str, default_name: str = "engine") -> Engine:
    """Return the layout that the text of an engine file describes; `place` is what errors call it."""
    return _Reader(text, place).engine(toml_table(text, place), default_name)


class _Reader:
    """Turns a parsed table into a layout, saying of every refusal where it stands."""

    def __init__(self, text: str, place: str) -> None:
        self.lines, self.place = text.split("\n"), place

    def engine(self, table: dict[str, Any], default_name: str) -> Engine:
        self.check_keys(table, (*_TOP, *_ROOMS), "", 0)
        for key in ("name", "description", "source"):
            if not isinstance(table.get(key, ""), str):
                raise self.refusal(key, table[key], "must be text", "write it in quotes")
        if ("layout" in table) == ("cylinder" in table):
            rule = "must hold either a [layout] table or [[cylinder]] tables"
            raise SymbalanceError(self.place, rule, "describe the engine one way")
        name = self.guarded("", "name", 0, lambda: checked_name(table.get("name", default_name)))
        about = {"name": name, "crank_train": self.crank_train(self.subtable(table, "crank_train"))}
        if "layout" not in table:
            return self.joined(table, self.cylinders(table, about))
        if "strokes" in table:
            raise self.refusal("strokes", table["strokes"], "belongs into [layout] here", "move it")
        return self.joined(table, self.layout(self.subtable(table, "layout"), about))

    def joined(self, table: dict[str, Any], made: Engine) -> Engine:
        """Return a layout, refused where a rod does not reach or a size it needs is not given."""
        self.guarded("cylinder", "", 0, lambda: made.groups)
        rows = table.get("cylinder", [{}] * len(made.cylinders))
        for i, (row, cylinder) in enumerate(zip(rows, made.cylinders, strict=True)):
            own = any(key in row for key in ROD)
            section = "cylinder" if own else "crank_train"
            self.guarded(section, "", i if own else 0, lambda c=cylinder: c.rod_split)
        return with_balancers(self, table, made)

    def crank_train(self, table: dict[str, Any]) -> CrankTrain:
        section = "crank_train"
        self.check_keys(table, _CRANK_TRAIN, section, 0)
        sizes = {
            key: self.guarded(section, key, 0, lambda key=key: checked_size(key, table[key]))
            for key in _CRANK_TRAIN
            if key in table
        }
        given = sizes.pop("ratio", None)
        train = CrankTrain(**sizes, given_ratio=given)
        if given is not None and (train.rod is not None or train.stroke is not None):
            rule, remedy = "is 2*rod/stroke already", "give either ratio, or stroke and rod"
            raise self.refusal("ratio", table["ratio"], rule, remedy, section)
        if train.ratio is not None:
            key, what = ("ratio", "ratio") if given is not None else ("rod", "2*rod/stroke")
            self.guarded(section, key, 0, lambda: checked_ratio(train.ratio, what))
        return train

    def layout(self, table: dict[str, Any], about: dict[str, Any]) -> Engine:
        self.check_keys(table, _LAYOUT, "layout", 0)
        if "firing_order" not in table:
            place = f"{self.place}:{self.line_of('layout', 0)}: [layout]"
            raise SymbalanceError(
                place, "needs firing_order", "write it like firing_order = [1, 3, 4, 2]"
            )
        for key in _LAYOUT_LISTS:
            self.check_list(table, key)
        made = self.guarded("layout", "", 0, lambda: from_firing_order(**table, **about))
        fine = next((k for k in ("firing_intervals", "banks") if k in table), "firing_order")
        self.guarded("layout", fine, 0, lambda: made.modulus)
        return made

    def check_list(self, table: dict[str, Any], key: str) -> None:
        value = table.get(key, [])
        rows, rule, remedy = (
            [value],
            "must be a list of numbers or fractions",
            'write it like [-30, "61/2"]',
        )
        good: Callable[[object], bool] = _single
        if key == "cylinders":
            rows, good = value if isinstance(value, list) else [None], _whole
            rule, remedy = "must be a list of lists of numbers", "write it like [[1, 3, 5], [2, 4, 6]]"
        elif key == "firing_order":
            rule, remedy, good = (
                "must be a list of cylinder numbers",
                "write it like [1, 3, 4, 2]",
                _whole,
            )
        if not all(isinstance(row, list) and all(map(good, row)) for row in rows):
            raise self.refusal(key, value, rule, remedy, "layout")

    def cylinders(self, table: dict[str, Any], about: dict[str, Any]) -> Engine:
        rows, strokes = table["cylinder"], table.get("strokes", 4)
        if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
            raise self.refusal("cylinder", rows, "must be [[cylinder]] tables", "use double brackets")
        cylinders = [self.cylinder(row, i) for i, row in enumerate(rows)]
        self.guarded("", "strokes", 0, lambda: checked_strokes(strokes))

        def made(places: Sequence[int]) -> Engine:
            layout = from_cylinders([cylinders[i] for i in places], strokes=strokes, **about)
            _ = layout.modulus  # refuses angles too fine together
            return layout

        # What is refused together is refused at the first cylinder that those before it do not bear.
        # Masters first: a link rod's file may list it before its master, without which it is refused.
        places = sorted(range(len(cylinders)), key=lambda i: cylinders[i].link is not None)
        counts = range(1, len(places) + 1)
        last = bisect_left(counts, True, key=lambda count: _is_refused(lambda: made(places[:count])))
        if last < len(places):
            self.guarded("cylinder", "", places[last], lambda: made(places[: last + 1]))
        return self.guarded("cylinder", "", 0, lambda: made(range(len(cylinders))))

    def cylinder(self, row: dict[str, Any], index: int) -> Cylinder:
        self.check_keys(row, _CYLINDER, "cylinder", index)
        for key in ("number", "throw"):
            if key not in row:
                place = f"{self.place}:{self.line_of('cylinder', index)}: [[cylinder]]"
                raise SymbalanceError(place, f"needs {key}", f"add {key} = ...")
        hung = {key: row[key] for key in _LINK if key in row}
        if hung and "master" not in hung:
            key = next(iter(hung))
            remedy = "add master = the number of the master rod's cylinder"
            raise self.refusal(key, row[key], "belongs to a link rod", remedy, "cylinder", index)
        rest = {key: value for key, value in row.items() if key not in _LINK}
        link = self.guarded("cylinder", "", index, lambda: _link(hung)) if hung else None
        return self.guarded("cylinder", "", index, lambda: Cylinder(**rest, link=link))

    def subtable(self, table: dict[str, Any], key: str) -> dict[str, Any]:
        value = table.get(key, {})
        if not isinstance(value, dict):
            raise self.refusal(key, value, "must be a table", f"write [{key}] on a line of its own")
        return value

    def check_keys(self, table: dict[str, Any], known: Sequence[str], section: str, index: int) -> None:
        for key in table:
            if key not in known:
                near = get_close_matches(key, known, 1)
                remedy = f"did you mean {near[0]}?" if near else f"known keys: {', '.join(known)}"
                name = shown(f"{section}.{key}" if section else key)
                place = f"{self.place}:{self.line_of(section, index, key)}"
                raise SymbalanceError(name, "is an unknown key", remedy, place)

    def guarded(self, section: str, key: str, index: int, make: Callable[[], T]) -> T:
        try:
            return make()
        except SymbalanceError as problem:
            named = re.match(r"\w+", problem.what)
            line = self.line_of(section, index, key or (named[0] if named else ""))
            shared = [s for s in ("layout", "crank_train") if named and self.holds(s, named[0])]
            if not key and shared and line == self.line_of(section, index):
                line = self.line_of(shared[0], 0, named[0] if named else "")  # where the size stands
            raise problem.within(f"{self.place}:{line}") from None

    def holds(self, section: str, key: str) -> bool:
        """Tell whether a table of the file has a key."""
        return self.line_of(section, 0, key) != self.line_of(section, 0)

    def refusal(
        self, key: str, value: object, rule: str, remedy: str, section: str = "", index: int = 0
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


def _link(keys: dict[str, Any]) -> Link:
    return Link(keys["master"], keys.get("link_angle", 0), keys.get("link_radius", 0))


def _single(value: object) -> bool:
    return not isinstance(value, list | dict)


def _is_refused(make: Callable[[], object]) -> bool:
    try:
        make()
    except SymbalanceError:
        return True
    return False


def _whole(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)
