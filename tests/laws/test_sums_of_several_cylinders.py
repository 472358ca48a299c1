"""What forces of several cylinders add up to is no single one's; λ/4 is no acceleration's A_2."""

import pytest

from tests.checked_pages import last_in

ENGINES = {
    "en": (
        "In a straight four the cranks are at 0°, 180°, 180°, 0°. Each cylinder has the reciprocating "
        "mass $m$, and $\\lambda = r/l$. The secondary forces add up to ",
        "4",
    ),
    "twin": (
        "In a parallel twin whose pins stand side by side (360°) the primary forces of both cylinders "
        "sum to ",
        "2",
    ),
    "de": (
        "Im Reihenvierzylinder mit den Kurbeln bei 0°, 180°, 180°, 0° hat jeder Zylinder die "
        "oszillierende Masse $m$. Die Kräfte zweiter Ordnung addieren sich zu ",
        "4",
    ),
    "fr": (
        "Dans un quatre cylindres en ligne (manivelles à 0°, 180°, 180°, 0°), chaque cylindre a la "
        "masse alternative $m$. Les forces du second ordre s'ajoutent : ",
        "4",
    ),
    "ja": (
        "直列4気筒機関のクランクは 0°、180°、180°、0° にある。1気筒の往復質量を $m$ とする。"
        "不つりあいの二次慣性力は ",
        "4",
    ),
}


@pytest.mark.parametrize("engine", ENGINES.values(), ids=ENGINES)
def test_one_cylinders_force_is_not_the_sum(engine):
    words, count = engine
    order = "1" if "primary" in words else "2"
    force = "m r\\omega^2\\cos\\theta" if order == "1" else "\\lambda m r\\omega^2\\cos 2\\theta"
    assert last_in(f"{words}$F_{order} = {force}$.") == "refuted"
    assert last_in(f"{words}$F_{order} = {count} {force}$.") in ("conditional", "definition")


def test_a_coefficient_of_the_accelerations_series_is_divided_by_nothing():
    series = "$\\ddot x = r\\omega^2\\left(\\cos\\theta + A_2\\cos 2\\theta - A_4\\cos 4\\theta\\right)$"
    page = f"The piston acceleration is {series} with $\\lambda = r/l$. The coefficient is "
    assert last_in(page + "$A_2 = \\lambda + \\frac{\\lambda^3}{4}$.") == "conditional"
    assert last_in(page + "$A_2 = \\frac{\\lambda}{4} + \\frac{\\lambda^3}{16}$.") == "refuted"
    assert last_in(page + "$A_4 = \\frac{\\lambda^3}{4} + \\frac{3\\lambda^5}{16}$.") == "conditional"
    assert last_in(page + "$A_4 = \\frac{\\lambda^3}{64} + \\frac{3\\lambda^5}{256}$.") == "refuted"
