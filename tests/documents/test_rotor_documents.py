"""What rotors' results say in print and to programs: published figures, verdicts, what is not known."""

from __future__ import annotations

import json
import pickle

import numpy as np
import pytest

import symbalance as sb

STEEL = sb.crankshaft.Material(211e9, 211 / (2 * 81.2) - 1, 7810)
RPM = np.pi / 30


def friswell_disc(diameter: float) -> sb.crankshaft.Disc:
    mass = 7810 * np.pi / 4 * (diameter**2 - 0.05**2) * 0.07
    polar = mass * (diameter**2 + 0.05**2) / 8
    return sb.crankshaft.Disc(mass, polar, polar / 2 + mass * 0.07**2 / 12)


def two_discs():
    """Return the rotor of Friswell and others, Dynamics of Rotating Machines (2010), example 5.9.1."""
    discs = {0.5: friswell_disc(0.28), 1.0: friswell_disc(0.35)}
    return sb.crankshaft.rotor.shaft(
        [sb.crankshaft.rotor.Tube(1.5, 0.05, elements=6)], discs, (0.0, 1.5), STEEL
    )


def rows_of(result, first: str) -> list[list[str]]:
    """Return the rows of a result's table in Markdown whose first head is `first`."""
    lines = iter(sb.to_markdown(result).splitlines())
    next(line for line in lines if line.startswith(f"| {first} |"))
    next(lines)
    rows = []
    for line in lines:
        if not line.startswith("|"):
            break
        rows.append([cell.strip() for cell in line.strip("|").split("|")])
    return rows


def test_published_frequencies_are_printed() -> None:
    """Example 5.9.4 of the book: supports of 1 MN/m with 3 kN s/m at 4000 rpm, Hz."""
    whirl = sb.crankshaft.rotor.whirl(
        two_discs(), [sb.crankshaft.rotor.Support(1e6, 3e3)] * 2, 4000 * RPM
    )
    rows = rows_of(whirl, "mode")
    assert [round(float(row[1]), 2) for row in rows[:6]] == [13.68, 14.07, 41.98, 50.65, 104.25, 105.66]
    assert [float(row[2]) for row in rows[:6]] == pytest.approx(
        [13.70, 14.09, 43.61, 52.18, 122.37, 149.81], abs=6e-3
    )
    assert "Whirl at 4000 rpm" in sb.to_text(whirl)
    assert "Stable: nothing grows." in sb.to_text(whirl)


def test_an_unstable_rotor_says_so_in_every_medium() -> None:
    crossed = sb.crankshaft.rotor.whirl(
        two_discs(), [sb.crankshaft.rotor.Support([[1e6, 5e5], [0, 1e6]])] * 2, 4000 * RPM
    )
    flat = sb.crankshaft.rotor.shaft(
        [sb.crankshaft.rotor.Tube(1.0, 0.03, bending=(1.0, 0.8))],
        {0.5: sb.crankshaft.Disc(5.0, 0.02, 0.01)},
        (0.0, 1.0),
        STEEL,
    )
    speeds = np.linspace(100.0, 500.0, 41)
    lines = sb.crankshaft.rotor.campbell(
        flat, [*speeds], sb.crankshaft.rotor.bearing_springs(flat, 1e9, axial=1e9), count=4
    )
    assert lines.unstable.any()
    assert not lines.unstable[0].any()
    for result in (crossed, lines):
        for write in (sb.to_text, sb.to_latex, sb.to_html, sb.to_markdown):
            assert "Unstable" in write(result)
    assert json.loads(sb.to_json(crossed))["stable"] is False
    growing = [float(speed) for speed in speeds[lines.unstable.any(axis=1)]]
    said = " ".join(sb.to_text(lines).split())
    assert all(f"{speed / RPM:.6g} rpm" in said for speed in growing)
    assert "Growth, 1/s" in said


def test_supports_that_depend_on_the_speed_are_said_to() -> None:
    rotor, even = two_discs(), [sb.crankshaft.rotor.Support(1e6)] * 2
    given = sb.crankshaft.rotor.critical_speeds(rotor, even, most=600.0)
    function = sb.crankshaft.rotor.critical_speeds(rotor, lambda omega: even, most=600.0)
    assert "a function of the speed" in sb.to_text(function)
    assert "a function of the speed" not in sb.to_text(given)
    assert (given.data()["supports"] is None, function.data()["supports"]) == (False, None)
    assert pickle.loads(pickle.dumps(function)).data() == function.data()
    assert [row["whirl"] for row in given.records()[:4]] == ["backward", "forward"] * 2
    assert len(given) == len(given.records()) == len(rows_of(given, "number"))


def test_cross_terms_of_supports_are_printed_where_there_are_any() -> None:
    rotor = two_discs()
    plain, crossed = (
        sb.to_markdown(sb.crankshaft.rotor.whirl(rotor, [sb.crankshaft.rotor.Support(k)] * 2, 100.0))
        for k in (1e6, [[1e6, 5e5], [0, 1e6]])
    )
    assert "500000" in crossed
    assert "vl" in crossed.split("bearing")[1].splitlines()[0]
    assert "K_{\\mathrm{vl}}" not in plain


def test_an_answer_to_unbalance_is_printed_in_micrometres_and_degrees() -> None:
    """Jeffcott's rotor at twice its critical speed: 4/3 of the eccentricity, opposite the unbalance."""
    light = sb.crankshaft.Material(density=1e-3)
    rotor = sb.crankshaft.rotor.shaft(
        [sb.crankshaft.rotor.Tube(1.0, 0.09)],
        {0.5: sb.crankshaft.Disc(20.0, 0.4, 0.2)},
        (0.0, 1.0),
        light,
    )
    rigid = [sb.crankshaft.rotor.Support(1e13)] * 2
    critical = float(sb.crankshaft.rotor.critical_speeds(rotor, rigid).speeds[0])
    answer = sb.crankshaft.rotor.unbalance_response(rotor, rigid, {0.5: 20.0 * 1e-3}, [2 * critical])
    (row,) = rows_of(answer, "rpm")
    assert [float(row[i].replace("−", "-")) for i in (1, 2, 3)] == pytest.approx([0.5, 1333, 1333])
    assert abs(float(row[4].replace("−", "-"))) == 180
    record = max(answer.records(), key=lambda each: each["largest"])
    assert (record["place"], record["largest"]) == pytest.approx((0.5, 4 / 3 * 1e-3))
    many = sb.crankshaft.rotor.unbalance_response(
        rotor, rigid, {0.5: 0.02}, [*np.linspace(0.1, 0.9, 30) * critical]
    )
    assert "Every node" in sb.to_text(answer)
    assert "Every node" not in sb.to_text(many)
    assert len(many.records()) == 30 * len(rotor.points)


def test_modes_are_given_with_their_shapes() -> None:
    rotor = two_discs()
    modes = sb.crankshaft.rotor.natural_modes(rotor, 6)
    data = json.loads(sb.to_json(modes))
    shapes = np.array([mode["shape"] for mode in data["modes"]])
    assert shapes.shape == (6, len(rotor.points), 6)
    flat = shapes.reshape(6, -1)
    squares = np.einsum("ki,ij,kj->k", flat, rotor.stiffness, flat)
    assert np.sqrt(squares) / (2 * np.pi) == pytest.approx([m["hertz"] for m in data["modes"]], rel=1e-6)
    shares = ("bending_u", "bending_v", "axial", "torsion")
    for mode in data["modes"]:
        assert sum(mode[name] for name in shares) == pytest.approx(1)
        assert mode["mostly"].lower().replace(" ", "_") == max(shares, key=lambda name, m=mode: m[name])
    held = sb.crankshaft.rotor.natural_modes(
        rotor, 6, sb.crankshaft.rotor.bearing_springs(rotor, 1e6, axial=1e6)
    )
    assert "free" in sb.to_text(modes)
    assert "on a given stiffness" in sb.to_text(held)


def test_a_chain_of_two_discs_turns_against_itself() -> None:
    chain = sb.crankshaft.rotor.torsional_chain([2.0, 1.0], [6.0])
    (mode,) = rows_of(chain, "mode")
    assert float(mode[1]) == pytest.approx(3 / (2 * np.pi), rel=1e-4)
    assert [row[1].replace("−", "-") for row in rows_of(chain, "disc")] == ["-0.5000", "1.0000"]
