"""The record's command: `python -m tests.record write FOLDER`, `compare OLD NEW` or `check COMMIT`."""

from __future__ import annotations

import argparse
import signal
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from .comparing import compare, read_allowances, report
from .recording import RecordError, Settings, summary, write


def main(arguments: Sequence[str]) -> int:
    """Run the command; return 0 if no difference is left, 1 if one is, 2 if nothing could be compared."""
    options = build_parser().parse_args(arguments)
    try:
        return options.run(options)
    except RecordError as problem:
        print(f"record: {problem}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


def build_parser() -> argparse.ArgumentParser:
    """Return the parser of the three commands."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.record",
        description="What every command of the program prints, as a folder; two such folders compared.",
    )
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    one = commands.add_parser("write", help="write the record of a commit, or of the tree as it is")
    one.add_argument("folder", type=Path, help="new, empty, or an older record, which is replaced")
    one.add_argument("--commit", help="whose program is run; default: the tree as it is")
    _add_settings(one)
    one.set_defaults(run=_write)
    two = commands.add_parser("compare", help="list the differences of two records by kind")
    two.add_argument("old", type=Path)
    two.add_argument("new", type=Path)
    _add_report(two)
    two.set_defaults(run=_compare)
    both = commands.add_parser("check", help="record a commit and the tree as it is, and compare them")
    both.add_argument("commit")
    both.add_argument(
        "--keep", type=Path, metavar="FOLDER", help="keep the records: FOLDER/old, FOLDER/new"
    )
    _add_settings(both)
    _add_report(both)
    both.set_defaults(run=_check)
    return parser


def _add_settings(parser: argparse.ArgumentParser) -> None:
    default = Settings()
    parser.add_argument(
        "--jobs", type=_positive, default=default.jobs, metavar="N", help="default: one a core"
    )
    parser.add_argument(
        "--only", action="append", default=[], metavar="PATTERN", help="cases, as 'balance/*'; repeatable"
    )
    parser.add_argument(
        "--limit",
        type=_positive,
        default=default.limit,
        metavar="S",
        help=f"seconds of processor time a case may take; default: {default.limit}",
    )
    parser.add_argument(
        "--hash-seed",
        type=int,
        default=default.hash_seed,
        metavar="N",
        help="another seed shows what depends on the order of a set; default: 0",
    )
    parser.add_argument(
        "--seeds", type=Path, metavar="FOLDER", help="more documents for `check`: its .txt files"
    )


def _add_report(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--all", action="store_true", help="list every difference, uncut")
    parser.add_argument(
        "--allow",
        type=Path,
        metavar="FILE",
        help="TOML: [[allowed]] case, kind, reason (place, old, new)",
    )


def _positive(text: str) -> int:
    number = int(text)
    if number < 1:
        raise ValueError
    return number


def _settings(options: argparse.Namespace) -> Settings:
    if options.seeds is not None and not options.seeds.is_dir():
        raise RecordError(f"--seeds {options.seeds}: is not a folder")
    return Settings(options.jobs, options.limit, options.hash_seed, tuple(options.only), options.seeds)


def _write(options: argparse.Namespace) -> int:
    print(summary(write(options.folder, options.commit, _settings(options))), file=sys.stderr)
    return 0


def _compare(options: argparse.Namespace) -> int:
    allowances = read_allowances(options.allow) if options.allow else []
    comparison = compare(options.old, options.new, allowances)
    print(report(comparison, everything=options.all))
    return 1 if comparison.differences else 0


def _check(options: argparse.Namespace) -> int:
    if options.allow:
        read_allowances(options.allow)  # refused now, not after the runs
    settings = _settings(options)
    with tempfile.TemporaryDirectory(prefix="symbalance-record-") as temporary:
        kept = options.keep or Path(temporary)
        options.old, options.new = kept / "old", kept / "new"
        for folder, commit in ((options.old, options.commit), (options.new, None)):
            print(f"record: {commit or 'the tree as it is'}", file=sys.stderr)
            print(summary(write(folder, commit, settings)), file=sys.stderr)
        return _compare(options)


if __name__ == "__main__":
    # Whoever ends this ends its workers and temporary folders too.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    sys.exit(main(sys.argv[1:]))
