"""A motion derived in general and then looked at at several angles: what is of one place stays there."""

import pytest

from symbalance.checking import check

DERIVED = r"""Crank radius $r = 45$ mm, rod length
$l = 150$ mm, $\lambda = r/l = 0.3$, $\omega = 314.16$ rad/s.

From the sketch {sketch}, so $\sin\beta = \lambda\sin\varphi$. The travel from top dead centre is

$$x = r(1-\cos\varphi) + l(1-\cos\beta)$$

With $\cos\beta = \sqrt{{1-\lambda^2\sin^2\varphi}} \approx 1-\tfrac12\lambda^2\sin^2\varphi$

$$x \approx r\left(1-\cos\varphi+\frac{{\lambda}}{{2}}\sin^2\varphi\right)$$

With $\dot\varphi = \omega$

$$v = \dot x = r\omega\left(\sin\varphi+\frac{{\lambda}}{{2}}\sin 2\varphi\right)$$

$$a = \dot v = r\omega^2\left(\cos\varphi+\lambda\cos 2\varphi\right)$$
"""
AT_PLACES = r"""
In numbers, for 30°:

- $x = 45\cdot(1-0.8660+0.15\cdot 0.25)$ mm $= 7.72$ mm
- $v = 14.14\cdot(0.5+0.15\cdot 0.8660) = 8.91$ m/s
- $a = 4441\cdot(0.8660+0.3\cdot 0.5) = {acceleration}$ m/s²

The force on the piston is $F_K = F_G - m a$ with $m = 0.80$ kg.

### 30°

$F_G = 16265$ N

$$F_K = 16265 - 0.80\cdot 4512 \approx 12655\,\text{{N}}$$

### 90°

$$F_K = 3776 - 0.80\cdot(-1332) \approx {force}\,\text{{N}}$$
"""


def _refuted(page):
    return [link["line"] for link in check(page).data()["links"] if link["verdict"] == "refuted"]


@pytest.mark.parametrize("sketch", [r"$r\sin\varphi = l\sin\beta$", r"$l\sin\beta = r\sin\varphi$"])
def test_the_rods_angle_follows_from_the_cranks_whichever_stands_first(sketch):
    page = DERIVED.format(sketch=sketch)
    assert _refuted(page) == []
    wrong = page.replace(r"\frac{\lambda}{2}\sin 2\varphi", r"\lambda\sin 2\varphi")
    assert len(_refuted(wrong)) >= 1


def test_numbers_of_one_angle_refute_nothing_at_another():
    page = DERIVED.format(sketch=r"$r\sin\varphi = l\sin\beta$")
    assert _refuted(page + AT_PLACES.format(acceleration="4512", force="4842")) == []
    assert _refuted(page + AT_PLACES.format(acceleration="4152", force="4842"))
    assert _refuted(page + AT_PLACES.format(acceleration="4512", force="4284"))


@pytest.mark.parametrize(
    "place",
    [
        "For $\\theta$ equal to 60° we find",
        "For θ = 60° we find",
        "Für $\\psi = 60°$ wird",
        "At $\\alpha = 60^\\circ$",
        "With cylinders inclined at 60° we find",
    ],
)
def test_the_angle_of_another_letter_or_between_parts_is_no_place_of_the_crank(place):
    text = f"$y = \\sin\\varphi$. {place} $y = 0.866$."
    assert "holds" not in {verdict.verdict for verdict in check(text).verdicts}
    assert "conditional" not in {verdict.verdict for verdict in check(text).verdicts}


@pytest.mark.parametrize(
    "place",
    ["For $\\varphi$ equal to 60° we find", "For φ = 60° we find", "At $\\phi = 60^\\circ$", "At 60°"],
)
@pytest.mark.parametrize(("value", "verdict"), [("0.866", "conditional"), ("0.5", "refuted")])
def test_the_angle_of_its_own_letter_is_one(place, value, verdict):
    text = f"$y = \\sin\\varphi$. {place} $y = {value}$."
    assert check(text).verdicts[-1].verdict == verdict
