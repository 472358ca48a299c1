"""Units without the signs between them, kgm², N/mm2 and 900/min: right ones hold, wrong ones fail."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

HOLDS, OPEN = (
    ("holds", "holds_to_order"),
    ("definition", "premise", "undecided", "unreadable", "conditional"),
)
RIGHT = [
    (r"$J = 0.35\,\mathrm{kgm^2} = 3500\,\mathrm{kgcm^2}$", "md"),
    (r"$J = 0.35\,\mathrm{kgm}^2 = 0.35\,\mathrm{kg\,m^2}$", "md"),
    (r"$A = 280.8\,\mathrm{kg^3m^6} = 280.8\,\mathrm{kg^3\,m^6}$", "md"),
    (r"$B = 3\,\mathrm{kNm^2} = 3000\,\mathrm{Nm^2}$", "md"),
    (r"$p = 3\,\mathrm{Nmm^{-2}} = 3\,\mathrm{MPa}$", "md"),
    (r"$v = 4\,\text{ms}^{-1} = 4\,\text{m/s}$", "md"),
    (r"$a = 4\,\mathrm{ms^{-2}} = 400\,\mathrm{cm/s^2}$", "md"),
    (r"$v=4$\,ms$^{-1}$ and $2v = 8$\,m/s", "tex"),
    (r"$\omega = 0.3\,\mathrm{ms}^{-1} = 300\,\mathrm{s}^{-1}$", "md"),
    (r"$n = 900/\mathrm{min} = 15/\mathrm{s}$", "md"),
    (r"$n = 900\,/\text{min} = 15\,\mathrm{/s}$", "md"),
    ("<p>J = 2.5 kgm<sup>2</sup> = 2.5 kg m&sup2;</p>", "html"),
    ("J = 0.35 kgm2 = 0.35 kg m2 = 0.35 kgm^2", "txt"),
    ("E = 210 GPa = 210000 N/mm2", "txt"),
    ("V = 0.5 l = 500 cm3", "txt"),
    ("rho = 7.85 g/cm3 = 7850 kg/m3", "txt"),
    ("w = 20 m s-1 = 20 m/s", "txt"),
    ("n = 3000 min-1 = 50 s-1", "txt"),
    ("n = 900/min = 15/s", "txt"),
]
WRONG = [
    (r"$J = 0.35\,\mathrm{kgm^2} = 350\,\mathrm{kgcm^2}$", "md"),
    (r"$B = 3\,\mathrm{kNm^2} = 300\,\mathrm{Nm^2}$", "md"),
    (r"$p = 3\,\mathrm{Nmm^{-2}} = 30\,\mathrm{MPa}$", "md"),
    (r"$n = 900/\mathrm{min} = 150/\mathrm{s}$", "md"),
    ("J = 0.35 kgm2 = 0.53 kg m2", "txt"),
    ("E = 210 GPa = 21000 N/mm2", "txt"),
    ("V = 0.5 l = 50 cm3", "txt"),
    ("n = 900/min = 1.5/s", "txt"),
]
LETTERS = [
    "m1 = 2 kg, m2 = 3 kg, F = 3 m2 = 9 kg",
    "s = 3, w = 10 s-1 = 29",
    "s = 3, k = 9/s = 3",
    "a = 6/min(2, 3) = 3",
]
"""Where the same signs are letters of the page."""


def _last(tmp_path, line: str, kind: str) -> str:
    path = tmp_path / f"page.{kind}"
    path.write_text(f"{line}\n", encoding="utf-8")
    return check(path, fixes=False).verdicts[-1].verdict


@pytest.mark.parametrize(("line", "kind"), RIGHT)
def test_right_conversions_hold(tmp_path, line, kind):
    assert _last(tmp_path, line, kind) in HOLDS


@pytest.mark.parametrize(("line", "kind"), WRONG)
def test_wrong_conversions_fail(tmp_path, line, kind):
    assert _last(tmp_path, line, kind) == "refuted"


@pytest.mark.parametrize("line", LETTERS)
def test_letters_of_the_page_stay_letters(tmp_path, line):
    assert _last(tmp_path, line, "txt") in HOLDS


def test_metres_by_seconds_are_said(tmp_path):
    path = tmp_path / "page.md"
    path.write_text("$v = 4\\,\\mathrm{ms^{-1}}$\n", encoding="utf-8")
    assert any("metres by seconds" in note for note in check(path, fixes=False).data()["notes"])
