"""Values that sentences give to letters: the mass $m$ is 0.5 kg."""

import pytest

from symbalance.checking import check

CLAIM = "$m r = 0{,}0225$ kg m"
WRONG = "$m r = 0{,}0325$ kg m"


def word(page: str) -> str:
    return check(page).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(
    "given",
    [
        "The crank radius $r$ is 45 mm and the mass $m$ is 0.5 kg.",
        "A crank radius $r$ of 45 mm and a mass $m$ of $0.5$ kg.",
        "The crank radius $r$ (45 mm) and the mass $m$ (0.5 kg).",
        "The crank radius $r$ 45 mm and the mass $m$ $0.5$~kg.",
        "Der Kurbelradius $r$ ist 45 mm, die Masse $m$ beträgt 0,5 kg.",
        "Le rayon $r$ vaut 45 mm et la masse $m$ est de 0,5 kg.",
        "クランク半径$r$は45 mm、質量$m$は0.5 kgとする。",
    ],
)
def test_a_value_in_a_sentence_is_put_in(given):
    assert word(f"{given}\n\n{CLAIM}") not in ("refuted", "premise")
    assert word(f"{given}\n\n{WRONG}") == "refuted"


@pytest.mark.parametrize(
    "given",
    [
        "The crank radius $r$ is 45 mm. The largest mass $m$ is 0.5 kg.",
        "The crank radius $r$ is 45 mm and the mass $m$ is 0.5 kg more than before.",
        "The crank radius $r$ is 45 mm. The mass $m$ is 0.5 kg here, and $m$ is 0.6 kg there.",
        "The crank radius $r$ is 45 mm. If the mass $m$ is 0.5 kg, it is light.",
    ],
)
def test_what_a_letter_may_be_otherwise_is_not_put_in(given):
    assert word(f"{given}\n\n{WRONG}") != "refuted"


def test_a_letter_in_plain_text_takes_the_value_of_its_sentence():
    page = "The crank radius r is 45 mm and the mass m is 0.5 kg.\n\nm r = 0.0325 kg m\n"
    assert word(page) == "refuted"


def test_a_name_behind_the_noun_of_a_french_text_is_one_letter():
    page = "La masse ma vaut 0.5 kg, R = 45 mm et w = 100 rad/s.\nF1 = ma R w² = 225 N\n"
    assert word(page) in ("holds", "holds_to_order", "conditional")
    assert word(page.replace("225", "325")) == "refuted"


@pytest.mark.parametrize(
    "said",
    [
        "The stroke $C$ is $2R = 80$ mm, with $R = 40$ mm.",
        "La course $C$ vaut $2R = 80$ mm, avec $R = 40$ mm.",
        "Der Hub $C$ beträgt $2R = 80$ mm mit $R = 40$ mm.",
    ],
)
def test_a_letter_said_to_be_a_formula_has_what_that_comes_to(said):
    area = "Mit $A = 50$ cm²."
    assert word(f"{said} {area}\n\n$A C = 400$ cm³") in ("holds", "holds_to_order", "conditional")
    assert word(f"{said} {area}\n\n$A C = 410$ cm³") == "refuted"


@pytest.mark.parametrize("said", ["The stroke $C$ is $2R$.", "The stroke C is 2R.", r"$C$ is $2\pi$."])
def test_a_factor_of_a_formula_is_no_value(said):
    assert word(f"{said}\n\n$3 C = 6$") not in ("holds", "holds_to_order", "conditional")
