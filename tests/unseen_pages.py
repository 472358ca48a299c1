"""Verdicts on pages that the checker was not written for, beside truths worked out apart.

    python -m tests.unseen_pages                 # the table of all pages in tests/hand/unseen
    python -m tests.unseen_pages FOLDER          # of one folder
    python -m tests.unseen_pages FOLDER 03 -v    # of its pages 03-..., with each relation that went wrong

Who wrote the pages had seen neither the program nor its tests, and worked the truths out with
programs of their own. `NAME.truth.toml` lists every relation sign of a page, in order: its line, which
sign of that line it is, the relation as typed, and whether it is `right`, `wrong` (planted, with what it
should be), `given` (data, a letter's first value, an assumption) or `follows` (right in itself behind a
planted error).
"""

from __future__ import annotations

import argparse
import sys
import tomllib
from collections import Counter
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from difflib import SequenceMatcher
from pathlib import Path
from typing import Any

from symbalance.budgets import Budget
from symbalance.checking import check
from symbalance.notes.checking.verdicts import PROVED_WORDS, STATED
from symbalance.text import lazy_patterns as re

UNSEEN = Path(__file__).parent / "hand" / "unseen"
KINDS = ("right", "given", "wrong")
OUTCOMES = ("confirmed", "given", "refuted", "undecided", "unreadable", "silent")
_MARKUP = re.compile(r"</?[a-z][^<>]*>|[\s$\\{}&`]|mathrm|text|left|right")
_ARROW = re.compile(r"[⇒⇔]|=>|Rightarrow|implies|iff")
PATIENT = Budget(seconds=3600)
"""A minute a relation: what comes out does not depend on what else the machine has to do."""
NEAR = 3
"""Lines by which a sign may stand beside where its truth says: a formula may go on in the next line."""
ALIKE, ALIKE_ELSEWHERE = 0.45, 0.7
"""How alike a relation has to be to its truth, on its line and beside it."""


@dataclass(frozen=True)
class Judged:
    """A relation of a page: its truth, and what the checker said of it."""

    page: str
    truth: dict[str, Any]
    entry: dict[str, Any] | None

    @property
    def kind(self) -> str:
        """Whether it is right, given or wrong."""
        return {"follows": "right"}.get(self.truth["truth"], self.truth["truth"])

    @property
    def outcome(self) -> str:
        """What was said of it, in one of six words."""
        if self.entry is None:
            return "silent"
        verdict = self.entry["verdict"]
        if verdict in PROVED_WORDS:
            return "confirmed"
        if verdict in STATED:
            return "given"
        if verdict in ("refuted", "contradiction"):
            return "refuted"
        return verdict if verdict in OUTCOMES else "silent"

    @property
    def is_as_it_should_be(self) -> bool:
        """Tell whether what is wrong is refuted, and what is not wrong confirmed or taken as given."""
        return (
            self.outcome == "refuted" if self.kind == "wrong" else self.outcome in ("confirmed", "given")
        )


def judged(truth: Path) -> list[Judged]:
    """Return each relation that a truth lists, with the entry of the report that is nearest to it."""
    stem = truth.name.removesuffix(".truth.toml")
    page = next(p for p in sorted(truth.parent.glob(f"{stem}.*")) if p.suffix != ".toml")
    relations = tomllib.loads(truth.read_text(encoding="utf-8"))["relation"]
    entries = [e for e in check(page, budget=PATIENT).data()["links"] if "continues" not in e]
    matched = _matched(relations, entries)
    return [Judged(stem, relation, matched.get(k)) for k, relation in enumerate(relations)]


def _matched(relations: list[dict[str, Any]], entries: list[dict[str, Any]]) -> dict[int, dict[str, Any]]:
    """Return the entry of each relation by its number: on its own line first, then on those around."""
    by_line: dict[str, list[dict[str, Any]]] = {}
    for entry in entries:
        by_line.setdefault(_line(entry), []).append(entry)
    matched: dict[int, dict[str, Any]] = {}
    taken: set[int] = set()
    for step in sorted(range(-NEAR, NEAR + 1), key=abs):
        for k, relation in enumerate(relations):
            if k in matched:
                continue
            free = [e for e in by_line.get(_moved(str(relation["line"]), step), []) if id(e) not in taken]
            best = max(free, key=lambda entry: _likeness(relation, entry), default=None)
            if best is not None and _likeness(relation, best) > (ALIKE_ELSEWHERE if step else ALIKE):
                matched[k] = best
                taken.add(id(best))
    for k, relation in enumerate(relations):  # what is left on a line, in its order
        free = [e for e in by_line.get(str(relation["line"]), []) if id(e) not in taken]
        if k not in matched and free:
            matched[k] = free[0]
            taken.add(id(free[0]))
    return matched


def _line(entry: dict[str, Any]) -> str:
    return f"{entry['cell']}:{entry['cell_line']}" if "cell" in entry else str(entry["line"])


def _moved(line: str, step: int) -> str:
    cell, colon, number = line.rpartition(":")
    return f"{cell}{colon}{int(number) + step}"


def _likeness(relation: dict[str, Any], entry: dict[str, Any]) -> float:
    if entry.get("sign") in ("⇒", "⇔"):
        return 0.9 if _ARROW.search(relation["text"]) else 0.0
    typed = "".join(entry.get(key) or "" for key in ("left", "sign", "source"))
    return SequenceMatcher(None, _MARKUP.sub("", relation["text"]), _MARKUP.sub("", typed)).ratio()


def tally(relations: Iterable[Judged]) -> dict[str, Counter[str]]:
    """Return how often each kind of relation had each outcome."""
    counts = {kind: Counter[str]() for kind in KINDS}
    for relation in relations:
        counts[relation.kind][relation.outcome] += 1
    return counts


def table(rows: Iterable[tuple[str, dict[str, Counter[str]]]]) -> str:
    """Return the tallies of several pages or folders as a table of Markdown."""
    lines = ["| | " + " | ".join(("relations", *OUTCOMES)) + " |", "|---" * (len(OUTCOMES) + 2) + "|"]
    for name, counts in rows:
        for kind in KINDS:
            own = counts[kind]
            cells = [str(own[outcome] or "") for outcome in OUTCOMES]
            lines.append(f"| {name}: {kind} | {own.total()} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main(arguments: list[str]) -> None:
    """Print the table, and with `-v` what went wrong."""
    parser = argparse.ArgumentParser(prog="python -m tests.unseen_pages")
    parser.add_argument("folder", nargs="?", type=Path, default=UNSEEN)
    parser.add_argument("pages", nargs="*", help="how the pages' names begin")
    parser.add_argument("-v", "--verbose", action="store_true", help="each relation that went wrong")
    options = parser.parse_args(arguments)
    truths = sorted(options.folder.rglob("*.truth.toml"))
    truths = [t for t in truths if not options.pages or t.name.startswith(tuple(options.pages))]
    if not truths:
        parser.error(f"{options.folder} has no such page: name a folder of pages with truths by its path")
    rows: dict[str, list[Judged]] = {}
    with ProcessPoolExecutor() as pool:
        for truth, relations in zip(truths, pool.map(judged, truths), strict=True):
            rows.setdefault(truth.parent.name, []).extend(relations)
            for relation in relations if options.verbose else ():
                if not relation.is_as_it_should_be:
                    _print(relation)
    print(table((folder, tally(relations)) for folder, relations in rows.items()))


def _print(relation: Judged) -> None:
    truth, entry = relation.truth, relation.entry or {}
    place = f"{relation.page}:{truth['line']}.{truth['nth']}"
    print(f"{place} [{truth['truth']}, {relation.outcome}] {truth['text']}")
    for key in ("reason", "assumption", "slip", "fix"):
        if entry.get(key):
            print(f"    {key}: {entry[key]}")
    if relation.kind == "wrong":
        print(f"    {truth['why']}; right: {truth.get('correct', '')}")


if __name__ == "__main__":
    main(sys.argv[1:])
