"""The command line's parser; what a command does is imported when it runs."""

from __future__ import annotations

import argparse
from typing import Any, NoReturn

from symbalance.cli.engine_commands import add_engine_commands
from symbalance.cli.options import add_output, command
from symbalance.cli.output import write
from symbalance.errors import SymbalanceError

QUANTITIES = ("displacement", "velocity", "acceleration", "force", "rod-angle")
CONVENTIONS = ("l/r", "r/l", "l/s")
ROTATIONS = ("vector", "uvw", "uwv", "vuw", "vwu", "wuv", "wvu")


class _Parser(argparse.ArgumentParser):
    """A parser whose refusals are one line, like every other refusal."""

    def _print_message(self, message: str, file: Any = None) -> None:
        """Print help as any result: what cannot be written is refused, not passed over."""
        if message:
            write(message, None)

    def error(self, message: str) -> NoReturn:
        command = self.prog.removeprefix("symbalance").strip() or "command line"
        raise SymbalanceError(command, message, f"see {self.prog} --help")


def build_parser() -> argparse.ArgumentParser:
    """Return the parser of the whole command line."""
    parser = _Parser(
        prog="symbalance",
        description="Exact free forces and couples of piston engines.",
        epilog="Try: symbalance balance v12-60",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action=_Version, nargs=0, help="print the version and exit")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    add_engine_commands(commands)
    _add_derive(commands)
    _add_check(commands)
    _add_engines(commands)
    _add_bench(commands)
    return parser


class _Version(argparse.Action):
    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> NoReturn:
        from symbalance import __version__

        write(f"symbalance {__version__}\n", None)
        parser.exit()


def _add_derive(commands: argparse._SubParsersAction) -> None:
    parser = command(commands, "derive", "The harmonics of one slider-crank, derived as by hand.")
    parser.add_argument(
        "--quantity",
        choices=(*QUANTITIES, "crank-node"),
        default="force",
        help="default: force; crank-node: the equations of a node of the turning crankshaft",
    )
    parser.add_argument(
        "--rotation",
        choices=ROTATIONS,
        help="of crank-node: a rotation vector, or the order of Cardan angles; default: vector",
    )
    parser.add_argument("--order", metavar="N", help="highest order, 1 to 1000; default: 6")
    parser.add_argument(
        "--convention",
        choices=CONVENTIONS,
        help="what is expanded in: λ = l/r, ρ = r/l or λ = l/s (s the stroke); default: l/r",
    )
    add_output(parser)


def _add_check(commands: argparse._SubParsersAction) -> None:
    parser = command(commands, "check", "A hand derivation, judged equation by equation.")
    parser.add_argument(
        "notes", metavar="NOTES", help="a .tex, .md or .txt file, left as it is; - is standard input"
    )
    parser.add_argument(
        "--symbols",
        metavar="FILE",
        help="what the letters mean, and what lines claim; default: NOTES.symbols.toml beside it",
    )
    parser.add_argument(
        "--lenient",
        action="store_true",
        help="exit 0 although something could not be read; still 1 where nothing could",
    )
    parser.add_argument(
        "--declare", action="store_true", help="print a symbols file to fill in, with the letters missing"
    )
    add_output(parser)


def _add_engines(commands: argparse._SubParsersAction) -> None:
    parser = command(commands, "engines", "The preset engines, with their sources.")
    what = parser.add_mutually_exclusive_group()
    what.add_argument(
        "--show", metavar="NAME", help="print a preset's engine file, to start your own from"
    )
    what.add_argument(
        "--schema", action="store_true", help="print the JSON Schema of engine files, for editors"
    )
    add_output(parser)


def _add_bench(commands: argparse._SubParsersAction) -> None:
    parser = command(commands, "bench", "Measurements on this machine, against named alternatives.")
    parser.add_argument(
        "topic",
        choices=("derive", "check", "accuracy", "stability", "crankshaft"),
        help="what to measure",
    )
    parser.add_argument(
        "--quick", action="store_true", help="fewer repeats, and no alternative over 10 s"
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="NAME",
        help="accuracy, crankshaft: also write points to NAME.csv, pictures to NAME.png and NAME.pdf; "
        "other topics: write the table to the file NAME",
    )
