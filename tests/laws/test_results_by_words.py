"""What words say of another thing, or of the result itself, proves no result."""

import pytest

from symbalance.checking import check
from symbalance.notes.checking.declared.symbol_roles import misspelt_role, role_of

PROVED = ("holds", "holds_to_order", "conditional")


def links_of(page: str) -> list[dict[str, object]]:
    return check(page + "\n", fixes=False).data()["links"]


def last_word(page: str) -> str:
    return str(links_of(page)[-1]["verdict"])


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        (
            "The bank angle is $60^\\circ$. The firing interval is $\\alpha = 720^\\circ/6 = ?^\\circ$.",
            "120",
            "60",
        ),
        (
            "The stroke is 80 mm, the bore is 90 mm. The radius is"
            " $\\rho = 80\\,\\mathrm{mm}/2 = ?\\,\\mathrm{mm}$.",
            "40",
            "90",
        ),
        ("Die Kurbel steht bei 60°. Dann ist $x = 2\\cdot 60° = ?°$.", "120", "60"),
    ],
)
def test_a_size_in_words_is_not_the_result_that_is_worked_out(page, right, wrong):
    assert last_word(page.replace("?", right)) in PROVED
    assert last_word(page.replace("?", wrong)) == "refuted"


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        (
            "$F = 200$ N, $c = 20$ N/mm. The bolt breaks at 500 N. The deflection is $f = F/c = ?$ mm.",
            "10",
            "25",
        ),
        (
            "$p = 5$ bar and $A = 10$ cm². The peak pressure is 60 bar. The mean force is"
            " $F = p A = ?$ N.",
            "500",
            "6000",
        ),
        (
            "Manivelle $r = 40$ mm, bielle de 160 mm. La course vaut $s = 2r = ?$ mm.",
            "80",
            "320",
        ),
    ],
)
def test_the_size_of_another_thing_in_a_sentence_before_proves_nothing(page, right, wrong):
    assert last_word(page.replace("?", right)) in PROVED
    assert last_word(page.replace("?", wrong)) not in PROVED


def test_a_side_equal_to_the_beginning_only_says_that_it_is_no_step():
    *_, wrong, behind = links_of("$x = 3\\cdot 4 = 13 = 12$.")
    assert wrong["verdict"] == "refuted"
    assert "not to the side before, which is refuted" in str(behind["reason"])
    assert last_word("$x = 3\\cdot 4 = 13 = 26/2$.") in PROVED


@pytest.mark.parametrize(
    ("page", "verdict"),
    [
        ("Torque: $M = 30\\cdot 2 = 60$ N", "refuted"),
        ("Torque: $M = 30\\cdot 2 = 60$ N m", "holds"),
        ("- **Angular velocity:** $\\omega = 2\\pi\\cdot 7000/60 = 733$ s^{-4}", "refuted"),
        (
            "Winkelgeschwindigkeit: $\\omega = 2\\pi\\cdot 7000/60 = 733\\,\\mathrm{s}^{-1}$",
            "holds_to_order",
        ),
        ("Winkelgeschwindigkeit: $\\omega = 2\\pi\\cdot 7000/60 = 733\\,\\mathrm{s}^{-4}$", "refuted"),
        ("Torque of the force: $F = 3\\cdot 10 = 30$ N", "holds"),
        ("Kolbenfläche und Gaskraft: $A = 5\\cdot 6 = 30$ cm²", "holds"),
    ],
)
def test_a_label_names_the_unit_of_its_letter(page, verdict):
    assert last_word(page) == verdict


def test_a_label_of_several_names_no_unit_of_the_first():
    words = [link["verdict"] for link in links_of("Gas force: $p = 55$ bar, $A = 58.1$ cm², $F = p A$")]
    assert "refuted" not in words


@pytest.mark.parametrize("place", ["only where", "nur wo", "provided"])
def test_what_something_takes_contradicts_no_value_later(place):
    page = f"Mounts isolate {place} $s > 1$. Do not let the set idle near $s = 1$."
    assert last_word(page) not in ("contradiction", "refuted")
    assert last_word("Here $s > 1$. Now $s = 1$.") == "contradiction"


def test_a_condition_behind_an_inequality_leaves_it_no_claim_of_all_values():
    page = "$F_2 = \\lambda F_1$. It is always the smaller, but $4F_2 > F_1$ as soon as $\\lambda > 1/4$."
    assert "refuted" not in [link["verdict"] for link in links_of(page)]


BOXER = (
    "In the boxer twin the pins are 180° apart, the cylinders staggered by $a$, and a couple stays."
    " Its first order is $M_1 = a F\\{}\\theta$."
)


def test_the_couple_of_two_cranks_goes_with_the_cosine():
    assert last_word(BOXER.format("cos")) in PROVED
    assert last_word(BOXER.format("sin")) not in PROVED


def test_a_couple_with_a_phase_is_left_as_it_is():
    page = BOXER.replace("\\theta$", "(\\theta + 90°)$").format("sin")
    assert last_word(page) not in ("undecided", "refuted")
    three = (
        "Inline three, cylinder spacing $a$. Its first order couple is $M_1 = \\sqrt3 a F\\cos\\theta$."
    )
    assert last_word(three) not in ("undecided", "refuted")


def test_a_unit_in_brackets_leaves_a_meaning_known():
    assert role_of("crank radius [mm]") == role_of("crank radius")
    assert role_of("angular velocity (rad/s)") == "angular speed"
    assert role_of("crank speed [rpm]") not in ("angular speed", "engine speed rpm")
    assert misspelt_role("engine speed [rpm]") is None
    assert misspelt_role("cranck radius [mm]") == "crank radius"
