"""A balance as plain values for JSON; exact numbers as strings for SymPy."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from math import hypot
from typing import Any

from symbalance.engine.balance_masses import Balancers, Counterweight, Weight
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine_document import dead_centre_angles_of, piston_strokes
from symbalance.exact.spectrum import COMPONENTS, Component
from symbalance.forces.free_forces import Balance, Order, Resultant
from symbalance.forces.operating_point import UNITS
from symbalance.forces.rows import plane_key, roll_rows
from symbalance.kinematics.mechanisms import LinkRod
from symbalance.text.numbers import decimal_text
from symbalance.text.reals import Real

DIGITS = 30
VALUE_DIGITS = 20


def balance_data(balance: Balance) -> dict[str, Any]:
    """Return what `to_json` writes of a balance, as plain Python values."""
    return {
        "engine": balance.engine.name,
        "strokes": balance.engine.strokes,
        "ratio": None if balance.ratio is None else str(balance.ratio),
        "reference_plane": plane_key(balance.reference),
        "cylinders": _cylinders(balance),
        **({"balancers": _balancers(balance.engine.balancers)} if balance.engine.balancers else {}),
        **({"operating_point": point.data()} if (point := balance.operating_point) else {}),
        "orders": [_order(order, balance) for order in balance.orders],
        **({"largest": largest_data(balance)} if point and not balance.engine.has_symbols else {}),
        **({"roll": _roll(balance)} if roll_rows(balance) else {}),
    }


def unit(balance: Balance, name: str) -> str:
    """Return the unit of a balance's "force" or "couple" of order n."""
    return _UNITS[balance.kinematics is not None, name]


def _roll(balance: Balance) -> list[dict[str, Any]]:
    """Return the roll moment of the shafts on the frame, + in the sense of rotation, in F_n r."""
    rows = roll_rows(balance)
    return [{"order": str(row.order), **component_values(row.component)} for row in rows]


def _balancers(balancers: Balancers) -> dict[str, Any]:
    """Return counterweights and shafts; a weight is `cos` + i `sin`, straight up and to the right."""
    return {
        "counterweights": [_counterweight(c) for c in balancers.counterweights],
        "shafts": [
            {
                "speed": shaft.speed,
                "phase": shaft.phase.as_text(),
                "x": str(shaft.x),
                "y": str(shaft.y),
                "weights": [_weight(w) for w in shaft.weights],
            }
            for shaft in balancers.shafts
        ],
    }


def _counterweight(counterweight: Counterweight) -> dict[str, Any]:
    weight = counterweight.weight
    places = {"throw": counterweight.throw, "web": counterweight.web}
    return {
        **{key: value for key, value in places.items() if value is not None},
        "angle": counterweight.angle.as_text(),
        "station": None if counterweight.station is None else str(counterweight.station),
        **(
            {"overbalance": str(counterweight.overbalance)}
            if weight is None
            else {"unit": _unit(weight), "vector": dict(component_values(Component(weight.vector)))}
        ),
    }


def _weight(weight: Weight) -> dict[str, Any]:
    vector = dict(component_values(Component(weight.vector)))
    return {"station": str(weight.station), "unit": _unit(weight), "vector": vector}


def _unit(weight: Weight) -> str:
    return "kg mm" if weight.in_kg_mm else "share"


def _cylinders(balance: Balance) -> list[dict[str, Any]]:
    """Return the cylinders, with what a drawing says of each in mm and degrees."""
    engine = balance.engine
    tops = {} if engine.has_symbols else dead_centre_angles_of(engine)
    strokes = piston_strokes(engine)
    return [
        _cylinder(c)
        | _own(balance, c)
        | ({"station_mm": str(c.station * engine.pitch)} if engine.pitch else {})
        | ({"top_dead_centre": str(tops[c.number])} if tops else {})
        | ({"stroke_mm": decimal_text(strokes[c.number], VALUE_DIGITS)} if strokes else {})
        for c in engine.cylinders
    ]


def _cylinder(cylinder: Cylinder) -> dict[str, Any]:
    return {
        "number": cylinder.number,
        "throw": cylinder.throw.as_text(),
        "bank": cylinder.bank.as_text(),
        "station": str(cylinder.station),
        "fires": None if cylinder.fires is None else str(cylinder.fires),
    }


def _own(balance: Balance, cylinder: Cylinder) -> dict[str, Any]:
    """Return what a cylinder has of its own where they are unlike: lengths over its crank radius."""
    mechanism = cylinder.mechanism
    if balance.kinematics or mechanism is None:
        return {}
    balancers: dict[str, Any] = {"ratio": str(mechanism.length), "offset": str(mechanism.offset)}
    if isinstance(mechanism, LinkRod) and cylinder.link:
        angle = str(mechanism.link_angle * 360)
        radius = str(mechanism.link_radius)
        balancers["link"] = {"master": cylinder.link.master, "angle": angle, "radius": radius}
    return balancers


def _order(order: Order, balance: Balance) -> dict[str, Any]:
    return {
        "order": str(order.order),
        "coefficient": _coefficient(order, balance),
        "force": resultant_data(order.force, balance, "force"),
        "couple": resultant_data(order.couple, balance, "couple"),
    }


def largest_data(balance: Balance) -> dict[str, Any]:
    """Return the largest force and couple over a turn, all orders together, with a proved bound."""
    return {
        output: {"value": top.value, "bound": top.bound, "degrees": top.angle, "unit": unit}
        for output, top in balance.turn_maxima.items()
        for unit in (UNITS[output.partition(".")[0]],)
    }


def _coefficient(order: Order, balance: Balance) -> dict[str, Any] | None:
    """Return A_n, or None where cylinders are unlike: components then hold the kinematics too."""
    if order.coefficient is None:
        return None
    value = balance.values.get(order.order)
    return {
        "series": order.coefficient.spelling,
        "through": order.coefficient.through,
        "value": None if value is None else decimal_text(value, VALUE_DIGITS),
    }


KEYS = {"force": "newtons", "couple": "newton_metres"}


def resultant_data(
    resultant: Resultant, balance: Balance, of: str, names: Sequence[str] = COMPONENTS
) -> dict[str, Any]:
    """Return the components of one order, at an operating point in N or N m too."""
    point = balance.operating_point
    factor = None
    if point is not None and not (of == "couple" and point.couple is None):
        factor = balance.unit_value(of) * balance.share(resultant.order)
    return {name: _with_value(resultant.component(name), KEYS[of], factor) for name in names}


def _with_value(component: Component, key: str, factor: Real | None) -> dict[str, Any]:
    values = dict(component_values(component))
    if factor is not None and values["decimal"] is not None:
        values[key] = [decimal_text(x * factor, VALUE_DIGITS) for x in component.decimal(DIGITS)]
    return values


@lru_cache(maxsize=4096)
def component_values(component: Component) -> dict[str, Any]:
    """Return a component's values, none of which can be changed: documents share them."""
    symbolic = component.number.has_symbols and not component.is_zero()
    return {
        **{name: component.form(name).spelling for name in ("cos", "sin", "amplitude", "phase")},
        "decimal": None if symbolic else _decimal(component),
    }


def _decimal(component: Component) -> tuple[str, ...]:
    return tuple(decimal_text(x, DIGITS) for x in component.decimal(DIGITS))


def balance_records(balance: Balance) -> list[dict[str, Any]]:
    """Return a row for each component of force and couple that does not vanish.

    Keys: order, of (force or couple), component, cos, sin, amplitude (floats, None with symbols in them),
    unit, and coefficient, A_n in decimals (None where it is not apart or no ratio is known).

    At an operating point also `value`, the amplitude in `value_unit` (without the sign of A_n),
    `value_cos` and `value_sin` with all signs, `per_cent` of one piston's first order, `rpm`; and a row
    "all orders" for each component, and for the vector in any direction: `value` is the largest over a
    turn, `bound` what it is proved not to exceed, `degrees` the crank angle.
    """
    records = []
    for order in balance.orders:
        value = balance.values.get(order.order)
        for of, resultant in (("force", order.force), ("couple", order.couple)):
            for name in COMPONENTS:
                part = resultant.component(name)
                if part.is_zero():
                    continue
                cos, sin = (None, None) if part.number.has_symbols else map(float, part.decimal())
                records.append(
                    {
                        "order": order.order,
                        "of": of,
                        "component": name,
                        "cos": cos,
                        "sin": sin,
                        "amplitude": None if cos is None or sin is None else hypot(cos, sin),
                        "exact_cos": part.form("cos").spelling,
                        "exact_sin": part.form("sin").spelling,
                        "unit": unit(balance, of),
                        "coefficient": None if value is None else float(value),
                        **_value_record(balance, order.order, of, cos, sin),
                    }
                )
    return records + _largest_records(balance)


def _value_record(
    balance: Balance, order: int, of: str, cos: float | None, sin: float | None
) -> dict[str, Any]:
    point = balance.operating_point
    if point is None:
        return {}
    known = cos is not None and sin is not None and not (of == "couple" and point.couple is None)
    factor = float(balance.unit_value(of) * balance.share(order)) if known else None
    value = None if factor is None or cos is None or sin is None else hypot(cos, sin) * abs(factor)
    return {
        "value": value,
        "value_unit": UNITS[of],
        "value_cos": None if factor is None or cos is None else cos * factor + 0.0,  # no -0.0
        "value_sin": None if factor is None or sin is None else sin * factor + 0.0,
        "per_cent": None if value is None else 100 * value / float(balance.unit_value(of)),
        "rpm": float(point.rpm),
        "bound": None,
        "degrees": None,
    }


def _largest_records(balance: Balance) -> list[dict[str, Any]]:
    """Return a row for each output's largest value over a turn; none without an operating point."""
    point = balance.operating_point
    if point is None or balance.engine.has_symbols:
        return []
    unknown = ("cos", "sin", "amplitude", "exact_cos", "exact_sin", "unit", "coefficient")
    records = []
    for output, top in balance.turn_maxima.items():
        of, _, name = output.partition(".")
        records.append(
            {
                "order": "all orders",
                "of": of,
                "component": name or "any direction",
                **dict.fromkeys(unknown),
                "value": top.value,
                "value_unit": UNITS[of],
                "value_cos": None,
                "value_sin": None,
                "per_cent": 100 * top.value / float(balance.unit_value(of)),
                "rpm": float(point.rpm),
                "bound": top.bound,
                "degrees": top.angle,
            }
        )
    return records


_UNITS = {
    (True, "force"): "A_n m r omega^2",
    (True, "couple"): "A_n m r omega^2 a",
    (False, "force"): "m r omega^2",
    (False, "couple"): "m r omega^2 a",
}
