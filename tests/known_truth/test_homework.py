"""Students' answers to an exercise on balancing: right ones are not accused, slips are named."""

from __future__ import annotations

import pytest

from symbalance.checking import check
from symbalance.notes.checking.declared.engines import NoEngines
from symbalance.notes.checking.declared.proposals import propose

BAD = {"refuted", "contradiction", "undecided", "unreadable"}

RIGHT = {
    "m is the page's mass, not a metre": r"""
Let $r = 45$ mm be the crank radius, $m = 0.7$ kg. The counterweight at $r_c = 60$ mm is
$$m_c = \frac{(1.2 + 0.5\,m)\,r}{r_c} = \frac{(1.2+0.35)\cdot45}{60} = 1.1625\ \mathrm{kg}$$
""",
    "velocity and acceleration are named together": r"""
Kolbengeschwindigkeit und Kolbenbeschleunigung:
$$v \approx r\omega\left(\sin\varphi+\frac{\lambda}{2}\sin2\varphi\right)$$
""",
    "an angular acceleration is no acceleration": r"""
The shaft has $J = 0.2$ kg m² and $M = 50$ N m. Die Winkelbeschleunigung ist
$$\beta = \frac{M}{J}$$
""",
    "a letter is another size in another exercise": """
6. couple of the three
   M = √3 · 3109 N · 0.09 m = 484.6 N m
   ω = 2π · 3000/60 = 314.2 rad/s
10. mean torque of the engine
   M = P/ω = 40000/314.2 = 127.3 N m
""",
    "a rounded result is put in": """
r ω^2 = 0.045·314.16^2 = 4441 m/s^2
a_max = 4441·1.3 = 5774 m/s^2
""",
}
WRONG = {
    "a mass in a sum, and its value": r"""
Let $r = 45$ mm be the crank radius, $m = 0.7$ kg. The counterweight at $r_c = 60$ mm is
$$m_c = \frac{(1.2 + 0.5\,m)\,r}{r_c} = \frac{(1.2+0.35)\cdot45}{60} = 1.2625\ \mathrm{kg}$$
""",
    "metres in a sum": r"$m = 0.7$ kg, $a = (0.3\,m + 0.5\,m) = 0.9\ \mathrm{m}$",
    "the torque of another exercise": """
6. couple of the three
   M = √3 · 3109 N · 0.09 m = 484.6 N m
10. mean torque of the engine
   M = P/ω = 40000/314.2 = 172.3 N m
""",
    "a rounded result is put in": """
r ω^2 = 0.045·314.16^2 = 4441 m/s^2
a_max = 4441·1.3 = 5776 m/s^2
""",
    "an exact result is put in": """
u = 12·34 = 408
w = 408·10 = 4083
""",
    "an exact result that was rounded elsewhere": """
u = 0.5·816 = 408
v = 0.5·817 = 408
w = 408·10 = 4083
""",
    "a velocity that is an acceleration": r"""
Die Kolbenbeschleunigung ist $r = 45$ mm, $\omega = 300$ rad/s, und
$$a = r\omega = 13.5\ \mathrm{m/s^2}$$
""",
}


@pytest.mark.parametrize("page", RIGHT.values(), ids=RIGHT)
def test_a_right_answer_is_not_accused(page: str) -> None:
    assert not [v for v in check(page).verdicts if v.verdict in BAD]


@pytest.mark.parametrize("page", WRONG.values(), ids=WRONG)
def test_a_wrong_answer_does_not_pass(page: str) -> None:
    assert [v for v in check(page).verdicts if v.verdict in BAD]


MOTION = r"""
Let $r$ be the crank radius, $l$ the rod length, $\lambda = r/l$ and $\theta$ the crank angle.
The displacement of the piston from top dead centre is
$$x = r(1-\cos\theta) + l\left(1-\sqrt{1-\lambda^2\sin^2\theta}\right)$$
"""
SLIPS = {
    r"$$x \approx r\left[1-\cos\theta+\tfrac{\lambda}{2}(1-\cos2\theta)\right]$$": ("{2}", "4"),
    r"$$x \approx r\left[1-\cos\theta+\frac{\lambda}{4}(1+\cos2\theta)\right]$$": (
        r"\cos2\theta",
        "-cos 2θ",
    ),
    r"$$x \approx r\left(1-\cos\theta+\frac{\lambda}{4}\sin^2\theta\right)$$": ("{4}", "2"),
    "With $\\theta = \\omega t$ the acceleration is\n"
    r"$$\ddot x \approx r\omega^2(\cos\theta - \lambda\cos2\theta)$$": (
        r"- \lambda\cos2\theta",
        "λ cos 2θ",
    ),
}


@pytest.mark.parametrize("slip", SLIPS)
@pytest.mark.parametrize("sizes", ["", "$r = 45$ mm, $l = 150$ mm.\n"])
def test_a_slip_in_the_second_order_is_mended_in_its_small_letter(slip: str, sizes: str) -> None:
    verdict = check(sizes + MOTION + slip).verdicts[-1]
    assert verdict.verdict == "refuted"
    assert verdict.fix is not None
    assert [(each.source, each.should) for each in verdict.fix.faults] == [SLIPS[slip]]


GIVEN = (
    "$P = 40$ kW, $n = 3000$ rpm, $F = 500$ N, $s = 20$ mm, $A = 20$ mm², $m = 0.7$ kg, $r = 45$ mm\n\n"
    r"$$\omega = \frac{2\pi n}{60} = \frac{2\pi\cdot 3000}{60} = 314.2\ \mathrm{rad/s}$$"
    "\n\n"
)
RESULTS = {
    r"$$M = \frac{P}{\omega} = \frac{40000}{314.2} = 127.3\ UNIT$$": r"\mathrm{N\,m}",
    r"$$K = m r\omega^2 = 0.7\cdot 0.045\cdot 314.2^2 = 3110\ UNIT$$": r"\mathrm{N}",
    r"$$W = F s = 500\cdot 0.02 = 10\ UNIT$$": r"\mathrm{J}",
    r"$$\sigma = \frac{F}{A} = \frac{500}{20} = 25\ UNIT$$": r"\mathrm{N/mm^2}",
    r"$$a = r\omega^2 = 0.045\cdot 314.2^2 = 4442\ UNIT$$": r"\mathrm{m/s^2}",
}


@pytest.mark.parametrize("line", RESULTS)
def test_a_result_behind_numbers_is_in_the_unit_of_its_formula(line: str) -> None:
    right = RESULTS[line]
    assert not [v for v in check(GIVEN + line.replace("UNIT", right)).verdicts if v.verdict in BAD]
    for unit in {r"\mathrm{kg}", r"\mathrm{W}", *RESULTS.values()} - {right}:
        last = check(GIVEN + line.replace("UNIT", unit)).verdicts[-1]
        is_of_its_size = {unit, right} == {r"\mathrm{N\,m}", r"\mathrm{J}"}
        assert (last.verdict in BAD) is not is_of_its_size, (unit, last)


NUMBERS = {
    r"$F = 4\cdot 0.3\cdot0.7\cdot4442 = 3731\ \mathrm{kN}$": ("unit: N, not kN", "3731 N"),
    r"$a = 0.045\cdot 314.2^2\cdot 1.3 = 57750\ \mathrm{m/s^2}$": ("ten times too large", "5775 m/s²"),
    r"$a = 0.045\cdot 314.2^2\cdot 1.3 = 5775000\ \mathrm{m/s^2}$": (
        "a thousand times too large",
        "5775 m/s²",
    ),
    r"$m = 0.6-0.4 = 0.3\ \mathrm{kg}$": ("miscalculated", "0.2 kg"),
    r"$r = 45$ mm, $\omega = 314.16$ rad/s, "
    r"$b = r\omega^2 = 0.045\cdot 314.16^2 = 4441\ \mathrm{mm/s^2}$": (
        "unit: m/s², not mm/s²",
        "4441 m/s²",
    ),
    "$\\cos\\theta - \\cos(\\theta-240°) = \\sqrt3\\cos(\\theta+30°)$": (
        "sign in the argument of cos",
        "-30°",
    ),
}


@pytest.mark.parametrize("page", NUMBERS)
def test_the_slip_in_a_number_is_named(page: str) -> None:
    (wrong,) = [v for v in check(page).verdicts if v.verdict == "refuted"]
    assert wrong.fix is not None
    assert (wrong.fix.words, wrong.fix.faults[0].should) == NUMBERS[page]


def test_an_angle_makes_no_number_true() -> None:
    page = MOTION + (
        "With $\\theta = \\omega t$ and $\\omega = 314.16$ rad/s, $r = 45$ mm, $\\lambda = 0.3$"
        " the largest acceleration is at TDC:\n"
        r"$$a_{max} = r\omega^2(1+\lambda) = 0.045\cdot 314.16^2\cdot 1.3 = 5774\ \mathrm{mm/s^2}$$"
    )
    assert check(page).verdicts[-1].verdict == "refuted"


LETTERS_TOLD = {
    "page.html": r"<p>\(r\) is the crank radius, \(l\) the rod length and \(\lambda = r/l\).</p>",
    "page.md": r"$r$ crank radius, $l$ rod length, $\lambda = r/l$",
    "seite.md": r"$r$ Kurbelradius, $l$ Pleuellänge, $\lambda = r/l$",
    "頁.md": r"クランク半径 $r = 45$ mm、連接棒の長さ $l = 150$ mm、$\lambda = r/l$ とする。",
}


@pytest.mark.parametrize("name", LETTERS_TOLD)
def test_a_list_of_letters_tells_what_they_mean(name: str) -> None:
    proposed = propose(LETTERS_TOLD[name], name, lambda line: (), NoEngines()).meanings
    assert {letter: each.meaning for letter, each in proposed.items()} == {
        "r": "crank radius",
        "l": "rod length",
        "lambda": "crank ratio r/l",
    }


def test_a_phrase_between_two_letters_is_not_of_both() -> None:
    page = r"At $\theta$ crank radius $r$ and rod meet: $x = r\cos\theta$"
    proposed = propose(page, "page.md", lambda line: (), NoEngines()).meanings
    assert "theta" not in proposed or proposed["theta"].meaning != "crank radius"


SHAFTS = "$m = 0.7$ kg, $r = 45$ mm, $l = 150$ mm, $\\lambda = r/l = 0.3$, $r_b = 15$ mm.\n\n"
BALANCE = r"$$2 m_b r_b (2\omega)^2 = 4\lambda m r\omega^2$$" + "\n\n"
SOLVED = {
    r"$$m_b = \frac{\lambda m r}{4 r_b}$$": "λ m r/(2 r_b)",
    r"$$m_b = \frac{\lambda m r}{r_b}$$": "λ m r/(2 r_b)",
    r"$$m_b r_b = \lambda m r$$": "1/2 λ m r",
}


@pytest.mark.parametrize("line", SOLVED)
@pytest.mark.parametrize("sizes", ["", SHAFTS])
def test_a_wrong_solution_says_what_it_should_be(line: str, sizes: str) -> None:
    wrong = check(sizes + BALANCE + line).verdicts[-1]
    assert wrong.verdict == "refuted"
    assert wrong.fix is not None
    assert wrong.fix.text == SOLVED[line]
    right = {r"$$m_b = \frac{\lambda m r}{2 r_b}$$", r"$$m_b r_b = \frac{1}{2}\lambda m r$$"}
    for page in right:
        assert check(sizes + BALANCE + page).verdicts[-1].verdict not in BAD


def test_an_exponent_lost_in_a_series_is_named() -> None:
    page = MOTION + r"$$\sqrt{1-\lambda^2\sin^2\psi} \approx 1 - \frac{\lambda}{2}\sin^2\psi$$"
    wrong = check(page).verdicts[-1]
    assert wrong.verdict == "refuted"
    assert wrong.fix is not None
    assert wrong.fix.words == "exponent of the second term"


def test_of_two_motions_named_a_letter_is_its_usual_one() -> None:
    page = "Kolbengeschwindigkeit und Kolbenbeschleunigung:\n$$v = r\\omega\\sin\\varphi$$"
    proposed = propose(page, "seite.md", lambda line: (), NoEngines()).meanings
    assert proposed["v"].meaning == "piston velocity"


PUT_IN = {
    r"$m = 0.6$ kg, $l = 150$ mm, $a = 50$ mm, "
    r"$m_A = m\frac{l-a}{l} = 0.6\cdot\frac{50}{150} = 0.2$ kg": ("{50}", "100"),
    r"$n = 3000$ min$^{-1}$, $q = \frac{\pi n}{60} = \frac{\pi\cdot3000}{30}$": ("{30}", "60"),
}


@pytest.mark.parametrize("page", PUT_IN)
def test_of_numbers_put_in_the_one_that_no_letter_has_is_wrong(page: str) -> None:
    wrong = next(v for v in check(page).verdicts if v.verdict == "refuted")
    assert wrong.fix is not None
    assert [(each.source, each.should) for each in wrong.fix.faults] == [PUT_IN[page]]
