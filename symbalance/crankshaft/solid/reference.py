"""A four-cylinder crank meshed whole: the frequencies every web model is measured against.

    python -m symbalance.crankshaft.solid.reference derivations/crankshaft/solid_four.json

writes the first twenty elastic frequencies of the bare crank and of the one with drawn counterweights, on
two meshes each; some minutes. The crank: radius 60, journals 65, pins 55, pitch 110 mm, the remaining
sizes chosen: journals 30, pins 32, webs 24 long, webs 100 wide, 38 beyond the pin, 44 beyond the journal,
fillets 4 mm, sectors out to 85 mm over 2 x 60 degrees. Its ends are alike, so that it is its own mirror
image twice and a quarter of it is solved.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from dataclasses import replace
from math import pi
from pathlib import Path
from time import perf_counter

from symbalance.crankshaft.crank import Crank, Journal, Material, Part, Pin, Web
from symbalance.crankshaft.webs.sector import sector_counterweight

SIZES = (0.020, 0.016)
"""The elements' sizes, in m."""


def reference_four(*, weighted: bool) -> Crank:
    """Return the in-line four, with drawn counterweights or without.

    >>> round(reference_four(weighted=True).length, 6)
    0.47
    """
    radius, material = 0.060, Material()
    journal = Journal(0.065, 0.030, fillet=0.004)
    slab = Web(0.024, 0.100, 0.038, 0.044)
    sector = sector_counterweight(slab, 0.0, radius, 0.085, pi / 3, material)
    parts: list[Part] = [journal]
    for cylinder, angle in enumerate((0.0, pi, pi, 0.0), start=1):
        web = replace(slab, counterweight=replace(sector, angle=angle + pi)) if weighted else slab
        parts += [web, Pin(0.055, 0.032, radius, angle, (cylinder,), fillet=0.004), web, journal]
    return Crank(tuple(parts), material)


def measured(sizes: Sequence[float] = SIZES, count: int = 20) -> dict[str, object]:
    """Return the solid cranks' frequencies (Hz) for each size of elements (m), and the seconds taken."""
    from symbalance.crankshaft.solid.free_modes import solid_frequencies

    found: dict[str, object] = {}
    for name, weighted in (("bare", False), ("weighted", True)):
        for size in sizes:
            start = perf_counter()
            frequencies = solid_frequencies(reference_four(weighted=weighted), size, count)
            seconds = round(perf_counter() - start, 1)
            row = [round(float(f), 3) for f in frequencies]
            found[f"{name} {size * 1e3:g}"] = {"frequencies": row, "seconds": seconds}
            print(f"{name}, {size * 1e3:g} mm: {seconds} s", file=sys.stderr, flush=True)
    return found


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(json.dumps(measured(), indent=1) + "\n", encoding="utf-8")
