"""`symbalance crankshaft`: an engine's crankshaft as it runs, from its file to a folder of results."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from symbalance.cli.budget import ENDLESS
from symbalance.cli.long_work import long_work, output_folder, take_one_blas_thread
from symbalance.cli.options import add_jobs, add_output, add_trust, command
from symbalance.cli.outcomes import say
from symbalance.cli.output import for_terminal, medium, printed, show, whole_number, write_folder
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.crankshaft.reports import Summary


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    summary = "The running crankshaft: stress against the crank angle."
    parser = command(commands, "crankshaft", run, summary, ENDLESS)
    parser.add_argument(
        "engine",
        metavar="ENGINE",
        help="a .toml file with [crankshaft], [bearings] and [running]",
    )
    parser.add_argument("--rpm", metavar="N", help="speeds: 2200, 1000,2200 or from:to:step")
    parser.add_argument(
        "--modes", metavar="N", default="0", help="modes kept beside the static shapes; default: 0, all"
    )
    parser.add_argument("--steps", metavar="N", default="720", help="steps of a cycle; default: 720")
    parser.add_argument(
        "--webs",
        choices=("solid", "fitted", "formula", "nominal"),
        default="formula",
        help="where the webs' stiffness comes from; solid and fitted need the mesher; default: formula",
    )
    parser.add_argument(
        "--connection",
        choices=("exact", "equivalent"),
        default="exact",
        help="film and housing in series: exactly, or as one equivalent stiffness; default: exact",
    )
    parser.add_argument(
        "--about",
        choices=("orbit", "centre"),
        default="orbit",
        help="what the films are linear about: the journals' orbits, or the centre as the paper has it",
    )
    parser.add_argument(
        "--passes", metavar="N", default="9", help="orbit: most iterations of the films; default: 9"
    )
    parser.add_argument("--no-plots", action="store_true", help="leave the pictures out")
    add_jobs(parser, "speeds")
    add_trust(parser, "the engine file")
    add_output(parser, "FOLDER")
    parser.add_argument("-o", "--output", metavar="OUT", help="a folder for reports, curves and pictures")


def run(options: argparse.Namespace) -> int:
    """Run the engine at every speed, each saved when it is finished; 1 if a result is not valid.

    Not valid: films that do not settle, an orbit beyond its clearance, an unstable speed, steps too
    coarse, a safety factor below 1.
    """
    modes = whole_number(options.modes, "modes")
    steps = whole_number(options.steps, "steps")
    iterations = whole_number(options.passes, "passes")
    folder = None if options.output is None else output_folder(options.output)
    terminal = for_terminal(options)
    form = medium(terminal)
    take_one_blas_thread()

    from symbalance.crankshaft.files import read_running_engine
    from symbalance.crankshaft.reports import summarise_run
    from symbalance.crankshaft.reports.pictures import check_drawing
    from symbalance.crankshaft.running import configure_run, run_speeds
    from symbalance.crankshaft.running.measured import check_overlay

    _check_libraries()
    if not options.no_plots:
        check_drawing()
    engine = read_running_engine(options.engine, trust_paths=options.trust_paths)
    if options.rpm is not None:
        engine = engine.at_speeds(_speeds(options.rpm))
    configuration = configure_run(
        engine,
        webs=options.webs,
        modes=modes,
        connection=options.connection,
        steps=steps,
        about=options.about,
        iterations=iterations,
        store=None if folder is None else folder / "webs.json",
        say=say,
    )
    if engine.operation.overlay is not None:  # before the long run, not after it
        names = [channel.name for channel in configuration.channels]
        check_overlay(engine.operation.overlay, names, engine.engine.strokes * 180)
    speeds = None if folder is None else folder / "speeds"
    with long_work(options, speeds) as means:
        outcomes = run_speeds(configuration, speeds, **means)
    summary = summarise_run(configuration, outcomes)
    if not options.no_plots and (folder is not None or form == "html"):
        summary = summary.with_pictures()
    if folder is not None:
        _write_all(folder, summary)
    show(summary, terminal)
    return 0 if summary.valid else 1


REPORTS = {"txt": "text", "tex": "latex", "html": "html", "json": "json"}
"""The media of the reports that a folder gets, by their ending."""


def _write_all(folder: Path, summary: Summary) -> None:
    """Write every report, curve and picture: who reads the folder has those of one run."""
    from symbalance.crankshaft.files.operation import speed_text
    from symbalance.crankshaft.reports import curves_csv, loads_csv

    reports = {
        f"report.{ending}": printed(summary, form, str(folder), standalone=form == "latex")
        for ending, form in REPORTS.items()
    }
    contents: dict[str, str | bytes] = {
        **reports,
        **{f"curves-{speed_text(o.rpm)}rpm.csv": curves_csv(o) for o in summary.outcomes},
        **{
            f"loads-{speed_text(o.rpm)}rpm.csv": loads_csv(o, summary.configuration)
            for o in summary.outcomes
        },
        **summary.pictures,
    }
    write_folder(folder, contents, say)
    patterns = ("curves-*rpm.csv", "loads-*rpm.csv", "*.png")
    older = sorted({p.name for pattern in patterns for p in folder.glob(pattern)} - {*contents})
    if older:
        say(f"{folder}: of earlier runs, no part of this report: {', '.join(older)}")


def _check_libraries() -> None:
    from importlib.util import find_spec

    from symbalance.errors import MissingPartError

    for name in ("scipy", "rainflow"):
        if sys.modules.get(name, name) is None or find_spec(name) is None:
            raise MissingPartError(
                "crankshaft", f"{name} is not installed", "pip install 'symbalance[crankshaft]'"
            )


def _speeds(text: str) -> list[float]:
    """Return the speeds of --rpm: 2200, or 1000:4000:500, or 1000,2200."""
    from symbalance.crankshaft.running.speed_sweep import speeds_between

    what, remedy = f"--rpm {text}", "write 2200, 1000,2200 or from:to:step, as in 1000:4000:500"
    try:
        parts = [float(part) for part in text.replace(":", ",").split(",")]
    except ValueError:
        raise SymbalanceError(what, "must be speeds in rpm", remedy) from None
    if not all(0 < part < 1e6 for part in parts):
        raise SymbalanceError(what, "must be positive speeds in rpm", remedy)
    if ":" not in text:
        return parts
    if len(parts) != 3 or "," in text or parts[0] > parts[1]:
        raise SymbalanceError(what, "must be from:to:step", remedy)
    low, high, step = parts
    return list(speeds_between(low, high, step, what))
