"""Engine files: TOML in the units of a data sheet, read strictly, refused with file, line and remedy.

What each key may hold stands in `engine_keys`; decimals are read exactly. A cylinder's own sizes override
the engine's.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import Any

from symbalance.engine.balance_masses import BalanceShaft, Counterweight, Weight
from symbalance.engine.builders import from_cylinders, from_firing_order, from_pins
from symbalance.engine.crank_train import ROD, CrankTrain, Link
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine, checked_name
from symbalance.engine.engine_keys import ENGINE_FILE
from symbalance.errors import SymbalanceError, encodable_name
from symbalance.kinematics.slider_crank import checked_ratio
from symbalance.text.files import STANDARD_INPUT, file_name, read_text
from symbalance.text.sections import Section, read_sections

LINK = ("master", "link_angle", "link_radius")


SCHEMA = "engine-file.schema.json"


def schema_text() -> str:
    """Return the JSON Schema of engine files (draft 2020-12), which editors check them by.

    >>> import json
    >>> json.loads(schema_text())["properties"]["strokes"]["enum"]
    [2, 4]
    """
    return (files("symbalance.engine") / SCHEMA).read_text(encoding="utf-8")


def read_engine_file(path: str | Path) -> Engine:
    """Return the engine that a file describes; every refusal names the file and the line."""
    return parse_engine(read_text(path), file_name(path), default_name=default_name(path))


def default_name(path: str | Path) -> str:
    """Return what an engine is called whose file gives no name: after the file.

    >>> default_name("my/v6.toml"), default_name("-")
    ('v6', 'engine')
    """
    return "engine" if str(path) == STANDARD_INPUT else encodable_name(Path(path).stem)


def parse_engine(text: str, place: str, default_name: str = "engine") -> Engine:
    """Return the engine that the text of a file describes; `place` is what errors call it."""
    return engine_from(read_sections(text, place, ENGINE_FILE), default_name)


def engine_from(file: Section, default_name: str) -> Engine:
    """Return the engine that a file's tables describe; what other rooms read is left alone."""
    texts = {key: file.value(key) for key in ("name", "description", "source")}
    _ = file.section(
        "estimates"
    ).values()  # refuses what is no reason; only the list of presets shows them
    name = texts["name"] or file.guarded(lambda: checked_name(default_name))
    train = file.section("crank_train")
    about = {"name": name, "crank_train": _crank_train(train)}
    if "layout" in file:
        rows, arrangement = [], file.section("layout")
        engine = _by_lists(arrangement, train, about)
    else:
        rows, arrangement = file.sections("cylinder"), train
        engine = _by_cylinder(file, rows, train, about)
    (rows or [arrangement])[0].guarded(lambda: engine.groups, elsewhere=(arrangement, train))
    if engine.has_link_pin_masses:  # they count in units of the reciprocating mass
        row_of_mass = next((row for row in rows if "rotating_mass" in row), train)
        row_of_mass.guarded(lambda: engine.rotating_sizes)
    for i, cylinder in enumerate(engine.cylinders):
        at = rows[i] if rows and any(key in rows[i] for key in ROD) else train
        at.guarded(lambda c=cylinder: c.rod_split)
    return with_balancers(file, engine)


def _crank_train(train: Section) -> CrankTrain:
    sizes = train.values()
    ratio = sizes.pop("ratio", None)
    shared = CrankTrain(**sizes, given_ratio=ratio)
    if shared.ratio is not None:
        key, what = ("ratio", "ratio") if ratio is not None else ("rod", "2*rod/stroke")
        train.guarded(lambda: checked_ratio(shared.ratio, what), key)
    return shared


def _by_lists(arrangement: Section, train: Section, about: dict[str, Any]) -> Engine:
    values = arrangement.values()
    build = from_pins if "pins" in arrangement else from_firing_order
    engine = arrangement.guarded(lambda: build(**values, **about), elsewhere=(train,))
    angles = ("pins", "splay", "firing_intervals", "banks", "firing_order")
    fine = next(k for k in angles if k in arrangement)
    arrangement.guarded(lambda: engine.modulus, fine)
    return engine


def _by_cylinder(file: Section, rows: list[Section], train: Section, about: dict[str, Any]) -> Engine:
    cylinders, strokes = [_cylinder(row) for row in rows], file.value("strokes")
    about = {**about, "crank_train": _with_bore(about["crank_train"], rows)}

    def engine_of(places: Sequence[int]) -> Engine:
        engine = from_cylinders([cylinders[i] for i in places], strokes=strokes, **about)
        _ = engine.modulus  # refuses angles too fine together
        return engine

    try:
        return engine_of(range(len(cylinders)))
    except SymbalanceError:
        # What is refused together is refused at the first cylinder that those before it do not bear.
        # Masters first: a link rod's file may list it before its master, without which it is refused.
        places = sorted(range(len(cylinders)), key=lambda i: cylinders[i].link is not None)
        counts = range(1, len(places) + 1)
        last = bisect_left(counts, True, key=lambda count: _is_refused(lambda: engine_of(places[:count])))
        if last == len(places):  # the file's own order is what is refused
            return rows[0].guarded(lambda: engine_of(range(len(cylinders))), elsewhere=(train,))
        return rows[places[last]].guarded(lambda: engine_of(places[: last + 1]), elsewhere=(train,))


def _with_bore(train: CrankTrain, rows: Sequence[Section]) -> CrankTrain:
    """Return the sizes all cylinders share with the bore that their tables give, which has to be one.

    Gas torque counts one piston's area: two would be answered wrongly, in silence.
    """
    bores = [row.value("bore") if "bore" in row else train.bore for row in rows]
    first = next((bore for bore in bores if bore is not None), None)
    for row, bore in zip(rows, bores, strict=True):
        if bore != first:
            other = f"{float(first or 0):.8g} mm of another cylinder"
            remedy = "gas torque counts one bore: give all the same, or none"
            if bore is None:
                raise row.refused(f"has no bore beside {other}", remedy)
            at = row if "bore" in row else next(r for r in rows if "bore" in r)
            raise at.refusal("bore", f"differs from {other}", remedy)
    return train if first == train.bore else replace(train, bore=first)


def _cylinder(row: Section) -> Cylinder:
    values = row.values()
    values.pop("bore", None)  # the engine's: `_with_bore`
    link = {key: values.pop(key) for key in LINK if key in values}
    attached = row.guarded(lambda: _link(**link)) if link else None
    return row.guarded(lambda: Cylinder(**values, link=attached))


def _link(master: int, link_angle: object = 0, link_radius: object = 0) -> Link:
    return Link(master, link_angle, link_radius)


def _is_refused(make: Callable[[], object]) -> bool:
    try:
        make()
    except SymbalanceError:
        return True
    return False


_ALONE = ("station", "unbalance", "share")
Balancer = Counterweight | BalanceShaft


def with_balancers(file: Section, engine: Engine) -> Engine:
    """Return an engine with the counterweights and shafts that its file lists."""
    tables = [(row, _counterweight(row)) for row in file.sections("counterweight")]
    tables += [(row, _shaft(row)) for row in file.sections("balance_shaft")]
    if not tables:
        return engine
    every = [balancer for _, balancer in tables]
    try:
        return _joined(engine, every)
    except SymbalanceError:
        for row, balancer in tables:  # what is refused is refused where it stands, if alone
            row.guarded(lambda balancer_alone=balancer: _joined(engine, [balancer_alone]))
        return tables[0][0].guarded(lambda: _joined(engine, every))


def _joined(engine: Engine, balancers: Sequence[Balancer]) -> Engine:
    balanced = engine.balanced_by(*balancers)
    _ = balanced.modulus  # refuses angles too fine together
    _ = balanced.rotating_masses  # refuses what needs masses that are not given
    return balanced


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
