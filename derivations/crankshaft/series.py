"""Figure 5 in kind: main bearing 3 of an in-line four, its film, its housing, and both in series.

    python derivations/crankshaft/series.py       writes pictures/crankshaft-series.png beside this folder

Stationary axes, 2200 rpm: the film's own direct stiffness (thin), the housing's (broken), the paper's
equivalent one (bold). Where the bold line runs above the thin one, the cross terms stiffen the joint.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from symbalance.bench.inline_four import CYCLE, Case, full_system
from symbalance.crankshaft.bearings.series import equivalent_coefficients

BEARING = 2


def drawn(path: Path) -> None:
    """Write the picture."""
    import matplotlib as mpl

    mpl.use("Agg")
    from matplotlib import pyplot

    system = full_system(Case("2200 rpm"))
    theta = CYCLE / 720 * np.arange(720)
    film = system.film.stiffness(theta), system.film.damping(theta)
    assert system.housing is not None
    series, _ = equivalent_coefficients(film, system.housing, 0.0)
    figure, axes = pyplot.subplots(2, 1, figsize=(8, 6.5), sharex=True)
    for i, (axis, name) in enumerate(zip(axes, ("vertical", "lateral"), strict=True)):
        own, both = film[0][:, BEARING, i, i] / 1e9, series[:, BEARING, i, i] / 1e9
        behind = system.housing.stiffness[BEARING, i, i] / 1e9
        axis.plot(np.degrees(theta), own, color="black", linewidth=0.8, label="film")
        axis.axhline(behind, color="black", linestyle="--", linewidth=0.8, label="housing")
        axis.plot(np.degrees(theta), both, color="tab:red", linewidth=2.2, label="in series")
        axis.fill_between(np.degrees(theta), own, both, where=both > own, color="tab:red", alpha=0.2)
        axis.set_yscale("symlog", linthresh=0.1)
        axis.set_ylabel(f"{name}, GN/m")
        axis.grid(True, linewidth=0.3)
    axes[0].legend(ncols=3, fontsize=8, loc="lower right", bbox_to_anchor=(1, 1), frameon=False)
    axes[1].set_xlabel("crank angle, degrees")
    axes[1].set_xticks(range(0, 721, 90))
    figure.tight_layout()
    figure.savefig(path, dpi=130, metadata={"Software": None})


if __name__ == "__main__":
    drawn(Path(__file__).parent.parent / "pictures" / "crankshaft-series.png")
