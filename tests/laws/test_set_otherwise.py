r"""A page set in another way says the same: no verdict hangs on \, or ~, \mathrm or \text, $ or \(."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from symbalance.checking import check

HAND = Path(__file__).parents[1] / "hand"
PAGES = (
    "guest_bericht.md",
    "guest_lehrbuch.tex",
    "integrals_and_limits.md",
    "numbers_and_units.md",
    "rod_masses.tex",
)
CONFIRMED = {"holds": "confirmed", "holds_to_order": "confirmed", "conditional": "confirmed"}


def put(pattern: str, by: str) -> Callable[[str], str]:
    return lambda text: re.sub(pattern, by, text)


SETTINGS: dict[str, Callable[[str], str]] = {
    "thick spaces": put(r"\\,", r"\\;"),
    "tildes": put(r"\\,", "~"),
    "spaces of words": put(r"\\,", r"\\ "),
    "text for units": put(r"\\mathrm\{(?!d\})", r"\\text{"),
    "the old command for upright letters": put(r"\\(?:mathrm|text)\{([A-Za-z/]{1,5})\}", r"{\\rm \1}"),
    "round marks": put(r"(?<![\\$])\$([^$\n]+)\$(?!\$)", r"\\(\1\\)"),
    "a style": put(r"(?<![\\$])\$(?!\$)([^$\n]+)\$(?!\$)", r"$\\displaystyle \1$"),
    "large fractions": put(r"\\frac(?![a-z])", r"\\dfrac"),
    "thin spaces before units": put(r"(?<=[0-9]) (?=(?:mm|kg|N|m|kN|g)\b)", "\u2009"),
    "spaces that do not break": put(r"(?<=[0-9]) (?=(?:mm|kg|N|m|kN|g)\b)", "\u00a0"),
}


def words(page: Path) -> list[str]:
    sidecar = page.with_suffix(".symbols.toml")
    links = check(page, sidecar if sidecar.exists() else None).data()["links"]
    return [CONFIRMED.get(link["verdict"], link["verdict"]) for link in links]


@pytest.mark.slow
@pytest.mark.parametrize("name", PAGES)
def test_a_page_set_otherwise_has_the_same_verdicts(name: str, tmp_path: Path) -> None:
    page = HAND / name
    text, expected = page.read_text(encoding="utf-8"), words(page)
    sidecar = page.with_suffix(".symbols.toml")
    if sidecar.exists():
        (tmp_path / sidecar.name).write_text(sidecar.read_text(encoding="utf-8"), encoding="utf-8")
    changed = [setting for setting in SETTINGS if SETTINGS[setting](text) != text]
    assert len(changed) > 3
    for setting in changed:
        (tmp_path / name).write_text(SETTINGS[setting](text), encoding="utf-8")
        assert words(tmp_path / name) == expected, setting
