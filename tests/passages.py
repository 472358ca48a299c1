"""Short passages with one formula each, right and wrong: how many are told apart.

    python -m tests.passages            # the table
    python -m tests.passages -v         # and each wrong formula that is not refuted

Who wrote them had not seen the checker. A passage has a `context`, a `right` sentence with a formula,
the same with `wrong` ones, and other right ways to say it (`alike`). Sentences without a relation
sign are not counted.
"""

from __future__ import annotations

import json
import sys
import tempfile
import tomllib
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

from symbalance.checking import check
from symbalance.notes.checking.verdicts import PROVED_WORDS, STATED
from tests.unseen_pages import PATIENT

PASSAGES = Path(__file__).parent / "hand" / "passages"
KINDS = ("right", "alike", "wrong")


def sentences(passage: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield the sentences of a passage with their kinds."""
    yield "right", passage["right"]
    for kind in ("alike", "wrong"):
        for sentence in passage.get(kind, ()):
            yield kind, sentence


def outcome(passage: dict[str, Any], sentence: str) -> str:
    """Return what is said of a sentence behind its context: the worst of its relations, or ""."""
    context = passage.get("context", "").strip()
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "page.md"
        page.write_text(f"{context}\n{sentence}\n", encoding="utf-8")
        if symbols := passage.get("symbols"):
            lines = [f"{json.dumps(name)} = {json.dumps(text)}" for name, text in symbols.items()]
            beside = Path(folder) / "page.symbols.toml"
            beside.write_text("\n".join(["[symbols]", *lines]) + "\n", encoding="utf-8")
        links = check(page, budget=PATIENT, fixes=False).data()["links"]
    first = len(context.splitlines()) + 1
    words = {link["verdict"] for link in links if "continues" not in link and int(link["line"]) >= first}
    if words & {"refuted", "contradiction"}:
        return "refuted"
    if words - {*PROVED_WORDS, *STATED}:
        return "open"
    return "given" if words & {*STATED} else "confirmed" if words else ""


def outcomes(path: Path) -> list[tuple[str, str, str]]:
    """Return the kind, the sentence and the outcome of every sentence of a file."""
    passages = tomllib.loads(path.read_text(encoding="utf-8"))["passage"]
    return [
        (kind, sentence, outcome(passage, sentence))
        for passage in passages
        for kind, sentence in sentences(passage)
    ]


def main(arguments: list[str]) -> None:
    """Print how many sentences of each kind have which outcome."""
    paths = sorted(PASSAGES.glob("*.toml"))
    print("| passages | confirmed | given | refuted | open |\n|---|---|---|---|---|")
    with ProcessPoolExecutor() as pool:
        for path, found in zip(paths, pool.map(outcomes, paths), strict=True):
            for kind in KINDS:
                counts = Counter(said for each, _, said in found if each == kind and said)
                cells = (counts[word] for word in ("confirmed", "given", "refuted", "open"))
                print(f"| {path.stem}: {kind} | " + " | ".join(str(n or "") for n in cells) + " |")
            if "-v" in arguments:
                for kind, sentence, said in found:
                    if said and (kind == "wrong") != (said == "refuted"):
                        print(f"  {kind}, {said}: {sentence}")


if __name__ == "__main__":
    main(sys.argv[1:])
