"""A quotation proves nothing, a denied one binds nothing, a root has its unit, and a size is chosen."""

from __future__ import annotations

from pathlib import Path

import pytest

from symbalance.checking import check

FORCE = "  F = M*r*w^2*(P + (L/r)*Q)\n"
RIGHT = "  F = M*r*w^2*(P + (r/L)*Q)\n"
QUOTED = "> F = M*r*w^2*(P + (L/r)*Q)\n"


def words_of(folder: Path, text: str, ending: str) -> list[str]:
    """Return the verdicts on a page's relations."""
    path = folder / f"page{ending}"
    path.write_text(text, encoding="utf-8")
    return [link["verdict"] for link in check(path).data()["links"]]


QUOTES = [
    (f"The force is\n\n{FORCE}\nBrian wrote:\n{QUOTED}", ["definition"] * 2),
    ("Die Kraft ist\n\n  K = m a + b\n\nHans schrieb:\n> K = b + m a\n", ["definition"] * 2),
    ("La force vaut\n\n  P = q s\n\n> P = q s\n\nDonc 2 P = 2 q s.\n", ["definition"] * 2 + ["holds"]),
    ("We have\n\n  sin^2 x + cos^2 x = 1\n\n> sin^2 x + cos^2 x = 1\n", ["holds"] * 2),
    ("We have\n\n  K = m a\n\nSo K = m a.\n", ["definition", "holds"]),
    (
        f"The force is\n\n{FORCE}\nBrian wrote:\n{QUOTED}\nThat is upside down. It is\n\n{RIGHT}",
        ["definition"] * 3,
    ),
    (
        "Es ist\n\n  K = m a b\n\n> K = m a b\n\nDas ist falsch:\n\n  K = m a/b\n",
        ["definition", "condition", "definition"],
    ),
    ("On a\n\n  K = m a b\n\n> K = m a b\n\nC'est une erreur :\n\n  K = m a/b\n", ["definition"] * 3),
]


@pytest.mark.parametrize(("text", "expected"), QUOTES)
def test_what_only_quotes_an_unproved_formula_is_given(tmp_path, text, expected):
    assert words_of(tmp_path, text, ".txt") == expected


def test_an_answer_that_denies_nothing_is_bound_by_what_it_quotes(tmp_path):
    text = "We have\n\n  K = m a b\n\n> K = m a b\n\nIndeed, and thus\n\n  K = m a/b\n"
    assert words_of(tmp_path, text, ".txt")[-1] in ("refuted", "undecided")


ROOTS = [
    ("We require $d^3 = 15.28$, so $d = 2.48$ in.", True),
    ("We require $d^3 = 15.28$, so $d = 2.84$ in.", False),
    ("Erforderlich ist $d^3 = 254648$, also $d = 63{,}4$ mm.", True),
    ("Erforderlich ist $d^3 = 254648$, also $d = 36{,}4$ mm.", False),
    ("Il faut $D^2 = 40$, donc $D = 6.32$ mm.", True),
    ("Il faut $D^2 = 40$, donc $D = 3.62$ mm.", False),
    ("Se necesita $b^3 = 16\\cdot 18000/(6000\\pi) = 15.28$, luego $b = 2.48$ in.", True),
    ("Se necesita $b^3 = 16\\cdot 18000/(6000\\pi) = 15.28$, luego $b = 3.48$ in.", False),
    ("Serve $2x = 41$, quindi $x = 20.5$ cm.", True),
    ("Serve $2x = 41$, quindi $x = 21.5$ cm.", False),
]
BOUND = [
    "With $d < 0$ we require $d^2 = 40$, so $d = 6.32$ mm.",
    "With $u < 0$ and $|u| = 2$ we get $u = 2$.",
    "With $u < 0$ and $|u| = 2$ we get $u = 2$ mm.",
    "Mit $d = 50$ mm und $d^3 = 15.28$ ist $d = 2.48$ in.",
]
HOLDS = ("holds", "holds_to_order", "conditional")


@pytest.mark.parametrize(("text", "is_right"), ROOTS)
def test_a_root_has_its_unit_and_its_condition_the_numbers(tmp_path, text, is_right):
    words = words_of(tmp_path, f"{text}\n", ".md")
    assert (words[-1] in HOLDS) == is_right, words
    assert is_right or words[-1] in ("refuted", "contradiction"), words


@pytest.mark.parametrize("text", BOUND)
def test_a_root_that_something_else_forbids_does_not_hold(tmp_path, text):
    assert words_of(tmp_path, f"{text}\n", ".md")[-1] not in HOLDS


def test_a_root_goes_on_with_its_unit(tmp_path):
    text = "We require $d^3 = 254648$, so $d = 63.4$ mm. The area is $A = \\pi d^2/4 = {}$ mm².\n"
    assert words_of(tmp_path, text.replace("{}", "3157"), ".md")[-1] in HOLDS
    assert words_of(tmp_path, text.replace("{}", "3517"), ".md")[-1] == "refuted"


CHOICES = [
    ("It has to be $d = 63.4$ mm. Take $d = 65$ mm.", True),
    ("It has to be $d = 63.4$ mm. Take $d = 64.3$ mm.", False),
    ("It has to be $d = 63.4$ mm. Here $d = 65$ mm.", False),
    ("It has to be $d = 2.48$ in, and the next standard size, $d = 2.5$ in, would be adopted.", True),
    ("It has to be $d = 2.48$ in, and $d = 2.75$ in is chosen.", True),
    ("It has to be $d = 2.48$ in, and $d = 2.84$ in is found.", False),
    ("Nötig ist $D = 63.4$ mm; gewählt wird $D = 70$ mm.", True),
    ("Nötig ist $D = 63.4$ mm; man findet $D = 70$ mm.", False),
    ("Il faut $b = 17.2$ mm ; on prendra $b = 18$ mm.", True),
    ("Il faut $b = 17.2$ mm ; on trouve $b = 18$ mm.", False),
    ("Serve $b = 17.2$ mm; si adotta $b = 20$ mm.", True),
    ("Resulta $b = 17.2$ mm y se toma $b = 18$ mm.", True),
    ("必要な直径は$d = 17.2$ mmであり、$d = 20$ mmを採用する。", True),
]


@pytest.mark.parametrize(("text", "is_right"), CHOICES)
def test_a_size_is_chosen_in_the_place_of_the_one_that_was_found(tmp_path, text, is_right):
    words = words_of(tmp_path, f"{text}\n", ".md")
    assert ("refuted" not in words and "contradiction" not in words) == is_right, words


def test_a_mixed_number_with_its_unit_is_no_root_by_half_a_unit(tmp_path):
    path = tmp_path / "page.txt"
    path.write_text("Let J = 7.95 in.⁴ and J = πd⁴/32.\n\nThen d = 2½ in.\n", encoding="utf-8")
    assert check(path).data()["links"][-1]["verdict"] not in HOLDS
