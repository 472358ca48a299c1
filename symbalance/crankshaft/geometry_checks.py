"""Checks that a crank's parts fit into each other and past each other."""

from __future__ import annotations

from itertools import pairwise
from math import hypot, pi

from symbalance.crankshaft.crank import Crank, Journal, Pin, Web, WebCounterweight
from symbalance.crankshaft.rotor.parts import Disc
from symbalance.crankshaft.webs.arm import Arm, arms, axis_of
from symbalance.errors import SymbalanceError, shown


def check_geometry(crank: Crank) -> None:
    """Refuse a crank whose parts overlap or whose sizes nobody can machine; errors in mm.

    >>> web = Web(0.02, 0.08, 0.04, 0.04)
    >>> ends = Journal(0.06, 0.03)
    >>> check_geometry(Crank((ends, web, Pin(0.05, 0.03, 0.04, 0.0, (1,), bore=0.05), web, ends)))
    Traceback (most recent call last):
        ...
    symbalance.errors.SymbalanceError: part 3, pin: bore = 50 mm: must be less than the diameter, 50 mm
    """
    for index, part in enumerate(crank.parts):
        place = f"part {index + 1}, {type(part).__name__.lower()}"
        if not isinstance(part, Web):
            _check_round(part, place)
    for index, arm in arms(crank):
        _check_arm(arm, f"part {index + 1}, web")
    _check_pairs(crank)
    for name, disc in (("pulley", crank.pulley), ("flywheel", crank.flywheel)):
        if disc is not None:
            _check_disc(disc, name)


def _refuse(place: str, name: str, value: float, rule: str, remedy: str = "") -> None:
    raise SymbalanceError(f"{name} = {mm(value)} mm", rule, remedy, place)


def mm(length: float) -> str:
    """Return a length in mm as a person writes it.

    >>> mm(0.0655)
    '65.5'
    """
    return f"{length * 1e3:.6g}"


def _check_round(part: Journal | Pin, place: str) -> None:
    if part.bore >= part.diameter:
        _refuse(place, "bore", part.bore, f"must be less than the diameter, {mm(part.diameter)} mm")
    if 2 * part.fillet >= part.length:
        rule = f"must be less than half the length, {mm(part.length / 2)} mm"
        _refuse(place, "fillet", part.fillet, rule)


def _check_arm(arm: Arm, place: str) -> None:
    """Refuse a web that does not cover what it carries, with its fillets, or is thinner than those."""
    names = ("heel" if isinstance(arm.near, Journal) else "tip", "tip")
    margins = (arm.near_margin, arm.far_margin)
    for part, own in ((arm.near, 0), (arm.far, 1)):
        kind, radius = type(part).__name__.lower(), part.diameter / 2 + part.fillet
        rule = f"must cover the {kind} with its fillets, {{}} mm"
        if radius > arm.web.width / 2 * (1 + 1e-9):
            _refuse(place, "width", arm.web.width, rule.format(mm(2 * radius)))
        for end, least in ((own, radius), (1 - own, radius - arm.reach)):
            if least > margins[end] * (1 + 1e-9):
                _refuse(place, names[end], margins[end], rule.format(mm(least)))
        if arm.web.thickness <= part.fillet:
            thin = f"must be more than the {kind}'s fillet, {mm(part.fillet)} mm"
            _refuse(place, "thickness", arm.web.thickness, thin)
    if arm.web.counterweight is not None:
        _check_weight(arm.web.counterweight, place)


def _check_pairs(crank: Crank) -> None:
    """Refuse two pins side by side whose sections do not meet."""
    for index, (one, other) in enumerate(pairwise(crank.parts)):
        if isinstance(one, Pin) and isinstance(other, Pin):
            (a, b), (c, d) = axis_of(one), axis_of(other)
            apart, most = hypot(c - a, d - b), (one.diameter + other.diameter) / 2
            if apart >= most:
                rule = f"must be less than {mm(most)} mm for the pins to meet"
                place = f"parts {index + 1} and {index + 2}, pins"
                _refuse(place, "distance between their axes", apart, rule, "a web between them")


def _check_weight(weight: WebCounterweight, place: str) -> None:
    if weight.outer and not 0 < weight.half_angle <= pi:
        what = f"counterweight half_angle = {weight.half_angle * 180 / pi:.6g}"
        raise SymbalanceError(what, "must lie in (0, 180]", "degrees either side of its angle", place)
    if weight.outer and weight.radius > weight.outer:
        rule = f"must be less than its outer radius, {mm(weight.outer)} mm"
        _refuse(place, "counterweight radius", weight.radius, rule)


def _check_disc(disc: Disc, name: str) -> None:
    for field in ("mass", "polar", "diametral"):
        value = getattr(disc, field)
        if not value > 0:
            raise SymbalanceError(f"{field} = {shown(value)}", "must be positive", "kg, kg m^2", name)
    if disc.polar > 2 * disc.diametral * (1 + 1e-9):
        rule = f"must be at most twice the diametral, {shown(disc.diametral)}"
        raise SymbalanceError(f"polar = {shown(disc.polar)}", rule, "as for any body", name)
