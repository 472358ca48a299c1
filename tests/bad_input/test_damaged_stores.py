"""Saved results that are damaged are said in one line and computed anew; none is believed, none stops."""

from __future__ import annotations

import io
import json
import os
import random
import time
import zipfile
from collections import Counter
from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest

from symbalance.crankshaft.running.outcome import CODEC, SpeedOutcome, encode_outcome, slot_of
from symbalance.crankshaft.solid import store as webs
from symbalance.crankshaft.solid.reference import reference_four
from symbalance.crankshaft.solid.store import WebStore, open_store
from symbalance.crankshaft.webs.arm import arms
from symbalance.errors import SymbalanceError
from symbalance.jobs.progress import Progress
from symbalance.jobs.running import Job, run_jobs
from symbalance.jobs.store import Store

STEPS = 24
ANGLES = 4 * np.pi * np.arange(STEPS) / STEPS
OUTCOME = SpeedOutcome(
    rpm=2200.0,
    theta=ANGLES,
    names=("pin 1 bending", "pin 1 torsion", "twist"),
    units=("Pa", "Pa", "degrees"),
    values=np.outer(np.cos(ANGLES), [1e7, 2e7, 0.5]),
    orbits=np.full((STEPS, 2, 2), 1e-5),
    bearings=np.full((STEPS, 2, 2), 1e4),
    clearance=np.array([3e-5, 3e-5]),
    largest=0.5,
    error=1e-4,
    seconds=1.5,
)


class Said(Progress):
    """Progress that keeps the lines it is to say."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: list[str] = []

    def say(self, line: str) -> None:
        self.lines.append(line)


def file_of(folder: Path, rpm: float) -> Path:
    return Store(folder).path(slot_of(rpm))


def save_outcome(folder: Path, key: str, outcome: SpeedOutcome) -> None:
    Store(folder).save(key, encode_outcome(outcome), slot_of(outcome.rpm))


def not_there(rpm: float) -> SpeedOutcome:
    raise SymbalanceError(f"{rpm}", "would be computed anew")


def load_outcome(folder: Path, key: str, rpm: float) -> tuple[SpeedOutcome | None, str]:
    """Return what a run believes of a saved speed, and what it says."""
    said, job = Said(), Job(f"{rpm} rpm", rpm, key, slot_of(rpm))
    ((_, outcome),) = run_jobs(not_there, [job], store=Store(folder), codec=CODEC, progress=said)
    assert len(said.lines) <= 1
    return outcome.value if outcome.saved else None, "".join(said.lines)


Damage = Callable[[bytes, random.Random], bytes]


def flip_a_bit(content: bytes, chance: random.Random) -> bytes:
    place = chance.randrange(len(content))
    return content[:place] + bytes([content[place] ^ 1 << chance.randrange(8)]) + content[place + 1 :]


def cut_short(content: bytes, chance: random.Random) -> bytes:
    return content[: chance.randrange(len(content))]


def make_longer(content: bytes, chance: random.Random) -> bytes:
    return content + chance.randbytes(chance.randrange(1, 3000))


def overwrite(content: bytes, chance: random.Random) -> bytes:
    start = chance.randrange(len(content))
    piece = chance.randbytes(chance.randrange(1, 400))
    damaged = content[:start] + piece + content[start + len(piece) :]
    return damaged if damaged != content else content[:-1]


def leave_out(content: bytes, chance: random.Random) -> bytes:
    start = chance.randrange(len(content))
    return content[:start] + content[start + chance.randrange(1, 200) :]


def zero(content: bytes, chance: random.Random) -> bytes:
    start = chance.randrange(len(content) - 64)
    return content[:start] + bytes(len(content) - start)


DAMAGES: tuple[Damage, ...] = (flip_a_bit, cut_short, make_longer, overwrite, leave_out, zero)


@pytest.mark.slow
def test_of_1800_damaged_files_none_is_believed_and_none_stops(tmp_path: Path) -> None:
    save_outcome(tmp_path, "key", OUTCOME)
    path = file_of(tmp_path, OUTCOME.rpm)
    content = path.read_bytes()
    results: Counter[str] = Counter()
    for seed in range(300):
        for damage in DAMAGES:
            path.write_bytes(damage(content, random.Random(f"{damage.__name__} {seed}")))
            restored, reason = load_outcome(tmp_path, "key", OUTCOME.rpm)
            results["believed" if restored is not None else "said"] += 1
            assert (restored is None) == bool(reason)
            assert "\n" not in reason
    assert results == {"said": 1800}


@pytest.mark.slow
def test_of_1800_damaged_stores_of_webs_none_is_believed_and_none_stops(tmp_path: Path) -> None:
    path = tmp_path / "webs.json"
    arm = next(arms(reference_four(weighted=False)))[1]
    web = open_store().lookup(arm)
    assert web is not None
    thicker = replace(arm, web=replace(arm.web, thickness=arm.web.thickness * 1.01))
    WebStore(path=path).keep(thicker, web)
    content = path.read_bytes()
    results: Counter[str] = Counter()
    for seed in range(300):
        for damage in DAMAGES:
            damaged = damage(content, random.Random(f"{damage.__name__} {seed}"))
            path.write_bytes(damaged)
            lines: list[str] = []
            store = open_store(path, lines.append)
            kept = store.lookup(thicker)
            if kept is not None:  # a space more, or less
                assert (kept.flexibility == web.flexibility).all()
                assert json.loads(damaged) == json.loads(content)
                results["same"] += 1
                continue
            assert len(lines) == 1
            assert "\n" not in lines[0]
            assert "anew" in lines[0]
            results["said"] += 1
            if seed % 100 == 0:  # and the store is written as if it were new
                store.keep(thicker, web)
                assert open_store(path, pytest.fail).lookup(thicker) is not None
    assert results["said"] > 1750


# What bears a right checksum and is wrong all the same ------------------------------------------------


def forge(folder: Path, entries: dict[str, bytes | np.ndarray | None]) -> Path:
    """Write a file of a speed with some entries replaced, added, or left out, and its checksum right."""
    whole_payload, content = io.BytesIO(encode_outcome(OUTCOME)), io.BytesIO()
    with (
        zipfile.ZipFile(whole_payload) as whole,
        zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as forged,
    ):
        for name in dict.fromkeys([*whole.namelist(), *(f"{name}.npy" for name in entries)]):
            entry = entries.get(name.removesuffix(".npy"), b"")
            if entry is None:
                continue
            if isinstance(entry, np.ndarray):
                stream = io.BytesIO()
                np.save(stream, entry, allow_pickle=True)
                entry = stream.getvalue()
            forged.writestr(name, entry or whole.read(name))
    Store(folder).save("key", content.getvalue(), slot_of(OUTCOME.rpm))
    return file_of(folder, OUTCOME.rpm)


def head_of(shape: tuple[int, ...]) -> bytes:
    stream = io.BytesIO()
    described = {"descr": "<f8", "fortran_order": False, "shape": shape}
    np.lib.format.write_array_header_1_0(stream, described)
    return stream.getvalue() + bytes(800)


NAN = np.full_like(OUTCOME.values, np.nan)
FORGED = {
    "values of another shape": {"values": OUTCOME.values[:-1]},
    "values not finite": {"values": NAN},
    "orbits of another shape": {"orbits": OUTCOME.orbits[:, :1]},
    "bearings not finite": {"bearings": OUTCOME.bearings * np.inf},
    "clearance not finite": {"clearance": np.array([np.nan, 1.0])},
    "clearance of another shape": {"clearance": np.ones((2, 1))},
    "sizes of no bearing": {"clearance": np.array([1e-5, -1e-5])},
    "another speed": {"rpm": np.array(2300.0)},
    "angles that are not even": {"theta": OUTCOME.theta**2},
    "theta of another shape": {"theta": OUTCOME.theta.astype(np.float32)},
    "channels of no unit": {"units": np.array(["Pa"])},
    "it holds other things": {"more": np.zeros(3)},
    "it holds other": {"reason": None},
    "an array is of another length than it says": {"values": head_of((10**12, 3))},
    "an array is of another length": {"orbits": head_of((2**62, 2**62))},
    "ValueError": {"reason": np.array([{"an": "object"}], dtype=object)},
}


@pytest.mark.parametrize("reason", FORGED)
def test_what_no_run_has_written_is_not_believed_whatever_its_checksum(reason, tmp_path):
    forge(tmp_path, {})
    assert load_outcome(tmp_path, "key", OUTCOME.rpm)[0] is not None
    forge(tmp_path, FORGED[reason])
    restored, line = load_outcome(tmp_path, "key", OUTCOME.rpm)
    assert restored is None
    assert reason in line or "length" in line


@pytest.mark.slow
def test_what_would_unpack_to_a_gigabyte_is_refused_by_its_word(tmp_path, monkeypatch):
    """The word is the archive's table of contents: nothing of the content is unpacked."""
    bomb = np.zeros(130_000_000)
    path = forge(tmp_path, {"values": bomb})
    del bomb
    assert path.stat().st_size < 5_000_000
    monkeypatch.setattr(zipfile.ZipExtFile, "read", lambda *_: pytest.fail("unpacked"))
    assert "would unpack to more" in load_outcome(tmp_path, "key", OUTCOME.rpm)[1]


def test_an_outcome_comes_back_as_it_was_and_one_with_a_reason_too(tmp_path):
    for outcome in (OUTCOME, replace(OUTCOME, values=NAN, orbits=OUTCOME.orbits * np.nan, reason="no")):
        save_outcome(tmp_path, "key", outcome)
        restored, _ = load_outcome(tmp_path, "key", OUTCOME.rpm)
        assert restored is not None
        for field in fields(SpeedOutcome):
            before, after = getattr(outcome, field.name), getattr(restored, field.name)
            assert np.array_equal(before, after, equal_nan=field.type in ("Array", "float")), field.name
        assert "another input" in load_outcome(tmp_path, "other", OUTCOME.rpm)[1]


@pytest.mark.skipif(os.name != "posix", reason="pipes as POSIX has them")
def test_a_pipe_in_the_place_of_a_saved_speed_holds_nobody_up(tmp_path):
    os.mkfifo(file_of(tmp_path, 2200.0))
    started = time.monotonic()
    assert "is a pipe" in load_outcome(tmp_path, "key", 2200.0)[1]
    assert time.monotonic() - started < 60


JSON = {
    "no JSON": '{"webs": ' + "[" * 100_000,
    "no webs": "[]",
    "no  webs": '{"webs": 3}',
    "not symmetric": {"a": {"web": "w", "flexibility": [1.0, 2.0] * 72, "body": [0, 0, 0]}},
    "lacks its numbers": {"a": {"web": "w", "flexibility": [10**400] * 144, "body": [0, 0, 0]}},
    "lacks its": {"a": {"web": "w", "flexibility": ["x"] * 144, "body": [0, 0, 0]}},
    "lacks": {"a": 1},
    "not symmetric and": {"a": {"web": "w", "flexibility": [float("nan")] * 144, "body": [0, 0, 0]}},
}


@pytest.mark.parametrize("reason", JSON)
def test_webs_that_are_none_are_not_believed_whatever_their_checksum(reason, tmp_path):
    content = JSON[reason]
    if isinstance(content, dict):
        document = {"format": webs.FORMAT, "mesher": webs.mesher_digest()}
        content = json.dumps({**document, "checksum": webs._checksum(content), "webs": content})
    (tmp_path / "webs.json").write_text(content, encoding="utf-8")
    lines: list[str] = []
    assert open_store(tmp_path / "webs.json", lines.append).new_webs == {}
    assert len(lines) == 1
    assert " ".join(reason.split()) in lines[0]
