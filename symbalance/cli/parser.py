"""The parser of the whole command line; what a command needs is imported when it runs."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import Any, NoReturn

from symbalance.cli import (
    assign,
    atlas,
    balance,
    bench,
    bounds,
    check,
    completion,
    crankshaft,
    derive,
    design,
    draw,
    emit,
    engines,
    firing,
    formulas,
    overbalance,
    page,
    search,
    sensitivities,
    sheet,
    sweep,
    tolerances,
    torque,
)
from symbalance.cli.output import write
from symbalance.errors import SymbalanceError

COMMANDS = (
    balance,
    emit,
    torque,
    crankshaft,
    design,
    overbalance,
    firing,
    search,
    formulas,
    draw,
    page,
    sheet,
    atlas,
    sensitivities,
    sweep,
    tolerances,
    assign,
    derive,
    bounds,
    check,
    engines,
    bench,
    completion,
)
"""One module each: `add` adds its options, `run` does what it is for; in the order of the help."""


class _Parser(argparse.ArgumentParser):
    """A parser whose refusals are one line, like every other refusal."""

    def _print_message(self, message: str, file: Any = None) -> None:
        """Print help as any result: what cannot be written is refused, not passed over."""
        if message:
            write(message, None)

    def error(self, message: str) -> NoReturn:
        command = self.prog.removeprefix("symbalance").strip() or "command line"
        raise SymbalanceError(command, message, f"see {self.prog} --help")


def build_parser(arguments: Sequence[str] = ()) -> argparse.ArgumentParser:
    """Return the parser of the whole command line, or of one that begins with a command's name.

    The options of the other commands, which take longer to add than most balances to compute, are then
    left out.
    """
    parser = _Parser(
        prog="symbalance",
        description="Exact free forces and couples of piston engines.",
        epilog="Try: symbalance balance v12-60",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action=_Version, nargs=0, help="print the version and exit")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    named = [m for m in COMMANDS if [m.__name__.rpartition(".")[2]] == list(arguments[:1])]
    for module in named or COMMANDS:
        module.add(commands)
    return parser


class _Version(argparse.Action):
    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> NoReturn:
        from symbalance import __version__

        write(f"symbalance {__version__}\n", None)
        parser.exit()
