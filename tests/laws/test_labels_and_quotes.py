"""Labels part the numbers of one letter, an answer is not bound by what it quotes, 5.70" is in inches."""

from __future__ import annotations

import pytest

from symbalance.checking import check as check_page
from symbalance.notes.checking import check

RODS = "The ratio lam of the crank radius to the rod:\n\n    short rod:  lam = 1.74/5.70 = 0.305\n"
ANGLES = "The largest angle of the rod is b = 17.8 deg for the 5.70"
QUOTED = (
    '> everybody tells me that it "takes the load off". In the usual formula\n'
    "> lambda = 1/1.64 ~= 0.61, which is huge.\n\nLet me do it from scratch.\n\n"
)
MAIL = 'He says it "takes the load off", and the other "rods are 5". '

CASES = [
    (RODS + "    long rod:   lam = 1.74/6.00 = 0.290", True),
    (RODS + "    long rod:   lam = 1.74/6.00 = 0.209", False),
    (RODS + "    short rod:  lam = 1.74/6.00 = 0.290", False),
    (RODS + "    in numbers: lam = 1.74/6.00 = 0.290", False),
    ('    5.70":  a_TDC ≈ 23750 · 1.305 ≈ 31000\n    6.00":  a_TDC ≈ 23750 · 1.290 ≈ 30600', True),
    ("langes Pleuel:  λ = 40/160 = 0,25\nkurzes Pleuel:  λ = 40/125 = 0,32", True),
    ("langes Pleuel:  λ = 40/160 = 0,25\nkurzes Pleuel:  λ = 40/125 = 0,23", False),
    (ANGLES + " and b = 16.9 deg for the 6.00, so a bit less.", True),
    (ANGLES + " and b = 16.9 deg for the 5.70, so a bit less.", False),
    (QUOTED + "    lam = r/l\n    x = r cos th + l - (r lam/2) sin^2 th", True),
    (QUOTED + "    lam = r/l\n    r lam^2 = r^3/l^2", True),
    (QUOTED + "    lam = r/l\n    lam = 1.74/6.00 = 0.209", False),
    (MAIL + 'The stroke is s = 3.48", i.e. s ~= 88.4 mm.', True),
    (MAIL + 'The stroke is s = 3.48", i.e. s ~= 84.8 mm.', False),
    ("They sell it as “new”, and the stroke is s = 3.48″ ≈ 88.4 mm.", True),
    ('The sticker says "stroke 5" and s = 5 = 5.0 holds.', True),
]


@pytest.mark.parametrize(("text", "is_right"), CASES)
def test_what_two_hands_or_two_labels_say_is_no_contradiction(tmp_path, text, is_right):
    path = tmp_path / "page.txt"
    path.write_text(f"{text}\n", encoding="utf-8")
    words = [v.verdict for v in check(path, fixes=False).verdicts]
    assert ("refuted" not in words and "contradiction" not in words) == is_right, words


AROUND = [
    (".txt", "              F = (W/g)*r*cos theta   lb.            (1)", ["definition"]),
    (".txt", "              F = (W/g)*r*sin theta,                 (2)", ["definition"]),
    (".txt", "     r*sin 2 theta = 2*r*sin theta*cos theta,        (3)", ["holds"]),
    (".txt", "     r*sin 2 theta = r*sin theta*cos theta   in.     (3)", ["refuted"]),
    (
        ".txt",
        "order     n (rpm)\n3         60*261/3   = 5220\n4.5       60*261/4.5 = 3480",
        ["holds"] * 2,
    ),
    (
        ".txt",
        "order     n (rpm)\n3         60*261/3   = 5220\n4.5       60*261/4.5 = 3840",
        ["holds", "refuted"],
    ),
    (".md", "## c) δ = 270°", ["definition"]),
    (".md", "**a) r = 40 mm, l = 150 mm**", ["definition", "definition"]),
    (".md", "a) r = 40 mm\n\nb) 2r = 80 mm\n\n(c) 2r = 90 mm", ["definition", "holds", "refuted"]),
    (".md", "- (i) r = 40 mm\n- (ii) r/2 = 20 mm", ["definition", "holds"]),
    (".tex", r"\[ \sin^2 x = \tfrac12(1-\cos 2x): \]", ["holds"]),
    (".tex", r"\[ \sin^2 x = \tfrac12(1+\cos 2x): \]", ["refuted"]),
    (".tex", r"\[ 1 + q = \frac{q^2-1}{q-1} \qquad (q \text{ not equal to one}). \]", ["holds"]),
    (".tex", r"\[ 1 + q = \frac{q^2+1}{q-1} \qquad (q \text{ not equal to one}). \]", ["refuted"]),
]


@pytest.mark.parametrize(("ending", "text", "expected"), AROUND)
def test_labels_units_numbers_and_words_around_a_formula_are_no_part_of_it(
    tmp_path, ending, text, expected
):
    path = tmp_path / f"page{ending}"
    path.write_text(f"{text}\n", encoding="utf-8")
    assert [link["verdict"] for link in check_page(path).data()["links"]] == expected


NAMED = "With the mass m, the crank radius r and an arm b :\n\n    F = mrω²\n    M = Fb\n"
PRODUCTS = [
    (NAMED + "    2M = 2bmrω²", "holds"),
    (NAMED + "    2M = bmrω²", "refuted"),
    ("Energie E = ½Jω², Trägheitsmoment J = ½mR²\n\n    E = ¼mR²ω²", "holds"),
    ("Energie E = ½Jω², Trägheitsmoment J = ½mR²\n\n    E = ½mR²ω²", "refuted"),
    ("Torsion: T = τπd³/16.\n\n    2T = πd³τ/8", "holds"),
    ("圧力 p、面積 A、力 F = pA。\n\n    2F = 2pA", "holds"),
    ("圧力 p、面積 A、力 F = pA。\n\n    2F = pA", "refuted"),
]


@pytest.mark.parametrize(("text", "expected"), PRODUCTS)
def test_letters_side_by_side_that_the_page_names_or_no_word_goes_on_with_are_a_product(
    tmp_path, text, expected
):
    path = tmp_path / "page.txt"
    path.write_text(f"{text}\n", encoding="utf-8")
    assert check_page(path).data()["links"][-1]["verdict"] == expected
