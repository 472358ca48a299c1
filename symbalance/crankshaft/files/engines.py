"""Reading of an engine file with all that a running crankshaft needs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from symbalance.crankshaft.crank import Crank
from symbalance.crankshaft.files import geometry, operation, supports
from symbalance.crankshaft.files.crank_keys import FILE_KEYS
from symbalance.crankshaft.files.operation import Operation
from symbalance.crankshaft.files.supports import MainBearings
from symbalance.engine.catalogue import preset_names
from symbalance.engine.engine import Engine
from symbalance.engine.engine_file import default_name, engine_from
from symbalance.errors import SymbalanceError
from symbalance.text.files import file_name, read_text
from symbalance.text.named_paths import NamingFolder
from symbalance.text.sections import Section, read_sections


@dataclass(frozen=True)
class RunningEngine:
    """All inputs of a crankshaft's run: engine, crank, main bearings and operating conditions."""

    engine: Engine
    crank: Crank
    bearings: MainBearings
    operation: Operation

    @property
    def mass(self) -> float:
        """The reciprocating mass of the first cylinder in kg."""
        return float(self.engine.first.reciprocating_mass or 0)

    def at_speeds(self, rpm: Sequence[float]) -> RunningEngine:
        """Return the same engine with other speeds to run at."""
        speeds = operation.sorted_speeds(list(rpm))
        return replace(self, operation=replace(self.operation, rpm=speeds))


def read_running_engine(path: str | Path, *, trust_paths: bool = False) -> RunningEngine:
    """Return the engine of a file with [crankshaft], [bearings] and [running]; refusals name the line.

    The files it names must lie in its folder or below, unless its reader says `trust_paths`.
    """
    refuse_preset(path)
    text, place = read_text(path), file_name(path)
    file = read_sections(text, place, FILE_KEYS)
    engine = engine_from(file, default_name(path))
    folder = NamingFolder.of(path, trust_paths)
    for cylinder in engine.cylinders:
        if cylinder.reciprocating_mass is None:
            what = f"{place}: cylinder {cylinder.number}"
            raise SymbalanceError(what, "has no reciprocating_mass", "give it in [crank_train], in kg")
    crank = geometry.read_crank(_section(file, "crankshaft"), engine)
    bearings = supports.read_bearings(_section(file, "bearings"), crank, folder)
    run = operation.read_operation(_section(file, "running"), engine, folder)
    return RunningEngine(engine, crank, bearings, run)


def refuse_preset(path: str | Path) -> None:
    """Refuse a preset's name: what it has, and what it lacks to run."""
    name = str(path)
    if name in preset_names() and not Path(name).exists():
        rule = "is a preset: angles and firing order, no sizes, and a crankshaft runs from an engine file"
        remedy = (
            f"symbalance engines --show {name} > engine.toml; add stroke, rod and reciprocating_mass to "
            "[crank_train], then [crankshaft], [bearings] and [running] as the README shows"
        )
        raise SymbalanceError(name, rule, remedy)


def _section(file: Section, name: str) -> Section:
    if name not in file:
        remedy = f"a running crankshaft needs [crankshaft], [bearings] and [running]: add [{name}]"
        raise SymbalanceError(file.source.place, f"has no [{name}] table", remedy)
    return file.section(name)
