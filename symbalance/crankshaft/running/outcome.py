"""Outcome of one speed: stresses against the crank angle, orbits, bearing loads, orders; and its file.

A file is one NPZ a speed, whole or not at all, under a key of all that it depends on: a digest of the
engine (the content of the files it names), of how it is solved, of the webs' compliances and of the
program. A file under another key, or one that does not read, is not believed: the speed is solved anew,
and the caller learns why.
"""

from __future__ import annotations

import io
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.jobs.digests import digest, program_digest
from symbalance.crankshaft.files.operation import speed_text
from symbalance.errors import SymbalanceError
from symbalance.text.writing import write_file

FORMAT = 2
"""The number of this layout of a file, raised with every change of it."""
REMEDY = "name a folder you may write to"


@dataclass(frozen=True)
class SpeedOutcome:
    """Periodic state at one speed, at even crank angles `theta` (s,) of a cycle; SI units but `rpm`.

    `values` (s, c) are the channels' (Pa, or degrees where `units` says so); `orbits` (s, b, 2) the
    journals' displacements in their bearings and `bearings` (s, b, 2) the shaft's forces on them,
    vertical and lateral; `clearance` (b,) is radial. `largest` is the largest Floquet multiplier's size,
    `error` the largest change of a stress when the steps are halved, films unchanged, over the largest
    stress; `seconds` the run time. `departure` is how far, over the clearance, the orbits lie from those
    the films are linear about. A `reason` says why the values are not to be relied on: no report
    prints them.
    """

    rpm: float
    theta: Array
    names: tuple[str, ...]
    units: tuple[str, ...]
    values: Array
    orbits: Array
    bearings: Array
    clearance: Array
    largest: float
    error: float
    seconds: float
    departure: float = float("nan")
    reason: str = ""

    @property
    def steps(self) -> int:
        """The steps of a cycle."""
        return len(self.theta)

    def channel(self, name: str) -> Array:
        """Return a channel's values (s,)."""
        return self.values[:, self.names.index(name)]

    @property
    def degrees(self) -> Array:
        """The crank angles in degrees."""
        return np.degrees(self.theta)

    @property
    def cycle(self) -> float:
        """The crank angle of a cycle, in radians."""
        return float(self.theta[1] * len(self.theta))

    @property
    def cycle_time(self) -> float:
        """The time of a cycle, in s."""
        return self.cycle / (self.rpm * np.pi / 30)

    def orders(self, name: str) -> tuple[Array, Array]:
        """Return (order, amplitude) of a channel: the real Fourier coefficients' sizes, mean first."""
        return harmonic_content(self.channel(name), self.cycle)

    @property
    def eccentricity(self) -> Array:
        """The largest |x|/clearance of each journal, (b,): above 1 the linear films no longer hold."""
        return np.abs(self.orbits[..., 0] + 1j * self.orbits[..., 1]).max(axis=0) / self.clearance

    @property
    def within_clearance(self) -> bool:
        """Whether every orbit stays in its clearance circle: the validity of the linear films."""
        return bool((self.eccentricity < 1).all())


def harmonic_content(values: Array, cycle: float) -> tuple[Array, Array]:
    """Return the orders and the amplitudes of values at even angles of a cycle, mean first.

    >>> theta = 4 * np.pi * np.arange(64) / 64
    >>> orders, sizes = harmonic_content(3 + 2 * np.cos(1.5 * theta), 4 * np.pi)
    >>> orders[:4].tolist(), sizes[:4].round(12).tolist()
    ([0.0, 0.5, 1.0, 1.5], [3.0, 0.0, 0.0, 2.0])
    """
    spectrum = np.abs(np.fft.rfft(values)) / len(values)
    spectrum[1:] *= 2
    if len(values) % 2 == 0:
        spectrum[-1] /= 2
    return np.array(range(len(spectrum)), dtype=float) * (2 * np.pi / cycle), spectrum


@dataclass(frozen=True)
class SavedOutcome:
    """A speed in a folder: its `outcome`, or None and the `reason` why a file there is not valid."""

    outcome: SpeedOutcome | None
    reason: str = ""


def key_of(*parts: object) -> str:
    """Return a key that differs where some part's content does, or the program (see `digests`)."""
    return digest(FORMAT, program_digest(), parts)


def file_of(folder: Path, rpm: float) -> Path:
    """Return where a speed's outcome lies: a file of its own for every speed.

    >>> file_of(Path("speeds"), 2200.0).name, file_of(Path("speeds"), 2200.001).name
    ('2200rpm.npz', '2200.001rpm.npz')
    """
    return folder / f"{speed_text(rpm)}rpm.npz"


def save_outcome(folder: Path, key: str, outcome: SpeedOutcome) -> None:
    """Write an outcome under its key, replacing an older one in one step."""
    path = file_of(folder, outcome.rpm)
    content = io.BytesIO()
    np.savez_compressed(content, key=key, **{f.name: getattr(outcome, f.name) for f in fields(outcome)})
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as problem:
        rule = f"cannot be written ({problem.strerror})"
        raise SymbalanceError(f"--output {path}", rule, REMEDY) from None
    write_file(path, content.getvalue(), what="--output ", remedy=REMEDY)


def load_outcome(folder: Path, key: str, rpm: float) -> SavedOutcome:
    """Return a speed's outcome if one of the same key is there; else why a file there is not it."""
    path = file_of(folder, rpm)
    if not path.exists():
        return SavedOutcome(None)
    try:
        with np.load(io.BytesIO(path.read_bytes()), allow_pickle=False) as data:
            if str(data["key"]) != key:
                return SavedOutcome(None, "is of another engine, other settings or another program")
            return SavedOutcome(_outcome({f.name: data[f.name] for f in fields(SpeedOutcome)}))
    except Exception as problem:  # a damaged file raises anything, from zlib.error to TokenError
        return SavedOutcome(None, f"does not read ({type(problem).__name__})")


def _outcome(values: dict[str, Any]) -> SpeedOutcome:
    for field in fields(SpeedOutcome):
        if field.type == "float":
            values[field.name] = float(values[field.name])
        elif field.type == "str":
            values[field.name] = str(values[field.name])
        elif field.type == "tuple[str, ...]":
            values[field.name] = tuple(str(x) for x in values[field.name])
    return SpeedOutcome(**values)
