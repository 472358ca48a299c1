"""Outcome of one speed: stresses against the crank angle, orbits, bearing loads, orders; and its file.

A file is one NPZ a speed, whole or not at all, under a key of all that it depends on: a digest of the
engine (the content of the files it names), of how it is solved, of the webs' compliances and of the
program. At its end stands a checksum of all before. A file under another key, or one that is not what was
written, is not believed: the speed is solved anew, and the caller learns why.
"""

from __future__ import annotations

import io
import os
import zipfile
from dataclasses import dataclass, fields
from hashlib import sha256
from math import isfinite, prod
from pathlib import Path
from typing import Any

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.digests import digest, program_digest
from symbalance.crankshaft.files.operation import speed_text
from symbalance.errors import SymbalanceError
from symbalance.text.files import read_bytes
from symbalance.text.writing import write_file

FORMAT = 3
"""The number of this layout of a file, raised with every change of it."""
CHECKSUM = 64
"""Bytes at a file's end: a digest of all before them, as the archive's comment."""
LARGEST_FILE = 500_000_000
LARGEST_CONTENT = 900_000_000
"""Bytes, packed and unpacked: the most steps of a cycle by some thousand channels."""
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


NAMES = ("format", "key", *(field.name for field in fields(SpeedOutcome)))
"""What a file holds."""


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
    values = {f.name: getattr(outcome, f.name) for f in fields(outcome)}
    np.savez_compressed(content, format=FORMAT, key=key, **values)
    with zipfile.ZipFile(content, "a") as archive:
        archive.comment = b"0" * CHECKSUM
    body = content.getvalue()[:-CHECKSUM]
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as problem:
        rule = f"cannot be written ({problem.strerror})"
        raise SymbalanceError(f"--output {path}", rule, REMEDY) from None
    write_file(path, body + _checksum(body), what="--output ", remedy=REMEDY)


def load_outcome(folder: Path, key: str, rpm: float) -> SavedOutcome:
    """Return a speed's outcome if one of the same key is there; else why a file there is not it.

    Nothing is unpacked before the checksum says that it is what was written, and its own table of
    contents how long it will be.
    """
    path = file_of(folder, rpm)
    if not os.path.lexists(path):
        return SavedOutcome(None)
    try:
        content = read_bytes(path, LARGEST_FILE, "a folder of your own", pipes=False)
        saved_key, outcome = _read(content)
    except SymbalanceError as problem:
        return SavedOutcome(None, problem.rule)
    except _DamagedError as problem:
        return SavedOutcome(None, f"does not read ({problem})")
    except Exception as problem:  # what is damaged on purpose raises anything, from zlib.error on
        return SavedOutcome(None, f"does not read ({type(problem).__name__})")
    if saved_key != key:
        return SavedOutcome(None, "is of another engine, other settings or another program")
    reason = _disagreement(outcome, rpm)
    return SavedOutcome(None, f"does not read ({reason})") if reason else SavedOutcome(outcome)


class _DamagedError(Exception):
    """A file is not what was written; the text says in what."""


def _checksum(body: bytes) -> bytes:
    return sha256(body).hexdigest().encode("ascii")


def _read(content: bytes) -> tuple[str, SpeedOutcome]:
    """Return a file's key and outcome; raises whatever comes where it is not what was written."""
    if content[-CHECKSUM:] != _checksum(content[:-CHECKSUM]):
        raise _DamagedError("its checksum is another")
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        entries = {entry.filename.removesuffix(".npy"): entry for entry in archive.infolist()}
        if sum(entry.file_size for entry in archive.infolist()) > LARGEST_CONTENT:
            raise _DamagedError(f"it would unpack to more than {LARGEST_CONTENT} bytes")
        if sorted(entries) != sorted(NAMES):
            raise _DamagedError("it holds other things")
        for entry in entries.values():
            _check_length(archive, entry)
    with np.load(io.BytesIO(content), allow_pickle=False) as data:
        if int(data["format"]) != FORMAT:
            raise _DamagedError("it is of another format")
        return str(data["key"]), _outcome({f.name: data[f.name] for f in fields(SpeedOutcome)})


def _check_length(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> None:
    """Refuse an array of another length than its head says, by which room would be taken for it."""
    with archive.open(entry) as stream:
        version = np.lib.format.read_magic(stream)
        if version != (1, 0):
            raise _DamagedError("it is of another format")
        shape, _, kind = np.lib.format.read_array_header_1_0(stream)
        if stream.tell() + prod(shape) * kind.itemsize != entry.file_size:
            raise _DamagedError("an array is of another length than it says")


def _disagreement(outcome: SpeedOutcome, rpm: float) -> str:
    """Return in what an outcome cannot be one of a speed, "" if it can."""
    steps, channels, bearings = len(outcome.theta), len(outcome.names), len(outcome.clearance)
    shapes = {
        "theta": (steps,),
        "values": (steps, channels),
        "orbits": (steps, bearings, 2),
        "bearings": (steps, bearings, 2),
        "clearance": (bearings,),
    }
    for name, shape in shapes.items():
        array = getattr(outcome, name)
        if array.shape != shape or array.dtype != float:
            return f"{name} of another shape"
        # What has a reason not to be relied on may hold no numbers, but stands at its angles.
        if not np.isfinite(array).all() and (not outcome.reason or name in ("theta", "clearance")):
            return f"{name} not finite"
    if outcome.rpm != rpm:
        return "another speed"
    if len(outcome.units) != channels or steps < 2:
        return "channels of no unit, or no angles"
    even = np.diff(outcome.theta, append=outcome.theta[0] + steps * outcome.theta[1])
    if not (outcome.theta[1] > 0 and np.allclose(even, outcome.theta[1], rtol=1e-6)):
        return "angles that are not even"
    return "" if (outcome.clearance > 0).all() and isfinite(outcome.seconds) else "sizes of no bearing"


def _outcome(values: dict[str, Any]) -> SpeedOutcome:
    for field in fields(SpeedOutcome):
        if field.type == "float":
            values[field.name] = float(values[field.name])
        elif field.type == "str":
            values[field.name] = str(values[field.name])
        elif field.type == "tuple[str, ...]":
            values[field.name] = tuple(str(x) for x in values[field.name])
    return SpeedOutcome(**values)
