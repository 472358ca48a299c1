"""Values listed behind one letter, z = ±a/2, ±3a/2, and relations that are said for such a list."""

from __future__ import annotations

import pytest

from symbalance.checking import check as check_with_engines
from symbalance.notes.checking import check
from symbalance.notes.reading.spellings.ranges import with_ranges

LISTS = [
    (r"$z = \pm a/2, \pm 3a/2, \pm 5a/2$", r"$-5a/2 ≤ z ≤ 5a/2$"),
    (r"$x_k = \pm\frac{a}{2}, \pm\frac{3a}{2}$", r"$-3a/2 ≤ x_k ≤ 3a/2$"),
    (r"$x = \tfrac12 a,\ -\tfrac32 a$", r"$-3a/2 ≤ x ≤ a/2$"),
    ("throws z = 3a/2, a/2, −a/2, −3a/2 from", "throws -3a/2 ≤ z ≤ 3a/2 from"),
    ("z = 1.5a, 0.5a, −0.5a and −1.5a.", "-3a/2 ≤ z ≤ 3a/2."),
    ("order n = 1/2, 1, 3/2, ... occur", "order n ≥ 1/2 occur"),
    ("n = ½, 1½, 2½.", "1/2 ≤ n ≤ 5/2."),
    ("n = ½, 1½, 2½ ….", "n ≥ 1/2."),
    ("For z = ±a/2, ±3a/2 it is", "For -3a/2 ≤ z ≤ 3a/2 it is"),
    ("位相 θ = 0, 90°, 180° で", "位相 0° ≤ θ ≤ 180° で"),
    (r"$\theta = 0, \frac{\pi}{2}, \pi$", r"$0 ≤ \theta ≤ \pi$"),
    (r"$\alpha = \pm 30^\circ, \pm 90^\circ$", r"$-90^\circ ≤ \alpha ≤ 90^\circ$"),
    ("z = L/2, −L/2.", "-L/2 ≤ z ≤ L/2."),
    (r"$z_{1,2,3} = -a, 0, a$", r"$-a ≤ z_{1,2,3} ≤ a$"),
]
NO_LISTS = [
    "$x = a, b$",
    "For l = 4r, r being the radius",
    "l = 4r, r = 40 mm",
    "λ = 1/4, 3000 rpm",
    "r = s/2, s = 80 mm",
    r"$z_1, z_2, z_3 = -a, 0, a$",
    r"$F = \frac{1}{2} m, m > 0$",
    "x = a/0, b/0",
]


@pytest.mark.parametrize(("typed", "range_"), LISTS)
def test_a_list_is_read_as_the_range_that_holds_it(typed, range_):
    rewritten, _ = with_ranges(typed)
    assert rewritten is not None
    assert rewritten.text == range_


@pytest.mark.parametrize("typed", NO_LISTS)
def test_what_is_no_list_stays(typed):
    assert with_ranges(typed)[0] is None


SAID_FOR_VALUES = [
    ("cos θ = 0 for θ = π/2, 3π/2.", "holds"),
    ("sin 2φ = 0 for φ = 0, π/2, π, 3π/2.", "holds"),
    ("cos 2φ = 0 for φ = 0, π/2, π, 3π/2.", "refuted"),
    ("cos θ = 0 at θ = 90°, 270°.", "holds"),
    ("cos θ = 0 at θ = 90°, 180°.", "refuted"),
    ("cos 2φ = 0 at φ = 45°, 135°, 225°, 315°.", "holds"),
    ("cos 2φ = 0 at φ = 45°, 135°, 225°, 300°.", "refuted"),
    ("sin² θ = 1/2 for θ = ±45°, ±135°.", "holds"),
    ("sin² θ = 1/2 for θ = ±45°, ±125°.", "refuted"),
    (r"$\cos 3\theta = 0$ at $\theta = 30^\circ$, $90^\circ$ and $150^\circ$.", "holds"),
    (r"$\cos 3\theta = 0$ at $\theta = 30^\circ, 60^\circ, 150^\circ$.", "refuted"),
    ("(2z)² = a² for z = ±a/2.\n\n(2z)² = a² for z = ±a/2, ±3a/2.", "undecided"),
    ("A cos θ = B at θ = 0, π.", "definition"),
    ("At n = 4 it is half. The orders n = 1, 2, 3 occur.", "range"),
    ("For order n = 4½ it vanishes. The orders n = ½, 1½, 2½ remain.", "range"),
    ("At n = 6000 rpm. The half orders n = ½, 1½, 2½ …, remain.", "range"),
    ("With n = 3 the sum is 3. The orders n = 4, 5, 6 remain, and 2·3 = 7.", "refuted"),
]


@pytest.mark.parametrize("judge", [check, check_with_engines])
@pytest.mark.parametrize(("page", "word"), SAID_FOR_VALUES)
def test_a_relation_is_judged_at_each_of_the_values(page, word, judge):
    verdicts = [
        v.verdict for v in judge(page, {"theta": "crank angle", "phi": "angle"}, fixes=False).verdicts
    ]
    words = [verdict for verdict in verdicts if verdict not in ("range", "premise")] or verdicts
    assert words[-1] == word


@pytest.mark.parametrize(
    "line",
    ["n = 1500–6000 rpm.", "n = 1500-6000 1/min.", "n = 1500--6000 1/min.", "$x = 3–5$ mm.", "x = 3–5."],
)
def test_a_dash_between_rising_numbers_is_a_range(tmp_path, line):
    path = tmp_path / "page.md"
    path.write_text(f"{line}\n", encoding="utf-8")
    assert {verdict.verdict for verdict in check(path, fixes=False).verdicts} == {"range"}


@pytest.mark.parametrize(
    ("line", "value"),
    [
        ("x = 8–5.", "x = 3"),
        ("x = 5-8.", "x = -3"),
        ("x = 5–8 = -3.", "x = -3"),
        ("x = 3 – 5.", "x = -2"),
    ],
)
def test_a_minus_sign_between_numbers_is_none(tmp_path, line, value):
    path = tmp_path / "page.md"
    path.write_text(f"{line}\n\n{value}\n", encoding="utf-8")
    assert check(path, fixes=False).verdicts[-1].verdict == "holds"
