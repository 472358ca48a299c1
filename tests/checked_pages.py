"""Pages written for one test, and what the checker says of their last relation."""

from __future__ import annotations

from pathlib import Path

from symbalance.checking import check as check_text
from symbalance.notes.checking import check


def last_verdict(folder: Path, text: str, symbols: str = "") -> str:
    """Return the verdict on the last relation of a Markdown page, with the symbols file beside it."""
    page = folder / "page.md"
    page.write_text(text + "\n", encoding="utf-8")
    if symbols:
        (folder / "page.symbols.toml").write_text(symbols, encoding="utf-8")
    return check(page).verdicts[-1].verdict


def verdicts_of(folder: Path, text: str, symbols: str = "") -> list[str]:
    """Return the verdicts on all relations of a Markdown page, with the symbols file beside it."""
    page = folder / "page.md"
    page.write_text(text + "\n", encoding="utf-8")
    if symbols:
        (folder / "page.symbols.toml").write_text(symbols, encoding="utf-8")
    return [verdict.verdict for verdict in check(page).verdicts]


def verdicts_in(text: str) -> list[str]:
    """Return the verdicts on all relations of a page given as text."""
    return [link["verdict"] for link in check_text(text + "\n", fixes=False).data()["links"]]


def last_in(text: str) -> str:
    """Return the verdict on the last relation of a page given as text."""
    return verdicts_in(text)[-1]


def in_displays(lines: tuple[str, ...] | list[str]) -> str:
    """Return formulas as displays, one below the other."""
    return "\n\n".join(f"$${line}$$" for line in lines)
