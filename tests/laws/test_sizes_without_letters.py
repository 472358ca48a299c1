"""Results by sizes that a page gives in words and without a letter: a bore of 86 mm, and V = π D² s/4."""

import pytest

from symbalance.checking import check

WRONG = ("refuted", "contradiction")
PROVED = ("holds", "conditional", "holds_to_order")
ENGINE = "The engine has a bore of 86 mm and a stroke of 80 mm, and it runs at 5000 rpm."
PAGES = {
    "swept volume": (ENGINE, r"The swept volume is $V = \frac{\pi}{4}D^2 s = {}$ cm³.", "465", "645"),
    "piston speed": (ENGINE, r"The mean piston speed is $v_m = 2 s n = {}$ m/s.", "13.3", "6.67"),
    "per minute": (ENGINE, r"The mean piston speed is $v_m = 2 s n/60 = {}$ m/s.", "13.3", "1.33"),
    "noun behind": (
        "Der Einzylinder hat 90 mm Bohrung und 72 mm Hub und dreht mit 6000 1/min.",
        r"Der Hubraum ist $V_h = \frac{\pi}{4}d^2 h = {}$ cm³.",
        "458",
        "485",
    ),
    "pair": (
        "Bore and stroke 76 x 71 mm, 6500 rpm.",
        r"The swept volume is $V = \pi D^2 s/4 = {}$ cm³.",
        "322",
        "232",
    ),
    "French": (
        "Le moteur a un alésage de 81 mm et une course de 95 mm ; il tourne à 4500 tr/min.",
        r"La vitesse moyenne du piston est $v_m = 2 s n = {}$ m/s.",
        "14.25",
        "1.425",
    ),
    "Japanese": (
        "ボア 86 mm、ストローク 86 mm の4気筒エンジンが 6000 rpm で回る。",
        r"行程容積は $V = \frac{\pi}{4}D^2 s = {}$ cm³、である。",
        "500",
        "50.0",
    ),
    "a product of two letters": (
        "The product is $m r = 0.45\\cdot 46 = 20.7$ kg mm and the throws are $a = 100$ mm apart.",
        r"The couple is $U = 3 m r a = {}\cdot 10^{-3}$ kg m².",
        "6.21",
        "7.21",
    ),
}


def last_word(page: str) -> str:
    return check(page + "\n").data()["links"][-1]["verdict"]


@pytest.mark.parametrize("kind", PAGES)
def test_a_result_is_computed_with_the_sizes_in_words(kind):
    given, result, right, wrong = PAGES[kind]
    assert last_word(f"{given}\n\n{result.replace('{}', right)}") in PROVED
    assert last_word(f"{given}\n\n{result.replace('{}', wrong)}") == "refuted"


@pytest.mark.parametrize(("number", "is_wrong"), [("524", False), ("542", True), ("52.4", True)])
def test_an_angular_speed_is_that_of_the_revolutions_in_words(number, is_wrong):
    word = last_word(f"{ENGINE}\n\nIts angular speed is $\\omega = {number}$ rad/s.")
    assert (word == "refuted") == is_wrong


@pytest.mark.parametrize(
    "page",
    [
        ENGINE + "\n\nThe section of the gudgeon pin is $A = \\frac{\\pi}{4}d^2 = 3.80$ cm².",
        ENGINE + "\n\n# The compressor\n\nIt displaces $V = \\frac{\\pi}{4}D^2 s = 120$ cm³.",
        ENGINE + "\n\nThe shafts of its balancer turn at $\\omega = 1047$ 1/s.",
        ENGINE + " The older one had a stroke of 90 mm.\n\nThen $v_m = 2 s n = 15$ m/s.",
        PAGES["a product of two letters"][0] + "\n\n# Another\n\nIt has $U = 3 m r a = 9.3$ kg mm m.",
    ],
)
def test_what_may_be_of_something_else_is_not_refuted(page):
    assert last_word(page) != "refuted"


PRODUCT = "The counterweight has to satisfy $m_c r_c = (0.85 + 0.21)\\cdot 0.045 = 0.0477$ kg m.\n\n"


@pytest.mark.parametrize(
    "sentence",
    [
        "With $r_c = 85$ mm, $m_c = {}$ kg.",
        "Avec $r_c = 85$ mm, $m_c = {}$ kg.",
        "Mit $r_c = 85$ mm wird $m_c = {}$ kg.",
    ],
)
def test_the_other_letter_of_a_product_is_a_result(sentence):
    assert last_word(PRODUCT + sentence.format("0.561")) in PROVED
    assert last_word(PRODUCT + sentence.format("0.651")) in WRONG


@pytest.mark.parametrize(
    "sentence",
    [
        "The one in the shop: $m_c = 0.5$ kg, $r_c = 80$ mm.",
        "For $m_c = 0.4$ kg, $r_c = 80$ mm it is too small.",
        "With $m_c = 0.6$ kg and $r_c = 80$ mm it is too large.",
    ],
)
def test_both_letters_of_a_product_may_be_data(sentence):
    assert last_word(PRODUCT + sentence) not in WRONG
