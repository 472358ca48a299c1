"""The V16 of INNIO's balancing tool against the forces and moments that the tool publishes.

Figures: github.com/miriam-innio/Balancing-tool-crankshaft, Balancing_HeatenV16.xlsm (throw angles) and
Tool_Results.xlsx (N and N mm at 1500 rpm, here to four places). The tool cuts a cylinder's series short;
its own coefficients are divided out, and it looks at whole degrees only, as is done here: what is
compared is exact but for rounding. "H" of a moment is about the horizontal axis: our vertical couple.
"""

from __future__ import annotations

import json
import re
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.engine.catalogue import preset_text
from symbalance.engine.engine_file import parse_engine
from symbalance.exact.spectrum import Spectrum

RADIUS, PITCH, LAMBDA = 0.06, 0.32, 60 / 411.5
FIRST = (11.93 + 9.86) * RADIUS * (1500 * np.pi / 30) ** 2
UNITS = {
    1: FIRST,
    2: FIRST * (LAMBDA + LAMBDA**3 / 4 + 15 / 128 * LAMBDA**5),
    4: FIRST * (LAMBDA**3 / 4 + 3 / 16 * LAMBDA**5),
    6: FIRST * 9 / 128 * LAMBDA**5,
}
"""m r omega^2 A_n in N, as the tool cuts A_n short."""
THROWS = {
    8207: (45, 247.5, 202.5, 90, 22.5, 270, 225, 67.5),
    8200: (45, 247.5, 202.5, 90, 270, 22.5, 67.5, 225),
    17118: (45, 202.5, 360, 247.5, 180, 67.5, 225, 22.5),
    17485: (45, 225, 180, 0, 247.5, 67.5, 382.5, 202.5),
    7005: (45, 202.5, 270, 90, 22.5, 225, 247.5, 67.5),
    27156: (45, 202.5, 337.5, 157.5, 270, 90, 225, 22.5),
}
ROTATING = {  # N mm
    **{8207: 2156752.6629, 8200: 5834618.1355, 17118: 2156752.6629},
    **{17485: 5421363.9186, 7005: 10896221.4764, 27156: 12311061.9516},
}
LATERAL_FORCE = {2: (34949.7025, 14476.6408), 6: (0.4575, 1.1044)}
"""N: of the first five cases, and of the last; there is no other force."""
MOMENTS = {  # N mm, by order: about the horizontal axis, about the vertical one
    8207: {
        1: (1226369.2097,) * 2,
        2: (1048491.0741, 5591952.3954),
        4: (32504.7242, 0),
        6: (13.7243, 73.1962),
    },
    8200: {1: (3317603.142,) * 2, 2: (1048491.0741, 0), 4: (0, 0), 6: (13.7243, 0)},
    17118: {1: (1226369.2097,) * 2, 2: (1048491.0741, 2316262.5223), 4: (0, 0), 6: (13.7243, 176.7113)},
    17485: {
        1: (3082687.1799,) * 2,
        2: (1048491.0741, 1918854.7015),
        4: (65009.4484, 0),
        6: (13.7243, 853.2376),
    },
    7005: {
        1: (6195676.5301,) * 2,
        2: (1048491.0741, 8023360.2033),
        4: (91895.2341, 0),
        6: (13.7243, 611.8896),
    },
    27156: {
        1: (7000296.1282,) * 2,
        2: (434299.2229, 6270369.9811),
        4: (48757.0863, 0),
        6: (33.1334, 228.4688),
    },
}
EITHER = pytest.mark.parametrize("case", THROWS)


def engine_text(case: int) -> str:
    """Return the preset's file with the throws of a case."""
    pins = f"pins = {list(THROWS[case])}"
    text, count = re.subn(r"(?m)^pins = .*$", pins, preset_text("innio-v16"))
    assert count == 1
    return text


def largest(of: Spectrum, order: int, component: str) -> float:
    """Return the largest amount of an order's component at whole degrees, in units F_n."""
    cos, sin = (float(part) for part in of.component(order, component).decimal(20))
    angles = order * np.deg2rad(np.arange(360))
    return float(np.max(np.abs(cos * np.cos(angles) + sin * np.sin(angles))))


def without_counterweights(case: int) -> sb.Engine:
    return parse_engine(engine_text(case).partition("[[counterweight]]")[0], "v16.toml")


def test_the_preset_is_case_8207() -> None:
    assert parse_engine(engine_text(8207), "v16.toml") == sb.load("innio-v16")


@EITHER
def test_forces_and_moments_of_the_pistons(case: int) -> None:
    left = sb.balance(without_counterweights(case), 6)
    for order, (horizontal, vertical) in MOMENTS[case].items():
        sideways = LATERAL_FORCE.get(order, (0, 0))[case == 27156]
        stated = ((left.couple, "vertical", horizontal), (left.couple, "lateral", vertical))
        for of, component, newton_mm in stated:
            ours = largest(of, order, component) * UNITS[order] * PITCH * 1000
            assert ours == pytest.approx(newton_mm, rel=1e-9, abs=6e-5), (order, component)
        assert largest(left.force, order, "lateral") * UNITS[order] == pytest.approx(
            sideways, rel=1e-9, abs=6e-5
        )
        assert largest(left.force, order, "vertical") == 0


@EITHER
def test_moment_of_what_rotates(case: int) -> None:
    """It turns with the crank against the pistons' moment: with counterweights the two are left."""
    pistons = sb.balance(without_counterweights(case), 1)[1].couple.forward.amplitude
    both = sb.balance(parse_engine(engine_text(case), "v16.toml"), 1)[1].couple
    left = ROTATING[case] / 1000 - float(pistons) * FIRST * PITCH
    assert float(both.forward.amplitude) * FIRST * PITCH == pytest.approx(abs(left), rel=1e-8)
    assert float(both.backward.amplitude) == 0


def test_counterweights_are_1966_thousandths_of_what_rotates() -> None:
    rotating = 2 * float(sb.load("innio-v16").first.rotating_mass or 0) * 60
    assert 4678.52 / rotating == pytest.approx(1.966355829461298, rel=1e-12)


SHARE_LEFT_OUT = {1: 0, 2: 1e-5, 4: 3e-3, 6: 3e-2}
"""By how much, relatively, the tool's short series may lie below the exact coefficients, by order."""


@EITHER
def test_the_command_says_the_published_newtons(
    case: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """`symbalance balance FILE --rpm 1500`: the published digits, with the tool's coefficients for ours.

    As they are, the exact ones lie above the tool's, by what its series leave out and no more.
    """
    file = tmp_path / "v16.toml"
    file.write_text(engine_text(case).partition("[[counterweight]]")[0], encoding="utf-8")
    assert run(["balance", str(file), "--rpm", "1500", "--order", "6", "--format", "json"]) == 0
    orders = {int(order["order"]): order for order in json.loads(capsys.readouterr().out)["orders"]}

    def largest_said(order: int, kind: str, component: str, unit: str) -> float:
        if order not in orders:
            return 0.0
        cos, sin = map(float, orders[order][kind][component][unit])
        angles = order * np.deg2rad(np.arange(360))
        return float(np.max(np.abs(cos * np.cos(angles) + sin * np.sin(angles))))

    for order, (horizontal, vertical) in MOMENTS[case].items():
        sideways = LATERAL_FORCE.get(order, (0, 0))[case == 27156]
        for kind, component, unit, scale, published in (
            ("couple", "vertical", "newton_metres", 1000, horizontal),
            ("couple", "lateral", "newton_metres", 1000, vertical),
            ("force", "lateral", "newtons", 1, sideways),
        ):
            said = scale * largest_said(order, kind, component, unit)
            if order in orders:
                exact = FIRST * abs(float(orders[order]["coefficient"]["value"]))
                tool = said * UNITS[order] / exact
                assert tool == pytest.approx(published, rel=1e-9, abs=6e-5), (order, component)
                assert 0 <= exact / UNITS[order] - 1 <= SHARE_LEFT_OUT[order] + 1e-12, order
            else:
                assert published == 0


@pytest.mark.slow
def test_the_search_betters_all_of_the_cases_in_couples() -> None:
    """Throws on the tool's grid, one bank 60 mm behind: some leave no couple of order 1 or 2."""
    from symbalance.search import search_cranks

    behind = "-3/16"
    places = [f"{7 - 2 * row}/2" if n == 0 else Fraction(behind) + Fraction(7 - 2 * row, 2)
              for row in range(8) for n in (0, 1)]  # fmt: skip
    result = search_cranks(
        16,
        banks=[45, -45],
        intervals="any",
        grid="22.5",
        stations=places,
        minimize=["couple.1", "couple.2"],
        require=["force.1=0"],
        limit=["couple.1<=1/2", "couple.2<=2"],
    )
    assert result.searched.cranks == 16**7
    (point,) = result.points
    assert all(point.stars[0].values[one].is_zero() for one in ("couple.1", "couple.2"))
    assert all(case[1][0] > 0 for case in MOMENTS.values())
