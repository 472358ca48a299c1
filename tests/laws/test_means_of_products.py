r"""A mean of a product is no product of means, nor is a bar nothing where letters may be complex."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")


def last(page: str) -> dict:
    return check(page + "\n", fixes=False).data()["links"][-1]


@pytest.mark.parametrize(
    "page",
    [
        r"$\overline{v^2} = \bar v^2$ is the mean of the square.",
        r"$\langle v^2\rangle = \langle v\rangle^2$",
        r"$\langle x\, y \rangle = \langle x\rangle\langle y\rangle$",
        r"$\left\langle \sin\varphi\right\rangle = \sin\left\langle\varphi\right\rangle$",
        r"$E[X^2] = E[X]^2$",
        r"$\mathbb{E}[XY] = \mathbb{E}[X]\,\mathbb{E}[Y]$",
        r"$\overline{ab} = \bar a\,\bar b$ holds for the mean values of two signals a(t) and b(t).",
        r"Die Mittelwerte: $\overline{uv} = \bar u\,\bar v$.",
        r"La moyenne du carré est $\overline{w^2} = \bar w^2$.",
        r"平均は $\overline{pq} = \bar p\,\bar q$ である。",
        r"I valori medi: $\overline{gh} = \bar g\,\bar h$.",
    ],
)
def test_means_of_products_are_refuted(page):
    assert last(page)["verdict"] == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        r"$v = 2 w$. The mean of the square is $\overline{w^2} = \bar w^2$.",
        r"For independent $X$ and $Y$: $\mathbb{E}[X^2] = \mathbb{E}[X]^2$",
        r"$\overline{z_1 z_2} = z_1 z_2$",
        r"For complex $a$ and $b$: $\overline{ab} = ab$",
        r"$|z_1 + z_2| = |z_1| + |z_2|$",
        r"$|Z_1 - Z_2| = |Z_1| - |Z_2|$",
        r"For complex numbers $|z_1 + z_2| = |z_1| + |z_2|$",
    ],
)
def test_what_other_words_or_lines_may_make_true_is_not_confirmed(page):
    assert last(page)["verdict"] not in PROVED


@pytest.mark.parametrize(
    "page",
    [
        r"$\overline{a+b} = \bar a+\bar b$ holds for the mean values.",
        r"Die Mittelwerte: $\overline{u+2v} = \bar u + 2\bar v$.",
        r"$\langle 3 p + q\rangle = 3\langle p\rangle + \langle q\rangle$",
        r"$E[X+Y] = E[X]+E[Y]$",
        r"$E[E[X]] = E[X]$",
        r"For independent $X$ and $Y$, $E[XY] = E[X]E[Y]$.",
        r"For uncorrelated signals the mean is $\overline{pq} = \bar p\,\bar q$.",
        r"$\langle x^2 \rangle = \mu^2 + s^2$. Then $\langle x^2\rangle - \mu^2 = s^2$.",
        r"$M = F\langle x-a\rangle^2 = F (x-a)^2$",
        r"$\sigma = E[\varepsilon_1 + \nu\varepsilon_2] = E\varepsilon_1 + E\nu\varepsilon_2$",
        r"$\sigma = E[\varepsilon_1\nu] = E\varepsilon_1\nu$",
        r"For complex numbers $\overline{z w} = \bar z\,\bar w$",
        r"$\overline{z_1 z_2} = \bar z_1 \bar z_2$",
        r"Let $Z = 3 + 4i$. $\overline{Z^2} = -7 - 24 i$",
        r"$|z_1 z_2| = |z_1| |z_2|$",
        r"$|x+y| = |x|+|y|$",
    ],
)
def test_what_is_true_of_means_and_conjugates_is_confirmed(page):
    assert last(page)["verdict"] in PROVED


def test_a_bar_that_nobody_explains_is_said_to_be_the_conjugate():
    verdict = last(r"$\overline{u v} = \bar u\,\bar v$")
    assert (verdict["verdict"], verdict["assumption"]) == (
        "conditional",
        "the bar is the complex conjugate",
    )


def test_of_real_letters_between_bars_the_signs_count():
    ranges = r"$z_1 > 0$ and $z_2 > 0$. $|z_1 + z_2| = |z_1| + |z_2|$"
    assert last(ranges)["verdict"] in PROVED
