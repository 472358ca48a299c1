r"""Ratios of similar engines by a product in words, or in letters, of quantities that grow with k."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_in

_ENGINES = (
    r"One engine is $k$ times as large as the other. The displacements are as $\frac{V_2}{V_1} = k^3$, "
    r"the rotational speeds as $\frac{n_2}{n_1} = \frac{1}{k}$, and "
    r"the mean effective pressure is the same. "
    r"The power goes as pressure times displacement times speed, so $\frac{P_2}{P_1} = "
)
_KRAFT = (
    r"Alle Maße werden um den Faktor $k$ größer, die Drehzahl bleibt gleich. Die Masse wächst mit $k^3$, "
    r"der Radius mit $k$. Die Fliehkraft $m r\omega^2$ wächst also um $\frac{F'}{F} = "
)
_FORCE = (
    r"La pression reste constante. La surface croît avec $q^2$. "
    r"La force va comme la pression fois la surface, donc $\frac{F_2}{F_1} = "
)
_MASS = (
    r"The mass grows with $k^3$ and the radius with $k$; the speed falls with $1/k$. "
    r"The force $m r \omega^2$ then changes by $\frac{F_2}{F_1} = "
)
WRONG = [
    *(_ENGINES + f"{power}$." for power in ("k^3", "k^4", "k", r"\frac{1}{k^2}")),
    *(_KRAFT + f"{power}$." for power in ("k^3", "k^2", "k^5")),
    _FORCE + "q$.",
    _FORCE + "q^3$.",
    _MASS + "k^4$.",
    _MASS + "k^3$.",
]
RIGHT = [
    _ENGINES + "k^2$.",
    _KRAFT + "k^4$.",
    _FORCE + "q^2$.",
    _MASS + "k^2$.",
    _ENGINES.replace("The power goes", "The power per unit of mass goes") + "k^3$.",
    _KRAFT.replace("wächst also", "gibt am Hebelarm $k$ ein Moment; das wächst also") + "k^5$.",
    _ENGINES.replace("and the mean effective pressure is the same", "and so on") + "k^3$.",
    _MASS.replace(
        "The mass grows with $k^3$", "One mass grows with $k^3$, the mass of the other with $k$"
    )
    + "k^3$.",
]


@pytest.mark.parametrize("page", WRONG)
def test_another_power_than_the_product_gives_is_refuted(page):
    assert last_in(page) == "refuted"


@pytest.mark.parametrize("page", RIGHT)
def test_the_right_power_and_other_quantities_are_not_accused(page):
    assert last_in(page) not in ("refuted", "contradiction")
