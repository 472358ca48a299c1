"""Pages that are made at every build: the API room by room, the commands, the derivations as they stand.

They are written below `docs/` because Sphinx reads one folder; git does not keep them. A file is written
only if it changed, so that a second build reads only what is new; one that nothing makes any more goes.
"""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any

from extensions import api_pages, command_pages, derivation_pages

ROOT = Path(__file__).parent.parent.parent
FOLDERS = {"api": api_pages.pages, "commands": command_pages.pages, "derivations": derivation_pages.pages}


def write_pages(docs: Path) -> None:
    """Write every generated page and picture below `docs`."""
    for folder, pages in FOLDERS.items():
        contents = {docs / folder / name: content for name, content in pages(ROOT).items()}
        for path, content in contents.items():
            if not path.exists() or path.read_bytes() != content:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
        for path in sorted((docs / folder).rglob("*"), reverse=True):
            if path.is_file() and path not in contents:
                path.unlink()
            elif path.is_dir() and not any(path.iterdir()):
                shutil.rmtree(path)


def _follow_links(_app: Any, page: str, source: list[str]) -> None:
    """Lead links from hand-written pages, which hold in the repository, to the pages made here."""
    text = source[0]
    if "/" not in page:
        text = text.replace("](../derivations/", "](derivations/").replace("](docs/", "](")
        text = re.sub(r"\]\(README\.md[^)]*\)", "](index.md)", text).replace("/README.md)", "/index.md)")
    # The empty line that ends a doctest in Markdown is not shown.
    source[0] = re.sub(r"\n\n```(?=\n|$)", "\n```", text)


def setup(app: Any) -> dict[str, bool]:
    """Write the pages before Sphinx looks for them."""
    app.connect("builder-inited", lambda app: write_pages(Path(app.srcdir)))
    app.connect("source-read", _follow_links)
    app.connect("include-read", lambda app, path, page, source: _follow_links(app, page, source))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
