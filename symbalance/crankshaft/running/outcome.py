"""Outcome of one speed: stresses against the crank angle, orbits, bearing loads, orders; and its bytes.

In a store (`symbalance.jobs.store`) it lies as an NPZ under a key of all that it depends on: a digest of
the engine (the content of the files it names), of how it is solved, of the webs' compliances and of the
program. What is read back is believed only where its lengths, shapes and numbers are those of a run.
"""

from __future__ import annotations

import io
import zipfile
from dataclasses import dataclass, fields
from math import isfinite, prod
from typing import Any

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.files.operation import speed_text
from symbalance.jobs import store

FORMAT = 3
"""The number of this layout of an outcome, raised with every change of it."""
LARGEST_CONTENT = 900_000_000
"""Bytes, unpacked: the most steps of a cycle by some thousand channels."""


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


def key_of(*parts: object) -> str:
    """Return a key that differs where some part's content does, or the program (see `jobs.digests`)."""
    return store.key_of(FORMAT, *parts)


def slot_of(rpm: float) -> str:
    """Return the name of a speed's file in a store: one of its own for every speed.

    >>> slot_of(2200.0), slot_of(2200.001)
    ('2200rpm', '2200.001rpm')
    """
    return f"{speed_text(rpm)}rpm"


def encode_outcome(outcome: SpeedOutcome) -> bytes:
    """Return an outcome as the bytes of an NPZ file."""
    content = io.BytesIO()
    np.savez_compressed(content, **{f.name: getattr(outcome, f.name) for f in fields(outcome)})
    return content.getvalue()


def decode_outcome(payload: bytes) -> SpeedOutcome:
    """Return the outcome of such bytes; of others anything is raised, from zlib.error to TokenError.

    Nothing is unpacked before the archive's table of contents says how long it will be.
    """
    with zipfile.ZipFile(io.BytesIO(payload)) as archive:
        if sum(entry.file_size for entry in archive.infolist()) > LARGEST_CONTENT:
            raise store.DamagedError(f"it would unpack to more than {LARGEST_CONTENT} bytes")
        names = sorted(entry.filename.removesuffix(".npy") for entry in archive.infolist())
        if names != sorted(f.name for f in fields(SpeedOutcome)):
            raise store.DamagedError("it holds other things")
        for entry in archive.infolist():
            _check_length(archive, entry)
    with np.load(io.BytesIO(payload), allow_pickle=False) as data:
        return _outcome({f.name: data[f.name] for f in fields(SpeedOutcome)})


def _check_length(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> None:
    """Refuse an array of another length than its head says, by which room would be taken for it."""
    with archive.open(entry) as stream:
        version = np.lib.format.read_magic(stream)
        if version != (1, 0):
            raise store.DamagedError("it is of another format")
        shape, _, kind = np.lib.format.read_array_header_1_0(stream)
        if stream.tell() + prod(shape) * kind.itemsize != entry.file_size:
            raise store.DamagedError("an array is of another length than it says")


def disagreement(rpm: float, outcome: SpeedOutcome) -> str:
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


CODEC: store.Codec[SpeedOutcome] = store.Codec(encode_outcome, decode_outcome, disagreement)


def _outcome(values: dict[str, Any]) -> SpeedOutcome:
    for field in fields(SpeedOutcome):
        if field.type == "float":
            values[field.name] = float(values[field.name])
        elif field.type == "str":
            values[field.name] = str(values[field.name])
        elif field.type == "tuple[str, ...]":
            values[field.name] = tuple(str(x) for x in values[field.name])
    return SpeedOutcome(**values)
