"""The piston's motion in every set of letters: right as it is derived, wrong with one thing changed.

Each formula is the exact motion of a slider-crank; a note that states it must hold whichever sizes its
letters stand for, and a note with one sign, factor or power changed must not.
"""

from __future__ import annotations

import unicodedata
from fractions import Fraction
from pathlib import Path

import pytest

import symbalance as sb
from symbalance.notes.reading.signs import VULGAR
from symbalance.notes.reading.units import (
    bracketed_unit_at,
    follows_number,
    plain_unit_at,
    scale_of,
    unit_fraction_at,
    unit_set_at,
)

# radius, rod length and angular speed in the letters of a note
LETTERS = {
    "l and r": (
        r"r",
        r"l",
        r"\omega",
        {"r": "crank radius", "l": "rod length", "omega": "angular speed"},
    ),
    "lambda = l/r": (
        r"r",
        r"\lambda r",
        r"\omega",
        {"r": "crank radius", "lambda": "rod ratio l/r", "omega": "angular speed"},
    ),
    "rho = r/l": (
        r"r",
        r"\frac{r}{\rho}",
        r"\omega",
        {"r": "crank radius", "rho": "crank ratio r/l", "omega": "angular speed"},
    ),
    "stroke and l": (
        r"\frac{s}{2}",
        r"l",
        r"\frac{\pi n}{30}",
        {"s": "stroke", "l": "rod length", "n": "engine speed rpm"},
    ),
    "lambda = l/s": (
        r"\frac{s}{2}",
        r"\lambda s",
        r"\omega",
        {"s": "stroke", "lambda": "rod ratio l/s", "omega": "angular speed"},
    ),
}
QUANTITIES = {
    "x": "displacement from top dead centre",
    "v": "piston velocity",
    "a": "piston acceleration",
    "F": "inertia force",
}


def motion(radius: str, length: str, speed: str) -> dict[str, str]:
    """Return the exact motion, as one types it."""
    ratio = rf"\left(\frac{{{radius}}}{{{length}}}\right)"
    root = rf"\sqrt{{1 - {ratio}^2 \sin^2\theta}}"
    bracket = (
        rf"\left(\cos\theta + {ratio} \frac{{\cos 2\theta}}{{{root}}}"
        rf" + {ratio}^3 \frac{{\sin^2\theta \cos^2\theta}}{{\left({root}\right)^3}}\right)"
    )
    around = rf"\left({radius}\right) \left({speed}\right)"
    return {
        "x": rf"\left({radius}\right)(1 - \cos\theta) + \left({length}\right)\left(1 - {root}\right)",
        "v": rf"{around} \left(\sin\theta + {ratio} \frac{{\sin\theta \cos\theta}}{{{root}}}\right)",
        "a": rf"{around} \left({speed}\right) {bracket}",
        "F": rf"m {around} \left({speed}\right) {bracket}",
    }


WRONG = {
    "x": (r"(1 - \cos\theta)", r"(1 + \cos\theta)"),
    "v": (r"\left(\sin\theta + ", r"\left(\sin\theta - "),
    "a": (r"\cos 2\theta", r"\cos \theta"),
    "F": (r")^3 \frac{\sin^2", r")^2 \frac{\sin^2"),
}


def verdict(text: str, symbols: dict[str, str]) -> str:
    found = sb.check(text, symbols).verdicts
    assert [v.fault for v in found] == [""] * len(found)
    return found[-1].verdict


@pytest.mark.spread(3)
@pytest.mark.parametrize("letter", QUANTITIES)
@pytest.mark.parametrize("letters", LETTERS)
def test_the_exact_motion_holds_in_its_letters_and_not_with_one_thing_changed(letters, letter):
    *sizes, symbols = LETTERS[letters]
    symbols = {**symbols, **QUANTITIES, "theta": "crank angle", "m": "reciprocating mass"}
    formula = motion(*sizes)[letter]
    assert verdict(f"$${letter} = {formula}$$", symbols) == "holds"
    old, new = WRONG[letter]
    assert old in formula
    assert verdict(f"$${letter} = {formula.replace(old, new, 1)}$$", symbols) == "refuted"
    assert verdict(rf"$${letter} = 2 \left({formula}\right)$$", symbols) == "refuted"


SERIES = {
    "lambda = l/r": (r"r", r"\frac{{1}}{{\lambda}}", 1),
    "rho = r/l": (r"r", r"\rho", 1),
    "lambda = l/s": (r"\frac{s}{2}", r"\frac{{1}}{{2\lambda}}", 1),
}


@pytest.mark.spread(1)
@pytest.mark.parametrize("letters", SERIES)
def test_the_series_in_the_small_letter_holds_to_its_order(letters):
    radius, small, _ = SERIES[letters]
    small = small.replace("{{", "{").replace("}}", "}")
    symbols = {**LETTERS[letters][3], **QUANTITIES, "theta": "crank angle", "m": "reciprocating mass"}
    for share, right in (("", True), ("2", False), ("-", False)):
        text = rf"$$a \approx {radius} \omega^2 \left(\cos\theta + {share} {small} \cos 2\theta\right)$$"
        assert (verdict(text, symbols) == "holds_to_order") == right, text
    text = rf"$$x \approx {radius} (1 - \cos\theta) + \frac{{{radius}}}{{4}} {small} (1 - \cos 2\theta)$$"
    assert verdict(text, symbols) == "holds_to_order"
    assert verdict(text.replace("{4}", "{2}"), symbols) == "refuted"


# A binding that means a piece of a line

LINE = r"the piston moves by r(1 - \cos\theta) at first and at last by 2r, which is the stroke"
SYMBOLS = '[symbols]\nr = "crank radius"\nl = "rod length"\ntheta = "crank angle"\n'


def bound(folder: Path, text: str, *binds: str) -> list[tuple[int, str, str]]:
    (folder / "notes.md").write_text(text, encoding="utf-8")
    rows = "".join(f"[[bind]]\n{bind}\n" for bind in binds)
    (folder / "notes.symbols.toml").write_text(SYMBOLS + rows, encoding="utf-8")
    found = sb.check(folder / "notes.md").verdicts
    return [(v.line, v.claimed, v.verdict) for v in found if v.bind]


def test_a_piece_of_a_line_is_read_where_it_stands(tmp_path):
    """Neither what stands before it nor what follows counts, on whichever line."""
    whole = r"r(1 - \cos\theta) + l - \sqrt{l^2 - r^2 \sin^2\theta}"
    text = (
        f"First line, with 3l.\n\nso much for ${whole}$ and 5 more\nwrong: $r(1 + \\cos\\theta)$ it is\n"
    )
    right = f"line = 3\ntext = '{whole}'\nquantity = \"displacement\""
    wrong = "line = 4\ntext = 'r(1 + \\cos\\theta)'\nquantity = \"displacement\""
    rows = bound(tmp_path, text, right, wrong)
    assert [(line, word) for line, _, word in rows] == [(3, "holds"), (4, "refuted")]
    assert rows[1][1].replace(" ", "") == "r(1+cosθ)"
    second = "line = 1\ntext = '3l'\nquantity = \"displacement\""
    assert [(line, word) for line, _, word in bound(tmp_path, text, second)] == [(1, "refuted")]


def test_a_column_tells_which_of_two_like_pieces_is_meant(tmp_path):
    text = "x = 1, and then 2r or 2r again\n"
    checked = bound(tmp_path, text, 'line = 1\ncolumn = 17\ntext = "2r"\nquantity = "displacement"')
    assert [row[1].replace(" ", "") for row in checked] == ["2r"]
    for column in (1, 16, 18):
        with pytest.raises(sb.SymbalanceError, match="does not stand on line 1"):
            bound(tmp_path, text, f'line = 1\ncolumn = {column}\ntext = "2r"\nquantity = "displacement"')
    with pytest.raises(sb.SymbalanceError, match="the document has 2 lines"):
        bound(tmp_path, text, 'line = 3\nquantity = "displacement"')


# Sums with dots, by induction

PROGRESSIONS = [
    (r"1 + 2 + \ldots + N = \frac{N(N+1)}{2}", True),
    (r"1 + 2 + \ldots + N = \frac{N(N-1)}{2}", False),
    (r"1 + 4 + \ldots + N^2 = \frac{N(N+1)(2N+1)}{6}", True),
    (r"1 + 4 + \ldots + N^2 = \frac{N(N+1)(2N+1)}{3}", False),
    (r"1 + 3 + \ldots + (2N-1) = N^2", True),
    (r"1 + 3 + \ldots + (2N-1) = N^2 + 1", False),
    (r"1 + 5 + \ldots + (2N-1) = N^2", False),
    (r"\sum_{k=1}^{N} k = \frac{N(N+1)}{2}", True),
    (r"\sum_{k=0}^{N} k = \frac{N(N+1)}{2}", True),
    (r"\sum_{k=2}^{N} k = \frac{N(N+1)}{2} - 1", True),
    (r"\sum_{k=2}^{N} k = \frac{N(N+1)}{2}", False),
    (r"3 + \sum_{k=1}^{N} 2 k = N^2 + N + 3", True),
    (r"N^2 = 1 + 3 + \ldots + (2N-1)", True),
]


@pytest.mark.parametrize(("relation", "true"), PROGRESSIONS)
def test_a_sum_over_all_cylinders_holds_by_induction_or_not_at_all(relation, true):
    word = verdict(f"$${relation}$$", {"N": "integer"})
    assert (word in ("holds", "conditional")) == true
    assert word in ("holds", "conditional", "refuted", "undecided")


# Units, by the SI's definitions

MILLI, KILO = Fraction(1, 1000), Fraction(1000)
UNITS = {
    "m": 1, "mm": MILLI, "cm": Fraction(1, 100), "km": KILO, "kg": 1, "g": MILLI, "mg": MILLI**2,
    "s": 1, "ms": MILLI, "min": 60, "h": 3600, "N": 1, "kN": KILO, "MN": 10**6, "Pa": 1, "MPa": 10**6,
    "GPa": 10**9, "bar": 10**5, "J": 1, "kJ": KILO, "W": 1, "kW": KILO, "Hz": 1, "kHz": KILO,
    "cc": Fraction(1, 10**6), "m^2": 1, "mm^2": MILLI**2, "cm^3": Fraction(1, 10**6), "m/s": 1,
    "km/h": Fraction(1000, 3600), "m/s^2": 1, "N m": 1, "N mm": MILLI, "kg m^2": 1, "kg mm^2": MILLI**2,
    "g/cm^3": KILO, "kg/m^3": 1, "N/mm^2": 10**6, "N/mm": KILO, "1/s": 1, "s^-1": 1, "mm^-1": KILO,
    "kg m/s^2": 1, "J/kg": 1, "kJ/kg": KILO, "kg/kW": MILLI, "Nmm": MILLI, "K": 1,
}  # fmt: skip
TURNS = {"rpm": Fraction(1, 30), "1/min": Fraction(1, 30)}
BY_THE_SECOND = ["rps", "rev/s", "U/s", "tr/s"]


@pytest.mark.parametrize("unit", UNITS)
def test_a_unit_is_so_many_of_the_si(unit):
    assert scale_of(unit) == (UNITS[unit], False)
    dotted, raised = (
        unit.replace(" ", r"\cdot "),
        unit.translate(str.maketrans("23", "²³")).replace("^", ""),
    )
    assert scale_of(dotted) == (UNITS[unit], False)
    if "-" not in unit:
        assert scale_of(raised) == (UNITS[unit], False)
    assert scale_of(unit.replace("/", " / ")) == (UNITS[unit], False)


@pytest.mark.parametrize("unit", TURNS)
def test_turns_are_counted_in_pi(unit):
    assert scale_of(unit) == (TURNS[unit], True)


@pytest.mark.parametrize("unit", BY_THE_SECOND)
def test_turns_by_the_second_are_counted_as_hertz_are(unit):
    assert scale_of(unit) == (1, False)


@pytest.mark.parametrize(
    "word", ["", "furlong", "m/", "/m", "m^", "m//s", "2m", "kg-m", "m" * 101, "m^2.5"]
)
def test_words_that_are_no_unit(word):
    assert scale_of(word) is None


def test_where_a_unit_begins_and_ends():
    text = r"5 \mathrm{kN}\,\mathrm{m} x"
    assert unit_set_at(text, 2, len(text)) == (r"{kN}\,{m}", len(text) - 2)
    assert scale_of(r"{kN}\,{m}") == (1000, False)
    fraction = r"\frac{\mathrm{m}}{\mathrm{s}^2} y"
    assert unit_fraction_at(fraction, 0, len(fraction)) == ("{m}/{s}^2", len(fraction) - 2)
    assert scale_of("{m}/{s}^2") == (1, False)
    assert bracketed_unit_at("x [mm] = 3", 2, 10) == ("mm", 6)
    assert bracketed_unit_at("x [ab] = 3", 2, 10) is None
    assert plain_unit_at("40 mm wide", 2, 10, ()) == ("mm", 5)
    assert plain_unit_at("40 mm wide", 2, 10, ("mm",)) is None
    assert plain_unit_at("40 m wide", 2, 9, ()) is None
    assert [follows_number(t, 0, len(t)) for t in ("5 ", r"2\pi ", "x}", "a ", "", ") ")] == [
        True, True, True, False, False, True,
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("relation", "right"),
    [
        (r"5 \mathrm{mm} = 0.005 \mathrm{m}", True),
        (r"5 \mathrm{mm} = 0.05 \mathrm{m}", False),
        (r"36 \mathrm{km/h} = 10 \mathrm{m/s}", True),
        (r"3000 \mathrm{rpm} = 100 \pi \mathrm{rad/s}", True),
        (r"3000 \mathrm{rpm} = 50 \pi \mathrm{rad/s}", False),
        (r"2 \mathrm{N}\,\mathrm{m} = 2000 \mathrm{N}\,\mathrm{mm}", True),
        (r"1 \mathrm{bar} = 0.1 \mathrm{MPa}", True),
    ],
)
def test_relations_of_numbers_with_units(relation, right):
    assert (verdict(f"$${relation}$$", {}) in ("holds", "holds_to_order")) == right


# Signs that stand for more than themselves


@pytest.mark.spread(4)
@pytest.mark.parametrize("character", sorted(VULGAR))
def test_a_fraction_of_one_sign_is_worth_what_unicode_says(character):
    value = Fraction(unicodedata.numeric(character)).limit_denominator(12)
    assert verdict(f"$$60 k {character} = {60 * value} k$$", {"k": "any"}) == "holds"
    assert verdict(f"$$60 k {character} = {60 * value + 1} k$$", {"k": "any"}) == "refuted"


@pytest.mark.parametrize(
    ("text", "word"),
    [
        (r"$$k = 2r {\cos}^2 \theta + r - 2r (\cos\theta)^2$$", "definition"),
        (r"$$2r {\cos}^2 \theta = r (1 + \cos 2\theta)$$", "holds"),
        (r"$$r + 2r {\sin}^2 \theta + r = r (3 - {\cos} 2\theta)$$", "holds"),
        (r"$$r + 2r {\sin}^2 \theta + r = r (3 + {\cos} 2\theta)$$", "refuted"),
    ],
)
def test_braces_around_a_functions_name_are_nothing(text, word):
    assert verdict(text, {"k": "any", "r": "crank radius", "theta": "crank angle"}) == word


@pytest.mark.parametrize("bullet", ["* ", "-   ", "+ ", "  *   "])
def test_a_bullet_is_no_sign_of_the_formula_behind_it(bullet, tmp_path):
    path = tmp_path / "notes.md"
    path.write_text(f"Hence:\n\n{bullet}$2r = r + r$\n{bullet}$2r = r$\n", encoding="utf-8")
    (tmp_path / "notes.symbols.toml").write_text(SYMBOLS, encoding="utf-8")
    found = sb.check(path).verdicts
    assert [(v.line, v.verdict) for v in found] == [(3, "holds"), (4, "refuted")]
