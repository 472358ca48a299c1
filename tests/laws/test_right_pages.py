"""Right relations as different hands write them: none may be accused, and their wrong twins are seen."""

import pytest

from symbalance.checking import check

ACCUSED = ("refuted", "contradiction")
OPEN = (*ACCUSED, "undecided", "unreadable")


def words_of(page: str) -> list[str]:
    return [link["verdict"] for link in check(page).data()["links"]]


RESULTS = [
    ("The power is $318\\times419 = {}\\times10^3$ W.", "133", "134"),
    ("Die Leistung ist 318 · 419 = {}·10³ W.", "133", "143"),
    ("The ring makes <math>2050/8={}</math>&nbsp;rpm.", "256", "265"),
    ("La came fait \\(2050/8 = {}\\) rpm.", "256", "265"),
    ("Der Hub ist $s = 92{{,}}8$ mm, die Drehzahl $n = 5000\\,\\mathrm{{min^{{-1}}}}$.\n\n"
     "$$v = 2\\,s\\,n = \\frac{{2\\cdot 0{{,}}0928\\cdot 5000}}{{60}} = {}\\ \\mathrm{{m/s}}$$\n",
     "15{,}47", "14{,}57"),
    ("E = 968 ft-lb, ω = 47.1 rad/s and k = 0.025, I = E/(k ω²) = 968/(0.025 × 47.1²) = {} slug ft².",
     "17.5", "15.7"),
]  # fmt: skip


@pytest.mark.parametrize(("page", "right", "wrong"), RESULTS)
def test_a_result_rounded_in_its_unit_is_right_and_another_one_is_not(page, right, wrong):
    assert not set(words_of(page.format(right))) & set(OPEN)
    assert words_of(page.format(wrong))[-1] in ACCUSED


BOTH_IN_ONE_SENTENCE = [
    "The 90° twin fires after $D=450^\\circ$, the 60° twin after $D=420^\\circ$.",
    "Beim Reihenmotor ist M = 300 N m, beim Boxer M = 200 N m.",
    "Per il motore A vale K = 12 kN, per il motore B vale K = 9 kN.",
    "Pour le V à 60°, A = 30 kN ; pour le V à 90°, A = 20 kN.",
    "Le piston d'origine pèse x = 320 g, celui de remplacement x = 280 g.",
    "Cylinder 1 gives P = 300 N, cylinder 2 P = 250 N.",
    "Bei Zylinder 3 F = 2 kN, bei Zylinder 4 F = 3 kN.",
    "For order 2 M = 40 N m and for order 4 M = 10 N m.",
    "１番気筒では S = 30 N、２番気筒では S = 20 N。",
    "One is at the top when $\\theta = 30° + \\varphi$, the other when $\\theta = 120° + \\varphi$.",
]


@pytest.mark.parametrize("sentence", BOTH_IN_ONE_SENTENCE)
def test_two_values_of_a_letter_in_one_sentence_are_of_two_things(sentence):
    assert not set(words_of(sentence)) & set(OPEN)


@pytest.mark.parametrize("between", ["that is", "d. h.", "so"])
def test_a_value_told_again_in_one_sentence_is_the_same(between):
    assert words_of(f"The rod has m = 0.52 kg, {between} m = 0.25 kg in all.")[-1] in OPEN


def test_the_number_of_a_thing_is_no_factor_and_a_factor_is_none_of_a_thing():
    assert words_of("Let P = 300 N. Two of them give 2 P = 600 N.")[-1] not in OPEN
    assert words_of("Let P = 300 N. Two of them give 2 P = 650 N.")[-1] in ACCUSED


PRESSURES = [
    "Gasdruck p = 38 bar bei 30° nach OT, A = 55,42 cm² und F = p·A = 21,06 kN.\n\n"
    "Bei 60° nach OT ist der Druck auf 14 bar gefallen; dort ist F = {} kN.\n",
    "Le piston pousse avec p = 38 bar à 30°, et A = 55,42 cm² : F = p A = 21,06 kN.\n\n"
    "À 60° la pression n'est plus que de 14 bar, et F = {} kN.\n",
    "The pressure is p = 38 bar at 30° after TDC, A = 55,42 cm² and F = p A = 21,06 kN.\n\n"
    "It drops. At 60° a mere 14 bar are left, and all that the piston has is F = {} kN.\n",
]


@pytest.mark.parametrize("page", PRESSURES)
def test_a_size_that_the_paragraph_says_without_its_letter_is_put_in(page):
    assert words_of(page.format("7,76"))[-1] not in OPEN
    assert words_of(page.format("6,77"))[-1] in ACCUSED


@pytest.mark.parametrize(
    "words", ["At 60° after TDC", "Bei 60° nach OT ist der Druck geringer; dort ist"]
)
def test_the_sine_of_an_angle_is_another_one_at_another_place(words):
    page = "With λ = 0.3, sin β = λ·sin 30° = 0.15.\n\n{} sin β = 0.3·0.866 = 0.260.\n"
    assert not set(words_of(page.format(words))) & set(OPEN)


@pytest.mark.parametrize(
    "words", ["call it 14.4 kN", "rund 14.4 kN", "soit environ 14.4 kN", "約14.4 kN"]
)
def test_a_result_goes_on_with_the_fewer_digits_that_words_give_it(words):
    page = (
        f"m = 0.76 kg, r = 41 mm, w = 681 rad/s.\n\nF = m r w^2 = 14450 N, {words}.\n\nF/2 = {{}} kN.\n"
    )
    assert words_of(page.format("7.20"))[-1] not in OPEN
    assert words_of(page.format("7.02"))[-1] in OPEN


def test_spanish_pages_have_their_sine_and_their_and():
    page = (
        "La biela y la manivela de los cilindros: F₁ = F cos(θ + 30°) y F₂ = F cos(θ − 30°).\n\n"
        "Para la componente del lado, X = (F₂ − F₁) sen 30° = 2F sen² 30° sen θ = {} F sen θ.\n\n"
        "El intervalo es 360° + 60° = 420° y 360° − 60° = 300°.\n\n"
        "La potencia es P = 40 CV = 29,4 kW.\n"
    )
    assert not set(words_of(page.format("0,5"))) & set(OPEN)
    assert "refuted" in words_of(page.format("0,6"))
