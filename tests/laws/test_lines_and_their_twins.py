"""Short pages with a wrong line, never said to hold, and the same pages right, never refuted."""

from __future__ import annotations

from pathlib import Path

import pytest

from symbalance.notes.checking import check

HELD, ACCUSED = {"holds", "holds_to_order", "conditional"}, {"refuted", "contradiction"}

LETTERS_LIKE_UNITS = {
    "right": [
        r"With the mass $m$ and the stiffness $k$: $(k-m\omega^2)^2 = k^2-2km\omega^2+m^2\omega^4$.",
        r"$(3km)^2 = 9k^2m^2$",
        r"$T = \frac12J\omega^2$ and $L = J\omega$, so $T = \frac{L^2}{2J}$.",
        "Let $c = 3$ and $m=2$. Then $c^2+2cm+m^2 = 25$.",
        "$(m+s)^2 = m^2 + 2ms + s^2$",
        "With $N$ and $m$ integers: $(N+m)^2 - (N-m)^2 = 4Nm$.",
        "$k = 3$, $g = 9.81$, $m = 2$. $ks = 2mg$, so $s = 2mg/k$.",
        "$m = 2$ kg, $k = 3$ N/m. The track has $x = 2km$, so $x = 2000$ m and $3km = 3000$ m.",
        "$m = 0.4$ kg and the stroke $s$; the time is $t = 2ms$, so $t = 0.002$ s.",
        "$k = 3$, $m = 2$, $t = x/v = 2km/(4 m/s) = 500$ s",
    ],
    "wrong": [
        r"With the mass $m$ and the stiffness $k$: $(k-m\omega^2)^2 = k^2+2km\omega^2+m^2\omega^4$.",
        "Let $k=5$ and $m=2$. Then $3km = 3000$.",
        "Let $c = 3$ and $m=2$. Then $c^2+2cm+m^2 = 19$.",
        "$(m+s)^2 = m^2 + 3ms + s^2$",
        "$m = 2$ kg, $k = 3$ N/m. The track has $x = 2km$, so $x = 12$ m.",
    ],
}
IN_TEXT = {
    "right": ["(k - mω²)² = k² - 2km ω² + m² ω⁴", "(c+m)² = c² + 2cm + m²", "L = Jω, T = ½Jω² = L²/(2J)"],
    "wrong": ["(k - mω²)² = k² - 3km ω² + m² ω⁴", "(c+m)² = c² + cm·3 + m²"],
}
MATRICES = {
    "wrong": [
        "Let $A$ and $B$ be matrices. Then $(A+B)(A-B) = A^2-B^2$.",
        "Let $A$ and $B$ be two rotation matrices in space. Then $AB = BA$.",
        "The square of a sum of two matrices is $(A+B)^2 = A^2+2AB+B^2$.",
        "Seien $A$ und $B$ zwei quadratische Matrizen. Dann ist $(AB)^2 = A^2B^2$.",
        "Soient $P$ et $Q$ deux matrices carrées. Alors $(P-Q)^2 = P^2 - 2PQ + Q^2$.",
        r"$A$, $B$ are $n\times n$ matrices, so $(AB)^{-1} = A^{-1}B^{-1}$.",
        "$A$ と $B$ を行列とする。$AB = BA$。",
    ],
    "right": [
        "Let $A$ and $B$ be matrices. Then $(A+B)(A-B) = A^2-AB+BA-B^2$.",
        "Let $A$ and $B$ be two commuting matrices. Then $AB = BA$, hence $(A+B)^2 = A^2+2AB+B^2$.",
        "Seien $A$ und $B$ zwei Diagonalmatrizen. Dann ist $(AB)^2 = A^2B^2$.",
        "Let $R$ and $S$ be rotation matrices about the same axis. Then $RS = SR$.",
        "Let $A$ and $B$ be matrices with $AB = BA$. Then $(A+B)^2 = A^2+2AB+B^2$.",
        r"$A$, $B$ are $n\times n$ matrices, so $(AB)^{-1} = B^{-1}A^{-1}$.",
        "A mass matrix is symmetric. The width is $B$, the area $A$: $A B = B A$.",
    ],
}
FOUR = "# Inline four-cylinder engine\n\n"
SIX = "# Inline six\n\n"
VIER = "# Reihenvierzylinder\n\n"
SECOND = r"\lambda m r\omega^2\cos2\theta$"
ENGINES = {
    "wrong": [
        rf"{FOUR}The secondary force is $F_2 = {SECOND}, the same as that of a single-cylinder engine.",
        rf"{SIX}Like the four-cylinder engine it has the secondary force $F_2 = 4{SECOND}.",
        rf"{VIER}Die Massenkraft zweiter Ordnung ist $F_2 = {SECOND}, wie beim Einzylindermotor.",
        f"The inline four has no secondary force, $F_2 = 0$, whereas the boxer four has $F_2 = "
        f"4{SECOND}.",
        "| engine | secondary force |\n|---|---|\n| twin, 180° | $F_2 = 2\\lambda m r\\omega^2$ |\n"
        "| inline three | $F_2 = 3\\lambda m r\\omega^2$ |",
        "# Single-cylinder engine\n\nThe primary inertia force is $F_1 = m r\\omega^2\\cos\\theta$, the "
        rf"secondary inertia force is $F_2 = -{SECOND}.",
        rf"{FOUR}The secondary force is $F_2 = 4{SECOND}, the fourth-order force is "
        r"$F_4 = \lambda^3m r\omega^2\cos4\theta$.",
    ],
    "right": [
        rf"{FOUR}The secondary force is $F_2 = 4{SECOND}, four times that of a single cylinder.",
        rf"{FOUR}Unlike the single-cylinder engine it has the secondary force $F_2 = 4{SECOND}.",
        f"{SIX}Unlike the four-cylinder engine it has no secondary force: $F_2 = 0$.",
        rf"{VIER}Im Gegensatz zum Einzylindermotor ist die Massenkraft zweiter Ordnung $F_2 = 4{SECOND}.",
        f"# Le quatre-cylindres en ligne\n\nLa force d'inertie du second ordre est $F_2 = 4{SECOND}, "
        "soit quatre fois celle d'un monocylindre.",
        "Inline four-cylinder engine\n\nSecondary force of the engine: F_2 = 4 m r ω² λ\n"
        "A single cylinder has only F_s = m r ω² λ",
        "# Inline three\n\nThe primary force is zero, $F_1=0$; with a 180° crank instead it would be "
        r"$F_1 = m r\omega^2\cos\theta$.",
        f"The boxer four has no secondary force, $F_2 = 0$, whereas the inline four has $F_2 = "
        f"4{SECOND}.",
        "# Single-cylinder engine\n\nThe primary inertia force is $F_1 = -m r\\omega^2\\cos\\theta$, the "
        rf"secondary inertia force is $F_2 = -{SECOND}.",
    ],
}
OF_ALL_VALUES = {
    "wrong": [
        "For all real $a$ and $b$: $a^2+b^2 > 2ab$.",
        r"For any real $a$, $b$: $|a+b|\le|a|+|b|$ and $|a-b|\le|a|-|b|$.",
        r"For $0<\lambda<1$ and all $\theta$ it holds that $|\cos\theta+\lambda\cos2\theta|\le1$.",
        r"For every real number $x$ we have $\sqrt{x^4} = x^2$ and $\sqrt{(x-1)^2} = x - 1$.",
        "Für alle reellen $x$ und $y$ gilt $x^2+y^2 > 2xy$.",
    ],
    "right": [
        r"For all real $a$ and $b$: $a^2+b^2 \ge 2ab$.",
        r"For any real $a$, $b$: $|a+b|\le|a|+|b|$ and $(a+b)^2 \le 2a^2+2b^2$.",
        r"For every real number $x$ we have $\sqrt{x^4} = x^2$ and $\sqrt{(x-1)^2} = |x - 1|$.",
        r"For all $x$ and $y$: $|x-y| \le |x|+|y|$.",
    ],
}
ONE_ANGLE = {
    "wrong": [
        r"We have $\sin\theta = 0.6$, hence $\cos\theta = 0.9$.",
        r"$\cos\theta = 0.6 \Rightarrow \sin\theta = 0.9$",
        r"Aus $\cos\theta = 0.25$ folgt $\sin\theta = 0.75$.",
    ],
    "right": [
        r"We have $\sin\theta = 0.6$, hence $\cos\theta = \pm0.8$.",
        r"$\sin\theta = 0.6$, so $\cos\theta = -0.8$ and thus $\tan\theta = -0.75$.",
        r"$\cos\theta = 0.64$, also ist $\sin\theta = 0.77$.",
        r"$\cos\theta = 0.5$ or $\cos\theta = -1$, hence $\sin\theta = 0.866$ or $\sin\theta = 0$.",
    ],
}
DRIVEN = r"The driven oscillator obeys $m\ddot x + kx = F\cos\omega t$. In the steady state "
INTEGRATED = {
    "wrong": [
        r"Integrating $\dot v = -kv$ gives $v = v_0e^{kt}$.",
        DRIVEN + r"$x = \frac{F}{k+m\omega^2}\cos\omega t$.",
        DRIVEN + r"$x = \frac{F}{k-m\omega^2}\sin\omega t$.",
        r"Aus $m\ddot x = -mg$ folgt durch Integration $x = \frac12 g t^2$.",
        r"L'équation $\dot v = -kv$, intégrée, donne $v = v_0e^{-2kt}$.",
    ],
    "right": [
        r"Integrating $\dot v = -kv$ gives $v = v_0e^{-kt}$.",
        DRIVEN + r"$x = \frac{F}{k-m\omega^2}\cos\omega t$.",
        r"Aus $m\ddot x = -mg$ folgt durch Integration $x = x_0 + v_0t - \frac12 g t^2$.",
        r"The natural frequency is $\omega_p = \omega\sqrt{R/\ell}$. To tune it to order $n$ we need "
        r"$\omega_p = n\omega$, hence $\ell = R/n^2$. With $n=2$ and $R = 80$ mm we get $\ell = 20$ mm.",
    ],
}


def _verdicts(tmp_path: Path, page: str, ending: str = "md") -> list[str]:
    path = tmp_path / f"page.{ending}"
    path.write_text(f"{page}\n", encoding="utf-8")
    return [link["verdict"] for link in check(path, fixes=False).data()["links"]]


@pytest.mark.parametrize("page", LETTERS_LIKE_UNITS["right"])
def test_letters_like_units_are_letters(tmp_path: Path, page: str):
    verdicts = _verdicts(tmp_path, page)
    assert verdicts[-1] in HELD
    assert not ACCUSED & set(verdicts)


@pytest.mark.parametrize("page", LETTERS_LIKE_UNITS["wrong"])
def test_letters_like_units_hide_no_slip(tmp_path: Path, page: str):
    assert _verdicts(tmp_path, page)[-1] in ACCUSED


@pytest.mark.parametrize("page", IN_TEXT["right"])
def test_letters_like_units_in_plain_text(tmp_path: Path, page: str):
    assert _verdicts(tmp_path, page, "txt")[-1] in HELD


@pytest.mark.parametrize("page", IN_TEXT["wrong"])
def test_slips_beside_letters_like_units_in_plain_text(tmp_path: Path, page: str):
    assert not HELD & set(_verdicts(tmp_path, page, "txt")[-1:])


@pytest.mark.parametrize("page", MATRICES["wrong"])
def test_products_of_matrices_do_not_commute(tmp_path: Path, page: str):
    assert _verdicts(tmp_path, page)[-1] in ACCUSED


@pytest.mark.parametrize("page", MATRICES["right"])
def test_right_products_of_matrices_hold(tmp_path: Path, page: str):
    verdicts = _verdicts(tmp_path, page)
    assert verdicts[-1] in HELD
    assert not ACCUSED & set(verdicts)


@pytest.mark.parametrize("page", ENGINES["wrong"])
def test_an_engine_compared_with_lends_no_verdict(tmp_path: Path, page: str):
    assert _verdicts(tmp_path, page)[-1] not in HELD


@pytest.mark.parametrize("page", ENGINES["right"])
def test_an_engine_compared_with_accuses_nothing_right(tmp_path: Path, page: str):
    assert not ACCUSED & set(_verdicts(tmp_path, page))


@pytest.mark.parametrize("page", OF_ALL_VALUES["wrong"])
def test_what_is_said_of_all_values_is_refuted_by_one(tmp_path: Path, page: str):
    assert _verdicts(tmp_path, page)[-1] in ACCUSED


@pytest.mark.parametrize("page", OF_ALL_VALUES["right"])
def test_what_is_right_of_all_values_is_proved(tmp_path: Path, page: str):
    verdicts = _verdicts(tmp_path, page)
    assert verdicts[-1] in HELD
    assert not ACCUSED & set(verdicts)


@pytest.mark.parametrize("page", ONE_ANGLE["wrong"])
def test_a_cosine_drawn_from_a_sine_has_one_size(tmp_path: Path, page: str):
    assert _verdicts(tmp_path, page)[-1] in ACCUSED


@pytest.mark.parametrize("page", ONE_ANGLE["right"])
def test_a_cosine_drawn_from_a_sine_may_have_either_sign(tmp_path: Path, page: str):
    assert not ACCUSED & set(_verdicts(tmp_path, page))


@pytest.mark.parametrize("page", INTEGRATED["wrong"])
def test_a_motion_has_to_solve_the_equation_it_is_drawn_from(tmp_path: Path, page: str):
    assert _verdicts(tmp_path, page)[-1] in ACCUSED


@pytest.mark.parametrize("page", INTEGRATED["right"])
def test_a_motion_that_solves_its_equation_and_a_demand_are_not_refuted(tmp_path: Path, page: str):
    verdicts = _verdicts(tmp_path, page)
    assert verdicts[-1] in HELD
    assert not ACCUSED & set(verdicts)
