"""What words say of a relation: that a letter is large in it, that it never holds, or not always."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")


def last(page: str) -> str:
    return check(page + "\n", fixes=False).data()["links"][-1]["verdict"]


@pytest.mark.parametrize(
    "page",
    [
        r"For large x, $\frac{1}{1+x} \approx \frac1x$.",
        r"For $x \to \infty$, $\frac{x}{1+x} \approx 1$.",
        r"Für große $\eta$ ist $\frac{\eta^2}{\eta^2-1} \approx 1$.",
        r"For $x \gg 1$: $\sqrt{1+x^2} \approx x$.",
        r"For $l \gg r$: $\sqrt{l^2 - r^2\sin^2\theta} \approx l$.",
        r"For small x, $\frac{1}{1+x} \approx 1 - x$.",
    ],
)
def test_an_approximation_holds_where_its_words_say(page):
    assert last(page) in PROVED


@pytest.mark.parametrize(
    "page",
    [
        r"For large x, $\frac{1}{1+x} \approx 1 - x$.",
        r"For large x, $\sin x \approx x$.",
        r"For angles near 180°: $\sin\theta \approx \theta$.",
        r"With $\lambda = 3$: $\sqrt{1-\lambda^2\sin^2 a} \approx 1 - \frac12\lambda^2\sin^2 a$.",
        r"Für große $\eta$ ist $\frac{1}{\eta^2-1} \approx -1$.",
        r"For $r \gg l$: $\sqrt{l^2 - r^2\sin^2\theta} \approx l$.",
    ],
)
def test_and_is_not_proved_where_they_say_otherwise(page):
    assert last(page) in ("refuted", "undecided")


@pytest.mark.parametrize(
    ("page", "verdict"),
    [
        (r"It is never so that $\cos\theta > 1$.", "holds"),
        (r"$\cos\theta > 1$ is impossible.", "holds"),
        (r"Es gilt nie $\cos\theta > 1$.", "holds"),
        (r"$x^2 \ge 0$ is impossible.", "refuted"),
        (r"It is never so that $x^2 > -1$.", "refuted"),
        (r"$\lambda > 1$ is impossible, since the rod is longer than the crank.", "condition"),
        (r"$\sin 2x = 2\sin x\cos x$ is not true in general.", "refuted"),
        (r"$\sin 2x = 2\sin x$ is not true in general.", "condition"),
        (r"$(a+b)^2 = a^2+2ab+b^2$ gilt nicht für alle $a$.", "refuted"),
        (r"$(a+b)^2 = a^2+2ab+b^2$ only if a vanishes.", "refuted"),
    ],
)
def test_what_is_denied_is_judged_by_its_denial(page, verdict):
    assert last(page) == verdict
