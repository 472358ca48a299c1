"""`symbalance check`: a person's derivation, judged equation by equation."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from symbalance.cli.ascii_spelling import as_quoted
from symbalance.cli.outcomes import DONE, FAILED, FAULT, say_fault
from symbalance.cli.output import write
from symbalance.errors import SymbalanceError


def run(options: argparse.Namespace) -> int:
    """Check the document and write the report; 1 if it is not to be relied on, 3 after a fault of ours.

    Not to be relied on: no relation was seen, or one is refuted, undecided or unreadable.
    """
    from symbalance.checking import check
    from symbalance.notes.checking import report_json, report_latex, report_text, sidecar_draft

    if options.declare:
        for given, name in ((options.format, "format"), (options.lenient, "lenient")):
            if given:
                raise SymbalanceError(f"--{name}", "plays no part in --declare", "leave it out")
        write(sidecar_draft(Path(options.notes), options.symbols), options.output, "source")
        return DONE
    checked = check(Path(options.notes), options.symbols)
    if options.format == "json":
        printed = json.dumps(report_json(checked), ensure_ascii=False, indent=1)
    elif options.format == "latex":
        printed = report_latex(checked)
    else:
        encoding = "utf-8" if options.output not in (None, "-") else sys.stdout.encoding or "utf-8"
        printed = report_text(checked, quoted=lambda text: as_quoted(text, encoding))
    write(printed.rstrip("\n") + "\n", options.output, options.format or "text")
    for verdict in checked.faults:
        say_fault(f"line {verdict.line} of {options.notes}: {verdict.fault}", verdict.traceback)
    if checked.faults:
        return FAULT
    return FAILED if checked.fails(lenient=options.lenient) else DONE
