"""Closed forms of the force and couple of evenly firing in-line engines, for any number of cylinders.

N cylinders fire evenly, one after another along the crank, h = 4 pi/N apart (four strokes; 2 pi/N in a
two-stroke). For order n, with the geometric sum of e^(i n h j),

    sum over j = 0..N-1 of cos n(theta + j h) = sin(N n h/2)/sin(n h/2) cos(n theta + n (N-1) h/2).

The numerator is sin 2 pi n = 0, so everything cancels unless sin(2 pi n/N) = 0 too: unless u = 2n/N is
whole. There the quotient has the limit N (-1)^(u (N-1)), the cosine the same sign, and the sum is
N cos n theta: the cylinders push as one.

Cylinder j stands at station (N-1)/2 - j. With zeta = e^(i n h), zeta^N = 1, the couple is the real
part of

    sum of ((N-1)/2 - j) zeta^j e^(i n theta) = N/(1 - zeta) e^(i n theta)      (u not whole, else 0)

that is N/(2 |sin(2 pi n/N)|) in size: from three cylinders on, every evenly firing crank in this order
has a first-order couple.

Source: derived here; the force's condition is the u of 000_6d19e3a8fb7bcb72.txt.

Formulas:
    c_0 + c_1 + c_2 = sin(3 h/2)/sin(h/2) cos(a + h)
    c_0 + c_1 + c_2 + c_3 = sin(2 h)/sin(h/2) cos(a + 3 h/2)
    with c_0 = cos a; c_1 = cos(a + h); c_2 = cos(a + 2 h); c_3 = cos(a + 3 h); a, h angles
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from symbalance.document.symbols import symbol
from symbalance.engine.engine import checked_strokes
from symbalance.errors import SymbalanceError, shown, written
from symbalance.text.numbers import whole

if TYPE_CHECKING:
    import sympy

    Count = int | sympy.Expr


def _read(value: Any, name: str) -> Any:
    """Return a whole number or a SymPy expression as an expression; text is refused, never evaluated."""
    import sympy

    number = whole(value)
    if number is not None:
        return sympy.Integer(number)
    real = isinstance(value, sympy.Expr) and value.is_extended_real is not False
    if not real or (value.is_number and not value.is_finite):
        rule = "must be a whole number or a real SymPy expression"
        raise SymbalanceError(f"{name} = {written(value)}", rule, "a symbol stands for any number")
    # A Float is a dyadic rational: exact, the poles of the closed forms are found beside it too.
    return value.xreplace({number: sympy.Rational(number) for number in value.atoms(sympy.Float)})


def _counted(count: Count) -> Any:
    """Return a number of cylinders, or refuse what cannot be one."""
    number = _read(count, "count")
    if number.is_integer is False or number.is_positive is False:
        rule = "must be a positive whole number or a symbol for one"
        raise SymbalanceError(f"count = {shown(count)}", rule, "an engine has at least one cylinder")
    return number


def spacing(count: Count, strokes: int = 4) -> sympy.Expr:
    """Return the even firing interval h = strokes pi/N in radians.

    >>> spacing(5)
    4*pi/5
    """
    import sympy

    return checked_strokes(strokes) * sympy.pi / _counted(count)


def condition(count: Count, order: Count, strokes: int = 4) -> sympy.Expr:
    """Return u = n h/(2 pi), which is 2n/N in a four-stroke: order n survives where u is whole.

    >>> [condition(6, n) for n in (1, 2, 3, 4, 6)]
    [1/3, 2/3, 1, 4/3, 2]
    """
    return _read(order, "order") * checked_strokes(strokes) / (2 * _counted(count))


def dirichlet_quotient(count: Count, order: Count, spacing: sympy.Expr) -> sympy.Expr:
    """Return sin(N n h/2)/sin(n h/2) with its limit where both vanish, for any spacing h.

    >>> import sympy
    >>> h = 2 * sympy.pi / 3
    >>> dirichlet_quotient(6, 3, h), dirichlet_quotient(6, 1, h)
    (-6, 0)
    """
    import sympy

    n, N, spacing = _read(order, "order"), _counted(count), _read(spacing, "spacing")
    turns = sympy.cancel(n * spacing / (2 * sympy.pi))
    quotient = sympy.sin(N * n * spacing / 2) / sympy.sin(n * spacing / 2)
    limit = N * sympy.cos(sympy.pi * turns * (N - 1))
    if turns.is_integer is True:
        return limit
    if turns.is_rational and turns.is_integer is False and N.is_integer:
        return sympy.S.Zero if (turns * N).is_integer else quotient
    return sympy.Piecewise((limit, sympy.Eq(sympy.Mod(turns, 1), 0)), (quotient, True))


def inline_sum(count: Count, order: Count, strokes: int = 4) -> sympy.Expr:
    """Return the sum of cos n(theta + j h) over N evenly firing cylinders, N and n numbers or symbols.

    Of a three, and of presets of five and six:

    Formulas:
        F = 5 cos 5 theta
        S = 0
        cos theta + cos(theta + h) + cos(theta + 2 h) = 0
        cos 3 theta + cos 3 (theta + h) + cos 3 (theta + 2 h) = 3 cos 3 theta
        1 + z + z^2 + z^3 + z^4 + z^5 = 0
        with h = 4 pi/3; z = e^(2 i pi/3);
        F the force of order 5 of inline-5; S the force of order 2 of inline-6

    >>> inline_sum(4, 2), inline_sum(5, 4)
    (4*cos(2*theta), 0)
    >>> import sympy
    >>> inline_sum(sympy.Symbol("N", integer=True, positive=True), 2)
    Piecewise((N*cos(2*theta), Eq(Mod(4/N, 1), 0)), (0, True))
    """
    import sympy

    n, N = _read(order, "order"), _counted(count)
    survives = sympy.Eq(sympy.Mod(condition(N, n, strokes), 1), 0)
    return sympy.Piecewise((N * sympy.cos(n * symbol("theta")), survives), (0, True))


def inline_couple(count: Count, order: Count, strokes: int = 4) -> sympy.Expr:
    """Return the couple of N evenly firing cylinders in a row, unit F_n a, positive front up.

    Firing order 1-2-...-N; amplitude N/(2 |sin(n h/2)|), zero where u is whole. Of a three, then a four:

    Formulas:
        cos theta - cos(theta - 2 h) = sqrt(3) cos(theta + pi/6)
        1 - z^2 = 3/(1 - z)
        3/2 + y/2 - y^2/2 - 3 y^3/2 = 4/(1 - y)
        with h = 4 pi/3; z = e^(2 i pi/3); y = e^(i pi)

    >>> inline_couple(3, 1), inline_couple(3, 3)
    (sqrt(3)*cos(theta + pi/6), 0)
    """
    import sympy

    n, N = _read(order, "order"), _counted(count)
    half = n * spacing(N, strokes) / 2
    survives = sympy.Eq(sympy.Mod(condition(N, n, strokes), 1), 0)
    # Cylinders fire later, h each: zeta = e^(-i n h), and 1/(1 - zeta) = e^(i n h/2)/(2i sin(n h/2)).
    couple = N / (2 * sympy.sin(half)) * sympy.cos(n * symbol("theta") + half - sympy.pi / 2)
    return sympy.Piecewise((sympy.S.Zero, survives), (couple, True))
