"""A letter that words make another thing, and formulas of two conditions, are no claims of one thing."""

import pytest

from symbalance.checking import check

ACCUSED = ("refuted", "contradiction")
PATH = r"Let $x$ be the displacement from top dead centre, $x = r(1-\cos\theta)$. "
WEG = r"Sei $x$ der Kolbenweg, $x = r(1-\cos\theta)$. "


def words_of(page: str) -> list[str]:
    return [link["verdict"] for link in check(page + "\n", fixes=False).data()["links"]]


@pytest.mark.parametrize(
    "page",
    [
        r"The piston is at $x = l + r$ when $\theta=0$ and at $x = l-r$ when $\theta=180^\circ$.",
        r"It is $a = r\omega^2(1+\lambda)$ for $\theta=0$ and $a = -r\omega^2(1-\lambda)$ for"
        r" $\theta=180^\circ$.",
        "The force is $F = F_0$ for $t<0$ and $F = 2F_0$ for $t > 0$.",
        "Die Kraft ist $F = k x$ für $x < a$ und $F = k a$ für $x > a$.",
        "La force vaut $F = kx$ pour $x<a$ et $F = ka$ pour $x > a$.",
        r"Some write $\lambda = r/l$, others $\lambda = l/r$; we take $\lambda=r/l$.",
        r"We write $\lambda = r/l$. Andere schreiben $\lambda = l/r$.",
        "Here λ = r/l.\n\n## Other authors\n\nHere λ = l/r.",
        PATH
        + r"Now let $x$ be the distance from the crankshaft, $x = r\cos\theta + l$. At bottom dead centre"
        " $x = l-r$.",
    ],
)
def test_two_cases_of_a_letter_are_not_accused(page):
    assert not {*ACCUSED} & {*words_of(page)}


@pytest.mark.parametrize(
    "page",
    [
        PATH
        + r"Now let $x$ be the distance from the crankshaft, $x = r\cos\theta + l$. At bottom dead centre"
        " $x = 2r$.",
        WEG
        + r"Sei nun $x$ der Abstand von der Kurbelwelle, $x = r\cos\theta + l$. Im unteren Totpunkt ist"
        " $x = 2r$.",
        "The force is $F = k x$ when $x>0$. Then $F = 2kx$ also.",
        r"We write $\lambda = r/l$. For our engine $\lambda = l/r$.",
        r"The force is $F = m r\omega^2\cos\theta$. Now $F$ is $F = m r \omega^2\sin\theta$.",
    ],
)
def test_what_is_wrong_of_the_letter_as_it_is_said_last_is_refuted(page):
    assert words_of(page)[-1] in ACCUSED


def test_what_a_letter_was_in_the_section_before_proves_nothing_of_it():
    page = (
        "## Period\n\nThe period is $T = 2\\pi/\\omega$.\n\n## Energy\n\n"
        "Here $T$ is the kinetic energy, $T = \\frac12J\\omega^2$. So $T\\omega = 2\\pi$."
    )
    assert words_of(page)[-1] not in ("holds", "holds_to_order", "conditional")
