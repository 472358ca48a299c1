r"""What a page itself calls wrong is no definition and no claim, unless it is right."""

import pytest

from symbalance.checking import check

PROVED = {"holds", "conditional", "holds_to_order"}
CALLED_WRONG = [
    "The relation {} is wrong.",
    "It is false that {}.",
    "It is not true that {}.",
    "Note that {} is a common mistake.",
    "{}, which is wrong.",
    "One might think that {}, but it is not so.",
    "{} does not hold.",
    "Es ist falsch, dass {}.",
    "{} gilt nicht.",
    "{} ist ein Druckfehler.",
    "Il est faux que {}.",
    "{} est faux.",
    "È falso che {}.",
    "{} は誤りである。",
    "{} ではない。",
]


@pytest.mark.parametrize("words", CALLED_WRONG)
def test_a_right_relation_that_is_called_wrong_is_refuted(words):
    last = check(words.format("$\\cos 2\\theta = 1 - 2\\sin^2\\theta$")).verdicts[-1]
    assert (last.verdict, last.reason) == ("refuted", "it is said to be wrong, and it holds")


@pytest.mark.parametrize("words", CALLED_WRONG)
def test_a_wrong_one_is_neither_accused_nor_believed(words):
    last = check(words.format("$\\cos 2\\theta = 1 - \\sin^2\\theta$")).verdicts[-1]
    assert (last.verdict, last.reason) == ("condition", "said to be wrong")


@pytest.mark.parametrize(
    "words",
    [
        "The textbook's {} is wrong; the right formula is {}.",
        "The old formula {} must be replaced by {}.",
        "One might think that {}, but in fact {}.",
        "{} is a misprint for {}.",
        "Instead of {} we use {}.",
        "Statt {} gilt {}.",
        "{} ist durch {} zu ersetzen.",
        "Au lieu de {} on prend {}.",
        "I first wrote {}, in fact it is {}.",
    ],
)
def test_what_takes_its_place_counts(words):
    page = words.format("$v = s n$", "$v = 2 s n$")
    page += "\n\nWith $s = 0.08$ m and $n = 50$ 1/s it is $v = {}$ m/s."
    right, wrong = (check(page.replace("{}", number)).verdicts for number in ("8", "4"))
    assert "refuted" not in {verdict.verdict for verdict in right}
    assert right[-1].verdict in PROVED
    assert wrong[-1].verdict == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        "$v = 2 s n$ is right.",
        "$v = 2 s n$; the number is wrong by 2 %.",
        "$v = 2 s n$ is not wrong.",
        "That is not wrong: $v = 2 s n$.",
        "$v = 2 s n$ holds.",
        "$v = 2 s n$ is an error of 2 %.",
        "$v = 2 s n$ ist ein Fehler von 2 %.",
        "$v = 2 s n$ ist durch Versuche bestätigt.",
        "$v = 2 s n$ ist durch den Hub bestimmt.",
        "$v = 2sn$. Wrong is what the book says.",
    ],
)
def test_other_words_leave_a_relation_alone(page):
    assert all(verdict.reason != "said to be wrong" for verdict in check(page).verdicts)


def test_of_numbers_alone_something_else_is_wrong():
    last = check("Adding the amplitudes would be wrong: $3 + 4 = 7$ N is wrong, as they are at 90°.")
    assert last.verdicts[-1].verdict == "holds"


def test_what_is_compared_is_claimed():
    page = "The force is $F = 888$ N instead of\n$P = 3 \\cdot 4 = 13$ N for the bare crank."
    assert check(page).verdicts[-1].verdict == "refuted"
    page = "The path is $x = 8$ mm instead of $y = 9$ mm. Now $y/3 = 3$ mm."
    assert check(page).verdicts[-1].verdict in PROVED
