r"""The free force and couple of engines whose cylinders are not alike: one sum for each group.

In units of m r omega^2 of cylinder 1, with s_j = m_j r_j/(m_1 r_1) and f_n = 2 n^2 c_n of each cylinder's
own mechanism (`symbalance.engine.unlike`),

    c_{+-n} = 1/2 sum of w_j s_j e^(i bank_j) f_{+-n}(j) e^(+-i n (throw_j - bank_j)).

Cylinders that are alike are summed exactly first, as in an ideal engine: where that geometry vanishes
the order is gone, exactly; what is left of several kinds of cylinder is a number of 40 digits.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

from mpmath import mp

from symbalance.engine.cylinders import Cylinder
from symbalance.engine.layout import Layout
from symbalance.engine.unlike import forces_of, kinds
from symbalance.exact.arithmetic import decimal
from symbalance.exact.decimal_phasor import DIGITS, DecimalPhasor
from symbalance.exact.phasor import Phasor
from symbalance.exact.spectrum import Number, Spectrum
from symbalance.kinematics.mechanisms.linkages import plain

Geometry = Callable[[Sequence[Cylinder], Sequence[int], Sequence[Fraction]], Mapping[int, Phasor]]


def unlike_spectrum(
    layout: Layout, orders: Sequence[int], weights: Sequence[Fraction], geometry: Geometry
) -> Spectrum:
    """Return the planar vector's orders in units of m r omega^2 of cylinder 1, to 40 digits.

    `geometry` sums like cylinders exactly, as for an ideal engine.
    """
    total: dict[int, DecimalPhasor] = {}
    for (mechanism, size), places in kinds(layout).items():
        exact = geometry([layout.cylinders[i] for i in places], orders, [weights[i] for i in places])
        forces = forces_of(plain(mechanism), max(orders, default=1))
        for n, phasor in exact.items():
            if abs(n) not in forces or phasor.is_zero():
                continue
            with mp.workdps(DIGITS):
                own = forces[n] if n > 0 else mp.conj(forces[-n])
                factor = own * size.numerator / size.denominator
                part = DecimalPhasor(decimal(phasor) * factor)
            total[n] = total[n] + part if n in total else part
    numbers: dict[int, Number] = {n: total[n] for n in sorted(total) if not total[n].is_zero()}
    return Spectrum(numbers)
