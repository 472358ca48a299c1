"""Relations of a notebook stand at the lines of their cells, whatever its program code holds."""

from __future__ import annotations

import json
from pathlib import Path

from symbalance.checking import check


def test_program_code_moves_no_line_below_it(tmp_path: Path) -> None:
    code = ["r, l = 0.045, 0.15\n", "m, rpm = 0.8, 3000\n", "n = 1, 2, 3\n", "lam = r/l"]
    words = ["Here\n", "\n", "$a = 2b$"]
    cells = [
        {"cell_type": "code", "source": code, "metadata": {}, "outputs": [], "execution_count": None},
        {"cell_type": "markdown", "source": words, "metadata": {}},
    ]
    path = tmp_path / "page.ipynb"
    path.write_text(json.dumps({"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 4}))
    (verdict,) = check(path, {"b": "variable"}).verdicts
    assert (verdict.cell, verdict.line) == ((2, 3), 12)
    assert "a run of values" not in str(check(path, {"b": "variable"}).data()["notes"])
