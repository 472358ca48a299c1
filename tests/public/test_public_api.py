"""The public names: all there, loaded on first use, documented, and what the interface says they are."""

import pickle
import subprocess
import sys

import numpy as np
import pytest
import sympy

import symbalance as sb


@pytest.mark.parametrize("name", sb.__all__)
def test_every_public_name_loads_and_is_documented(name):
    value = getattr(sb, name)
    assert name in dir(sb)
    assert isinstance(value, str) or value.__doc__


def test_every_room_loads_on_first_use():
    """In a process of its own: any import elsewhere would have loaded the room already."""
    code = "import symbalance as sb; print(sb.kinematics.SliderCrank(4), sb.exact.Component.__name__)"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ran.stdout == "SliderCrank(ratio=Fraction(4, 1), offset=Fraction(0, 1)) Component\n"


def test_unknown_names_are_refused():
    with pytest.raises(AttributeError, match="no attribute 'ballance'"):
        _ = sb.ballance  # type: ignore[attr-defined]


def test_no_public_name_is_hidden_by_a_module():
    """`import symbalance.x` binds the module as an attribute, over a function of the same name."""
    from pathlib import Path

    modules = {path.stem for path in Path(sb.__file__).parent.iterdir()}
    assert not modules & {*sb.__all__}


def test_absent_orders_say_so():
    balanced = sb.balance(sb.load("inline-6"))
    assert [order.order for order in balanced.orders] == [6, 12]
    with pytest.raises(KeyError, match="order 2 is absent"):
        _ = balanced[2]


def test_reference_plane_moves_the_couple_by_the_force():
    four = sb.load("inline-4")
    about_front = sb.balance(four, order=2, reference="3/2")
    assert about_front[2].couple.vertical.cos == -6
    assert '"reference_plane": "station 3/2"' in sb.to_json(about_front)


def test_function_is_picklable_and_keeps_shapes():
    result = sb.balance(sb.load("v8-90"))
    made = sb.to_function(result, ratio="7/2", outputs=("force.vertical", "couple.lateral"))
    again = pickle.loads(pickle.dumps(made))
    theta = np.linspace(-7, 7, 24).reshape(2, 3, 4)
    for name, values in again(theta, mass=0.5, radius=0.04, omega=300, pitch=0.1).items():
        assert values.shape == theta.shape
        assert (values == made(theta, mass=0.5, radius=0.04, omega=300, pitch=0.1)[name]).all()
    assert np.isscalar(sb.to_function(result)(0.1).item())


def test_function_holds_only_surviving_orders():
    made = sb.to_function(sb.balance(sb.load("v12-60")))
    assert made.orders == {"force.vertical": ("6", "12")}
    assert "cos^2" in made.source  # a polynomial in cos 6 theta
    assert "cos^3" not in made.source
    assert "LATERAL" not in made.source
    assert sb.to_function(sb.balance(sb.load("v12-60")), outputs="force.lateral")(1.0) == 0


def test_function_against_the_exact_kinematics():
    """Piston by piston, from the closed form of the second derivative, with no series at all."""
    layout, lam, theta = sb.load("v6-90"), 3.2, np.linspace(0, 4 * np.pi, 257)
    vertical, couple = np.zeros_like(theta), np.zeros_like(theta)
    for cylinder in layout.cylinders:
        own = theta + 2 * np.pi * float((cylinder.throw - cylinder.bank).turns)
        sine, cosine, root = np.sin(own), np.cos(own), np.sqrt(lam**2 - np.sin(own) ** 2)
        push = cosine + (cosine**2 - sine**2) / root + (sine * cosine) ** 2 / root**3
        bank = 2 * np.pi * float(cylinder.bank.turns)
        vertical += push * np.cos(bank)
        couple += push * np.sin(bank) * float(cylinder.station)
    made = sb.to_function(
        sb.balance(layout, order=40), ratio=lam, outputs=("force.vertical", "couple.lateral")
    )(theta, mass=2.0, radius=0.5, omega=3.0, pitch=0.25)
    assert np.allclose(made["force.vertical"], 9 * vertical, rtol=0, atol=1e-13)
    assert np.allclose(made["couple.lateral"], 9 * 0.25 * couple, rtol=0, atol=1e-13)


def test_non_finite_angles_give_nan_there_only():
    values = sb.to_function(sb.balance(sb.load("inline-4")))([0.0, np.nan, np.inf, 1.0])
    assert np.isnan(values).tolist() == [False, True, True, False]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"outputs": "force.up"}, "force.vertical"),
        ({"outputs": ()}, "no output"),
        ({"target": "fortran"}, "numpy"),
        ({"ratio": 0.5}, "longer"),
    ],
)
def test_functions_refuse_what_they_cannot_be(arguments, words):
    with pytest.raises(sb.SymbalanceError, match=words):
        sb.to_function(sb.balance(sb.load("inline-4")), **arguments)


def test_function_needs_a_ratio_and_numbers():
    with pytest.raises(sb.SymbalanceError, match="no rod ratio"):
        sb.to_function(sb.balance(sb.inline("1-3-4-2")))
    twin = sb.balance(sb.vee(sympy.Symbol("alpha"), pins=[0]), ratio=4)
    with pytest.raises(sb.SymbalanceError, match="symbols"):
        sb.to_function(twin)


def test_symbols_print_everywhere():
    twin = sb.balance(sb.vee(sympy.Symbol("alpha"), pins=[0]), order=2, ratio=4)
    assert "1 + cos α" in sb.to_text(twin)
    assert r"1 + \cos \alpha" in sb.to_latex(twin)
    assert '"cos": "cos(alpha) + 1"' in sb.to_json(twin)
