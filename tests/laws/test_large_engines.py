"""Work grows with the number of cylinders and no faster, counted in calls; and large results are right.

Twice the cylinders may take 2.3 times the calls: 2, and room for what grows with its logarithm.
"""

from __future__ import annotations

import re
from cmath import rect
from collections.abc import Callable
from fractions import Fraction
from math import pi
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp

import symbalance as sb
from symbalance.codegen import plan_for
from symbalance.codegen.targets import files
from symbalance.design.variations.annular_sectors import AnnularSector, largest_sum
from symbalance.engine.engine_document import firing
from symbalance.exact.phasor import Phasor, amplitude_sum
from symbalance.exact.spectrum import Component
from tests.effort import effort

MOST_GROWTH = 2.3
COUNT = 120


def uneven(count: int) -> sb.Engine:
    """Throws in sevenths of a degree, no two alike."""
    chance = Random(1)
    throws = [Fraction(k, 7) for k in chance.sample(range(2520), count)]
    return sb.Engine([shared(i + 1, throw=str(t), station=-i) for i, t in enumerate(throws)], pitch=100)


def unlike(count: int) -> sb.Engine:
    """No two masses or strokes alike, all in one plane."""
    chance = Random(2)
    sizes = [(Fraction(chance.randrange(500, 700), 1000), 80 + Fraction(i, 50)) for i in range(count)]
    return sb.Engine(
        [
            shared(i + 1, throw=7 * i % 360, station=-i, reciprocating_mass=mass, stroke=stroke)
            for i, (mass, stroke) in enumerate(sizes)
        ],
        pitch=100,
    )


def linked(count: int) -> sb.Engine:
    """Pairs of a master and a link rod, all pairs alike but for their throws."""
    cylinders = []
    for i in range(0, count, 2):
        throw = 11 * i % 360
        cylinders.append(shared(i + 1, throw=throw, station=-i))
        link = sb.engine.Link(i + 1, 45, 40)
        sizes = {"stroke": None, "rod": 100, "link": link}
        cylinders.append(shared(i + 2, throw=throw, bank=45, station=-i, **sizes))
    return sb.Engine(cylinders, pitch=100)


def shared(number: int, **own: object) -> sb.Cylinder:
    """Return a cylinder of usual sizes."""
    sizes = {"stroke": 80, "rod": 140, "reciprocating_mass": "0.6", "rotating_mass": "0.5"}
    present = {key: value for key, value in (sizes | own).items() if value is not None}
    return sb.Cylinder(number, **present)  # type: ignore[arg-type]


def emitted(engine: sb.Engine) -> object:
    """Return the engine's force as a source."""
    plan = plan_for(sb.balance(engine, 1), None, ["force.vertical"], "numpy", 0.0, 1)
    return files(plan, "numpy", engine.name, "engine", grid=False)


WORK: dict[str, Callable[[sb.Engine], object]] = {
    "balance as text": lambda e: sb.to_text(sb.balance(e)),
    "balance as JSON": lambda e: sb.to_json(sb.balance(e)),
    "balance as HTML": lambda e: sb.to_html(sb.balance(e)),
    "torque as JSON": lambda e: sb.to_json(sb.inertia_torque(e)),
    "design as JSON": lambda e: sb.to_json(sb.design_balance(e)),
    "sensitivities as text": lambda e: sb.to_text(sb.sensitivities(e)),
    "worst cases": lambda e: sb.worst_cases(
        e, sb.design.Tolerances(mass="1%", throw="0.1"), of=["vertical"]
    ),
    "source": emitted,
}


CASES = [(work, family) for work in WORK for family in (uneven, unlike, linked)]


@pytest.mark.slow
@pytest.mark.parametrize(("work", "family"), CASES)
def test_twice_the_cylinders_take_twice_the_calls(work: str, family: Callable[[int], sb.Engine]) -> None:
    WORK[work](family(6))  # imports, and tables that all engines share
    once, twice = (effort(lambda count=count: WORK[work](family(count))) for count in (COUNT, 2 * COUNT))
    assert twice < MOST_GROWTH * once, f"{once} calls, then {twice}"


@pytest.mark.slow
@pytest.mark.parametrize("terms", [101, 180])
def test_long_numbers_are_written_as_what_they_are(terms: int) -> None:
    """The text is read by the terms of its own grammar, and added up in decimals."""
    chance = Random(terms)
    exponents = chance.sample(range(2520), terms)
    number = Phasor.of(2520, {k: chance.randrange(1, 9) for k in exponents})
    long = Component(number)
    assert long.is_long
    texts = long.form("cos").spelling, long.form("sin").spelling
    with mp.workdps(40):
        true = mp.fsum(c * mp.expjpi(mp.mpf(2 * k) / 2520) for k, c in number.terms.items())
        for text, value in zip(texts, (true.real, true.imag), strict=True):
            assert abs(_cosines(text) - value) < mp.mpf(10) ** -35
        amplitude = re.fullmatch(
            r"sqrt\(\((.*)\)\*\*2 \+ \((.*)\)\*\*2\)", long.form("amplitude").spelling
        )
        assert amplitude
        assert amplitude.groups() == texts
    assert long.form("phase").spelling == f"atan2({texts[1]}, {texts[0]})"


def _cosines(text: str) -> mp.mpf:
    """Return a sum of rational multiples of roots, cosines and sines of fractions of pi, no more."""
    signs = 0
    for place, sign in enumerate(text):  # a plus or a minus within brackets parts no terms
        signs += {"(": 1, ")": -1}.get(sign, 0)
        if signs == 0 and text[place : place + 3] in (" + ", " - "):
            first, rest = text[:place], text[place + 3 :]
            return _cosines(first) + _cosines(rest if text[place + 1] == "+" else _negative(rest))
    parts = re.fullmatch(r"(-?)(?:(\d+)(?:\*|(?=/|$)))?(?:(cos|sin|sqrt)\((.*)\))?(?:/(\d+))?", text)
    assert parts, text
    sign, above, function, inside, below = parts.groups()
    factor = (-1 if sign else 1) * mp.mpf(above or 1) / int(below or 1)
    if function == "sqrt":
        return factor * mp.sqrt(_cosines(inside))
    if function is None:
        return factor
    angle = re.fullmatch(r"(?:(\d+)\*)?pi(?:/(\d+))?", inside)
    assert angle, inside
    turns = mp.mpf(angle[1] or 1) / int(angle[2] or 1)
    return factor * (mp.cospi if function == "cos" else mp.sinpi)(turns)


def _negative(text: str) -> str:
    return text[1:] if text.startswith("-") else f"-{text}"


@pytest.mark.slow
@given(st.lists(st.tuples(st.integers(0, 23), st.integers(-4, 4)), min_size=1, max_size=9))
def test_numbers_added_at_once_are_their_sum(parts: list[tuple[int, int]]) -> None:
    numbers = [Phasor.root(Fraction(k, 24)).scaled(c) for k, c in parts]
    assert amplitude_sum(numbers) == sum(numbers[1:], numbers[0])


@pytest.mark.slow
@pytest.mark.parametrize("spread", [True, False])
def test_the_largest_of_many_sectors_is_the_highest_support(spread: bool) -> None:
    """Evenly spread all directions are as good; else the best is looked for among many."""
    chance, count = Random(3), 200
    sectors = [
        AnnularSector(-1.0, 1.0, pi * i / count)
        if spread
        else AnnularSector(chance.uniform(-1, 1), chance.uniform(1, 2), chance.uniform(0, 6.2), 0.02)
        for i in range(count)
    ]
    best = largest_sum(sectors).value
    phis = [2 * pi * i / 2000 for i in range(2000)]
    highest = max(sum(_support(sector, phi) for sector in sectors) for phi in phis)
    assert highest <= best * (1 + 1e-12)
    assert best <= highest * (1 + 1e-5)


def _support(sector: AnnularSector, phi: float) -> float:
    """Return the largest part along a direction, over the sector's corners and an arc between them."""
    sides = [sector.half * i / 4 for i in range(-4, 5)] if sector.half else [0.0]
    return max(
        (weight * rect(1, sector.angle + side - phi)).real
        for weight in (sector.low, sector.high)
        for side in sides
    )


@pytest.mark.slow
@given(st.lists(st.integers(1, 3), min_size=1, max_size=8), st.integers(1, 3))
def test_firing_intervals_are_given_to_their_period(gaps: list[int], repeats: int) -> None:
    """The period printed is the least that explains all intervals, found by trying each."""
    cycle = gaps * repeats
    unit = Fraction(720, sum(cycle))
    count = len(cycle)
    engine = sb.inline(
        "-".join(map(str, range(1, count + 1))), firing_intervals=[str(g * unit) for g in cycle]
    )
    period = next(k for k in range(1, count + 1) if all(cycle[i] == cycle[i % k] for i in range(count)))
    text = firing(engine)
    if len(set(cycle)) > 1:
        assert text.count("°") == period
        assert text.endswith("and so on") == (period < count)


@pytest.mark.slow
def test_what_no_page_holds_is_counted_and_in_the_json() -> None:
    engine = uneven(COUNT)
    text = sb.to_text(sb.balance(engine, 2))
    assert "exact forms fill a page: the JSON of this result has them" in text
    assert len(text) < 4000
    assert sb.to_json(sb.balance(engine, 2)).count("cos(") > 10 * COUNT


@pytest.mark.slow
def test_many_cylinders_in_all_directions_are_refused_with_the_figure() -> None:
    tolerances = sb.design.Tolerances(mass="1%", bank="0.1")
    with pytest.raises(sb.SymbalanceError, match=r"300 cylinders and 6 searches .* are 1800 together"):
        sb.worst_cases(uneven(300), tolerances)
