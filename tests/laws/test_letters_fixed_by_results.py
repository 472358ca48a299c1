"""One result fixes the one letter that has no value; ω is that of the speed in turns, if there is one."""

import pytest

import symbalance as sb


@pytest.mark.parametrize(("stress", "is_wrong"), [("0.793", False), ("7.93", True)])
def test_a_result_fixes_the_one_letter_without_a_value(stress, is_wrong):
    """What is computed with it later is judged."""
    page = (
        "The rim has $R_a = 0.32$ m and $\\rho = 7850$ kg/m³. There $u = R_a \\omega = 10.05$ m/s.\n\n"
        f"So $\\sigma = \\rho u^2 = {stress}$ MPa.\n"
    )
    links = sb.check(page, {}).data()["links"]
    assert [link["verdict"] for link in links][-3] in ("premise", "definition")
    assert (links[-1]["verdict"] in ("refuted", "contradiction")) is is_wrong


@pytest.mark.parametrize(("power", "verdict"), [("254.8", "conditional"), ("245", "undecided")])
def test_an_angular_speed_is_that_of_the_turns(power, verdict):
    page = f"$T = 811$ N m at $n = 3000$ rpm.\n\n$P = T\\omega = {power}$ kW\n"
    last = sb.check(page, {}).data()["links"][-1]
    assert last["verdict"] == verdict
    assert "ω = 2π n" in (last["assumption"] or last["reason"])
