"""The derivations as they stand, with their pictures and the files they link to.

A link that leads out of `derivations/` (to a golden file of the tests) becomes the file's name.
"""

from __future__ import annotations

import re
from pathlib import Path

_LEADS_OUT = re.compile(r"\[([^\]]*)\]\(\.\./(?!checked/)[^)]*\)")


def pages(root: Path) -> dict[str, bytes]:
    """Return the Markdown files and pictures of `derivations/`, README.md as index.md."""
    folder = root / "derivations"
    contents = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.suffix == ".md":
            contents[name.replace("README.md", "index.md")] = _page(folder, path).encode()
        elif path.suffix in (".png", ".json", ".toml", ".txt", ".csv"):
            contents[name] = path.read_bytes()
    return contents


def _page(folder: Path, path: Path) -> str:
    text = path.read_text(encoding="utf-8").replace("README.md", "index.md")
    text = text if path.parent != folder else _LEADS_OUT.sub(r"\1", text)
    if path.name == "README.md":
        names = [p.stem for p in sorted(path.parent.glob("*.md")) if p.name != "README.md"]
        names += ["checked/index"] if path.parent == folder else []
        text += "\n```{toctree}\n:hidden:\n\n" + "\n".join(names) + "\n```\n"
    return text
