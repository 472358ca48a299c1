"""The atlas within the site: pages that move, and their table, written beside the documentation's pages.

Nine engines of different kinds at every build; all presets, some minutes, with `-D atlas_engines=all`.
They are finished pages, which Sphinx does not read: they go into the site when it is built.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

FOLDER = "atlas"
SHOWN = "inline-3 inline-4 vw-vr6 v8-90 v12-60 boxer-4 bugatti-w16 r-985 wartsila-12rta96c"


def write_atlas(site: Path, names: str) -> None:
    """Write the pages of engines, "all" or names, and their table."""
    from symbalance.engine.catalogue import load, preset_names
    from symbalance.pages.atlas import atlas_entry, atlas_index
    from symbalance.pages.published_tables import published_cells

    folder = site / FOLDER
    folder.mkdir(parents=True, exist_ok=True)
    entries = []
    for name in preset_names() if names == "all" else names.split():
        entry = atlas_entry(load(name))
        (folder / f"{name}.html").write_text(entry.html, encoding="utf-8")
        entries.append((f"{name}.html", entry.row))
    index = atlas_index(entries, (), 12, published_cells())
    (folder / "index.html").write_text(index, encoding="utf-8")


def _write(app: Any, failure: Exception | None) -> None:
    if failure is None and app.builder.format == "html":
        write_atlas(Path(app.outdir), app.config.atlas_engines)


def setup(app: Any) -> dict[str, bool]:
    """Write the atlas when the site's own pages are."""
    app.add_config_value("atlas_engines", SHOWN, "")
    app.connect("build-finished", _write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
