"""Sentences that give a letter its value, in many ways: what is computed from it is judged."""

from itertools import product

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
SAYINGS = {
    "en": (
        "The {noun} {letter} is {value}.",
        "With a {noun} {letter} of {value} we go on.",
        "Let the {noun} {letter} be {value}.",
        "The {noun} {letter} ({value}) is known.",
        "The {noun} {letter} amounts to {value}.",
        "The {noun} {letter} is equal to {value}.",
        "The {noun}, {letter}, is {value}.",
        "{letter} is the {noun}, {value}.",
        "The {noun} is {value} ({letter}).",
        "The {noun} is {value}, which we call {letter}.",
        "We call the {noun} {letter}; it is {value}.",
        "- {noun} {letter}: {value}\n\n",
        "| quantity | letter | value |\n|---|---|---|\n| {noun} | {letter} | {value} |\n\n",
    ),
    "de": (
        "Hier ist der Wert von {noun} {letter} gegeben: {noun} {letter} beträgt {value}.",
        "{noun} {letter} ist gleich {value}.",
        "- {noun} {letter}: {value}\n\n",
    ),
    "ja": (
        "{noun} {letter} は {value} である。",
        "{noun} {letter} を {value} とする。",
        "{noun} {letter}（{value}）を用いる。",
    ),
    "fr": ("Le {noun} {letter} vaut {value}.", "Le {noun} {letter} est égal à {value}."),
}
NOUNS = {
    "en": ("crank radius", "bank angle", "rod ratio"),
    "de": ("Kurbelradius", "Bankwinkel", "Stangenverhältnis"),
    "ja": ("クランク半径", "バンク角", "連桿比"),
    "fr": ("rayon de manivelle", "angle de calage", "rapport"),
}
QUANTITIES = (
    (r"$r$", "r", ("40 mm", "4 cm"), r"2r = 80\text{ mm}", r"2r = 120\text{ mm}"),
    (r"$\beta$", "β", ("60°", "$60^\\circ$", "60 deg"), r"\cos\beta = \frac12", r"\cos\beta = \frac13"),
    (r"$\lambda$", "λ", ("1/4", "0.25"), r"\lambda^2 = \frac1{16}", r"\lambda^2 = \frac12"),
)
CASES = [
    (saying.format(noun=noun, letter=letter, value=value), right, wrong)
    for language, sayings in SAYINGS.items()
    for saying in sayings
    for noun, (marked, plain, values, right, wrong) in zip(NOUNS[language], QUANTITIES, strict=True)
    for letter, value in product((marked, plain), values)
]


def last(page: str) -> str:
    return check(page + "\n", fixes=False).data()["links"][-1]["verdict"]


@pytest.mark.spread(40)
@pytest.mark.parametrize(("said", "right", "wrong"), CASES)
def test_what_is_computed_from_a_value_in_words_is_judged(said, right, wrong):
    assert last(f"{said} Then ${right}$.") in PROVED
    assert last(f"{said} Then ${wrong}$.") in ("refuted", "contradiction")


@pytest.mark.parametrize(
    "said",
    [
        "The mass $m$ is 5 pounds.",
        "The temperature $m$ is 5 °C.",
        "The engine has a shaft $m$ of 5 throws.",
        "The ratio of the masses $m$ is 5.",
        "For one of them $m$ is 5 kg.",
    ],
)
def test_what_is_counted_in_no_unit_that_is_read_gives_no_value(said):
    assert last(f"{said} Then $2m = 10$.") not in PROVED


@pytest.mark.parametrize(
    ("page", "verdict"),
    [
        (
            r"The speed is largest where $\cos\theta = 0$. At top dead centre $\cos\theta = 1$.",
            "condition",
        ),
        (r"θ is the crank angle. At bottom dead centre $\cos\theta = 1$.", "undecided"),
        (r"θ is the crank angle. At bottom dead centre $\cos\theta = -1$.", "condition"),
        (r"With $\beta = 60°$ we go on." "\n\n" r"Hence $\cos\beta = \frac12$.", "conditional"),
        (r"With $\beta = 60°$ we go on." "\n\n" r"Hence $\cos\beta = \frac13$.", "undecided"),
        (r"θ is the crank angle. At 30° after TDC, $\cos\theta = \frac12$.", "undecided"),
    ],
)
def test_a_condition_on_an_angle_is_tried_where_its_sentence_says_it_is(page, verdict):
    assert last(page) == verdict
