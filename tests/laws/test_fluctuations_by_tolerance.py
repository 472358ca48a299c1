"""A coefficient of fluctuation is twice the tolerance of the speed to each side."""

import pytest

from tests.checked_pages import verdicts_in


@pytest.mark.parametrize(
    "page",
    [
        r"The coefficient of fluctuation of speed is $C_s = (\omega_1-\omega_2)/\omega$; for $\pm0.5\%$"
        r" it is $C_s = {}$.",
        r"The speed must stay within ± 0.5 %, so the coefficient of fluctuation of speed is $C_s = {}$.",
        r"Die Drehzahl darf um ± 0,5 % schwanken, der Ungleichförmigkeitsgrad ist also $\delta = {}$.",
        r"La vitesse peut varier de ± 0,5 %, donc le coefficient d'irrégularité est $\delta = {}$.",
    ],
)
def test_a_tolerance_is_half_of_the_fluctuation(page):
    assert verdicts_in(page.replace("{}", "0.01"))[-1] == "conditional"
    assert verdicts_in(page.replace("{}", "0.005"))[-1] == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        r"The coefficient of fluctuation is $C_s = (\omega_1-\omega_2)/(2\omega)$; for $\pm0.5\%$"
        r" $C_s = 0.005$.",
        r"The damping ratio is known to ± 0.5 %, and $\zeta = 0.005$.",
        r"The total fluctuation of ± 0.25 %, the coefficient of fluctuation, is $C_s = 0.0025$.",
    ],
)
def test_half_of_it_by_another_definition_is_not_refuted(page):
    assert verdicts_in(page)[-1] != "refuted"
