"""Roots below an equation set to zero satisfy it, or they are wrong; other values beside it are none."""

import pytest

import symbalance as sb

BEATS = r"$(k - m\omega^2)^2 - k_c^2 = 0$"
DETERMINANT = r"$\begin{vmatrix} 2c - m\omega^2 & -c\\ -c & 2c-m\omega^2\end{vmatrix} = 0$"
PAIRS = [
    (f"{BEATS}, so $\\omega_1^2 = ROOT$.\n", r"\frac{k+2k_c}{m}", r"\frac{k+k_c}{m}"),
    (f"{BEATS}\n\n$\\omega^2 = ROOT$\n", r"\frac{k \pm k_c}{2m}", r"\frac{k \pm k_c}{m}"),
    (
        f"{BEATS} has the roots $\\omega_{{1,2}}^2 = ROOT$.\n",
        r"\frac{2k \pm k_c}{m}",
        r"\frac{k \pm k_c}{m}",
    ),
    (
        f"{BEATS} gives $f_1 = \\frac{{1}}{{2\\pi}}ROOT$.\n",
        r"\sqrt{\frac{k-2k_c}{m}}",
        r"\sqrt{\frac{k-k_c}{m}}",
    ),
    (
        f"Aus {DETERMINANT} folgen die Eigenkreisfrequenzen\n\n"
        "$\\omega_1^2 = c/m$ und $\\omega_2^2 = ROOT$.\n",
        "2c/m",
        "3c/m",
    ),
    (
        "$(2k - m\\lambda)(2k - m\\lambda) - k^2 = 0$ donne "
        "$\\lambda_1 = \\frac{k}{m}$ et $\\lambda_2 = ROOT$.\n",
        r"\frac{2k}{m}",
        r"\frac{3k}{m}",
    ),
    ("$(c - J p^2)^2 - c_t^2 = 0$ より $p_1 = ROOT$\n", r"\sqrt{(c-2c_t)/J}", r"\sqrt{(c-c_t)/J}"),
    (
        "Da $(c - J p^2)^2 - c_t^2 = 0$ si ottiene $p_1 = ROOT$.\n",
        r"\sqrt{(c+c_t)/(2J)}",
        r"\sqrt{(c+c_t)/J}",
    ),
    (
        "De $x^2 + 2 a x + b = 0$ se obtiene $x_{1,2} = ROOT$.\n",
        r"-a \pm \sqrt{a^2 + b}",
        r"-a \pm \sqrt{a^2 - b}",
    ),
    ("$2x^2 - 7x + 3 = 0$ gives $x_1 = 3$, $x_2 = ROOT$.\n", "2", r"\frac12"),
    (
        "$A=\\begin{pmatrix}2&1\\\\1&2\\end{pmatrix}$ and $\\det(A - \\lambda I) = 0$, so "
        "$\\lambda_1 = 1$, $\\lambda_2 = ROOT$.\n",
        "4",
        "3",
    ),
    (
        f"m = 2 kg, k = 800 N/m, k_c = 100 N/m. {BEATS} gives $\\omega_2 = ROOT$ rad/s.\n",
        "25.2",
        "21.2",
    ),
    (f"{DETERMINANT}\n\nExpanded: $ROOT = 0$.\n", r"(2c-m\omega^2)^2 + c^2", r"(2c-m\omega^2)^2 - c^2"),
    (
        f"{DETERMINANT}\n\n$ROOT = 0$\n",
        r"m^2\omega^4 - 4cm\omega^2 + 4c^2",
        r"m^2\omega^4 - 4cm\omega^2 + 3c^2",
    ),
]
BESIDE = [
    "$(k_1 - m_1\\omega^2)(k_2 - m_2\\omega^2) - k_c^2 = 0$ with the abbreviations "
    "$\\omega_1^2 = k_1/m_1$ and $\\omega_2^2 = k_2/m_2$.\n",
    "$(k_1 - m_1\\omega^2)(k_2 - m_2\\omega^2) - k_c^2 = 0$. The uncoupled oscillators have "
    "$\\omega_1^2 = k_1/m_1$.\n",
    f"{BEATS}. For $k_c = 0$ both roots are $\\omega^2 = k/m$.\n",
    f"{BEATS}. The reference frequency is $\\omega_0^2 = k/m$.\n",
    f"{BEATS}. Set $\\omega_1 = \\sqrt{{k/m}}$.\n",
    f"{BEATS}. Für schwache Kopplung ist $\\omega^2 = k/m$.\n",
    r"$2\lambda c^2 + c - \lambda = 0$, $c = \cos\theta$" + "\n",
    "$$F_1 + F_2 = 0$$\n\n$$F_1 = \\cos\\theta$$\n\n$$F_2 = -\\cos\\theta$$\n",
    "$m\\omega^2 - k = 0$\n\nThe driving frequency is $\\omega_2 = 2\\sqrt{k/m}$.\n",
]


def _verdicts(page):
    return [link["verdict"] for link in sb.check(page, {}).data()["links"]]


@pytest.mark.parametrize(("page", "wrong", "right"), PAIRS)
def test_a_root_satisfies_the_equation_above(page, wrong, right):
    assert _verdicts(page.replace("ROOT", wrong))[-1] == "refuted"
    assert _verdicts(page.replace("ROOT", right))[-1] in ("holds", "holds_to_order", "conditional")


@pytest.mark.parametrize("page", BESIDE)
def test_another_value_of_the_letter_is_no_root(page):
    assert "refuted" not in _verdicts(page)


def test_a_determinant_and_its_polynomial_are_set_to_zero_together():
    page = r"$\begin{vmatrix} k - x & -c\\ -c & k - x\end{vmatrix} = (k-x)^2 SIGN c^2 = 0$"
    assert _verdicts(page.replace("SIGN", "-")) == ["holds", "condition"]
    assert _verdicts(page.replace("SIGN", "+"))[0] == "refuted"
