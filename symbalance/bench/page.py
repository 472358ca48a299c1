"""`symbalance bench page`: the size of engines' pages and the processor time that making them takes.

The balance is computed before the clock starts: what is measured is the page beyond it. Every preset, or
quickly one of each kind of engine.
"""

from __future__ import annotations

import gzip
import platform
from dataclasses import dataclass
from time import process_time

from symbalance.bench.timing import progress
from symbalance.engine.catalogue import load, preset_names
from symbalance.forces.free_forces import balance
from symbalance.pages.moving_page import ORDER, page

LARGEST, LARGEST_ZIPPED, SLOWEST = 150_000, 50_000, 1.5
"""Targets: bytes of a page, as it is and packed by gzip; seconds of processor time."""
KINDS = ("inline-3", "vw-vr6", "v8-90", "v12-60", "boxer-4", "bugatti-w16", "r-1820", "kharkiv-v2")


@dataclass(frozen=True)
class PageMeasurement:
    """A page's size in bytes, packed and not, and the seconds it took."""

    name: str
    size: int
    zipped: int
    seconds: float

    @property
    def is_met(self) -> bool:
        """Tell whether the page keeps every target."""
        return self.size <= LARGEST and self.zipped <= LARGEST_ZIPPED and self.seconds <= SLOWEST


@dataclass(frozen=True)
class PageReport:
    """The pages that were measured, the largest first."""

    pages: tuple[PageMeasurement, ...]

    def text(self) -> str:
        """Return the report as it is printed."""
        lines = [
            f"Python {platform.python_version()}, {platform.machine()}; pages to order {ORDER}",
            f"targets: {LARGEST} bytes, {LARGEST_ZIPPED} packed, {SLOWEST:g} s of processor time",
            "",
            f"{'engine':24}{'bytes':>9}{'packed':>9}{'seconds':>9}",
        ]
        for each in self.pages:
            missed = "" if each.is_met else "  missed"
            lines.append(f"{each.name:24}{each.size:9}{each.zipped:9}{each.seconds:9.2f}{missed}")
        return "\n".join(lines) + "\n"

    def missed_targets(self) -> list[PageMeasurement]:
        """Return the pages that miss a target."""
        return [each for each in self.pages if not each.is_met]


def measure(name: str) -> PageMeasurement:
    """Return the measurement of one preset's page."""
    result = balance(load(name), ORDER)
    start = process_time()
    data = page(result).html.encode()
    seconds = process_time() - start
    return PageMeasurement(name, len(data), len(gzip.compress(data, mtime=0)), seconds)


def report(quick: bool = False) -> PageReport:
    """Return the measurements of all presets, or of one of each kind."""
    measure(KINDS[0])  # once uncounted: what is imported then is there
    pages = []
    for name in KINDS if quick else preset_names():
        progress(name)
        pages.append(measure(name))
    return PageReport(tuple(sorted(pages, key=lambda each: -each.size)))
