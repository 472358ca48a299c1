"""Sizes of the crank train: given in any way, the engine is the same, within what geometry allows."""

from __future__ import annotations

import tomllib
from fractions import Fraction

import pytest

import symbalance as sb
from symbalance.engine.crank_train import CrankTrain
from symbalance.engine.engine_file import parse_engine
from symbalance.errors import SymbalanceError

THREE = """
[layout]
firing_order = [1, 3, 2]
"""


def engine(sizes: str) -> sb.Engine:
    return parse_engine(f'name = "three"\n[crank_train]\n{sizes}\n{THREE}', "three.toml")


def shaking(of: sb.Engine) -> list[dict[str, object]]:
    return [*sb.balance(of, 6).records(), *sb.inertia_torque(of, 6).records()]


@pytest.mark.parametrize(("stroke", "rod"), [("86.4", "151.2"), ("80", "140"), ("70", "189/2")])
@pytest.mark.parametrize("offset", ["0", "6.5", "-3"])
def test_a_ratio_beside_a_stroke_is_a_rod(stroke: str, rod: str, offset: str) -> None:
    """lambda = l/r = 2 l/s: the ratio and the stroke say what the stroke and the rod say."""
    ratio = Fraction(rod) / (Fraction(stroke) / 2)
    aside = f"offset = {offset}" if offset != "0" else ""
    by_rod = engine(f'stroke = {stroke}\nrod = "{rod}"\n{aside}')
    by_ratio = engine(f"stroke = {stroke}\nrod = 300\n{aside}").with_ratio(ratio)
    assert by_rod.cylinders[0].ratio == by_ratio.cylinders[0].ratio == ratio
    assert by_rod.cylinders[0].mechanism == by_ratio.cylinders[0].mechanism
    assert shaking(by_rod) == shaking(by_ratio)
    written = parse_engine(sb.engine.engine_text(by_ratio), "again.toml")
    assert written.cylinders[0].mechanism == by_rod.cylinders[0].mechanism
    assert written.cylinders[0].sizes.rod == Fraction(rod)
    assert written.cylinders[0].stroke == Fraction(stroke)


def test_a_cylinder_of_its_own_length_ends_the_shared_ratio() -> None:
    """What a cylinder says of its stroke or rod counts for it alone; the others keep what they share."""
    shared = CrankTrain(stroke=Fraction(80), given_ratio=Fraction(4))
    assert shared.overridden(CrankTrain(rod=Fraction(150))).ratio == Fraction(150, 40)
    assert shared.overridden(CrankTrain(stroke=Fraction(90))).ratio is None
    assert shared.overridden(CrankTrain(offset=Fraction(2))).ratio == 4
    both = CrankTrain(stroke=Fraction(80), rod=Fraction(150))
    assert both.overridden(CrankTrain(stroke=Fraction(75))).ratio == 4
    assert both.overridden(CrankTrain(rod=Fraction(120))).ratio == 3


@pytest.mark.parametrize("side", [1, -1])
def test_an_offset_reaches_as_far_as_the_crank_can_turn(side: int) -> None:
    """With the pin as far aside as it goes, the rod must still reach: |e| < l - r."""
    stroke, rod = 80, 130
    most = rod - stroke // 2
    inside = engine(f'stroke = {stroke}\nrod = {rod}\noffset = "{side * (most - Fraction(1, 1000))}"')
    assert inside.cylinders[0].mechanism.offset == Fraction(side * (most * 1000 - 1), 40_000)  # type: ignore[union-attr]
    for aside in (most, most + 1):
        with pytest.raises(SymbalanceError, match=f"{most} mm"):
            engine(f"stroke = {stroke}\nrod = {rod}\noffset = {side * aside}")


@pytest.mark.spread("r-985", "vw-vr6", "v8-90")
@pytest.mark.parametrize("name", [row["name"] for row in sb.presets().records()])
def test_a_written_engine_is_the_same_and_says_nothing_twice(name: str) -> None:
    """Reading what is written gives the engine back; a cylinder repeats no size that all share."""
    first = sb.load(name)
    text = sb.engine.engine_text(first)
    again = parse_engine(text, "again.toml")
    assert again.cylinders == first.cylinders
    assert [c.mechanism for c in again.cylinders] == [c.mechanism for c in first.cylinders]
    assert (again.pitch, again.balancers, again.strokes) == (first.pitch, first.balancers, first.strokes)
    assert sb.engine.engine_text(again) == text
    file = tomllib.loads(text)
    shared = {key: value for key, value in file.get("crank_train", {}).items() if key != "pitch"}
    for row in file["cylinder"]:
        if "link" not in str(row):
            assert not {(key, row.get(key)) for key in shared} & set(shared.items())
