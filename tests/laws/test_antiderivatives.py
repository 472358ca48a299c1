"""Integrals without bounds are decided by their derivatives, up to the constant that is left out."""

import pytest

from symbalance.checking import check


def links(page: str) -> list[dict[str, object]]:
    return check(page, fixes=False).data()["links"]


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (r"\int x^2\,dx = \frac{x^3}{3} + C", r"\int x^2\,dx = \frac{x^3}{2} + C"),
        (
            r"\int\sin 2\theta\,d\theta = -\tfrac12\cos 2\theta",
            r"\int\sin 2\theta\,d\theta = \tfrac12\cos 2\theta",
        ),
        (
            r"\int\cos\omega t\,dt = \frac{\sin\omega t}{\omega}",
            r"\int\cos\omega t\,dt = \omega\sin\omega t",
        ),
        (r"\int\frac{dx}{x} = \ln x + C", r"\int\frac{dx}{x} = -\frac{1}{x^2} + C"),
        (r"\int\frac{dx}{1+x^2} = \arctan x", r"\int\frac{dx}{1+x^2} = \ln(1+x^2)"),
        (r"\int x e^x dx = x e^x - \int e^x dx", r"\int x e^x dx = x e^x + \int e^x dx"),
        (
            r"\int\sin^2\theta\,d\theta = \frac{\theta}{2} - \frac{\sin 2\theta}{4}",
            r"\int\sin^2\theta\,d\theta = \frac{\theta}{2} + \frac{\sin 2\theta}{4}",
        ),
    ],
)
def test_an_antiderivative_and_a_wrong_one(right, wrong):
    assert links(f"$${right}$$")[-1]["verdict"] in ("holds", "conditional")
    assert links(f"$${wrong}$$")[-1]["verdict"] == "refuted"


def test_a_constant_that_is_left_out_is_named():
    assert "constant of integration" in str(links(r"$$\int x\,dx = \frac{x^2}{2}$$")[-1]["assumption"])
    assert "constant of integration" not in str(
        links(r"$$\int x\,dx = \frac{x^2}{2} + C$$")[-1]["assumption"]
    )


@pytest.mark.parametrize(
    "page", [r"$$W = \int p\,dV$$", r"$$\int p\,dV = W$$", r"$$\int\sin x\,dx = 2$$"]
)
def test_what_depends_on_no_letter_is_no_antiderivative(page):
    assert links(page)[-1]["verdict"] not in ("holds", "conditional", "refuted")
