"""Functions of one job for the tests, which leave a file for every time that they are begun and ended."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path
from typing import Any
from uuid import uuid4

from symbalance.errors import SymbalanceError
from symbalance.jobs import Job, key_of, note


def square(value: Any) -> int:
    """Square a number, said and counted: (folder, number, seconds, what happens)."""
    folder, number, seconds, event = value
    mark(folder, "begun", number)
    if event == "dies once" and len(marks(folder, "begun", number)) == 1:
        os.kill(os.getpid(), signal.SIGKILL)
    if event == "dies":
        time.sleep(seconds)
        os.kill(os.getpid(), signal.SIGKILL)
    if event == "refused":
        raise SymbalanceError(f"number = {number}", "is refused", "take another")
    if event == "fault":
        raise ZeroDivisionError
    time.sleep(seconds)
    note(f"squared {number}")
    mark(folder, "ended", number)
    return number * number


def mark(folder: str, what: str, number: int) -> None:
    (Path(folder) / f"{what}-{number}-{uuid4().hex}-{os.getpid()}").touch()


def marks(folder: Any, what: str, number: int | str = "*") -> list[Path]:
    return sorted(Path(folder).glob(f"{what}-{number}-*"))


def jobs(
    folder: Path, count: int, seconds: float = 0.05, events: dict[int, str] | None = None
) -> list[Job]:
    values = [(str(folder), n, seconds, (events or {}).get(n, "")) for n in range(count)]
    return [Job(f"number {n}", value, key_of("square", n)) for n, value in enumerate(values)]
