"""The comment at the head of every generated source: engine, conventions, units, error bounds."""

from __future__ import annotations

from collections.abc import Iterator
from textwrap import wrap

from symbalance import __version__
from symbalance.codegen.cosines import LIMIT
from symbalance.codegen.plans import Output, Plan

WIDTH = 96
"""Columns of the text; the comment signs around it come on top."""
SIGNS = (
    "theta is the crank angle in radians, positive in the sense of rotation, on the engine's own zero "
    "(cylinder 1 at firing top dead centre, where the engine was made from a firing order). Vertical is "
    "positive upwards, lateral positive to the right seen from the front; a couple is positive where the "
    "front is pushed up, or right."
)
KEYWORDS = (
    "mass: reciprocating mass of one cylinder, kg. radius: crank radius, half the stroke, m. omega: "
    "crank speed, rad/s. pitch: distance between neighbouring cylinders of a bank, m. "
)
ONE_EACH = "Each is 1 unless given: values then are in units of m r omega^2, couples in m r omega^2 a."
AT_SPEED = (
    "Unless given they are those of the engine at {}. Values then are in the units named above; with 1 "
    "for each of them they are in m r omega^2, couples in m r omega^2 a."
)
UNKNOWN = " The engine gives no {}, and no output takes it: it is 1."
TORQUE = (
    "A torque is positive on the crank in the sense of rotation, torque.frame on the frame. "
    "torque.inertia and torque.frame are in units of m r^2 omega^2 where each keyword is 1; torque.rod "
    "takes omega alone, torque.gas radius alone, torque.total none."
)
REDUCTION = (
    f"Up to |theta| = {LIMIT:.0f} rad the angle is reduced exactly. Beyond it every value rests on the "
    "library's cos(theta) and sin(theta), raised to the order. A theta that is not finite gives NaN at "
    "its place and nowhere else; keywords whose product overflows give infinities or NaN. u = 2^-53; "
    "float32 angles are computed in double and rounded once."
)


def paragraphs(plan: Plan, engine: str, reduction: str = REDUCTION) -> Iterator[str]:
    """Yield the lines of a source's head; `reduction` says what happens to the angles."""
    ratio = plan.ratio
    ratio_text = f"{ratio.numerator}" if ratio.denominator == 1 else f"{float(ratio)!r}"
    yield f"{comment_text(engine)}, lambda = l/r = {ratio_text}; made by symbalance {__version__}."
    yield ""
    for output in plan.outputs:
        yield from wrap(_describe(output, plan), WIDTH, subsequent_indent="    ")
    torque = [TORQUE] if any(o.harmonic_sum.name.startswith("torque") for o in plan.outputs) else []
    for text in (SIGNS, KEYWORDS + _defaults(plan), *torque, reduction):
        yield ""
        yield from wrap(text, WIDTH)


def _defaults(plan: Plan) -> str:
    """Return what the keywords are where a call gives none."""
    defaults = plan.defaults
    if not defaults.at_speed:
        return ONE_EACH
    unknown = UNKNOWN.format(" and no ".join(defaults.unknown)) if defaults.unknown else ""
    return AT_SPEED.format(defaults.words()) + unknown


def _describe(output: Output, plan: Plan) -> str:
    harmonic_sum = output.harmonic_sum
    orders = [str(t.order) for t in harmonic_sum.terms]
    listing = ", ".join(orders if len(orders) < 12 else [*orders[:6], "...", orders[-1]])
    if not output.amplitude:
        return f"{harmonic_sum.name}: {harmonic_sum.meaning}. Zero: every order asked for cancels."
    what = "all orders, exact in lambda" if output.uses_closed_form else f"orders {listing}"
    text = (
        f"{harmonic_sum.name} in {harmonic_sum.unit.name}: {harmonic_sum.meaning}. {what}; {output.form}."
    )
    text += f" Mean {float(harmonic_sum.mean):.6g}." if harmonic_sum.mean else ""
    text += f" Amplitude {output.amplitude:.6g}{_at_speed(output, plan)}"
    text += f"; rounding errs by at most {output.rounding:.3g} u of it"
    if output.uses_closed_form or harmonic_sum.left_out == 0.0:
        return text + "."
    if harmonic_sum.left_out is None:
        return text + f"; orders above {harmonic_sum.through} are left out."
    return text + f"; the orders left out sum to at most {harmonic_sum.left_out:.3g}."


def _at_speed(output: Output, plan: Plan) -> str:
    """Return an output's amplitude where no keyword is given; empty where each is 1 then."""
    unit = output.harmonic_sum.unit
    if not (plan.defaults.at_speed and unit.factors):
        return ""
    return f", {output.amplitude * plan.defaults.unit(unit.factors):.6g} {unit.name} at the speed below"


def comment_text(text: str) -> str:
    """Return an engine's name as a comment may hold it: nothing that could end the comment.

    >>> comment_text('V8 "x" */ %')
    'V8 _x_ _/ _'
    """
    return "".join(c if c.isalnum() or c in " .,:;-+()/°" else "_" for c in text)


def identifier(text: str) -> str:
    """Return a name every target language takes.

    >>> identifier("v12-60"), identifier("4 in line")
    ('v12_60', 'engine_4_in_line')
    """
    name = "".join(c if c.isascii() and c.isalnum() else "_" for c in text).strip("_") or "engine"
    return name if name[0].isalpha() else f"engine_{name}"
