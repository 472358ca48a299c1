"""`symbalance balance`: an engine's free forces and couples."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symbalance.budgets import Budget, run_within
from symbalance.cli.budget import read_budget
from symbalance.cli.engine_comparison import (
    add_comparison,
    is_comparison,
    refuse_bank,
    refuse_comparison_options,
    show_comparison,
)
from symbalance.cli.long_work import STORE, long_work, output_folder, report_paths
from symbalance.cli.options import (
    ENGINE,
    add_bank,
    add_jobs,
    add_operating_point,
    add_output,
    bank_angle,
    check_speed_for_sizes,
    command,
    engine_of,
    resized,
)
from symbalance.cli.outcomes import DONE, FAULT, REFUSED, say_fault
from symbalance.cli.output import label_of, medium_of_several, printed, show, whole_number, write_all
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.forces.free_forces import Balance
    from symbalance.forces.speed_table import SpeedTable


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    summary = "Free forces and couples of an engine, order by order, exactly."
    parser = command(
        commands,
        "balance",
        run,
        summary,
        divides_budget=lambda options: options.engine is None and not is_comparison(options),
    )
    parser.add_argument(
        "engine",
        metavar="ENGINE",
        nargs="+",
        action=_Engines,
        help=f"{ENGINE}; several make one table, or with -o FOLDER/ a file each",
    )
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
    add_bank(parser)
    add_comparison(parser)
    add_operating_point(parser, bore=True)
    add_jobs(parser, "engines")
    add_output(parser)


class _Engines(argparse.Action):
    """Puts what is named into `engines`, and a single one into `engine`."""

    def __call__(
        self, parser: argparse.ArgumentParser, namespace: argparse.Namespace, values: Any, *_: object
    ) -> None:
        namespace.engines = values
        namespace.engine = values[0] if len(values) == 1 else None


def run(options: argparse.Namespace) -> int:
    """Load the engine, balance it, show the result."""
    order = whole_number(options.order, "order")
    power = None if options.power is None else whole_number(options.power, "power")
    if is_comparison(options):
        show_comparison(options, order)
        return 0
    refuse_comparison_options(options)
    if options.engine is None:
        return _balance_several(options, order, power)
    if options.dask is not None:
        raise SymbalanceError("--dask", "is for several engines", "leave it out, or name more")

    from symbalance.forces.free_forces import balance

    check_speed_for_sizes(options)
    engine = engine_of(options)
    if options.bank is not None:
        from symbalance.engine.builders import with_bank_angle

        engine = with_bank_angle(engine, bank_angle(options.bank))
    result = balance(engine, order, power=power)
    show(result if options.rpm is None else _at_speeds(result, options.rpm), options)
    return 0


def _at_speeds(result: Balance, rpm: str) -> Balance | SpeedTable:
    """Return a balance at a speed, or a table over several."""
    from symbalance.forces.operating_point import checked_speeds
    from symbalance.forces.speed_table import over_speeds

    speeds = checked_speeds(rpm)
    return result.at(rpm=speeds[0]) if len(speeds) == 1 else over_speeds(result, speeds)


def _balance_several(options: argparse.Namespace, order: int, power: int | None) -> int:
    """Balance several engines, each into a file of a folder; one that is refused stops no other."""
    refuse_bank(options)
    form = medium_of_several(options)

    from symbalance.jobs.running import Job, run_jobs
    from symbalance.jobs.store import TEXT_OR_BYTES, Store, key_of

    if options.label is not None and form == "latex":
        from symbalance.document.latex_document import checked_label

        checked_label(options.label)  # once, before the first is written
    names = [_result_name(engine) for engine in options.engines]
    folder = output_folder(options.output)
    paths = report_paths(folder, names, form, map(Path, options.engines))
    check_speed_for_sizes(options)
    settings = (order, power, options.rpm, form, options.standalone, options.full)
    loaded = [_loaded(engine, options) for engine in options.engines]
    limit = read_budget(options.budget)  # for each engine
    labels = [label_of(options.label, name) for name in names]
    jobs = [
        Job(engine, (limit, value, *settings, label), key)
        for engine, value, label in zip(options.engines, loaded, labels, strict=True)
        for key in [
            "" if isinstance(value, SymbalanceError) else key_of("balance", value, settings, label)
        ]
    ]
    code, store = DONE, Store(folder / STORE, "--output")
    with long_work(options, store.folder) as means:
        for place, (job, outcome) in enumerate(
            run_jobs(_balanced, jobs, store=store, codec=TEXT_OR_BYTES, **means)
        ):
            if outcome.is_done:
                write_all({str(paths[place]): outcome.value})
            elif outcome.problem is not None:
                code = max(code, REFUSED)
                means["progress"].say(f"symbalance: {outcome.problem}")
            else:
                code = FAULT
                say_fault(f"{job.name}: {outcome.fault}", outcome.traceback)
    return code


def _result_name(engine: str) -> str:
    """Return what an engine's result is called: the preset's name, or the file's without its ending."""
    if engine in ("", "-"):
        what = "standard input" if engine else "an empty name"
        raise SymbalanceError(f"ENGINE {engine!r}", f"is {what}, among several", "name a file")
    return Path(engine).name.removesuffix(".toml")


def _loaded(engine: str, options: argparse.Namespace) -> Any:
    """Return an engine, or why it cannot be read: that is said in its turn, and stops no other."""
    from symbalance.engine.catalogue import load

    try:
        return resized(load(engine), options)
    except SymbalanceError as problem:
        return problem


def _balanced(
    value: tuple[Budget, Any, int, int | None, str | None, str, bool, bool, str | None],
) -> str | bytes:
    """Return the balance of an engine in a medium, within the budget of one engine."""
    from symbalance.forces.free_forces import balance

    limit, engine, order, power, rpm, form, standalone, full, label = value
    if isinstance(engine, SymbalanceError):
        raise engine

    def work() -> str | bytes:
        result = balance(engine, order, power=power)
        shown = result if rpm is None else _at_speeds(result, rpm)
        return printed(shown, form, "file", standalone=standalone, full=full, label=label)

    return run_within(limit, work)
