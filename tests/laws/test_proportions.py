"""A proportion, F ∝ ω², is proved by the formula that stands above, or refuted with the right power."""

import pytest

from symbalance.checking import check

FORCE = r"The force is $F = m r \omega^2$. "
SPEED = r"$F = m r \omega^2$, wobei $\omega = 2\pi n$ ist. "
ROOT = r"La pulsation vaut $p = \sqrt{C/I}$. "
STEADY = r"$C_s = \frac{\Delta E}{I\omega^2}$. "
MOMENT = r"$M = F a$ である。$F = m r \omega^2$ とする。"


def last(page: str) -> tuple[str, str]:
    found = check(page + "\n", fixes=False).data()["links"][-1]
    return found["verdict"], found["reason"] or ""


@pytest.mark.parametrize(
    "page",
    [
        FORCE + r"So $F \propto \omega^2$.",
        FORCE + "So F ∝ m.",
        FORCE + r"At $\omega = 100$ rad/s too, $F \propto r\omega^2$.",
        SPEED + r"Also $F \propto n^2$.",
        SPEED + r"$F \propto \omega^2 \propto n^2$",
        ROOT + r"Donc $p \propto 1/\sqrt{I}$.",
        STEADY + r"Thus $$C_s \propto \frac{1}{\omega^2}$$",
        MOMENT + r"よって $M \propto a\omega^2$",
        r"$F = m r \omega^2 \cos\theta$, so $F \propto m$.",
    ],
)
def test_what_grows_as_it_says_holds(page):
    assert last(page)[0] == "holds"


@pytest.mark.parametrize(
    ("page", "right"),
    [
        (FORCE + r"So $F \propto \omega$.", "ω^2"),
        (FORCE + "So F ∝ r².", "as r"),
        (SPEED + r"Also $F \propto n$.", "n^2"),
        (ROOT + r"Donc $p \propto 1/I$.", "I^(-1/2)"),
        (STEADY + r"Thus $$C_s \propto \frac{1}{\omega}$$", "ω^(-2)"),
        (MOMENT + r"よって $M \propto \omega$", "ω^2"),
        (r"$W = \frac12 m v^2 + m g h$, so $W \propto v^2$.", "not grow as a power of v"),
        (r"$T = 1/f$. Thus $T \propto f$.", "f^(-1)"),
    ],
)
def test_what_grows_otherwise_is_refuted_with_the_right_power(page, right):
    verdict, reason = last(page)
    assert verdict == "refuted"
    assert right in reason


def test_a_proportion_alone_is_a_premise_and_no_formula():
    page = r"The load grows, $T \propto N^2$. With $N = 2$ we have $T = 4$."
    assert [e["verdict"] for e in check(page, fixes=False).data()["links"]][::2] == [
        "premise",
        "definition",
    ]


def test_a_number_is_nothing_to_be_proportional_to():
    assert last(r"$x \propto 5$")[0] == "undecided"


@pytest.mark.parametrize("claim", [r"C \propto 1/\omega_m", r"C \propto \omega_m^{-1}"])
def test_what_another_line_ties_otherwise_is_open(claim):
    page = r"$C = \frac{\omega_1-\omega_2}{\omega_m}$. It has $J = \frac{E}{C\omega_m^2}$. So $CLAIM$."
    assert last(page.replace("CLAIM", claim))[0] == "undecided"
