"""Check of several documents, each a job: a table with a line for each, a report of each in a folder."""

from __future__ import annotations

import argparse
import os
import re
import unicodedata
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from symbalance.budgets import Budget
from symbalance.checking import check
from symbalance.cli.budget import read_budget
from symbalance.cli.long_work import STORE, long_work, output_folder, report_paths
from symbalance.cli.named_files import declared_files
from symbalance.cli.outcomes import DONE, FAILED, FAULT, REFUSED, say, say_fault
from symbalance.cli.output import for_terminal, medium_of_several, printed, show, write, write_all
from symbalance.errors import SymbalanceError
from symbalance.jobs.running import Job, JobOutcome, run_jobs
from symbalance.jobs.store import JSON, Codec, Store, key_of
from symbalance.notes.checking.documents import COURSE, IN_FOLDERS, WEB_PAGES
from symbalance.notes.checking.reports.document_table import DocumentRow, DocumentTable
from symbalance.text.files import STANDARD_INPUT

MOST_DOCUMENTS = 10_000
HANDED_IN = (".pdf", ".docx", ".doc", ".odt", ".rtf", ".pages", ".djvu")
"""Documents that are no text: what stands in them is not checked, and that is said."""
MOST_NAMED = 8
REPORT_SIGN, HEAD = b"<style>\n.symbalance{", 4096
"""What stands in the first bytes of a web page of ours."""


def check_several(options: argparse.Namespace) -> int:
    """Check every document and show the table; the exit code is the worst of all of them."""
    if options.declare:
        return _declare_several(options)
    if options.certificates is not None:
        remedy = "check them one by one: --certificates PAGE.certificates.json"
        raise SymbalanceError("--certificates", "is for one document, and these are several", remedy)
    if options.label or options.format == "xlsx":
        what = "--label" if options.label else "--format xlsx"
        remedy = "write them one by one" if options.label else "take csv, or write them one by one"
        raise SymbalanceError(what, "is for the report of one document", remedy)
    form = medium_of_several(options)
    folder = None if options.output in (None, "-") else output_folder(options.output)
    documents = _documents(options.documents, folder)
    _say_what_is_no_text(options.documents, documents)
    reports: list[Path] = []
    if folder is not None:
        reports = report_paths(folder, _names(documents), form, documents)
    same = {"form": form, "standalone": options.standalone, "here": options.dask is None}
    same["choices"] = (options.accept_proposals, not options.no_fixes)
    limit = read_budget(options.budget)  # for each document
    job_of = partial(_job, symbols=options.symbols, limit=limit, trust_paths=options.trust_paths, **same)
    jobs = [job_of(path) for path in documents]
    store = None if folder is None else Store(folder / STORE, "--output")
    rows, faults = [], []
    with long_work(options, store and store.folder) as means:
        for place, (job, outcome) in enumerate(run_jobs(_check, jobs, store=store, codec=CODEC, **means)):
            if reports and outcome.is_done:
                reports[place].parent.mkdir(parents=True, exist_ok=True)
                write_all({str(reports[place]): outcome.value["printed"]})
            row = _row(job, outcome, options.lenient)
            if reports and outcome.is_done and folder is not None:
                row = replace(row, file=reports[place].relative_to(folder).as_posix())
            rows.append(row)
            faults += _faults(job, outcome)
    table = DocumentTable(tuple(rows))
    if folder is not None:
        (index,) = report_paths(folder, ["index"], form, documents)
        write_all({str(index): printed(table, form, str(index), standalone=options.standalone)})
    show(table, for_terminal(options))
    for row in rows:
        if row.exit_code == REFUSED:
            refusal = re.sub(": line ([0-9]+): ", r":\1: ", f"{row.name}: {row.problem}", count=1)
            say(f"symbalance: {refusal}")
    for fault in faults:
        say_fault(*fault)
    return max(row.exit_code for row in rows)


def _documents(named: list[str], output: Path | None) -> list[Path]:
    """Return every document, folders searched to the bottom, each once, in the order of their naming."""
    documents: dict[str, Path] = {}
    for name in named:
        if name == STANDARD_INPUT:
            raise SymbalanceError("NOTES -", "is one document among several", "name files, or - alone")
        if not name:
            raise SymbalanceError("NOTES ''", "is an empty name", "name a file or a folder")
        inside = _inside(Path(name), output) if os.path.isdir(name) else [Path(name)]
        if not inside:
            rule = f"holds no {', '.join(IN_FOLDERS[:-1])} or {IN_FOLDERS[-1]} file"
            raise SymbalanceError(name, rule, "name a folder of documents")
        for path in inside:
            documents.setdefault(os.path.realpath(path), path)
    if len(documents) > MOST_DOCUMENTS:
        rule = f"are more than {MOST_DOCUMENTS} documents"
        raise SymbalanceError(f"{len(documents)} files", rule, "name fewer folders at once")
    return [*documents.values()]


def _inside(folder: Path, output: Path | None) -> list[Path]:
    """Return the documents of a folder and those below it, by name; none hidden, no report of ours."""
    documents: list[Path] = []
    for place, folders, names in os.walk(folder):
        if output is not None and os.path.samefile(place, output):
            if Path(place) == folder:
                rule = "is a folder of documents, and reports in it would be documents too"
                raise SymbalanceError(f"--output {output}", rule, "name another folder")
            folders.clear()
            continue
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        documents += [
            Path(place, name)
            for name in names
            if name.casefold().endswith((*IN_FOLDERS, *WEB_PAGES))
            and not name.startswith(".")
            and Path(place, name).is_file()
            and not _is_report(Path(place, name))
        ]
    return sorted(documents, key=_reading_order)


def _is_report(path: Path) -> bool:
    """Tell whether a web page is a report of this program, and no notes."""
    if not path.name.casefold().endswith(WEB_PAGES):
        return False
    try:
        with path.open("rb") as file:
            return REPORT_SIGN in file.read(HEAD).replace(b"\r\n", b"\n")
    except OSError:
        return False  # said where it is read


def _say_what_is_no_text(named: list[str], documents: list[Path]) -> None:
    """Say which documents of a folder are left out: a PDF without the notes it was made from."""
    taken = {path.with_suffix("") for path in documents}
    left = sorted(
        str(path)
        for name in named
        if os.path.isdir(name)
        for path in Path(name).rglob("*")
        if path.name.casefold().endswith(HANDED_IN)
        and path.with_suffix("") not in taken
        and not any(part.startswith(".") for part in path.relative_to(name).parts)
    )
    if left:
        shown = ", ".join(left[:MOST_NAMED]) + (", …" if len(left) > MOST_NAMED else "")
        say(f"symbalance: not checked, as they are no text: {shown}")


def _reading_order(path: Path) -> tuple[list[str], str]:
    """Return where a name stands in a list that a person reads: Óscar with the O, capitals with small."""
    plain = unicodedata.normalize("NFKD", str(path))
    letters = "".join(c for c in plain if not unicodedata.combining(c)).casefold()
    return letters.split("/"), str(path)


def _declare_several(options: argparse.Namespace) -> int:
    """Write one draft of a symbols file for all of them; 2 if some could not be read."""
    from symbalance.checking import sidecar_draft
    from symbalance.notes.checking.declared.declaration_draft import course_toml

    unused = ("standalone", "label", "lenient", "accept_proposals", "no_fixes", "certificates", "format")
    for name in unused:
        if getattr(options, name):
            option = name.replace("_", "-")
            remedy = "leave it out"
            if name == "format":
                remedy = "leave it out: the draft is one .toml file; of one document it may be typeset"
            raise SymbalanceError(f"--{option}", "plays no part in --declare of several", remedy)
    if options.output and not options.output.endswith(".toml") and options.output != "-":
        rule = "is no .toml file, and one file declares letters for all of a folder"
        raise SymbalanceError(f"--output {options.output}", rule, f"name FOLDER/{COURSE}")
    limit = read_budget(options.budget)
    drafts, problems = [], []
    for path in _documents(options.documents, None):
        try:
            drafts.append(sidecar_draft(path, options.symbols, budget=limit))
        except SymbalanceError as problem:
            problems.append(str(problem))
    if drafts:
        write(course_toml(drafts), options.output, "source")
    for problem in problems:
        say(f"symbalance: {problem}")
    return REFUSED if problems else DONE


def _names(documents: list[Path]) -> list[str]:
    """Return the reports' names: the documents' own paths below the folder that they share."""
    places = [os.path.realpath(path) for path in documents]
    shared = os.path.commonpath([os.path.dirname(place) for place in places])
    return [os.path.relpath(place, shared) for place in places]


def _job(
    path: Path,
    symbols: str | None,
    limit: Budget,
    trust_paths: bool,
    form: str,
    standalone: bool,
    here: bool,
    choices: tuple[bool, bool] = (False, True),
) -> Job:
    """Return the job of a document; its key is of all that decides what is said of it.

    `here` tells that it is checked by processes that have this working folder.
    """
    place, sidecar = (str(path), symbols) if here else (os.path.abspath(path), _absolute(symbols))
    value = (place, str(path), sidecar, limit, trust_paths, form, standalone, choices)
    try:
        read = [path, *declared_files(path, symbols)]
        before = _states(read)
        settings = (str(path), symbols or "", tuple(limit), trust_paths, form, standalone, *choices)
        key = key_of("check", *settings, [(str(p), p) for p in read])
        weight = float(path.stat().st_size)
    except (SymbalanceError, OSError):  # what cannot be read is refused where it is checked
        return Job(str(path), value)

    def changed() -> str:
        return "" if _states(read) == before else "was changed while it was checked"

    return Job(str(path), value, key, weight=weight or 1.0, changed=changed)


def _states(files: list[Path]) -> list[tuple[int, ...] | None]:
    """Return what tells a file that was written meanwhile, even if with the same content."""
    states: list[tuple[int, ...] | None] = []
    for path in files:
        try:
            status = os.stat(path)
        except OSError:
            states.append(None)
        else:
            states.append((status.st_mtime_ns, status.st_size, status.st_ino))
    return states


CODEC: Codec[dict[str, Any]] = Codec(JSON.encode, JSON.decode, keeps=lambda value: not value["unjudged"])
"""What a budget ended, another run may judge."""


def _absolute(name: str | None) -> str | None:
    return None if name is None else os.path.abspath(name)


def _check(
    value: tuple[str, str, str | None, Budget, bool, str, bool, tuple[bool, bool]],
) -> dict[str, Any]:
    """Return what is said of a document, as data and in a medium, and what its check exits with."""
    place, name, symbols, limit, trust_paths, form, standalone, (accepts, fixes) = value
    checked = check(
        Path(place),
        symbols,
        budget=limit,
        trust_paths=trust_paths,
        accept_proposals=accepts,
        fixes=fixes,
    )
    return {
        "report": {**checked.data(), "document": name},
        "printed": printed(checked, form, name, standalone=standalone),
        "unjudged": any(v.is_unjudged for v in checked.verdicts),
        "fails": [checked.fails(), checked.fails(lenient=True)],
        "faults": [[f"line {v.line} of {name}: {v.fault}", v.traceback] for v in checked.faults],
    }


def _row(job: Job, outcome: JobOutcome, lenient: bool) -> DocumentRow:
    if outcome.problem is not None:
        return DocumentRow(job.name, None, REFUSED, _unnamed(str(outcome.problem), job.name))
    if outcome.fault:
        return DocumentRow(job.name, None, FAULT, f"a fault of symbalance: {outcome.fault}")
    value = outcome.value
    code = FAILED if value["fails"][lenient] else DONE
    return DocumentRow(job.name, value["report"], FAULT if value["faults"] else code)


def _unnamed(problem: str, name: str) -> str:
    """Return what is said of a document without its name, which the job and the reader both put first.

    >>> _unnamed("a.md: a.md:3: is not UTF-8 text", "a.md")
    'line 3: is not UTF-8 text'
    """
    while problem.startswith(f"{name}: "):
        problem = problem.removeprefix(f"{name}: ")
    return f"line {problem[len(name) + 1 :]}" if problem.startswith(f"{name}:") else problem


def _faults(job: Job, outcome: JobOutcome) -> list[tuple[str, str]]:
    if outcome.fault:
        return [(f"{job.name}: {outcome.fault}", outcome.traceback)]
    return [(what, traceback) for what, traceback in (outcome.value or {}).get("faults", ())]
