"""Two records compared: every difference by its kind, less those that a file allows with a reason."""

from __future__ import annotations

import re
import tomllib
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from .differences import KINDS, Difference, of_files
from .recording import MANIFEST, RecordError, read_manifest

_KEYS = ("case", "kind", "place", "old", "new", "reason")
FEW = 5
LINE = 160


@dataclass
class Comparison:
    """The differences of two records, and what a reader must know of both."""

    old: dict
    new: dict
    differences: list[Difference]
    allowed: list[tuple[Allowance, int]] = field(default_factory=list)
    """What was allowed, with how many differences each allowance took."""


@dataclass(frozen=True)
class Allowance:
    """Differences that are right, and why: patterns in which `*` is anything."""

    case: str
    kind: str
    reason: str
    place: str = "*"
    old: str = "*"
    new: str = "*"

    def takes(self, one: Difference) -> bool:
        """Return whether it allows a difference."""
        pairs = ((self.case, one.case), (self.kind, one.kind), (self.place, one.place))
        return all(_fits(p, t) for p, t in (*pairs, (self.old, one.old), (self.new, one.new)))


def compare(old: Path, new: Path, allowances: Sequence[Allowance] = ()) -> Comparison:
    """Return the differences of two records, in the order of their cases."""
    before, after = read_manifest(old), read_manifest(new)
    counts = dict.fromkeys(allowances, 0)
    left = []
    for one in _differences(old, before, new, after):
        taker = next((a for a in allowances if a.takes(one)), None)
        if taker is None:
            left.append(one)
        else:
            counts[taker] += 1
    return Comparison(before, after, left, list(counts.items()))


def _differences(old: Path, before: dict, new: Path, after: dict) -> Iterator[Difference]:
    for name in sorted({*before["inputs"], *after["inputs"]}):
        digests = before["inputs"].get(name), after["inputs"].get(name)
        if digests[0] != digests[1]:
            shown = [d[:12] if d else "none" for d in digests]
            yield Difference(f"inputs/{name}", "input", "", *shown)
    stray = [_stray(folder, manifest) for folder, manifest in ((old, before), (new, after))]
    for name in sorted({*before["cases"], *after["cases"]}):
        yield from _of_case(name, old, before["cases"].get(name), new, after["cases"].get(name))
    for names, kind in zip(stray, ("file missing", "file added"), strict=True):
        for name in sorted(names):
            yield Difference(name, kind, note=f"not listed in {MANIFEST}")


def _stray(folder: Path, manifest: dict) -> set[str]:
    """Return the files of a record that its manifest does not list: left there by something else."""
    listed = {name for case in manifest["cases"].values() for name in case["files"]} | {MANIFEST}
    return {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()} - listed


def _of_case(
    name: str, old: Path, before: dict | None, new: Path, after: dict | None
) -> Iterator[Difference]:
    if before is None or after is None:
        present = before or after or {}
        kind = "case added" if before is None else "case missing"
        yield Difference(name, kind, note="symbalance " + " ".join(present["argv"]))
        return
    if before["argv"] != after["argv"]:
        yield Difference(name, "arguments", "", " ".join(before["argv"]), " ".join(after["argv"]))
    if before["exit"] != after["exit"]:
        # What was printed belongs to another end: to list it line by line would say nothing more.
        said = [_first_line(folder / f"{name}.stderr") for folder in (old, new)]
        note = "; ".join(
            f"{when}: {line}" for when, line in zip(("old", "new"), said, strict=True) if line
        )
        yield Difference(name, "exit code", "", str(before["exit"]), str(after["exit"]), note)
        return
    for file in sorted({*before["files"], *after["files"]}):
        sides = [_read(old, before, file), _read(new, after, file)]
        place = "" if file == name else file.removeprefix(name)
        if sides[0] is not None and sides[1] is not None:
            yield from of_files(name, file, sides[0], sides[1])
        elif sides[0] is not None or sides[1] is not None:
            kind, present = ("file added", sides[1]) if sides[0] is None else ("file missing", sides[0])
            lost = file in before["files"] and file in after["files"]
            note = f"listed in {MANIFEST}, but not there" if lost else _first_of(present or b"")
            yield Difference(name, kind, place, note=note)
        else:
            yield Difference(name, "file missing", place, note="listed in both records, in neither there")


def _read(folder: Path, case: dict, file: str) -> bytes | None:
    path = folder / file
    return path.read_bytes() if file in case["files"] and path.is_file() else None


def _first_line(path: Path) -> str:
    return _first_of(path.read_bytes()) if path.is_file() else ""


def _first_of(data: bytes) -> str:
    lines = data.decode("utf-8", "backslashreplace").strip().splitlines()
    return lines[0] if lines else ""


def read_allowances(path: Path) -> list[Allowance]:
    """Return what a TOML file of [[allowed]] tables allows; each needs a case, a kind and a reason."""
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as problem:
        raise RecordError(f"{path}: cannot be read as TOML ({problem})") from None
    rows = table.get("allowed", [])
    if set(table) - {"allowed"} or not isinstance(rows, list):
        raise RecordError(f"{path}: must hold [[allowed]] tables and nothing else")
    allowances = []
    for number, row in enumerate(rows, 1):
        wrong = [k for k, v in row.items() if k not in _KEYS or not isinstance(v, str)]
        if wrong:
            raise RecordError(
                f"{path}: [[allowed]] {number}: {wrong[0]}: a text under one of {', '.join(_KEYS)}"
            )
        absent = [key for key in ("case", "kind", "reason") if not row.get(key, "").strip()]
        if absent:
            raise RecordError(f"{path}: [[allowed]] {number}: {absent[0]} is missing")
        if not any(_fits(row["kind"], kind) for kind in _all_kinds()):
            raise RecordError(
                f"{path}: [[allowed]] {number}: kind {row['kind']!r} is that of no difference"
            )
        allowances.append(Allowance(**row))
    return allowances


def _all_kinds() -> Iterator[str]:
    for kind in KINDS:
        yield kind
        for medium in ("json", "text", "latex", "toml", "stderr", "source"):
            yield f"{medium}: {kind}"


def _fits(pattern: str, text: str) -> bool:
    """Return whether a text fits a pattern; only `*` means anything, for places hold brackets.

    >>> _fits("$.orders[order 6].*", "$.orders[order 6].force"), _fits("$.orders[*]", "$.order")
    (True, False)
    """
    return re.fullmatch(".*".join(map(re.escape, pattern.split("*"))), text, re.DOTALL) is not None


def report(comparison: Comparison, *, everything: bool = False) -> str:
    """Return the report: what was compared, how many differences of each kind, the first of each."""
    old, new = comparison.old, comparison.new
    lines = [f"old: {_of_record(old)}", f"new: {_of_record(new)}", *_notes(old, new)]
    by_kind: dict[str, list[Difference]] = {}
    for one in comparison.differences:
        by_kind.setdefault(one.kind, []).append(one)
    cases = {one.case for one in comparison.differences}
    lines.append(f"{len(comparison.differences)} differences in {len(cases)} cases")
    order = list(KINDS)
    kinds = sorted(by_kind, key=lambda kind: (order.index(kind.rpartition(": ")[2]), kind))
    for kind in kinds:
        lines.append(f"  {len(by_kind[kind]):6}  {kind:<24}  {KINDS[kind.rpartition(': ')[2]]}")
    for kind in kinds:
        shown = by_kind[kind] if everything else _spread(by_kind[kind])
        lines += ["", kind, *(f"  {_in_a_line(one, everything)}" for one in shown)]
        if len(shown) < len(by_kind[kind]):
            lines.append(f"  … {len(by_kind[kind]) - len(shown)} more (--all)")
    if comparison.allowed:
        lines += ["", "allowed"]
        for allowance, count in comparison.allowed:
            said = f"{count} of" if count else "NOT USED:"
            lines.append(f"  {said} {allowance.kind} in {allowance.case}: {allowance.reason}")
    return "\n".join(lines)


def _spread(differences: Sequence[Difference]) -> list[Difference]:
    """Return a few, of as many commands and cases as can be: the first of each before the second."""
    rank: Counter[str] = Counter()
    ranked = []
    for position, one in enumerate(differences):
        folder = one.case.partition("/")[0]
        ranked.append((rank[folder], rank[one.case], position))
        rank.update((folder, one.case))
    return [differences[position] for *_, position in sorted(sorted(ranked)[:FEW], key=lambda r: r[2])]


def _of_record(manifest: dict) -> str:
    program = manifest["program"]
    changed = program["changed"]
    state = f", with {len(changed)} changed files" if changed else ""
    where = program["commit"][:12] if program["commit"] else "no commit"
    return f"{where}{state}, {program['version']}, {len(manifest['cases'])} cases"


def _notes(old: dict, new: dict) -> Iterator[str]:
    for key in ("python", "dependencies", "settings"):
        if old[key] != new[key]:
            yield f"note: {key}: {old[key]} → {new[key]}"
    for name, manifest in (("old", old), ("new", new)):
        for line in manifest["program"]["changed"]:
            yield f"note: {name}: not as committed: {line.strip()}"


def _in_a_line(one: Difference, everything: bool) -> str:
    at = f" {one.place}" if one.place else ""
    change = f": {_cut(one.old, everything)} → {_cut(one.new, everything)}" if one.old or one.new else ""
    return f"{one.case}{at}{change}" + (f"  ({_cut(one.note, everything)})" if one.note else "")


def _cut(text: str, everything: bool) -> str:
    line = " ⏎ ".join(part.strip() for part in text.splitlines()) or "nothing"
    # A record holds what hostile documents print: control characters must not reach the terminal.
    line = "".join(c if c.isprintable() else "\ufffd" for c in line)
    return line if everything or len(line) <= LINE else f"{line[:LINE]}…"
