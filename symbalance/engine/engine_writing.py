"""Writing of an engine file, which `symbalance.engine.engine_file` reads back as the same engine.

Cylinders are written one by one, so that any layout can be. A weight whose size and direction are not
both fractions is written as the sum of weights that are: every number of the exact fields is one.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from symbalance.engine.balance_masses import BalanceShaft, Counterweight, Weight
from symbalance.engine.crank_train import CYLINDER_SIZES
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.angles import Angle
from symbalance.exact.phasor import Phasor
from symbalance.exact.spectrum import Component
from symbalance.exact.symbolic_phasor import SymbolicPhasor
from symbalance.text.reals import Real, nstr

DIGITS = 30
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
        tables += [("[[counterweight]]", row) for row in _counterweight(counterweight)]
    tables += [("[[balance_shaft]]", _shaft(s)) for s in engine.balancers.shafts]
    return "\n".join(_table(head, rows) for head, rows in tables if rows)


def _table(head: str, rows: Row) -> str:
    lines = [head] if head else []
    return "\n".join([*lines, *(f"{key} = {_value(value)}" for key, value in rows)]) + "\n"


def _value(value: Any) -> str:
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


def _counterweight(counterweight: Counterweight) -> list[Row]:
    place: Row = _present_keys([("throw", counterweight.throw), ("web", counterweight.web)])
    place += _present_keys([("station", counterweight.station)])
    if counterweight.weight is None:
        angle = _degrees(counterweight.angle)
        direction: Row = [("angle", angle)] if angle else []
        return [[*place, *direction, ("overbalance", counterweight.overbalance)]]
    weight = counterweight.weight
    return [[*place, ("angle", angle), (_unit(weight), size)] for size, angle in _simple(weight.vector)]


def _shaft(shaft: BalanceShaft) -> Row:
    phase = _degrees(shaft.phase)
    rows: Row = [("speed", shaft.speed), *([("phase", phase)] if phase else [])]
    rows += [(key, value) for key, value in (("x", shaft.x), ("y", shaft.y)) if value]
    weights: list[Row] = [
        [("station", weight.station), (_unit(weight), size), ("phase", phase)]
        for weight in shaft.weights
        for size, phase in _simple(weight.vector)
    ]
    return [*rows, ("weights", weights)]


def _unit(weight: Weight) -> str:
    return "unbalance" if weight.in_kg_mm else "share"


def _simple(vector: Amplitude) -> list[tuple[Fraction | str, Fraction]]:
    """Return sizes and degrees of weights that add up to a vector: one, if fractions say it."""
    if vector.is_decimal:
        value = vector.evaluated()
        parts = ((value.real, 0), (value.imag, 90))
        return [(_decimal(x), Fraction(degrees)) for x, degrees in parts if x]
    if isinstance(vector, SymbolicPhasor):
        _degrees(Angle(Fraction(0), next(s for s in vector.parts if s)))
    assert isinstance(vector, Phasor)  # every symbol is refused
    if vector.is_zero():
        return [(Fraction(0), Fraction(0))]
    short = min(vector.primitive(), vector, key=lambda p: len(p.terms))
    if len(short.terms) > 1:
        part = Component(vector)
        amplitude: Any = part.amplitude
        turns: Any = part.phase / 2 / _pi()
        if amplitude.is_Rational and turns.is_Rational:
            size, turns_exact = (Fraction(int(x.p), int(x.q)) for x in (amplitude, turns))
            return [(size, turns_exact * 360)]
    return [(Fraction(c), Fraction(360 * k, short.modulus)) for k, c in sorted(short.terms.items())]


def _decimal(value: Real) -> str:
    return nstr(value, DIGITS, min_fixed=1, max_fixed=0)


def _pi() -> Any:
    import sympy

    return sympy.pi
