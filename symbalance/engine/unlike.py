r"""Engines whose cylinders are not alike: offset axes, link rods, masses and strokes of their own.

Cylinder j pushes along its axis with F_j = m_j r_j omega^2 Re sum of 2 n^2 c_n(j) e^(i n p_j), c_n the
harmonics of its own mechanism's height (`symbalance.kinematics.mechanisms`), p_j = theta + throw -
bank. Here stand each cylinder's mechanism, its f_n = 2 n^2 c_n, its s_j = m_j r_j/(m_1 r_1), and which
cylinders are alike; `symbalance.forces.unlike_spectrum` sums them.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from mpmath import mp

from symbalance.engine.cylinders import Cylinder
from symbalance.engine.layout import Layout
from symbalance.engine.trains import CrankTrain
from symbalance.errors import SymbalanceError
from symbalance.exact.decimal_phasor import DIGITS
from symbalance.kinematics.mechanisms import LinkRod, Mechanism, SliderCrank, force_harmonics, force_tail
from symbalance.kinematics.slider_crank import acceleration_values
from symbalance.text.numbers import Real

Kind = tuple[Mechanism, Fraction]


def mechanism_of(layout: Layout, cylinder: Cylinder) -> Mechanism:
    """Return what joins a cylinder's piston to the crank, lengths over its crank radius.

    >>> from symbalance.engine.catalogue import load
    >>> mechanism_of(load("inline-4"), load("inline-4").cylinders[0])
    SliderCrank(ratio=Fraction(4, 1), offset=Fraction(0, 1))
    """
    train = layout.train_of(cylinder)
    if cylinder.link is None:
        _check_reach(train)
        offset = train.offset_ratio
        return SliderCrank(_ratio(train, cylinder), offset)
    master = next(c for c in layout.cylinders if c.number == cylinder.link.master)
    over = layout.train_of(master)
    if over.stroke is None or cylinder.own.rod is None:
        what = f"cylinder {cylinder.number}"
        raise SymbalanceError(
            what, "hangs on a rod of unknown size", "give stroke and rod in [crank_train]"
        )
    radius = over.stroke / 2
    between = cylinder.bank.turns - master.bank.turns
    offset = (train.offset or Fraction(0)) / radius
    first = SliderCrank(_ratio(over, master), over.offset_ratio)
    link = cylinder.link
    return LinkRod(first, link.angle, link.radius / radius, cylinder.own.rod / radius, between, offset)


def _check_reach(train: CrankTrain) -> None:
    """Refuse an offset at which the crank cannot turn, in the units of the file."""
    if train.offset and train.rod is not None and train.stroke is not None:
        most = train.rod - train.stroke / 2
        if most > 0 and abs(train.offset) >= most:
            rule = f"must lie within {float(-most):.12g} and {float(most):.12g} mm (rod - stroke/2)"
            remedy = "nearer the crank's axis, or a longer rod: the crank could not turn"
            raise SymbalanceError(f"offset = {float(train.offset):.12g}", rule, remedy)


def _ratio(train: CrankTrain, cylinder: Cylinder) -> Fraction:
    if train.ratio is None:
        what, remedy = f"cylinder {cylinder.number}", "give stroke and rod in mm, or ratio"
        raise SymbalanceError(what, "has no rod ratio, and the engine's cylinders are not alike", remedy)
    return train.ratio


def sizes(layout: Layout) -> list[Fraction]:
    """Return every cylinder's m r over that of cylinder 1; 1 where no masses or strokes are given."""
    trains = [layout.train_of(c) for c in layout.cylinders]
    strokes = [layout.stroke_of(c) for c in layout.cylinders]
    one = layout.cylinders.index(layout.first)
    masses = [t.reciprocating_mass for t in trains]
    found = [Fraction(1)] * len(trains)
    for name, values in (("reciprocating_mass", masses), ("stroke", strokes)):
        first = values[one]
        if any(v != first for v in values):
            if first == 0 and name == "reciprocating_mass":
                rule = f"is 0 for cylinder {layout.first.number}, whose m r is the unit of the others'"
                raise SymbalanceError(name, rule, "give it a mass, or number another cylinder first")
            if not first or any(v is None for v in values):
                rule = "is given for some cylinders and not for others"
                raise SymbalanceError(name, rule, "give it for all, or in [crank_train]")
            found = [f * v / first for f, v in zip(found, values, strict=True) if v is not None]
    return found


def forces_of(mechanism: Mechanism, order: int) -> dict[int, Real]:
    """Return n -> f_n = A_n - i B_n, n = 1..order, to 40 digits; orders that symmetry removes are absent.

    >>> [(n, mp.nstr(f.real, 6)) for n, f in forces_of(SliderCrank(4), 4).items()]
    [(1, '1.0'), (2, '0.254025'), (4, '-0.00409811')]
    """
    with mp.workdps(DIGITS):  # mpc rounds to the working precision, whatever the caller's is
        if isinstance(mechanism, SliderCrank) and not mechanism.offset:
            values = acceleration_values(order, mechanism.ratio, DIGITS)
            return {n: mp.mpc(a) for n, a in values.items() if n <= order}
        return {n: mp.mpc(a, -b) for n, (a, b) in force_harmonics(mechanism, order, DIGITS).items()}


def kinds(layout: Layout) -> dict[Kind, list[int]]:
    """Return the places of the cylinders by kind: mechanism, and m r over that of the first."""
    if layout.has_symbols:
        rule, remedy = (
            "has angles with symbols, and cylinders that are not alike",
            "give the angles in numbers, or take symbolic_order",
        )
        raise SymbalanceError(f"engine {layout.name!r}", rule, remedy)
    found: dict[Kind, list[int]] = {}
    for place, (cylinder, size) in enumerate(zip(layout.cylinders, sizes(layout), strict=True)):
        found.setdefault((mechanism_of(layout, cylinder), size), []).append(place)
    return found


def spectrum_left_out(layout: Layout, order: int, weights: Sequence[Real]) -> Real:
    """Return a proved bound on the sum of |weight| times every cylinder's harmonics above `order`.

    In units of m r omega^2 of cylinder 1: the sum of |w_j| s_j `force_tail`.
    """
    total = mp.mpf(0)
    for (mechanism, size), places in kinds(layout).items():
        tail = force_tail(mechanism, order)
        total += tail * mp.fsum(abs(weights[i]) for i in places) * size.numerator / size.denominator
    return total
