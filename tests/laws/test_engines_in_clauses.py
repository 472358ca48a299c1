"""What a clause with an engine's name says of a first formula, and what its words are no measure of."""

import pytest

from symbalance.checking import check


def last(page: str) -> str:
    return check(page + "\n").data()["links"][-1]["verdict"]


def test_a_letter_before_japanese_words_is_no_article() -> None:
    sizes = "往復質量 m(1気筒)、クランク半径 r、角速度 ω、隣り合う気筒の間隔 a。\n\n"
    assert last(sizes + "直列3気筒の1次偶力の振幅は M1 = √3 m r ω² a である。") == "conditional"
    assert last(sizes + "直列3気筒の1次偶力の振幅は M1 = 2 m r ω² a である。") == "refuted"


def test_the_distance_of_ignitions_is_an_angle() -> None:
    page = "Der Zündabstand des Viertakt-Reihenvierzylinders beträgt Δφ = {}°."
    assert last(page.format(180)) == "conditional"
    assert last(page.format(90)) == "refuted"


@pytest.mark.parametrize("index", ["1", "I"])
def test_a_force_that_is_zero_is_refuted_whatever_its_angle(index: str) -> None:
    page = "Beim Reihenvierzylinder ist die freie Massenkraft erster Ordnung F_{} = 4 m r ω² cos φ."
    assert last(page.format(index)) == "refuted"


@pytest.mark.parametrize(
    "engine",
    ["The inline four has the", "In the inline six the", "A 60° V-twin shows the", "The flat-plane V8's"],
)
def test_a_formula_of_one_cylinder_is_not_shown_of_a_whole_engine(engine: str) -> None:
    formula = "second-order force {} F_2 = λ m r ω² cos 2θ, with λ = r/l."
    assert check(f"{engine} {formula.format('')}\n").data()["links"][0]["verdict"] != "conditional"
    alone = check(f"{engine} {formula.format('per cylinder')}\n").data()["links"][0]
    assert alone["verdict"] == "conditional"


@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        ("直列6気筒では2次の慣性力は打ち消し合う。F2 = 0", "conditional"),
        ("直列4気筒では2次の慣性力が打ち消し合う。F2 = 0", "refuted"),
        ("直列4気筒では1次の慣性力が打ち消し合う。すなわち F1 = 0", "conditional"),
        ("In the inline four the second-order forces cancel. $F_2 = 0$.", "refuted"),
        ("In the inline four the first-order forces cancel. $F_1 = 0$.", "conditional"),
    ],
)
def test_a_formula_that_is_a_sentence_of_its_own_is_of_the_one_before(words, verdict):
    assert last(words) == verdict
