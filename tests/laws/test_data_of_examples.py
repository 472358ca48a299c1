"""A number in a list of data is no contradiction of an equation above; one that is claimed still is."""

import pytest

from symbalance.checking import check

ABOVE = "We have $c + d = 3$ and $c - d = 1$.\n\n"


def last_word(page: str) -> str:
    return check(page).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(
    "data",
    [
        "With $r = 40$ mm, $l = 150$ mm, $c = 5$",
        "For $n = 50$ and $c = 5$",
        "Beispiel: $r = 40$ mm, $l = 150$ mm, $c = 5$",
    ],
)
def test_a_datum_is_open(data):
    assert last_word(ABOVE + data) == "undecided"


@pytest.mark.parametrize("claim", ["So $c = 5$.", "Hence $c = 5$.", "$c = 5$"])
def test_a_claim_is_not(claim):
    assert last_word(ABOVE + claim) in ("refuted", "contradiction")


@pytest.mark.parametrize(
    "words",
    ["It is exact if and only if", "It is exact only if", "Es ist genau dann exakt, wenn"],
)
def test_what_something_takes_binds_no_line_below(words):
    page = f"Let $J = m k^2$. {words} $k^2 = a b$.\n\nA bar has $a = b = l/2$ and $J = m l^2/12$."
    found = [link["verdict"] for link in check(page).data()["links"]]
    assert found[1] == "condition"
    assert found[-1] not in ("refuted", "contradiction")


RATIO = "The ratio is $n = l/r = 3.494$ with $l = 138$ mm and $r = 39.5$ mm.\n\n"


def test_a_number_that_the_words_give_is_another_case():
    links = check(RATIO + "With a 150 mm rod $n = 150/39.5 = 3.797$.").data()["links"]
    assert [link["verdict"] for link in links[-2:]] == ["premise", "holds_to_order"]
    assert last_word(RATIO + "It is said that $n = 160/39.5$.") == "refuted"


def test_a_number_printed_for_a_formula_stands_for_it():
    page = (
        "$m = 0.45$ kg, $r = 40$ mm, $q = 0.3125$, $\\omega = 2\\pi\\cdot 4800/60 = 502.7$ rad/s.\n\n"
        "$m r\\omega^2 = 0.45\\cdot0.04\\cdot502.7^2 = 4549$ N.\n\n"
    )
    assert last_word(page + "$4 q m r\\omega^2 = 4(0.3125)(4549)$") in ("holds", "holds_to_order")
    assert last_word(page + "$4 q m r\\omega^2 = 4(0.3215)(4549)$") == "refuted"


@pytest.mark.parametrize("claim", ["n = 39.5/150", "n = 150/40.5", "n = 2\\cdot150/39.5"])
def test_such_a_number_makes_no_other_formula_right(claim):
    assert last_word(RATIO + f"With a 150 mm rod ${claim}$.") in ("refuted", "undecided")


def test_a_result_behind_the_data_is_claimed():
    above = "We have $m_1 = m b/l$.\n\n"
    data = "With $m = 0.6$ kg, $l = 150$ mm and $b = 45$ mm "
    assert last_word(above + data + "is $m_1 = 0.28$ kg.") in ("refuted", "contradiction")
    assert last_word(above + data + "and $m_1 = 0.28$ kg.") in ("refuted", "contradiction")
    assert last_word(above + data + "is $m_1 = 0.18$ kg.") in ("holds", "holds_to_order", "conditional")


def test_words_name_nothing_of_another_thing_behind_and():
    page = "$R = 0.04$ m. Put in the inertia force and the largest term is $T_2 = -m R^2\\omega^2$."
    assert last_word(page) != "refuted"


FIRST = "m = 0.50 kg, r = 40 mm, l = 140 mm\n\nlambda = 40/140 = 0.286\n\n"


@pytest.mark.parametrize(
    "data",
    [
        "m = 0.52 kg, r = 41 mm, l = 144 mm",
        "Second example: m = 0.52 kg, r = 41 mm and l = 144 mm.",
        "Zweites Beispiel: m = 0,52 kg, r = 41 mm und l = 144 mm.",
        "Autre moteur : m = 0,52 kg, r = 41 mm, l = 144 mm.",
        "次の例: m = 0.52 kg、r = 41 mm、l = 144 mm",
        "For the touring model we have\nm = 0.52 kg,\nr = 41 mm,\nl = 144 mm.",
    ],
)
def test_a_list_of_data_begins_another_case(data):
    second = FIRST + data + "\n\nlambda = {} = {}\n\nm*r = {}*0.041\n"
    found = [link["verdict"] for link in check(second.format("41/144", 0.285, 0.52)).data()["links"]]
    assert found[5:8] == ["premise"] * 3
    assert not {*found} & {"refuted", "contradiction", "undecided"}
    assert last_word(second.format("41/144", 0.285, "0.50")) == "refuted"
    wrong = [link["verdict"] for link in check(second.format("41/144", 0.258, 0.52)).data()["links"]]
    assert wrong[9] == "refuted"


def test_a_list_that_gives_a_result_leaves_what_it_rests_on_to_the_case_before():
    page = (
        "F = m r ω², λ = r/l\n\nm = 0.50 kg, r = 40 mm, l = 140 mm, ω = 314.2 rad/s, a = 100 mm\n\n"
        "    F = 0.50×0.040×314.2² = 1974 N\n    λ F = 40/140×1974 = 564 N\n\n"
        "{}F = 2400 N, λ = 0.25, a = 106 mm\n\n    F a = 2400×0.106 = 254.4 N·m\n    λ F = {} N\n"
    )
    for words in ("", "Example 2: ", "例: "):
        found = [link["verdict"] for link in check(page.format(words, 600)).data()["links"]]
        assert not {*found} & {"refuted", "contradiction", "undecided"}
        assert last_word(page.format(words, 564)) == "refuted"
    found = [link["verdict"] for link in check(page.format("So ", 600)).data()["links"]]
    assert {*found} & {"refuted", "contradiction", "undecided"}


@pytest.mark.parametrize("words", ["Check: ", "So ", "Hence ", "Probe: ", "結果: "])
def test_numbers_that_are_called_results_are_no_data(words):
    found = [link["verdict"] for link in check(FIRST + words + "m = 0.52 kg, r = 41 mm").data()["links"]]
    assert {*found} & {"refuted", "contradiction", "undecided"}


def test_a_list_says_what_does_not_change_once_more():
    page = FIRST + "m = 0.52 kg, r = {}, l = 144 mm\n"
    found = [link["verdict"] for link in check(page.format("0.040 m")).data()["links"]]
    assert not {*found} & {"refuted", "contradiction", "undecided"}


@pytest.mark.parametrize(
    "data", ["m = 0.50 kg, r = 41 mm, l = 140 mm", "m = 0.50 kg, r = 40 mm, l = 141 mm"]
)
def test_one_number_of_a_list_that_is_nearly_as_before_is_open(data):
    found = [link["verdict"] for link in check(FIRST + "Again: " + data).data()["links"]]
    assert sorted(set(found[5:]) - {"premise"}) == ["holds", "undecided"]
    assert found[5:].count("undecided") == 1
    alone = [link["verdict"] for link in check(FIRST + "Also ist r = 41 mm.").data()["links"]]
    assert alone[-1] == "refuted"
