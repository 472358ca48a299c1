"""What is said of several numbers of a letter at once is said of each, of one of them, or of none."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")


def verdicts(tmp_path, page):
    path = tmp_path / "page.md"
    path.write_text(page)
    return [(v.source, v.verdict) for v in check(path, fixes=False).verdicts]


def last(tmp_path, page):
    return verdicts(tmp_path, page)[-1][1]


@pytest.mark.parametrize(
    "page",
    [
        "For x = 2 and x = 3, x² = 9.",
        "For x = 2 and for x = 3 we have x² = 9.",
        "Both for r = 40 mm and for r = 50 mm the stroke is 2r = 100 mm.",
        "y = 2 or y = 3. Then y² = 9.",
        "Für z = 2 und für z = 3 gilt z² = 9.",
        "Case 1: x = 2. Case 2: x = 3. In each case x² = 9.",
        "Case 1: x = 2. Case 2: x = 3. Always x² = 9.",
        "Engine A: m = 2 kg. Engine B: m = 3 kg. Each engine has 2m = 6 kg.",
    ],
)
def test_what_is_said_of_all_is_not_proved_by_the_last(tmp_path, page):
    assert last(tmp_path, page) in ("undecided", "refuted")


@pytest.mark.parametrize(
    "page",
    [
        "For x = 3 and x = −3, x² = 9.",
        "Für y = 3 und für y = −3 gilt y² = 9.",
        "Case 1: z = 3. Case 2: z = −3. In each case z² = 9.",
        "x² = 9, so x = 3 or x = −3. In both cases x⁴ = 81.",
    ],
)
def test_what_is_so_of_all_holds(tmp_path, page):
    assert last(tmp_path, page) in PROVED


@pytest.mark.parametrize(
    "page",
    [
        "Neither for x = 2 nor for x = 3 we have x² = 9.",
        "Neither for x = 2 nor for x = 3 we have x² = 4.",
        "Weder für y = 2 noch für y = 3 gilt y² = 9.",
    ],
)
def test_what_is_said_of_none_and_is_so_of_one_is_refuted(tmp_path, page):
    assert last(tmp_path, page) == "refuted"


def test_what_is_so_of_none_may_be_denied_of_all(tmp_path):
    assert last(tmp_path, "Neither for x = 2 nor for x = 3 we have x² = 10.") == "condition"


@pytest.mark.parametrize(
    "page",
    [
        "Either x = 2 or x = 3. In the first case x² = 9.",
        "Entweder y = 2 oder y = 3. Im ersten Fall ist y² = 9.",
        "x² − 5x + 6 = 0, so x = 2 or x = 3. In the first case x³ = 27.",
        "x² − 5x + 6 = 0, so x = 2 or x = 3. In the first case x³ = 8, in the second case x³ = 8.",
    ],
)
def test_the_other_case_does_not_prove_it(tmp_path, page):
    assert last(tmp_path, page) in ("undecided", "refuted")


@pytest.mark.parametrize(
    "page",
    [
        "Either x = 2 or x = 3. In the first case x² = 4, in the second x² = 9.",
        "Entweder y = 2 oder y = 3. Im ersten Fall ist y² = 4, im zweiten Fall y² = 9.",
        "x² − 5x + 6 = 0, so x = 2 or x = 3. In the first case x³ = 8, in the second case x³ = 27.",
    ],
)
def test_each_case_has_its_own(tmp_path, page):
    assert [verdict for _, verdict in verdicts(tmp_path, page)][-2:] == ["holds", "holds"]


@pytest.mark.parametrize(
    ("page", "count"),
    [
        ("y = x². For x = 2 and x = 3 we get y = 4 and y = 9, respectively.", 2),
        ("f = x². For x = 2 and x = 3 we get f = 4 and f = 9, respectively.", 2),
        ("s = 2r. For r = 40 mm or r = 50 mm the stroke is s = 80 mm or s = 100 mm.", 2),
        ("Für x = 2 und x = 3 ist x² = 4 bzw. x² = 9.", 2),
        (
            "a = cos θ + 0.25 cos 2θ. For θ = 0, 90° and 180° it is a = 1.25, a = −0.25 and a = −0.75,"
            " respectively.",
            3,
        ),
    ],
)
def test_results_in_turn_hold(tmp_path, page, count):
    found = [verdict for _, verdict in verdicts(tmp_path, page)]
    assert len(found) >= count
    assert all(verdict in PROVED for verdict in found[-count:])


@pytest.mark.parametrize(
    ("page", "count"),
    [
        ("y = x². For x = 2 and x = 3 we get y = 9 and y = 4, respectively.", 2),
        ("s = 2r. For r = 40 mm or r = 50 mm the stroke is s = 100 mm or s = 80 mm.", 2),
        ("Für x = 2 und x = 3 ist x² = 9 bzw. x² = 4.", 2),
    ],
)
def test_results_out_of_turn_do_not(tmp_path, page, count):
    found = [verdict for _, verdict in verdicts(tmp_path, page)]
    assert all(verdict in ("undecided", "refuted") for verdict in found[-count:])


def test_one_wrong_result_in_turn_is_refuted(tmp_path):
    page = (
        "a = cos θ + 0.25 cos 2θ. For θ = 0, 90° and 180° it is a = 1.25, a = 0.25 and a = −0.75,"
        " respectively."
    )
    found = [verdict for _, verdict in verdicts(tmp_path, page)][-3:]
    assert found == ["conditional", "refuted", "conditional"]
