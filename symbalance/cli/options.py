"""Command-line options shared by commands: engine, running conditions, output format."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from symbalance.budgets import Budget
from symbalance.cli.budget import USUAL, add_budget, read_budget, run_with_budget
from symbalance.cli.named_files import check_named_files
from symbalance.cli.outcomes import say
from symbalance.cli.output import MEDIA
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.engine.engine import Engine

ENGINE = "a preset (symbalance engines), a .toml file, or - for standard input"

RESERVED = frozenset(
    {"A", "C", "E", "F", "I", "S", "a", "l", "lam", "m", "n", "omega", "pi", "r", "theta"}
)
"""What stands for something else in formulas, or is a number of SymPy's."""
LONGEST_LETTER = 20
"""Characters of a letter that stands for an angle."""


def command(
    commands: argparse._SubParsersAction,
    name: str,
    run: Callable[[argparse.Namespace], int],
    summary: str,
    budget: Budget = USUAL,
    divides_budget: Callable[[argparse.Namespace], bool] = lambda options: False,
) -> argparse.ArgumentParser:
    """Return the parser of a command, which `run` does once its files are known to be in order.

    It ends within its budget; a command that `divides_budget` among the parts of its work, so that what
    is finished stands, sees to that itself.
    """

    def checked_run(options: argparse.Namespace) -> int:
        check_named_files(options)
        limit = read_budget(options.budget)
        if divides_budget(options):
            return run(options)
        return run_with_budget(name, limit, lambda: run(options))

    parser = commands.add_parser(name, help=summary, description=summary, allow_abbrev=False)
    parser.set_defaults(command=name, run=checked_run)
    add_budget(parser, budget)
    return parser


def add_output(parser: argparse.ArgumentParser, what: str = "FILE", *, full: bool = True) -> None:
    """Add the options of the medium a result is shown in, and of where it goes; see `output.show`.

    Where `what` is no FILE, the command adds its own -o. With `full` comes the option that shows what a
    short document leaves out and names.
    """
    if full and what == "FILE":
        help_ = "text, latex: all exact forms and tables, those that few readers need too"
        parser.add_argument("--full", action="store_true", help=help_)
    default = "what the ending of -o says (.tex, .html, .md, .json, .csv, .xlsx), else text"
    parser.add_argument(
        "--format",
        choices=tuple(MEDIA),
        help=f"default: {default}" if what == "FILE" else "on the terminal; default: text",
    )
    parser.add_argument(
        "--standalone", action="store_true", help="latex: a document that compiles alone, not a fragment"
    )
    parser.add_argument(
        "--label",
        metavar="PREFIX",
        help="latex: tables that float, with captions and labels: tab:PREFIX-force and so on",
    )
    if what == "FILE":
        help_ = "write to FILE instead of the terminal; - is the terminal"
        parser.add_argument("-o", "--output", metavar="FILE", help=help_)


def add_trust(parser: argparse.ArgumentParser, what: str) -> None:
    """Add the option by which a file may name files outside its folder."""
    parser.add_argument(
        "--trust-paths",
        action="store_true",
        help=f"{what} may name files anywhere; without it: in its own folder and below",
    )


def add_engine(parser: argparse.ArgumentParser, order: str | None = None) -> None:
    """Add the engine, its rod ratio, and the highest order where one is asked for."""
    parser.add_argument("engine", metavar="ENGINE", help=ENGINE)
    if order is not None:
        help_ = f"highest order, 1 to 1000; default: {order}"
        parser.add_argument("--order", metavar="N", default=order, help=help_)
    parser.add_argument("--ratio", metavar="λ", help="rod ratio l/r, overrides the engine's")


def add_bank(parser: argparse.ArgumentParser) -> None:
    """Add another bank angle for a vee, which may be a letter; see `bank_angle`."""
    parser.add_argument(
        "--bank",
        metavar="β",
        help="the angle between the two banks, degrees or a letter: 75, or alpha; the crank stays",
    )


def bank_angle(text: str) -> object:
    """Return the bank angle of --bank: a symbol where it is a letter's name, else a number as written."""
    if not (text.isidentifier() and len(text) <= LONGEST_LETTER):
        return text
    if text in RESERVED:
        rule = "is a letter that results use themselves"
        raise SymbalanceError(f"--bank {text}", rule, "take another, as alpha")
    import sympy

    return sympy.Symbol(text)


def add_operating_point(
    parser: argparse.ArgumentParser,
    speeds: str = "N or FROM:TO:STEP",
    *,
    rod: bool = True,
    pitch: bool = True,
    bore: bool = False,
) -> None:
    """Add the speed that values in N and N m are for, and the sizes that an engine may lack."""
    about = "for values in N and N m" + ("; several make a table" if ":" in speeds else "")
    speed = f"speed, {speeds}, {about}" if " " in speeds else f"speed, {about}"
    parser.add_argument("--rpm", metavar=speeds.split(maxsplit=1)[0], help=speed)
    for option, unit, what in (
        ("mass", "KG", "reciprocating mass of a cylinder"),
        ("stroke", "MM", "stroke"),
        *((("rod", "MM", "rod's length"),) if rod else ()),
        *((("pitch", "MM", "pitch of the cylinders"),) if pitch else ()),
        *((("bore", "MM", "bore"),) if bore else ()),
    ):
        parser.add_argument(f"--{option}", metavar=unit, help=f"{what}, where the engine gives none")


def engine_of(options: argparse.Namespace, sizes: Mapping[str, str] | None = None) -> Engine:
    """Return the engine a command is about, with the rod ratio and the sizes that its options give.

    `sizes` are those of a command whose options of these names mean something else.
    """
    from symbalance.engine.catalogue import load

    return resized(load(options.engine), options, sizes)


def resized(
    engine: Engine, options: argparse.Namespace, sizes: Mapping[str, str] | None = None
) -> Engine:
    """Return an engine with the rod ratio and the sizes that a command line gives.

    Sizes that no engine has, as metres for mm, are said in a line on stderr, and counted with.
    """
    from symbalance.engine.doubtful_sizes import doubtful_size
    from symbalance.forces.operating_point import sized

    if sizes is None:
        sizes = sizes_of(options)
    ratio = getattr(options, "ratio", None)
    if ratio is not None and "rod" in sizes:
        rule = "gives the rod ratio, and so does --ratio"
        raise SymbalanceError(f"--rod {sizes['rod']}", rule, "leave one out")
    whole = sized(engine if ratio is None else engine.with_ratio(ratio), sizes)
    if doubt := doubtful_size(whole):
        say(f"symbalance: {whole.name}: {doubt}")
    return whole


def sizes_of(options: argparse.Namespace) -> dict[str, str]:
    """Return the sizes that a command line gives, as they are written."""
    from symbalance.forces.operating_point import SIZES

    return {name: text for name in SIZES if (text := getattr(options, name, None)) is not None}


def check_speed_for_sizes(
    options: argparse.Namespace, sizes: Sequence[str] = ("mass", "pitch", "bore")
) -> None:
    """Refuse sizes that play a part at a speed only, where none is given."""
    if any(getattr(options, name, None) is not None for name in ("rpm", "pressure", "compression")):
        return
    for name in (*sizes, *(() if getattr(options, "rod", None) is not None else ("stroke",))):
        if getattr(options, name, None) is not None:
            remedy = "add --rpm N, or leave it out"
            raise SymbalanceError(f"--{name}", "plays a part at a speed only", remedy)


def add_running(parser: argparse.ArgumentParser, *, pitch: bool = False) -> None:
    """Add what makes an engine run: its pressure, speed and sizes."""
    pressure = parser.add_mutually_exclusive_group()
    pressure.add_argument(
        "--pressure", metavar="FILE", help="CSV: degrees after firing top dead centre, bar absolute"
    )
    pressure.add_argument("--compression", metavar="ε", help="an ideal Otto cycle of this compression")
    parser.add_argument(
        "--heat",
        metavar="Q",
        help="its heat added over the swept volume, in bar (100 J per litre); default: 18, 0: motored",
    )
    add_operating_point(parser, "N", pitch=pitch, bore=True)


def add_jobs(parser: argparse.ArgumentParser, what: str) -> None:
    """Add where the parts of long work run, `what` they are said to be; see `long_work`."""
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--jobs", metavar="N", default="1", help=f"processes that share the {what}; default: 1"
    )
    where.add_argument(
        "--dask", metavar="ADDRESS", help=f"a Dask scheduler, whose workers share the {what}"
    )
