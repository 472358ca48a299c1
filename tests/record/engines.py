"""The engines of a record: the presets of the recorded program, and the engine files of this checkout."""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path

FENCE = re.compile(r"^```toml\n(.*?)^```", re.DOTALL | re.MULTILINE)
OWN = Path(__file__).parent / "engines"


@dataclass(frozen=True)
class Engine:
    """One engine: the name its cases have, what the command line calls it, and its file's text."""

    key: str
    argument: str
    text: str

    @property
    def cylinders(self) -> int:
        """How many cylinders it has."""
        table = tomllib.loads(self.text)
        layout = table.get("layout", {})
        return len(table.get("cylinder") or layout.get("firing_order", ()))

    @property
    def strokes(self) -> int:
        """Four, or two."""
        table = tomllib.loads(self.text)
        return table.get("layout", {}).get("strokes") or table.get("strokes") or 4

    @property
    def missing_ratio(self) -> tuple[str, ...]:
        """The option that gives the rod ratio where its file leaves it out."""
        train = tomllib.loads(self.text).get("crank_train", {})
        return () if {"ratio", "rod"} & set(train) else ("--ratio", "3.5")

    @property
    def has_all_sizes(self) -> bool:
        """Whether its file gives all that results in N, N m and kg mm take."""
        train = tomllib.loads(self.text).get("crank_train", {})
        return {"stroke", "rod", "pitch", "reciprocating_mass"} <= set(train)

    @property
    def missing_sizes(self) -> tuple[str, ...]:
        """The options that give a running engine the sizes its file leaves out.

        An option for a size that the file does give is refused, so the text decides.
        """
        train = tomllib.loads(self.text).get("crank_train", {})
        stroke = () if "stroke" in train else ("--stroke", "80")
        mass = () if "reciprocating_mass" in train else ("--mass", "0.5")
        return (*stroke, *mass)


def is_engine(text: str) -> bool:
    """Return whether a TOML text describes an engine (sidecars and truth files do not)."""
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return False
    return isinstance(table.get("layout"), dict) or isinstance(table.get("cylinder"), list)


def engine_files(root: Path) -> dict[str, str]:
    """Return the engine files of a checkout by the name they are staged under, without `.toml`.

    `own/` are the record's, `documents/` the fenced blocks of Markdown files, the rest lie in
    `tests/` and `derivations/` and keep their folder.
    """
    texts = {f"own/{path.stem}": path.read_text(encoding="utf-8") for path in sorted(OWN.glob("*.toml"))}
    for top in ("tests", "derivations"):
        for path in sorted((root / top).rglob("*.toml")):
            if OWN in path.parents or path.is_symlink():
                continue
            text = path.read_text(encoding="utf-8", errors="replace")
            if is_engine(text):
                texts[path.relative_to(root / top).with_suffix("").as_posix()] = text
    documents = [*root.glob("*.md"), *(root / "derivations").rglob("*.md")]
    for path in sorted(documents):
        blocks = FENCE.findall(path.read_text(encoding="utf-8"))
        for number, block in enumerate(filter(is_engine, blocks), 1):
            name = path.relative_to(root).with_suffix("").as_posix().replace("/", "-")
            texts[f"documents/{name}-{number}"] = block
    return texts


def preset_names(listing: str) -> list[str]:
    """Return the presets that `symbalance engines` lists: the first word of every row of its table.

    Earlier programs have no head above the rows, and do not indent them.

    >>> preset_names("v8-90   cross-plane\\n        [a source]\\nv12-60  vee\\n")
    ['v8-90', 'v12-60']
    >>> preset_names("Presets\\n\\n  name   what\\n  ───────\\n  v8-90  cross-plane\\n         crank\\n")
    ['v8-90']
    """
    head, rule, rows = listing.partition("─\n")
    indent = 2 if rule else 0
    lines = (rows if rule else head).splitlines()
    return [line.split()[0] for line in lines if line[indent:] and not line[indent].isspace()]
