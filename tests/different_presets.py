"""The presets without those that differ from another in sizes alone, for tests that take long.

The others stand under `like` in `textbook/textbook.toml`, and `test_against_textbook.py` proves of each
that its cylinders stand, turn and fire as those of the engine it is like: in a test of geometry, of a
printed table or of a design they would be the same case again, with another rod ratio at most. Every
preset still goes through the fast tests.
"""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path

from symbalance.engine.catalogue import preset_names

TEXTBOOK = Path(__file__).parent / "textbook" / "textbook.toml"


@cache
def different_presets() -> tuple[str, ...]:
    """Return the names of one preset of each geometry, in the order of all."""
    rows = tomllib.loads(TEXTBOOK.read_text(encoding="utf-8"))["row"]
    alike = {name for row in rows for name in row.get("like", ())}
    return tuple(name for name in preset_names() if name not in alike)
