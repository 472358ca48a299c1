"""Writing of an engine file, which `symbalance.engine.engine_file` reads back as the same engine.

Cylinders are written one by one, so that any layout can be. A weight's size is written
exactly, as a fraction or a sum of cosines; one whose direction is no fraction of a turn by its two parts,
straight up and to the right. What each weight is in decimals, and in kg mm where sizes say it, stands
above it.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from symbalance.document.decimals import short_decimal
from symbalance.engine.balance_masses import BalanceShaft, Counterweight, Weight
from symbalance.engine.crank_train import CYLINDER_SIZES
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine, checked_engine
from symbalance.engine.rotating_masses import share_sign, unit_of_share
from symbalance.errors import SymbalanceError
from symbalance.exact.angles import Angle
from symbalance.exact.cosine_sums import cosine_text
from symbalance.exact.phasor import Phasor
from symbalance.exact.spectrum import turns_and_size
from symbalance.exact.symbolic_phasor import SymbolicPhasor
from symbalance.text.reals import Real, atan2, nstr, pi

DIGITS = 30
QUARTER = Fraction(1, 4)
SHOWN = 6
"""Digits of a decimal in a comment."""
COMMENT = "#"
"""The key of a row that is said of the rows after it."""
Row = list[tuple[str, Any]]
Sizes = Mapping[str, Fraction | None]
"""What a file says of one cylinder's sizes, by key; None where it has none."""


def engine_text(engine: Engine) -> str:
    """Return the text of an engine file; symbols, which no file holds, are refused.

    >>> from symbalance.engine.builders import inline
    >>> print(engine_text(inline("1")).splitlines()[3:6])
    ['[[cylinder]]', 'number = 1', 'throw = 0']
    """
    sizes = [_written_sizes(c) for c in checked_engine(engine).cylinders]
    shared = _shared(engine, sizes)
    tables = [
        ("", [("name", engine.name), ("strokes", engine.strokes)]),
        ("[crank_train]", _crank_train(engine, shared)),
    ]
    rows = zip(engine.cylinders, sizes, strict=True)
    tables += [("[[cylinder]]", _cylinder(c, of_cylinder, shared)) for c, of_cylinder in rows]
    for counterweight in engine.balancers.counterweights:
        tables += [("[[counterweight]]", row) for row in _counterweight(engine, counterweight)]
    tables += [("[[balance_shaft]]", _shaft(engine, s)) for s in engine.balancers.shafts]
    return "\n".join(_table(head, rows) for head, rows in tables if rows)


def _table(head: str, rows: Row) -> str:
    lines = [head] if head else []
    written = [f"# {value}" if key == COMMENT else f"{key} = {_value(value)}" for key, value in rows]
    return "\n".join([*lines, *written]) + "\n"


def _value(value: Any) -> str:
    if isinstance(value, tuple):
        return f"[{', '.join(map(_value, value))}]"
    if isinstance(value, list):
        inline = (", ".join(f"{k} = {_value(v)}" for k, v in row) for row in value)
        return f"[{', '.join(f'{{ {row} }}' for row in inline)}]"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, Fraction) and value.denominator != 1:
        return _fraction(value)
    return str(value)


def _fraction(value: Fraction) -> str:
    """Return a fraction as a decimal where it is a short one, else in quotes."""
    if 10**6 % value.denominator == 0:
        places = next(k for k in range(1, 7) if 10**k % value.denominator == 0)
        sign, whole = "-" if value < 0 else "", abs(value.numerator) * (10**places // value.denominator)
        text = f"{whole:0{places + 1}d}"
        return f"{sign}{text[:-places]}.{text[-places:]}"
    return f'"{value}"'


def _present_keys(rows: Iterable[tuple[str, Any]]) -> Row:
    return [(key, value) for key, value in rows if value is not None]


def _written_sizes(cylinder: Cylinder) -> Sizes:
    """Return the sizes of a cylinder as a file says them: a rod ratio as a rod, where it has a stroke."""
    sizes, ratio = cylinder.sizes, cylinder.sizes.given_ratio
    if ratio is not None and sizes.stroke is not None:
        sizes, ratio = replace(sizes, rod=ratio * sizes.stroke / 2), None
    if ratio is not None and sizes.rod is not None:
        rule = f"cannot stand in an engine file beside rod = {sizes.rod}"
        raise SymbalanceError(f"ratio = {ratio}", rule, "give stroke and rod")
    return {**{key: getattr(sizes, key) for key in CYLINDER_SIZES}, "ratio": ratio}


def _shared(engine: Engine, sizes: Sequence[Sizes]) -> dict[str, Fraction]:
    """Return the sizes that stand in [crank_train]: those no cylinder lacks, as most of them have them.

    A link rod takes no stroke, rod and ratio from there.
    """
    shared = {}
    for key in (*CYLINDER_SIZES, "ratio"):
        values = [
            of_cylinder[key]
            for c, of_cylinder in zip(engine.cylinders, sizes, strict=True)
            if c.link is None or key not in ("stroke", "rod", "ratio")
        ]
        known = [value for value in values if value is not None]
        if known and len(known) == len(values):
            shared[key] = Counter(known).most_common(1)[0][0]
    return shared


def _crank_train(engine: Engine, shared: Mapping[str, Fraction]) -> Row:
    of_engine = {"bore": engine.bore, "pitch": engine.pitch}
    keys = ("bore", "stroke", "rod", "pitch", *CYLINDER_SIZES[2:], "ratio")
    return _present_keys((key, of_engine[key] if key in of_engine else shared.get(key)) for key in keys)


def _cylinder(cylinder: Cylinder, sizes: Sizes, shared: Mapping[str, Fraction]) -> Row:
    places = [("throw", cylinder.throw), ("bank", cylinder.bank)]
    rows: Row = [("number", cylinder.number), *((k, _degrees(a)) for k, a in places)]
    rows += [("station", cylinder.station), ("fires", cylinder.fires)]
    link = cylinder.link
    if sizes["ratio"] != shared.get("ratio") and link is None:
        rule = "cannot stand in an engine file beside other cylinders' ratios"
        raise SymbalanceError(f"ratio = {sizes['ratio']}", rule, "give its stroke and rod")
    of_cylinder = {key: sizes[key] for key in CYLINDER_SIZES if sizes[key] != shared.get(key)}
    if link is not None:
        of_cylinder |= {"rod": sizes["rod"]}
    rows += [(key, of_cylinder[key]) for key in CYLINDER_SIZES if key in of_cylinder]
    if link is not None:
        rows += [("master", link.master), ("link_angle", link.angle * 360), ("link_radius", link.radius)]
    return _present_keys(rows)


def _degrees(angle: Angle) -> Fraction:
    if angle.symbols:
        remedy = "give numbers for its symbols first"
        raise SymbalanceError(f"angle = {angle.as_text()}", "cannot stand in an engine file", remedy)
    return angle.in_degrees()


def _counterweight(engine: Engine, counterweight: Counterweight) -> list[Row]:
    place: Row = _present_keys([("throw", counterweight.throw), ("web", counterweight.web)])
    place += _present_keys([("station", counterweight.station)])
    if counterweight.weight is None:
        angle = _degrees(counterweight.angle)
        direction: Row = [("angle", angle)] if angle else []
        return [[*place, *direction, ("overbalance", counterweight.overbalance)]]
    weight = counterweight.weight
    parts = _parts(engine, weight, 1)
    rows = [[*place, *_direction("angle", angle), (_unit(weight), size)] for size, angle in parts]
    words = _in_decimals(engine, weight, 1)
    if counterweight.throw is not None or counterweight.web is not None:
        words += ", from opposite its pin"
    together = f"{words}, exactly as {len(parts)} weights" if len(parts) > 1 else words
    return [[(COMMENT, together), *rows[0]], *rows[1:]]


def _in_decimals(engine: Engine, weight: Weight, speed: int) -> str:
    """Return what a weight is in decimals: size, direction, and mass times radius if that is known."""
    sign = 1 if weight.in_kg_mm else share_sign(engine, speed)
    value = weight.vector.evaluated() * sign  # what points where the weight does
    angle = atan2(value.imag, value.real) * 180 / pi()
    where = f"at {_rounded(angle)} degrees"
    if weight.in_kg_mm:
        return f"{_rounded(abs(value))} kg mm {where}"
    size, unit = sign * abs(value), engine.unit_unbalance
    words = (
        f"{_rounded(size)} {'m r' if abs(speed) == 1 else f'A{abs(speed)} m r/{speed * speed}'} {where}"
    )
    known = abs(speed) == 1 or not engine.has_common_harmonics or engine.ratio is not None
    if unit is None or not known:
        return words
    kg_mm = size * unit_of_share(engine, speed) * unit / speed**2
    return f"{words}, {_rounded(kg_mm)} kg mm"


def _rounded(value: Real) -> str:
    return short_decimal(value, SHOWN)


def _shaft(engine: Engine, shaft: BalanceShaft) -> Row:
    phase = _degrees(shaft.phase)
    rows: Row = [("speed", shaft.speed), *([("phase", phase)] if phase else [])]
    rows += [(key, value) for key, value in (("x", shaft.x), ("y", shaft.y)) if value]
    weights: list[Row] = [
        [("station", weight.station), (_unit(weight), size), *_direction("phase", phase)]
        for weight in shaft.weights
        for size, phase in _parts(engine, weight, shaft.speed)
    ]
    said: Row = [
        (COMMENT, f"station {weight.station}: {_in_decimals(engine, weight, shaft.speed)}")
        for weight in shaft.weights
    ]
    return [*said, *rows, ("weights", weights)]


def _unit(weight: Weight) -> str:
    return "unbalance" if weight.in_kg_mm else "share"


def _direction(key: str, degrees: Fraction | None) -> Row:
    """Return the row of a direction; none where a weight is given by its parts up and to the right."""
    return [] if degrees is None else [(key, degrees)]


Size = Fraction | str | tuple[Fraction | str, Fraction | str]
"""A weight's size as it is written, or its parts straight up and to the right."""


def _parts(engine: Engine, weight: Weight, speed: int) -> list[tuple[Size, Fraction | None]]:
    """Return a weight as it is written: its size and degrees, or its parts and None.

    The size is below 0 where the A_n is that it is a multiple of: then it points where the degrees say.
    What takes too many cosines is written as several weights, whose sizes are fractions.
    """
    vector = weight.vector
    if vector.is_decimal:
        value = vector.evaluated()
        if not value.imag or not value.real:  # straight up, or to the right
            along, degrees = (value.real, 0) if not value.imag else (value.imag, 90)
            return [(_decimal(along), Fraction(degrees))]
        return [((_decimal(value.real), _decimal(value.imag)), None)]
    if isinstance(vector, SymbolicPhasor):
        _degrees(Angle(Fraction(0), next(s for s in vector.parts if s)))
    assert isinstance(vector, Phasor)  # every symbol is refused
    if vector.is_zero():
        return [(Fraction(0), Fraction(0))]
    sign = 1 if weight.in_kg_mm else share_sign(engine, speed)
    polar = turns_and_size(vector.scaled(sign))
    if polar is not None:
        turns, amplitude = polar
        size = _real(amplitude.scaled(sign))
        return _several(vector) if size is None else [(size, turns * 360)]
    up, right = _real(vector.real()), _real(vector.rotated(-QUARTER).real())
    if up is None or right is None:
        return _several(vector)
    return [((up, right), None)]


def _real(number: Phasor) -> Fraction | str | None:
    """Return a real number as it is written: a fraction, or a sum of cosines unless it is too long."""
    rational = number.rational()
    return cosine_text(number) if rational is None else rational


def _several(vector: Phasor) -> list[tuple[Size, Fraction | None]]:
    """Return sizes and degrees of weights that add up to a vector."""
    short = min(vector.primitive(), vector, key=lambda p: len(p.terms))
    return [(Fraction(c), Fraction(360 * k, short.modulus)) for k, c in sorted(short.terms.items())]


def _decimal(value: Real) -> str:
    return nstr(value, DIGITS, min_fixed=1, max_fixed=0)
