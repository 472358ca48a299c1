"""`symbalance atlas`: a static site of engines in motion, and a table that sorts by what shakes."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from symbalance.cli.long_work import STORE, long_work, output_folder
from symbalance.cli.options import add_jobs, command
from symbalance.cli.outcomes import DONE, FAULT, REFUSED, say_fault
from symbalance.cli.output import whole_number, write_all
from symbalance.errors import SymbalanceError

INDEX = "index"


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    parser = command(commands, "atlas", run, "A folder of pages, one an engine, and a table of all.")
    parser.add_argument(
        "engines", metavar="ENGINE", nargs="*", help="presets or files; default: all presets"
    )
    parser.add_argument("--order", metavar="N", default="12", help="highest order; default: 12")
    add_jobs(parser, "engines")
    parser.add_argument(
        "-o", "--output", metavar="FOLDER", required=True, help="created where it is not there"
    )


def run(options: argparse.Namespace) -> int:
    """Write each engine's page as it is finished, and the table last; one refused stops no other."""
    order = whole_number(options.order, "order")

    from symbalance.engine.catalogue import preset_names
    from symbalance.jobs.running import Job, run_jobs
    from symbalance.jobs.store import JSON, Store, key_of
    from symbalance.pages.atlas import atlas_index
    from symbalance.pages.published_tables import published_cells

    engines = list(dict.fromkeys(options.engines)) or list(preset_names())
    names = _file_names(engines)
    folder = output_folder(options.output)
    jobs = []
    for engine in engines:
        value = _loaded(engine)
        key = "" if isinstance(value, SymbalanceError) else key_of("atlas", value, order)
        jobs.append(Job(engine, (value, order), key))
    code, store = DONE, Store(folder / STORE, "--output")
    entries: list[tuple[str, dict[str, Any]]] = []
    refused: list[str] = []
    with long_work(options, store.folder) as means:
        outcomes = run_jobs(_entry, jobs, store=store, codec=JSON, **means)
        for name, (job, outcome) in zip(names, outcomes, strict=True):
            if outcome.is_done:
                file = f"{name}.html"
                write_all({str(folder / file): outcome.value["html"]})
                entries.append((file, outcome.value["row"]))
            elif outcome.problem is not None:
                code = max(code, REFUSED)
                refused.append(str(outcome.problem))
                means["progress"].say(f"symbalance: {outcome.problem}")
            else:
                code = FAULT
                refused.append(f"{job.name}: {outcome.fault}")
                say_fault(f"{job.name}: {outcome.fault}", outcome.traceback)
    cells = [
        cell
        for cell in published_cells()
        if not options.engines or cell.engine in {row["engine"][0] for _, row in entries}
    ]
    write_all({str(folder / f"{INDEX}.html"): atlas_index(entries, refused, order, cells)})
    return code


def _file_names(engines: list[str]) -> list[str]:
    """Return the pages' names, none that of the table, nor of two engines."""
    names: dict[str, str] = {}
    for engine in engines:
        if engine in ("", "-"):
            what = "standard input" if engine else "an empty name"
            raise SymbalanceError(f"ENGINE {engine!r}", f"is {what}, in an atlas", "name a file")
        name = Path(engine).name.removesuffix(".toml")
        plain = (
            "".join(c if c.isalnum() or c in "-_." else "-" for c in name).strip("-.")[:60] or "engine"
        )
        if plain.casefold() == INDEX or plain.casefold() in {n.casefold() for n in names.values()}:
            rule = f"would be {plain}.html, and that is another page"
            raise SymbalanceError(f"ENGINE {engine}", rule, "give it a file name of its own")
        names[engine] = plain
    return [*names.values()]


def _loaded(engine: str) -> Any:
    """Return an engine, or why it cannot be read: that is said in its turn, and stops no other."""
    from symbalance.engine.catalogue import load

    try:
        return load(engine)
    except SymbalanceError as problem:
        return problem


def _entry(value: tuple[Any, int]) -> dict[str, Any]:
    """Return an engine's page and its row."""
    engine, order = value
    if isinstance(engine, SymbalanceError):
        raise engine

    from symbalance.pages.atlas import atlas_entry

    entry = atlas_entry(engine, order)
    return {"html": entry.html, "row": entry.row}
