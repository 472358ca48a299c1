"""`symbalance design`: the counterweights and balance shafts that balance given orders."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from symbalance.cli.output import medium, printed, whole_number, write, write_files
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.design.balancing import Design


def run(options: argparse.Namespace) -> int:
    """Design, print the design, and write the balanced engine and the picture where asked for."""
    remove = [whole_number(part, "remove") for part in options.remove.split(",")]
    shafts = None if options.shafts is None else whole_number(options.shafts, "shafts")
    stations = None if options.stations is None else options.stations.split(",")

    from symbalance.design.balancing import design_balance
    from symbalance.engine.catalogue import load

    design = design_balance(
        load(options.engine),
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
        ratio=options.ratio,
    )
    form = medium(options)
    text = printed(design, form, options.output, standalone=options.standalone)
    files = _files(design, options)
    if options.output in (None, "-"):
        if files:
            write_files(files)
        write(text, None, form)
    else:
        write_files({**files, options.output: text})
    return 0


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
