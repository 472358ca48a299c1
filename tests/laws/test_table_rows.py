"""A number in a row of a table is its letter's value by the formula above, where the row is."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

DATA = "r = 0.045 m, l = 0.15 m, λ = r/l = 0.3, ω = 377 rad/s, m = 0.6 kg.\n\n"
ACCELERATION = DATA + "a ≈ r ω² (cos θ + λ cos 2θ)\n\n"
ROWS = (("30°", "6498"), ("60°", "2239"), ("90°", "-1919"), ("120°", "-4157"), ("180°", "-4477"))
WRONG = ("refuted", "contradiction")


def _page(kind: str, head: str, rows, lead: str) -> str:
    cells = [(place, f"a = {value} m/s²") for place, value in rows]
    if kind == "md":
        lines = [f"| {head} | acceleration |", "|---|---|", *(f"| {a} | {b} |" for a, b in cells)]
    elif kind == "html":
        lines = ["<table>", f"<tr><th>{head}</th><th>acceleration</th></tr>"]
        lines += [f"<tr><td>{a}</td><td>{b}</td></tr>" for a, b in cells] + ["</table>"]
    elif kind == "wiki":
        lines = ["{|", f"! {head} !! acceleration"]
        lines += [line for a, b in cells for line in ("|-", f"| {a} || {b}")] + ["|}"]
    elif kind == "adoc":
        lines = ['[cols="1,2"]', "|===", f"|{head} |acceleration", ""]
        lines += [line for a, b in cells for line in (f"|{a}", f"|{b}", "")] + ["|==="]
    else:
        lines = [f"   {head}        acceleration", *(f"   {a}       {b}" for a, b in cells)]
    return lead + "\n".join(lines) + "\n"


def _verdicts(tmp_path, kind, text, count):
    page = tmp_path / f"page.{kind}"
    page.write_text(text, encoding="utf-8")
    return [v.verdict for v in check(page, fixes=False).verdicts][-count:]


@pytest.mark.parametrize("kind", ["md", "html", "wiki", "adoc", "txt"])
@pytest.mark.parametrize("head", ["angle", "θ in °"])
def test_a_row_that_does_not_fit_the_others_is_refuted(tmp_path, kind, head):
    right = _verdicts(tmp_path, kind, _page(kind, head, ROWS, ACCELERATION), len(ROWS))
    assert right == ["conditional"] * len(ROWS)
    for k, (place, value) in enumerate(ROWS):
        slip = value.removeprefix("-") if value.startswith("-") else f"-{value}"
        wrong = (*ROWS[:k], (place, slip), *ROWS[k + 1 :])
        expected = ["conditional"] * len(ROWS)
        expected[k] = "refuted"
        assert _verdicts(tmp_path, kind, _page(kind, head, wrong, ACCELERATION), len(ROWS)) == expected


def test_the_angle_may_be_named_by_the_head_alone(tmp_path):
    rows = [(place.removesuffix("°"), value) for place, value in ROWS]
    lead = ACCELERATION
    assert _verdicts(tmp_path, "md", _page("md", "θ, degrees", rows, lead), 5) == ["conditional"] * 5
    rows[1] = ("60", "2938")
    assert _verdicts(tmp_path, "md", _page("md", "θ, degrees", rows, lead), 5)[1] == "refuted"


def test_a_table_of_the_exact_values_is_not_accused_by_the_rough_formula(tmp_path):
    rows = [("0°", "8315"), ("30°", "6494"), ("60°", "2194"), ("90°", "-2012"), ("180°", "-4477")]
    words = _verdicts(tmp_path, "md", _page("md", "angle", rows, ACCELERATION), 5)
    assert not set(words) & {*WRONG}


def test_a_table_of_another_engine_is_not_accused(tmp_path):
    rows = [(place, f"{float(value) * (1.3 + k / 10):.0f}") for k, (place, value) in enumerate(ROWS)]
    words = _verdicts(tmp_path, "md", _page("md", "angle", rows, ACCELERATION), len(ROWS))
    assert not set(words) & {*WRONG}


def test_no_row_gives_its_number_to_what_follows(tmp_path):
    page = (
        _page("md", "angle", ROWS, ACCELERATION) + "\n\nThe force is F = m a = 0.6·(-4477) = -2686 N.\n"
    )
    assert _verdicts(tmp_path, "md", page, 3)[-1] not in WRONG
    page = _page("md", "angle", ROWS, ACCELERATION) + "\n\nSo a = -4477.\n"
    assert _verdicts(tmp_path, "md", page, 1)[0] not in ("holds", "holds_to_order", "conditional")


SPEEDS = (("2000 rpm", "1.58"), ("4000 rpm", "6.32"), ("6000 rpm", "14.2"))
FORCE = (
    "m = 0.6 kg, r = 0.045 m, λ = 0.3, n = 3600 rpm, ω = 377 rad/s.\n\nF = m r ω² (1 + λ) = 4.99 kN\n\n"
)
OPEN = "The amplitude is F = 4 m r ω² λ.\n\n"
"""Nothing says what m, r and λ are: the rows go with each other."""


@pytest.mark.parametrize(
    ("lead", "values"), [(FORCE, ("1.54", "6.16", "13.9")), (OPEN, ("0.867", "3.47", "7.80"))]
)
def test_a_row_at_another_speed_is_computed_with_its_speed(tmp_path, lead, values):
    rows = [f"| {place} | F = {value} kN |" for (place, _), value in zip(SPEEDS, values, strict=True)]
    head = "| speed | force |\n|---|---|\n"
    assert _verdicts(tmp_path, "md", lead + head + "\n".join(rows) + "\n", 3) == ["conditional"] * 3
    linear = f"| 4000 rpm | F = {2 * float(values[0]):.3g} kN |"
    page = lead + head + "\n".join([rows[0], linear, rows[2]]) + "\n"
    assert _verdicts(tmp_path, "md", page, 3) == ["conditional", "refuted", "conditional"]


def test_a_number_in_a_column_of_plain_text_is_no_factor(tmp_path):
    page = "k = cos A + (cos 2A)/n for a rod of n = 5 cranks.\n\n  A, degrees   factor\n"
    page += "    0       k =  1.200\n   90       k = -0.200\n  120       k = -0.600\n"
    assert _verdicts(tmp_path, "txt", page, 3) == ["conditional"] * 3
    assert _verdicts(tmp_path, "txt", page.replace("-0.600", "-0.400"), 3)[-1] == "refuted"


def test_a_row_does_not_go_with_itself(tmp_path):
    page = "$F_y = -k U \\sin\\theta$ is what stays.\n\n| k | across |\n|---|---|\n| 1 | $F_y = 0$ |\n"
    assert _verdicts(tmp_path, "md", page, 1)[0] not in ("holds", "holds_to_order", "conditional")


def test_rows_of_a_formula_with_several_open_letters_are_premises(tmp_path):
    page = "$F = U + V \\cos\\theta$ is the force.\n\n| angle | force |\n|---|---|\n"
    page += "| 0° | $F = 3$ N |\n| 60° | $F = 2$ N |\n| 90° | $F = 1$ N |\n"
    assert _verdicts(tmp_path, "md", page, 3) == ["premise"] * 3


LETTERS = "F_x = (1 - k)·U·cos φ and F_y = -k·U·sin φ.\n\n| k | what remains |\n|---|---|\n"
CELLS = (
    ("0", "F_x = U·cos φ, F_y = 0"),
    ("½", "F_x = ½·U·cos φ, F_y = -½·U·sin φ"),
    ("1", "F_x = 0, F_y = -U·sin φ"),
)


def test_a_formula_in_a_row_is_the_formula_above_at_its_letters_number(tmp_path):
    rows = "".join(f"| {k} | {cell} |\n" for k, cell in CELLS)
    assert _verdicts(tmp_path, "md", LETTERS + rows, 6) == ["conditional"] * 6
    wrong = rows.replace("F_y = -U·sin φ", "F_y = 0")
    assert _verdicts(tmp_path, "md", LETTERS + wrong, 6) == ["conditional"] * 5 + ["refuted"]
    wrong = rows.replace("F_x = ½", "F_x = ¼")
    assert _verdicts(tmp_path, "md", LETTERS + wrong, 6)[2] == "refuted"


@pytest.mark.parametrize("factor", [-1, 1.15, 10, 0.001])
def test_a_whole_column_wrong_by_one_factor_does_not_hold(tmp_path, factor):
    rows = [(place, f"{float(value) * factor:.6g}") for place, value in ROWS]
    words = _verdicts(tmp_path, "md", _page("md", "angle", rows, ACCELERATION), len(ROWS))
    assert not set(words) & {"holds", "holds_to_order", "conditional"}


def test_a_column_in_another_unit_than_its_formula_is_said(tmp_path):
    page = _page("md", "angle", ROWS, ACCELERATION).replace(" m/s² |", " m/s |")
    assert "refuted" in _verdicts(tmp_path, "md", page, len(ROWS) + 1)  # of the two, the formula


def test_a_zero_supports_no_other_row(tmp_path):
    page = "x = R cos θ\n\n| θ | x |\n|---|---|\n| 90° | x = 0 |\n| 60° | x = 25 mm |\n"
    assert _verdicts(tmp_path, "md", page, 1)[0] not in ("holds", "holds_to_order", "conditional")


def test_two_letters_of_a_row_count_both(tmp_path):
    page = "r = 0.04 m, ω = 419 rad/s\n\na = r ω² (cos θ + λ cos 2θ)\n\n| θ | λ | a |\n|---|---|---|\n"
    for place, ratio, value in (
        ("0°", "0.25", 8778),
        ("0°", "0.3", 9129),
        ("60°", "0.25", 2633),
        ("60°", "0.3", 2458),
    ):
        page += f"| {place} | {ratio} | a = {value} m/s² |\n"
    assert _verdicts(tmp_path, "md", page, 4) == ["conditional"] * 4


def test_the_speed_of_another_row_excuses_none(tmp_path):
    page = "r = 0.04 m.\n\na = r ω²\n\n| speed | a |\n|---|---|\n"
    for speed, value in ((1000, 439), (2000, 1755), (3000, 3948), (4000, 1755)):
        page += f"| {speed} rpm | a = {value} m/s² |\n"
    assert _verdicts(tmp_path, "md", page, 4) == ["conditional"] * 3 + ["refuted"]


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        ("555", "2221", ["conditional", "conditional"]),
        ("655", "2221", ["refuted", "conditional"]),  # one digit
        ("555", "1110", ["conditional", "refuted"]),  # the speed not squared
        ("555", "2212", ["conditional", "refuted"]),  # two digits exchanged
        ("555", "1730", ["conditional", "premise"]),  # it may be of anything
    ],
)
def test_in_a_table_of_two_rows_a_slip_beside_a_right_row_is_refuted(tmp_path, first, second, expected):
    page = (
        "With $m = 0.5$ kg and $r = 45$ mm the force is $F_1 = m r\\omega^2$.\n\n"
        f"| speed | force |\n|---|---|\n| 1500 rpm | $F_1 = {first}$ N |\n"
        f"| 3000 rpm | $F_1 = {second}$ N |\n"
    )
    assert _verdicts(tmp_path, "md", page, 2) == expected
