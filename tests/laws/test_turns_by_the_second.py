"""Speeds in revolutions per second: N = 50 rev/s turns by 2π N radians per second, and is 3000 rpm."""

import re

import pytest

from tests.checked_pages import in_displays, last_verdict

PROVED = ("holds", "holds_to_order", "conditional")
_UNIT = re.compile(r" (rev/s|rps|U/s|tr/s|rpm|rad/s|m/s|mm)\b")


@pytest.mark.parametrize("unit", ["rev/s", "rps", "U/s", "tr/s"])
@pytest.mark.parametrize("is_typeset", [True, False])
@pytest.mark.parametrize(
    ("claim", "right", "wrong"),
    [
        (["N = 50 {u}", "ω = 2 π N = {x} rad/s"], "314.2", "324.1"),
        (["N = 50 {u}", "s = 80 mm", "v = 2 s N = {x} m/s"], "8.0", "4.0"),
        (["3000 rpm = {x} {u}"], "50", "60"),
        (["2 π 50 {u} = {x} rad/s"], "314.2", "341.2"),
        (["n = 3000 rpm = {x} {u}"], "50", "55"),
        (["ω = 314.2 rad/s = {x} {u}"], "50.0", "55.0"),
    ],
)
def test_turns_by_the_second(tmp_path, unit, is_typeset, claim, right, wrong):
    def verdict(number: str) -> str:
        lines = [line.replace("{u}", unit).replace("{x}", number) for line in claim]
        if is_typeset:
            lines = [_UNIT.sub(r"\\,\\mathrm{\1}", line) for line in lines]
            return last_verdict(tmp_path, in_displays(lines))
        return last_verdict(tmp_path, "\n\n".join(lines))

    assert verdict(right) in PROVED
    assert verdict(wrong) == "refuted"
