"""The picture of `symbalance bench crankshaft`: error against run time, one panel a model."""

from __future__ import annotations

import io
import math
from collections.abc import Sequence
from importlib import import_module
from typing import Any

from symbalance.bench.integrating.runs import Run

OURS = ("radau-iia", "radau-iia-9")


def drawn(runs: Sequence[Run]) -> dict[str, bytes]:
    """Return the picture as .png and .pdf."""
    import_module("matplotlib").use("Agg")
    pyplot = import_module("matplotlib.pyplot")
    panels = list(dict.fromkeys((r.case, r.model) for r in runs))
    figure, axes = pyplot.subplots(1, len(panels), figsize=(5.5 * len(panels), 4.5), squeeze=False)
    for axis, panel in zip(axes[0], panels, strict=True):
        _panel(axis, [r for r in runs if (r.case, r.model) == panel])
        axis.set_title(", ".join(panel))
    figure.tight_layout()
    files = {}
    for ending in ("png", "pdf"):
        stream = io.BytesIO()
        figure.savefig(
            stream, format=ending, dpi=130, metadata={"CreationDate": None} if ending == "pdf" else None
        )
        files[f".{ending}"] = stream.getvalue()
    pyplot.close(figure)
    return files


def _panel(axis: Any, runs: Sequence[Run]) -> None:
    for method in dict.fromkeys(r.method for r in runs):
        points = [(r.seconds, r.error) for r in runs if r.method == method and not math.isnan(r.error)]
        if points:
            style = (
                {"linewidth": 2.2, "marker": "o"} if method in OURS else {"linewidth": 1, "marker": "x"}
            )
            axis.loglog(*zip(*points, strict=True), label=method, **style)
    axis.axhline(1e-4, color="grey", linewidth=0.7, linestyle=":")
    axis.set_xlabel("CPU seconds for one cycle, preparation included")
    axis.set_ylabel("largest error, relative")
    axis.grid(True, which="major", linewidth=0.3)
    axis.legend(fontsize=8)
