"""`symbalance check`: a person's derivation, judged equation by equation; or several, a line for each."""

from __future__ import annotations

import argparse
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from symbalance.cli.budget import read_budget
from symbalance.cli.options import add_jobs, add_output, add_trust, command
from symbalance.cli.outcomes import DONE, FAILED, FAULT, say_fault
from symbalance.cli.output import show, write, write_all
from symbalance.errors import SymbalanceError

if TYPE_CHECKING:
    from symbalance.notes.checking.verdicts import Checked


def add(commands: argparse._SubParsersAction) -> None:
    """Add the command and its options."""
    summary = "A hand derivation, judged equation by equation."
    parser = command(commands, "check", run, summary, divides_budget=lambda options: True)
    parser.add_argument(
        "notes",
        metavar="NOTES",
        nargs="+",
        action=_Documents,
        help="a .tex, .md, .txt, .ipynb, .wiki, .html, .adoc, .rst or .org file, left as it is; "
        "- is standard input; several, and folders of "
        "them, are a line each of a table, and with -o FOLDER a report each",
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
        "--declare",
        action="store_true",
        help="draft a symbols file: every letter, with what the text proposes, for you to confirm; of "
        "several documents, one .toml file for all of them; "
        "of one document --format html and others show the proposals typeset",
    )
    parser.add_argument(
        "--accept-proposals",
        action="store_true",
        help="take proposals as confirmed: those of the symbols file or, without one, the text's own; "
        "the report says so",
    )
    parser.add_argument(
        "--no-fixes",
        action="store_true",
        help="verdicts alone, without a search for what is meant: quicker",
    )
    parser.add_argument(
        "--certificates",
        metavar="FILE",
        help="of one document: write a certificate of each verdict to FILE.json, which "
        "verify_certificates.py, a program of the standard library alone, retraces",
    )
    add_jobs(parser, "documents")
    add_trust(parser, "the symbols file")
    add_output(parser, full=False)


class _Documents(argparse.Action):
    """Puts what is named into `documents`, and into `notes` a single one that is no folder."""

    def __call__(
        self, parser: argparse.ArgumentParser, namespace: argparse.Namespace, values: Any, *_: object
    ) -> None:
        namespace.documents = values
        is_one = len(values) == 1 and not os.path.isdir(values[0])
        namespace.notes = values[0] if is_one else None


def run(options: argparse.Namespace) -> int:
    """Check the document and write the report; 1 if it is not to be relied on, 3 after a fault of ours.

    Not to be relied on: no relation was seen, or one is refuted, undecided or unreadable.
    """
    from symbalance.checking import check
    from symbalance.text.files import file_name

    if options.notes is None:
        from symbalance.cli.check_several import check_several

        return check_several(options)
    if options.dask is not None:
        raise SymbalanceError("--dask", "is for several documents", "leave it out, or name a folder")
    if options.declare:
        return _declare(options)
    limit = read_budget(options.budget)
    checked = check(
        Path(options.notes),
        options.symbols,
        budget=limit,
        trust_paths=options.trust_paths,
        accept_proposals=options.accept_proposals,
        fixes=not options.no_fixes,
    )
    show(checked, options)
    if options.certificates is not None:
        _write_certificates(checked, options.certificates)
    for verdict in checked.faults:
        place = f"line {verdict.line} of {file_name(options.notes)}"
        say_fault(f"{place}: {verdict.fault}", verdict.traceback)
    if checked.faults:
        return FAULT
    return FAILED if checked.fails(lenient=options.lenient) else DONE


def _write_certificates(checked: Checked, name: str) -> None:
    """Write the certificates of a document's verdicts."""
    import json

    from symbalance.notes.checking.reports.certificates import certificates

    if not name.endswith(".json"):
        raise SymbalanceError(
            f"--certificates {name}", "is no .json file", "name one: page.certificates.json"
        )
    write_all({name: json.dumps(certificates(checked), ensure_ascii=False, indent=1) + "\n"})


def _declare(options: argparse.Namespace) -> int:
    """Write the draft of a symbols file or, in a medium that is asked for, what is proposed, typeset."""
    from symbalance.checking import sidecar_draft

    for name in ("standalone", "label", "lenient", "accept_proposals", "no_fixes", "certificates"):
        if getattr(options, name):
            option = name.replace("_", "-")
            raise SymbalanceError(f"--{option}", "plays no part in --declare", "leave it out")
    draft = sidecar_draft(Path(options.notes), options.symbols, budget=read_budget(options.budget))
    if options.format is None:
        write(draft.toml(), options.output, "source")
    else:
        show(draft, options)
    return DONE
