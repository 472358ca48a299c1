"""A store of results: what is damaged, foreign or in the way is said, and never believed."""

from __future__ import annotations

import os

import pytest

from symbalance.errors import SymbalanceError
from symbalance.jobs import JSON, Job, LogProgress, Store, digest, key_of, run_jobs

KEY = key_of("a result")


@pytest.fixture
def store(tmp_path):
    store = Store(tmp_path / "store")
    store.save(KEY, b"payload\n\x00\xff")
    return store


def test_a_result_comes_back_as_it_was(store):
    saved = store.load(KEY)
    assert (saved.payload, saved.reason) == (b"payload\n\x00\xff", "")
    assert store.load(key_of("another")) == type(saved)(None, "")


@pytest.mark.slow
def test_every_byte_counts(store):
    path = store.path(KEY)
    content = path.read_bytes()
    for place in range(len(content)):
        for changed in (content[place] ^ 255, content[place] ^ 1):
            path.write_bytes(content[:place] + bytes([changed]) + content[place + 1 :])
            saved = store.load(KEY)
            assert saved.payload is None, place
            assert saved.reason, place
    for length in range(len(content)):
        path.write_bytes(content[:length])
        assert store.load(KEY).payload is None, length
    path.write_bytes(content + b"more")
    assert store.load(KEY).reason == "is damaged"


@pytest.mark.parametrize(
    "content",
    [b"", b"\n", b"[" * 100_000 + b"\n", b"{}\n", b"[1]\n", b'{"symbalance": "result"}\n', b"\xff\xfe\n"],
)
def test_what_is_no_result_is_said(store, content):
    store.path(KEY).write_bytes(content)
    assert store.load(KEY).reason


def test_another_key_in_the_same_slot_is_said_and_replaced(tmp_path):
    store = Store(tmp_path)
    store.save(key_of(1), b"one", "speed")
    assert (
        store.load(key_of(2), "speed").reason == "is of another input, other settings or another program"
    )
    store.save(key_of(2), b"two", "speed")
    assert store.load(key_of(2), "speed").payload == b"two"
    assert len(list(tmp_path.iterdir())) == 1


def test_a_pipe_or_a_folder_in_its_place_is_not_waited_for(store):
    path = store.path(KEY)
    path.unlink()
    os.mkfifo(path)
    assert store.load(KEY).reason == "is a pipe, not a file"
    path.unlink()
    path.mkdir()
    assert store.load(KEY).reason == "is a directory"


@pytest.mark.parametrize("slot", ["../outside", "a/b", ".hidden", "", "a\0b", "x" * 101, "a\n"])
def test_no_slot_leads_out_of_the_folder(tmp_path, slot):
    with pytest.raises(ValueError, match="no slot"):
        Store(tmp_path).path(slot)


def test_a_folder_that_cannot_be_is_refused_in_a_line(tmp_path):
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(SymbalanceError, match=r"--output .*cannot be written"):
        Store(tmp_path / "file" / "store", "--output").save(KEY, b"")


def test_bytes_that_do_not_decode_are_computed_anew(tmp_path, capsys):
    store, job = Store(tmp_path), Job("one", -1, KEY)
    store.save(KEY, b"no JSON")
    ((_, outcome),) = run_jobs(abs, [job], store=store, progress=LogProgress())
    assert (outcome.value, outcome.saved) == (1, False)
    assert "does not read (JSONDecodeError): computed anew" in capsys.readouterr().err
    ((_, outcome),) = run_jobs(abs, [job], store=store)
    assert (outcome.value, outcome.saved) == (1, True)


def test_json_gives_back_what_it_took():
    value = {"a": [1, 2.5, None, "ü\ud800"], "b": {"c": True}}
    assert JSON.decode(JSON.encode(value)) == value


@pytest.mark.slow
def test_digests_do_without_numpy_and_are_the_same_with_it():
    import subprocess
    import sys

    code = (
        "import sys; from symbalance.jobs import digest; "
        "print(digest(1, 2.5, 'a', b'b', None, [1], {'k': (2,)}), 'numpy' in sys.modules)"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.split() == [digest(1, 2.5, "a", b"b", None, [1], {"k": (2,)}), "False"]
