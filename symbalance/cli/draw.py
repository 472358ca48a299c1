"""`symbalance draw`: one drawing of an engine as SVG, TikZ, PNG or PDF."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from symbalance.cli.options import add_engine, add_operating_point, command, engine_of
from symbalance.cli.output import whole_number, write
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.document.shapes import Drawing

MOVING = ("section", "plan", "oblique")
WHAT = (*MOVING, "star", "firing", "forces", "path", "couple-path", "orders", "torque", "overview")
ENDINGS = (".svg", ".tex", ".png", ".pdf")


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(
        commands, "draw", run, "A drawing of an engine or of its forces: SVG, TikZ, PNG, PDF."
    )
    add_engine(parser)
    parser.add_argument("--what", choices=WHAT, default="section", help="default: section")
    parser.add_argument(
        "--angle", metavar="θ", help="crank angle in degrees, of section, plan and oblique; default: 0"
    )
    parser.add_argument(
        "--order", metavar="N", help="star: its order, default 1; else the highest, default 12"
    )
    add_operating_point(parser, "N")
    parser.add_argument(
        "-o", "--output", metavar="FILE", help=f"{', '.join(ENDINGS)}; without it SVG on the terminal"
    )


def run(options: argparse.Namespace) -> int:
    """Draw, and write the drawing in the form that the file's ending says."""
    output = options.output or "-"
    ending = ".svg" if output == "-" else "." + output.rpartition(".")[2].lower()
    if ending not in ENDINGS:
        raise SymbalanceError(f"-o {output}", f"must end in {', '.join(ENDINGS)}", "as -o engine.svg")
    drawing = _drawing(options)
    if ending == ".svg":
        from symbalance.document.svg_writer import drawing_svg

        write(drawing_svg(drawing, standalone=True), options.output, "source")
    elif ending == ".tex":
        from symbalance.document.tikz_writer import drawing_tikz

        write(f"% Needs \\usepackage{{tikz}}\n{drawing_tikz(drawing)}", options.output, "latex")
    else:
        from symbalance.document.picture_files import drawing_picture

        write(drawing_picture(drawing, ending[1:]), options.output)
    return 0


def _drawing(options: argparse.Namespace) -> Drawing:
    what = options.what
    _check_options(options)
    engine = engine_of(options)
    if what in MOVING:
        from symbalance import draw

        return {"section": draw.section, "plan": draw.plan, "oblique": draw.oblique}[what](
            engine, _angle(options.angle)
        )
    if what == "star":
        from symbalance.drawing.crank_star import draw_star_alone

        return draw_star_alone(engine, options.order or 1)
    if what == "firing":
        from symbalance.drawing.firing_diagram import draw_firing

        return draw_firing(engine)
    order = 12 if options.order is None else whole_number(options.order, "order")
    at_speed = {} if options.rpm is None else {"rpm": options.rpm}
    if what == "torque":
        from symbalance.torque import inertia_torque
        from symbalance.torque.pictures import draw_torque

        torque = inertia_torque(engine, order)
        return draw_torque(torque.at(**at_speed) if at_speed else torque)
    from symbalance.forces.free_forces import balance
    from symbalance.forces.pictures import draw_force_path, draw_forces, draw_orders

    result = balance(engine, order)
    result = result.at(**at_speed) if at_speed else result
    if what in ("couple-path", "overview"):
        from symbalance.draw import overview

        return overview(result) if what == "overview" else draw_force_path(result, "couple")
    return {"forces": draw_forces, "path": draw_force_path, "orders": draw_orders}[what](result)


def _check_options(options: argparse.Namespace) -> None:
    """Refuse options that another drawing takes."""
    what = options.what
    unused = {
        "angle": what not in MOVING,
        "order": what in (*MOVING, "firing"),
        "rpm": what in (*MOVING, "firing", "star"),
    }
    for name, is_unused in unused.items():
        if is_unused and getattr(options, name) is not None:
            raise SymbalanceError(f"--{name}", f"says nothing of --what {what}", "leave it out")


def _angle(text: str | None) -> float:
    if text is None:
        return 0.0
    from symbalance.text.numbers import exact

    return float(exact(text, "--angle"))
