"""`symbalance design`: the counterweights and balance shafts that balance given orders."""

from __future__ import annotations

import argparse
from dataclasses import replace
from typing import TYPE_CHECKING

from symbalance.cli.options import ENGINE, add_operating_point, add_output, command, engine_of
from symbalance.cli.output import content_of, medium, whole_number, write, write_all
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.design.balancing import Design


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(
        commands,
        "design",
        run,
        "Counterweights and balance shafts that balance given orders, with a certificate.",
    )
    parser.add_argument("engine", metavar="ENGINE", help=ENGINE)
    parser.add_argument("--remove", metavar="N,…", default="1,2", help="orders to balance; default: 1,2")
    parser.add_argument(
        "--shafts", metavar="N", help="at most so many shafts; default: as many as it takes"
    )
    parser.add_argument(
        "--no-counter-rotation", action="store_true", help="no shaft may turn against the crank"
    )
    parser.add_argument(
        "--no-counterweights", action="store_true", help="nothing may be put on the crank"
    )
    parser.add_argument(
        "--stations",
        metavar="A,…",
        help="places for weights, in pitches, as --stations=1,-1; default: one if that does, or the ends",
    )
    parser.add_argument(
        "--spread", choices=("ends", "even"), default="ends", help="even: a weight at every station"
    )
    parser.add_argument(
        "--per-throw",
        action="store_true",
        help="counterweights on every throw, half the reciprocating mass",
    )
    parser.add_argument(
        "--vertical", metavar="W", default="1", help="weight of the vertical in the residual; default: 1"
    )
    parser.add_argument(
        "--lateral", metavar="W", default="1", help="weight of the lateral in the residual; default: 1"
    )
    parser.add_argument(
        "--length", metavar="L", default="1", help="pitches over which couples count; default: 1"
    )
    parser.add_argument("--most", metavar="KGMM", help="no weight may have a larger unbalance, kg mm")
    parser.add_argument("--ratio", metavar="λ", help="rod ratio l/r, overrides the engine's")
    parser.add_argument(
        "--segment",
        metavar="MM:MM:MM",
        help="the weights as segments cut from a ring: inner and outer radius and thickness, as 20:60:18",
    )
    parser.add_argument(
        "--density", metavar="KG/M3", help="of the segments; default: 7850, a crankshaft's steel"
    )
    add_operating_point(parser, "N", bore=True)
    add_output(parser)
    parser.add_argument("--write", metavar="FILE", help="write the balanced engine to FILE.toml")
    parser.add_argument("--picture", metavar="FILE", help="draw the ellipses to FILE.png or FILE.pdf")


def run(options: argparse.Namespace) -> int:
    """Design, print the design, and write the balanced engine and the picture where asked for."""
    remove = [whole_number(part, "remove") for part in options.remove.split(",")]
    shafts = None if options.shafts is None else whole_number(options.shafts, "shafts")
    stations = None if options.stations is None else options.stations.split(",")
    if options.density is not None and options.segment is None:
        raise SymbalanceError(
            "--density", "is of segments, and none are asked for", "add --segment 20:60:18"
        )

    from symbalance.design.balancing import design_balance

    design = design_balance(
        engine_of(options),
        remove,
        shafts=shafts,
        counter_rotation=not options.no_counter_rotation,
        counterweights=not options.no_counterweights,
        stations=stations,
        spread=options.spread,
        vertical=options.vertical,
        lateral=options.lateral,
        length=options.length,
        most=options.most,
        per_throw=options.per_throw,
    )
    if options.rpm is not None:
        design = design.at(rpm=options.rpm)
    if options.segment is not None:
        design = _cut(design, options)
    form = medium(options)
    if form == "text" and not options.full:
        design = replace(design, full=False)
    content = content_of(design, form, options)
    files = _files(design, options)
    if options.output in (None, "-"):
        if files:
            write_all(files)
        write(content, None, form)
    else:
        write_all({**files, options.output: content})
    return 0


def _cut(design: Design, options: argparse.Namespace) -> Design:
    """Return the design with its weights as segments of the ring that --segment says."""
    parts = [part.strip() for part in options.segment.split(":")]
    if len(parts) != 3:
        rule = "must be inner radius, outer radius and thickness in mm"
        raise SymbalanceError(f"--segment {options.segment}", rule, "write it like 20:60:18")
    inner, outer, thickness = parts
    density = {} if options.density is None else {"density": options.density}
    return design.cut_from(outer, thickness, inner, **density)


def _files(design: Design, options: argparse.Namespace) -> dict[str, str | bytes]:
    """Return the files asked for beside the design: the balanced engine, the picture."""
    texts: dict[str, str | bytes] = {}
    if options.write is not None:
        from symbalance.engine.engine_writing import engine_text

        if not options.write.endswith(".toml"):
            what = f"--write {options.write}"
            raise SymbalanceError(what, "must end in .toml", "other commands know engine files by it")
        texts[options.write] = engine_text(design.balanced)
    if options.picture is not None:
        from symbalance.design.balancing.design_picture import design_picture

        texts[options.picture] = design_picture(design, options.picture)
    return texts
