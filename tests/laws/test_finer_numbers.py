"""A number with more digits than the one before it is the value of what stands further ahead."""

import pytest

from symbalance.notes.checking import check


def last_word(page: str) -> str:
    checked = check(page + "\n", {})
    return max(checked.verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(
    "page",
    [
        r"$λ = 45/150 = 0.3 = 0.34$",
        r"$x = 10/3 = 3.3 = 3.34$",
        r"$\sqrt{2} = 1.4 = 1.42$",
        r"$1{,}5^2 = 2{,}3 = 2{,}28$",
        r"$2/3 ≈ 0.7 = 72\,\%$",
        r"$F = 2218.41\,\mathrm{N} = 2.2\,\mathrm{kN} = 2240\,\mathrm{N}$",
        r"$A = \frac{π}{4} 0.08^2 = 0.0050\,\mathrm{m^2} = 50.4\,\mathrm{cm^2}$",
    ],
)
def test_digits_from_nowhere_are_refuted(page):
    assert last_word(page) == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        r"$λ = 45/150 = 0.3 = 0.30$",
        r"$x = 10/3 = 3.3 = 3.33$",
        r"$\sqrt2 = 1.4 = 1.41 = 1.414$",
        r"$2/3 ≈ 0.667 ≈ 0.67 ≈ 0.7 = 70\,\%$",
        r"$2/3 ≈ 0.7 = 67\,\%$",
        r"$F = 2218.41\,\mathrm{N} = 2.2\,\mathrm{kN} = 2200\,\mathrm{N}$",
        r"$φ = \arcsin 0.3 = 0.30 = 17.2°$",
        r"$G = 2.5\cdot 9.81 = 24.5 = 24.53$",
        r"$m = 0.5$ kg, $r = 0.04$ m, $ω = 314.159$ 1/s"
        "\n\n" + r"$F = m r ω^2 = 0.5\cdot 0.04\cdot 314^2 = 1.97$ kN $= 1974$ N",
        "$x = 10/3 = 3.3$\n\n$x = 3.33$",
        "$x = 10/3 = 3.3$\n\n$x = 3.3$",
    ],
)
def test_digits_of_the_exact_value_hold(page):
    assert last_word(page) in ("holds", "holds_to_order")


@pytest.mark.parametrize("page", ["$x = 10/3 = 3.3$\n\n$x = 3.35$", "$F = 2218.4 = 2200$\n\n$F = 2240$"])
def test_the_same_letter_further_down_has_no_other_digits(page):
    assert last_word(page) not in ("holds", "holds_to_order")


@pytest.mark.parametrize(
    ("page", "words"),
    [
        ("For $x = 0.5$ $$\\frac{1}{2} = x = 0.51$$", ("undecided",)),
        ("Let $x = 2.5$ exactly. $$x = 2.54$$", ("premise",)),
        ("The radius is $r = 40.5$ mm. So $r = 0.04054$ m.", ("premise",)),
        ("The radius is $r = 40.5$ mm. So $r = 0.0405$ m.", ("holds",)),
        ("Let $x = 2.5$. Then $$x = 2.50$$", ("conditional", "premise")),
        ("$$x = \\pi = 3.14$$\n\n$$x = 3.1400$$", ("refuted",)),
        ("$$x = \\pi = 3.14$$\n\n$$x = 3.1416$$", ("holds_to_order",)),
    ],
)
def test_no_line_gives_a_datum_more_digits(page, words):
    assert last_word(page) in words


CRANK = {
    "lambda": "crank ratio r/l",
    "theta": "crank angle",
    "a": "piston acceleration",
    "omega": "angular speed",
    "r": "crank radius",
    "s": "stroke",
}


@pytest.mark.parametrize(
    ("page", "word"),
    [
        (r"$r = 40$ mm. $$s = 2r = 81\,\mathrm{mm}$$", "refuted"),
        (r"$r = 40$ mm. $$s = 2r = 80\,\mathrm{mm}$$", "holds"),
        (r"$r = 40.2$ mm. $$s = 2r = 80\,\mathrm{mm}$$", "holds_to_order"),
        (r"With $λ = 0.3$, $$a = r\omega^2(\cos\theta + 0.26\cos2\theta)$$", "undecided"),
        (r"With $λ = 0.3$, $$a = r\omega^2(\cos\theta + 0.3\cos2\theta)$$", "holds_to_order"),
        (r"With $λ = 0.286$, $$a = r\omega^2(\cos\theta + 0.29\cos2\theta)$$", "holds_to_order"),
    ],
)
def test_a_number_behind_an_equals_sign_has_its_digits(page, word):
    checked = check(page + "\n", CRANK)
    assert max(checked.verdicts, key=lambda v: (v.line, v.span)).verdict == word
