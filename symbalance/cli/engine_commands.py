"""The options of the commands that take an engine."""

from __future__ import annotations

import argparse

from symbalance.cli.options import ENGINE, add_engine, add_output, add_running, command

TARGETS = ("numpy", "numba", "array-api", "c", "javascript", "octave")


def add_engine_commands(commands: argparse._SubParsersAction) -> None:
    """Add every command that takes an engine, in the order of the help."""
    _add_balance(commands)
    _add_emit(commands)
    _add_torque(commands)
    _add_crankshaft(commands)
    _add_design(commands)
    _add_sensitivities(commands)
    _add_tolerances(commands)
    _add_assign(commands)


def _add_balance(commands: argparse._SubParsersAction) -> None:
    parser = command(
        commands, "balance", "Free forces and couples of an engine, order by order, exactly."
    )
    parser.add_argument("engine", metavar="ENGINE", help=ENGINE)
    parser.add_argument(
        "--order", metavar="N", default="12", help="highest order, 1 to 1000; default: 12"
    )
    parser.add_argument(
        "--power",
        metavar="P",
        help="highest power of 1/λ in the printed series; default: two terms an order",
    )
    parser.add_argument(
        "--ratio", metavar="λ", help="rod ratio l/r, overrides the engine's: 4, 3.7 or 147.15/36.65"
    )
    add_output(parser)


def _add_emit(commands: argparse._SubParsersAction) -> None:
    parser = command(commands, "emit", "An engine's forces and couples as source code that runs alone.")
    parser.add_argument("engine", metavar="ENGINE", help=ENGINE)
    parser.add_argument("--target", choices=TARGETS, required=True, help="the language or library")
    parser.add_argument(
        "--outputs",
        metavar="NAMES",
        default="force.vertical",
        help="with commas: force. or couple. with vertical, lateral, forward, backward; piston. with "
        "displacement, velocity or acceleration; torque. with inertia, rod or frame, and with a pressure "
        "gas or total; default: force.vertical",
    )
    orders = parser.add_mutually_exclusive_group()
    orders.add_argument("--order", metavar="N", help="highest order, 1 to 1000")
    orders.add_argument(
        "--tolerance",
        metavar="ε",
        help="the fewest orders whose proven bound is within ε, in m r ω² (couples m r ω² a); "
        "default: every order that shows in a double",
    )
    parser.add_argument("--ratio", metavar="λ", help="rod ratio l/r, overrides the engine's")
    add_running(parser)
    parser.add_argument(
        "--uniform-grid",
        action="store_true",
        help="add a function for evenly spaced angles, which computes one period only",
    )
    parser.add_argument(
        "-o", "--output", metavar="FILE", help="the file to write; C writes FILE.c and FILE.h"
    )


def _add_torque(commands: argparse._SubParsersAction) -> None:
    parser = command(
        commands, "torque", "The torque on an engine's crank and frame: inertia exactly, gas on top."
    )
    add_engine(parser, "6")
    add_running(parser)
    parser.add_argument("--delta", metavar="δ", help="speed fluctuation; default: 0.02")
    add_output(parser)


def _add_crankshaft(commands: argparse._SubParsersAction) -> None:
    parser = command(commands, "crankshaft", "The running crankshaft: stress against the crank angle.")
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
        "--passes", metavar="N", default="9", help="orbit: how often films are made at most; default: 9"
    )
    parser.add_argument("--no-plots", action="store_true", help="leave the pictures out")
    add_output(parser, "FOLDER")
    parser.add_argument("-o", "--output", metavar="OUT", help="a folder for reports, curves and pictures")


def _add_design(commands: argparse._SubParsersAction) -> None:
    parser = command(
        commands,
        "design",
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
    add_output(parser)
    parser.add_argument("--write", metavar="FILE", help="write the balanced engine to FILE.toml")
    parser.add_argument("--picture", metavar="FILE", help="draw the ellipses to FILE.png or FILE.pdf")


def _add_sensitivities(commands: argparse._SubParsersAction) -> None:
    parser = command(
        commands, "sensitivities", "How each order changes with each size of each cylinder, worst first."
    )
    add_engine(parser, "4")
    parser.add_argument(
        "--parameters",
        metavar="NAMES",
        help="with commas, some of mass, throw, bank, station, stroke, rod, offset, rotating",
    )
    add_output(parser)


def _add_tolerances(commands: argparse._SubParsersAction) -> None:
    parser = command(commands, "tolerances", "The worst an engine within its tolerances can shake.")
    add_engine(parser, "4")
    for name, unit, about in (
        ("mass", "KG", "reciprocating mass, kg or percent (0.5%%)"),
        ("throw", "DEGREES", "crank pin angle"),
        ("bank", "DEGREES", "angle of a cylinder's axis"),
        ("station", "MM", "place along the crank, mm or percent of the pitch"),
        ("stroke", "MM", "stroke"),
        ("rod", "MM", "rod length"),
        ("offset", "MM", "offset of the axis from the crank"),
        ("rotating", "KG", "rotating mass, kg or percent of the reciprocating mass"),
    ):
        parser.add_argument(f"--{name}", metavar=unit, help=f"plus or minus, of every cylinder: {about}")
    parser.add_argument(
        "--of",
        metavar="NAMES",
        default="largest",
        help="with commas: largest (over a turn), vertical, lateral, forward, backward; default: largest",
    )
    parser.add_argument("--rpm", metavar="N", help="speed, for results in N and N m")
    add_output(parser)


def _add_assign(commands: argparse._SubParsersAction) -> None:
    parser = command(
        commands, "assign", "Which weighed part goes to which cylinder, with the least residual."
    )
    add_engine(parser)
    parser.add_argument(
        "--parts",
        metavar="FILE",
        required=True,
        help="CSV with a header: name, piston, rod_reciprocating, rod_rotating; kg",
    )
    parser.add_argument("--paired", action="store_true", help="keep a row's piston and rod together")
    parser.add_argument("--orders", metavar="LIST", default="1", help="orders that count; default: 1")
    parser.add_argument("--rpm", metavar="N", help="speed, for results in N and N m")
    parser.add_argument(
        "--lever",
        metavar="MM",
        help="a couple counts as the force at this lever; default: root mean square of the stations",
    )
    parser.add_argument(
        "--whole", action="store_true", help="count whole masses, not what they differ from their mean by"
    )
    add_output(parser)
