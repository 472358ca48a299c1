"""Engine files of running crankshafts for the tests: a worked sheet with keys replaced."""

from __future__ import annotations

from pathlib import Path

from symbalance.crankshaft.files import RunningEngine, read_running_engine

WORKED = Path(__file__).parent.parent / "derivations" / "crankshaft"

PRESSURE = "degrees,bar\n" + "".join(
    f"{a},{3 if abs(a) > 90 else 3 + 60 * (1 - abs(a) / 90) ** 2:.6g}\n" for a in range(-360, 360, 5)
)
CRANKSHAFT = """
[crankshaft]
young = 206
[crankshaft.journal]
diameter = 65
length = 30
fillet = 4
[crankshaft.pin]
diameter = 55
length = 32
fillet = 4
[crankshaft.web]
thickness = 24
width = 100
tip = 38
heel = 44
"""
BEARINGS = """
[bearings]
clearance = 0.035
viscosity = 0.012
"""
RUNNING = """
[running]
bore = 92
rpm = 2200
pressure = "trace.csv"
big_end_mass = 1.1
"""
TRAIN = """
[crank_train]
stroke = 120
rod = 192
reciprocating_mass = 1.5
"""
SINGLE = "[layout]\nfiring_order = [1]\n"


def sheet(layout: str = SINGLE, *more: str, **changed: str) -> str:
    """Return an engine file's text; `changed` replaces the line of a key wherever it stands."""
    text = TRAIN + layout + CRANKSHAFT + BEARINGS + RUNNING + "\n".join(more)
    lines = text.splitlines()
    for key, line in changed.items():
        place = next(i for i, old in enumerate(lines) if old.startswith(f"{key} ="))
        lines[place] = line
    return "\n".join(lines) + "\n"


def written(folder: Path, text: str) -> Path:
    """Write an engine file and its pressure trace into a folder."""
    (folder / "trace.csv").write_text(PRESSURE, encoding="utf-8")
    path = folder / "engine.toml"
    path.write_text(text, encoding="utf-8")
    return path


def engine(folder: Path, text: str) -> RunningEngine:
    """Return the engine of a text."""
    return read_running_engine(written(folder, text))
