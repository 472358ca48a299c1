"""`symbalance search`: the best crank and firing order of all, with proof."""

from __future__ import annotations

import argparse
import os
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from symbalance.cli.budget import ENDLESS
from symbalance.cli.long_work import long_work
from symbalance.cli.options import add_jobs, add_output, command
from symbalance.cli.outcomes import DONE
from symbalance.cli.output import medium, show, whole_number, write, write_folder
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.search.search_result import CrankSearch


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    summary = "The best of all cranks and firing orders: the whole Pareto front, proved."
    parser = command(commands, "search", run, summary, ENDLESS)
    parser.add_argument("--cylinders", metavar="N", required=True, help="cylinders, up to 24")
    parser.add_argument("--strokes", metavar="2|4", default="4", help="strokes of a cycle; default: 4")
    parser.add_argument(
        "--banks", metavar="β,…", default="0", help="banks, degrees from vertical, as -45,45; default: 0"
    )
    parser.add_argument(
        "--pins",
        metavar="KIND",
        default="shared",
        help="shared by a row, split (one for each cylinder) or offset[:DEGREES]; default: shared",
    )
    parser.add_argument(
        "--intervals",
        metavar="D,…",
        default="even",
        help="degrees between firings, or any (with --grid); default: even",
    )
    parser.add_argument("--grid", metavar="D", help="all throws are multiples of so many degrees, as 90")
    parser.add_argument(
        "--stations", metavar="Z,…", help="places along the crank, front first, in pitches; default: even"
    )
    names = "force.N, couple.N, bending, bearing, torsion.Q, adjacent, evenness"
    parser.add_argument("--minimize", metavar="NAMES", help=f"what is to be small: {names}")
    parser.add_argument("--require", metavar="NAME=V,…", help="what must be so, exactly: couple.1=0")
    parser.add_argument("--limit", metavar="NAME<=V,…", help="what may not be passed: couple.2<=0.5")
    parser.add_argument(
        "--after",
        metavar="WHAT",
        nargs="+",
        help="counterweights, or balance-shafts and their orders: what they balance counts no more",
    )
    parser.add_argument(
        "--mode",
        metavar="A,…",
        action="append",
        default=[],
        help="a mode shape for torsion.Q, one value for each cylinder; a second one is torsion.Q:2",
    )
    parser.add_argument(
        "--list", metavar="K", default="100", help="classes named of each point; default: 100"
    )
    parser.add_argument(
        "--engines", metavar="FOLDER", help="write an engine file for each star that is named there"
    )
    parser.add_argument(
        "--pages",
        metavar="FOLDER",
        help="write a page of each of these engines in motion, as `page` does",
    )
    parser.add_argument(
        "--ratio", metavar="λ", default="4", help="rod ratio l/r of the pages' engines; default: 4"
    )
    parser.add_argument(
        "--certificate",
        metavar="FILE",
        help="write there why each branch ends, for symbalance/search/certificate_check.py to verify",
    )
    parser.add_argument(
        "--keep", metavar="FOLDER", help="parts are kept there, and not searched again after a break"
    )
    add_jobs(parser, "parts of the search")
    add_output(parser)


def run(options: argparse.Namespace) -> int:
    """Search and show what comes of it; that there is none is an answer too."""
    medium(options)
    question = {
        "strokes": whole_number(options.strokes, "strokes"),
        "banks": _parts(options.banks),
        "pins": options.pins,
        "intervals": options.intervals,
        "grid": options.grid,
        "stations": None if options.stations is None else _parts(options.stations),
        "minimize": _named("minimize", options.minimize),
        "require": _named("require", options.require),
        "limit": _named("limit", options.limit),
        "after": options.after,
        "modes": [_parts(mode) for mode in options.mode],
        "listed": whole_number(options.list, "list"),
    }
    cylinders = whole_number(options.cylinders, "cylinders")

    from symbalance.cli.long_work import output_folder
    from symbalance.cli.outcomes import say
    from symbalance.jobs.store import Store
    from symbalance.search.cranks_search import expected_work, search_cranks

    work = expected_work(cylinders, **question)

    certificate = None
    if options.certificate is not None:  # first: it may be refused, and the search may take hours
        from symbalance.search.certificate import search_certificate

        certificate = search_certificate(cylinders, **question)
        if question["minimize"]:
            say("symbalance: the certificate is of the conditions: that a front is one is not in it")
    folders = {  # before the search too
        option: output_folder(folder, f"--{option}")
        for option, folder in (("engines", options.engines), ("pages", options.pages))
        if folder is not None
    }
    if "pages" in folders:  # a bad ratio is refused before the search too
        from symbalance.engine.cylinders import Cylinder
        from symbalance.engine.engine import Engine

        Engine([Cylinder(1)]).with_ratio(options.ratio)
    if work is not None:
        say(f"symbalance: {work}")
    store = None if options.keep is None else Store(Path(options.keep), "--keep")
    with long_work(options, store and store.folder) as means:
        result = search_cranks(cylinders, store=store, **question, **means)
    if certificate is not None:
        write(certificate, options.certificate, "json")
    if "engines" in folders:
        from symbalance.engine.engine_writing import engine_text

        files = {f"{star.engine.name}.toml": engine_text(star.engine) for star in result}
        write_folder(folders["engines"], files, say)
    if "pages" in folders:
        from symbalance.pages.moving_page import page

        files = {
            f"{star.engine.name}.html": page(star.engine.with_ratio(options.ratio)).html
            for star in result
        }
        write_folder(folders["pages"], files, say)
    linked = {"pages": ".html", "engines": ".toml"}
    option = next((name for name in linked if name in folders), None)
    if option is not None:
        result = replace(result, links=_links(result, folders[option], linked[option], options.output))
    show(result, options)
    return DONE


def _links(result: CrankSearch, folder: Path, ending: str, output: str | None) -> dict[str, str]:
    """Return where each star's file is, as seen from the file that is written, or from here."""
    start = "." if output in (None, "-") else os.path.dirname(output) or "."
    place = Path(os.path.relpath(folder, start)).as_posix()
    return {star.engine.name: f"{place}/{star.engine.name}{ending}" for star in result}


def _named(option: str, text: str | None) -> list[str]:
    """Return the names or conditions of an option; one that is empty is a slip, not a search of all."""
    parts = _parts(text or "")
    if text is not None and not parts:
        raise SymbalanceError(f"--{option} {text!r}", "names nothing", "as couple.1, or leave it out")
    return parts


def _parts(text: str) -> list[str]:
    """Return what stands between the commas of an option."""
    return [part.strip() for part in text.split(",") if part.strip()]
