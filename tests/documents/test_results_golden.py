"""Every result as it is read: its words, its signs and the order of its rows, in golden files.

Laws and second computations hold the numbers. What a document says of them, which column they stand in
and what unit is named beside them, no law knows: `pytest --update` rewrites these files, and whoever does
so reads the change.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest

from symbalance.document.result import to_html, to_latex, to_markdown, to_text
from tests.results import EXAMPLES, example

BY_MACHINE = {
    "campbell",
    "crankshaft",
    "critical-speeds",
    "natural-modes",
    "torsional-chain",
    "unbalance-response",
    "whirl",
}
"""Eigenvalues and time steps, whose last digits are those of the machine's linear algebra."""
ELSEWHERE = {"presets", "check", "crank-node", "derivation"}
"""Presets come and go; a page that is checked, the node and derivations have files of their own."""
READ = [name for name in EXAMPLES if name not in BY_MACHINE | ELSEWHERE]
AS_HTML = ["balance", "check", "design", "derivation", "symbolic-order-of-a-vee", "torque-symbolic"]
AS_MARKDOWN = ["balance-unlike", "check", "derivation", "running-torque"]


@pytest.mark.spread("balance", "torque-unlike", "truncation-bounds")
@pytest.mark.parametrize("name", READ)
def test_text(name: str, golden: Callable[[str, str], None]) -> None:
    """The text, as a terminal of 80 columns has it."""
    golden(f"result-{name}.txt", to_text(example(name), width=80))


@pytest.mark.spread("torque-unlike", "harmonics")
@pytest.mark.parametrize("name", READ)
def test_latex(name: str, golden: Callable[[str, str], None]) -> None:
    """The LaTeX of a fragment."""
    golden(f"result-{name}.tex", to_latex(example(name)))


@pytest.mark.spread("torque-symbolic")
@pytest.mark.parametrize("name", AS_HTML)
def test_html(name: str, golden: Callable[[str, str], None]) -> None:
    """A page of HTML with its formulas in MathML."""
    golden(f"result-{name}.html", to_html(example(name), standalone=True))


@pytest.mark.spread("running-torque")
@pytest.mark.parametrize("name", AS_MARKDOWN)
def test_markdown(name: str, golden: Callable[[str, str], None]) -> None:
    """Markdown."""
    golden(f"result-{name}.md", to_markdown(example(name)))


def test_every_example_is_read_or_named() -> None:
    """A new example gets its files, or a reason why not."""
    assert set(EXAMPLES) >= BY_MACHINE | ELSEWHERE
    assert set(AS_HTML + AS_MARKDOWN) <= set(EXAMPLES) - BY_MACHINE
