"""A Python module for any array library of the array API standard: JAX, PyTorch, CuPy, NumPy.

It imports no array library and never looks at a value, so that it can be compiled (`jax.jit`),
differentiated and left on a device. float64 angles are reduced exactly to 2^50 rad, float32 angles in
float32 (`argument_reduction`, `float32_cosines`): the type of the angles decides, not what the library or
the device can do besides. Both reductions cost less than the choice between two kernels, which computes
both.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import chain
from math import pi

import numpy as np

from symbalance.codegen.argument_reduction import FARTHEST_ANGLE, TURNS, extend_range
from symbalance.codegen.checks import (
    ANGLES,
    KEYWORDS,
    Check,
    checks,
    counted_angles,
    grid_checks,
    grid_points,
    unit_values,
)
from symbalance.codegen.cosines import LIMIT
from symbalance.codegen.expression_ir import Kernel
from symbalance.codegen.float32_cosines import LIMIT32, float32_kernel
from symbalance.codegen.plans import Plan
from symbalance.codegen.targets.header_text import paragraphs
from symbalance.codegen.targets.numpy_module import WHOLE, defaults_text
from symbalance.codegen.targets.syntax import Syntax, fold, keyword_arguments, points_per_period, unique

SYNTAX = Syntax(
    {
        "rint": "xp.round({})",
        "abs": "xp.abs({})",
        "sqrt": "xp.sqrt({})",
        "side": "xp.where({} < 0.0, -one, one)",
        "cos": "xp.cos({})",
        "sin": "xp.sin({})",
    },
    line="{} = {}",
    constant="{} = {}",
    comment="# {}",
)
REDUCTION = (
    "The type of theta decides the arithmetic. float64: angles are reduced exactly up to "
    f"{FARTHEST_ANGLE:.3g} rad, values are within the bounds above, and u = 2^-53. float32: up to "
    f"{LIMIT32:.3g} rad theta is taken exactly as it is, everything is computed in float32, and "
    "u = 2^-24. Larger angles, which the type holds to no better than 1/4 of a radian, and angles that "
    "are not finite give NaN at their place and nowhere else. Every other type of theta is refused."
)
MODULE = '''
{imports}

OUTPUTS = ({names},)
LIMIT = {limit!r}  # the largest |theta| in float64
LIMIT_SINGLE = {limit_single!r}  # and in float32

# To reduce float64 angles.
{double}

# To reduce float32 angles.
{single}

# The outputs.
{constants}


def evaluate(theta, *, {arguments}, xp=None):
    """Return the outputs at crank angles `theta` (radians, any shape), in SI units.

    One array of theta's shape, type and device for one output, a dict of arrays by name for
    several. `theta` is a float64 or float32 array. `xp` is its library, found from theta where not
    given. The keywords are numbers, or arrays of that library. No step depends on a value:
    jax.jit(evaluate) works.
    """
    xp = _namespace(theta) if xp is None else xp
    if hasattr(theta, "mask") or isinstance(theta, (list, tuple)) and _has_mask(theta):
        raise TypeError("theta is a masked array: its mask would be lost, pass theta.filled(nan)")
    theta = theta if hasattr(theta, "dtype") else xp.asarray(theta)
    scales = _scales(mass=mass, radius=radius, omega=omega, pitch=pitch)
    if theta.dtype == xp.float64:
        {basis} = _angles(_within(theta, LIMIT, xp), xp)
    elif theta.dtype == xp.float32:
        {basis} = _angles_single(_within(theta, LIMIT_SINGLE, xp), xp)
    else:
        raise TypeError(f"theta holds {{theta.dtype}}: must be float64 or float32, in radians")
    return _given([scale*value for scale, value in zip(scales, _outputs({basis}, xp))])
{grid}

def _given(values):
    return values[0] if len(OUTPUTS) == 1 else dict(zip(OUTPUTS, values))


def _namespace(array):
    """Return an array's library: what the standard says it is, else its type's package (torch)."""
    if hasattr(array, "__array_namespace__"):
        return array.__array_namespace__()
    package = type(array).__module__.partition(".")[0]
    if package == "builtins":
        raise TypeError(f"theta is a {{type(array).__name__}}: pass an array, or its library as xp=")
    if package not in sys.modules or not hasattr(sys.modules[package], "float64"):
        raise TypeError(f"theta is a {{type(array).__name__}}: {{package}} is no array library")
    return sys.modules[package]


def _has_mask(angles):
    """Tell whether a list, or one inside it, holds a masked array."""
    return any(_has_mask(a) if isinstance(a, (list, tuple)) else hasattr(a, "mask") for a in angles)


def _number(name, value):
    """Return a number as a Python one, which leaves the type of the arrays it multiplies alone."""
    if isinstance(value, float) or type(value) is int:
        return _float(name, value)
    if hasattr(value, "dtype"):
        kind = str(value.dtype)
        if ("float" in kind or "int" in kind) and not hasattr(value, "mask"):
            return value
    elif hasattr(value, "__float__") and not isinstance(value, bool):
        return _float(name, value)
    raise TypeError(f"{{name}} = {{value!r}}: must be a real number or an array of them, in SI units")


def _float(name, value):
    try:
        return float(value)
    except OverflowError:
        raise ValueError(f"{{name}} is beyond every double: 1.8e308 is the largest") from None


def _scales(**keywords):
    """Return what each output is measured in: {units}."""
    mass, radius, omega, pitch = (_number(name, value) for name, value in keywords.items())
    return ({scales},)


def _within(theta, limit, xp):
    """Return theta, NaN beyond the limit."""
    return xp.where(xp.abs(theta) <= limit, theta, xp.full_like(theta, float("nan")))


{functions}


def _outputs({basis}, xp):
    """The outputs, with every keyword 1."""
{tail}    return (
{formulas}
    )
'''
GRID = (
    '''

def on_grid(points, turns=1, *, xp, dtype=None, {arguments}):
    """Return the outputs at theta = 2 pi j/points, j = 0, 1, ... over so many whole turns.

    Only one period is computed, from angles that are exact; the rest repeats it. `xp` is the array
    library, `dtype` its float64 or float32, the library's own default where not given. A keyword that
    is an array is broadcast against all the points of all the turns.
    """
    points, turns = _whole("points", points), _whole("turns", turns)
    period, length = {period}, points*turns
    index = xp.arange(0.0, float(min(period, length)), dtype=dtype)
    if index.dtype != xp.float64 and {highest}*points > 2**24:
        raise ValueError(f"points = {{points}}: float32 takes up to {{2**24//{highest}}}, float64 more")
    scales = _scales(mass=mass, radius=radius, omega=omega, pitch=pitch)
    {basis} = _on_grid(index, float(points), xp)
    values = [xp.tile(value, (-(-length//period),))[:length] for value in _outputs({basis}, xp)]
    return _given([scale*value for scale, value in zip(scales, values)])
'''
    + WHOLE
)
FAR_ANGLE = 3e14
"""An angle at which every part of the period counts that reduces angles to 2^50."""
SELF_TEST = '''

# Angles, the true values there (mpmath, 50 digits), and what each may be off; then for float32.
CHECKS = (
{rows}
)
CHECKS_SINGLE = (
{rows_single}
)
# Keywords that tell each from every other, and what they make of a value of 1.
KEYWORDS = {keywords!r}
UNITS = ({units},)
{defaults}{grid_rows}

def self_test(xp=None):
    """Compare with the true values, in float32 and, where `xp` (or NumPy) has it, float64."""
    import warnings

    if xp is None:
        import numpy as xp
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # JAX without float64 warns, and gives float32
        double = xp.asarray([check[0] for check in CHECKS], dtype=xp.float64)
    if double.dtype == xp.float64:
        _test(double, CHECKS, xp, 1.0)
    single = xp.asarray([check[0] for check in CHECKS_SINGLE], dtype=xp.float32)
    _test(single, CHECKS_SINGLE, xp, 2.0**29)


def _test(angles, checks, xp, times):
    _compare("", evaluate(angles, xp=xp{ones}), checks, angles.dtype, 1.0)
{at_speed}    actual = evaluate(angles, xp=xp, **KEYWORDS)
    _compare(" with keywords", actual, checks, angles.dtype, 2.0, UNITS)
{grid}    infinite = xp.asarray([float("inf"), float("-inf"), float("nan")], dtype=angles.dtype)
    lost = evaluate(infinite, xp=xp)
    for values in [lost] if len(OUTPUTS) == 1 else lost.values():
        if not bool(xp.all(xp.isnan(values))):
            raise AssertionError(f"not NaN where theta is not finite: {{values}}")


def _compare(where, actual, checks, dtype, times, units=(1.0,)*len(OUTPUTS)):
    for j, (name, unit) in enumerate(zip(OUTPUTS, units)):
        values = actual if len(OUTPUTS) == 1 else actual[name]
        if values.dtype != dtype:  # no assert: python -O would leave it out
            raise AssertionError(f"{{name}}: {{values.dtype}} from {{dtype}}")
        for i, (theta, true, allowed) in enumerate(checks):
            value = float(values[i])
            if not abs(value - unit*true[j]) <= times*unit*allowed[j]:
                right = unit*true[j]
                raise AssertionError(f"{{name}}{{where}}({{theta!r}}) = {{value!r}}, true {{right!r}}")


if __name__ == "__main__":
    self_test()
    print("self-test passed:", len(CHECKS) + len(CHECKS_SINGLE), "angles,", ", ".join(OUTPUTS))
'''
AT_SPEED = """    actual = evaluate(angles, xp=xp)
    _compare(" at speed", actual, checks, angles.dtype, 2.0, UNITS_AT_SPEED)
"""
GRID_ROWS = """
# The same at theta = 2 pi j/{points}, two turns, for on_grid.
GRID_CHECKS = (
{rows}
)
"""
GRID_TEST = """    grid = on_grid({points}, 2, xp=xp, dtype=angles.dtype{ones})
    _compare(" on the grid", grid, GRID_CHECKS, angles.dtype, times)
    grid = on_grid({points}, 2, xp=xp, dtype=angles.dtype, **KEYWORDS)
    _compare(" on the grid, with keywords", grid, GRID_CHECKS, angles.dtype, 2.0*times, UNITS)
"""


def array_api_source(plan: Plan, engine: str, grid: bool) -> str:
    """Return a module that needs the array library of its arguments alone."""
    double, single = extend_range(plan.reduced_range), float32_kernel(plan.shared, plan.basis)
    more = [plan.tail, *([plan.on_grid] if grid else [])]
    basis = ", ".join(plan.basis) or "theta"
    units = [o.harmonic_sum.unit.formula for o in plan.outputs]
    functions = [
        *_function("_angles", "theta", double, basis, "float64 angles"),
        "",
        "",
        *_function("_angles_single", "theta", single, basis, "float32 angles"),
    ]
    zero = "0.0*" + (plan.basis or ("theta",))[0]
    formulas = [zero if o.formula == "0.0" else SYNTAX.formula(o.formula) for o in plan.outputs]
    first, *rest = paragraphs(plan, engine, REDUCTION)
    calls_gcd = grid and points_per_period(plan)[1]
    module = MODULE.format(
        imports="import math\nimport sys" if calls_gcd else "import sys",
        names=", ".join(repr(o.harmonic_sum.name) for o in plan.outputs),
        arguments=keyword_arguments(plan),
        limit=FARTHEST_ANGLE,
        limit_single=LIMIT32,
        **_constants(double, single, more),
        grid=_grid(plan, basis) if grid else "",
        basis=basis,
        units=", ".join(o.harmonic_sum.unit.name for o in plan.outputs),
        scales=", ".join(units),
        functions="\n".join(functions),
        tail="".join(f"{line}\n" for line in _body(plan.tail)),
        formulas="\n".join(f"        {formula}," for formula in formulas),
    )
    hard = (counted_angles(plan.reduced_range, limit) for limit in (LIMIT, pi * TURNS))
    angles = (*ANGLES, FAR_ANGLE, *chain.from_iterable(hard))
    rows = "\n".join(_row(check) for check in checks(plan, angles))
    points, grid_rows = grid_points(plan), "\n".join(map(_row, grid_checks(plan)))
    at_speed = plan.defaults.at_speed
    ones = ", **ONES" if at_speed else ""
    test = SELF_TEST.format(
        defaults=defaults_text(plan) if at_speed else "",
        at_speed=AT_SPEED if at_speed else "",
        ones=ones,
        rows=rows,
        rows_single="\n".join(map(_row, _single_checks(plan))),
        keywords=KEYWORDS,
        units=", ".join(map(repr, unit_values(plan))),
        grid_rows=GRID_ROWS.format(points=points, rows=grid_rows) if grid else "",
        grid=GRID_TEST.format(points=points, ones=ones) if grid else "",
    )
    return fold("\n".join([f'"""{first}', *rest, '"""']) + "\n" + module + test, "# ", bracketed=True)


def _constants(double: Kernel, single: Kernel, more: list[Kernel]) -> dict[str, str]:
    """Return the definitions of the constants, each once, under what needs it first."""
    groups = {"double": [double], "single": [single], "constants": more}
    texts, before = {}, []
    for name, kernels in groups.items():
        count = len(unique(before))
        constants = unique([*before, *(k.constants for k in kernels)])
        texts[name] = "\n".join(SYNTAX.constants(constants[count:]))
        before.append(constants)
    return texts


def _function(name: str, arguments: str, kernel: Kernel, basis: str, where: str) -> list[str]:
    head = [f"def {name}({arguments}, xp):", f'    """What the outputs are made of, from {where}."""']
    return [*head, *_body(kernel), f"    return {basis}"]


def _body(kernel: Kernel) -> list[str]:
    """Return a kernel's lines; `side` needs an array of ones first."""
    lines = SYNTAX.lines(kernel.lines, "    ")
    argument = "index" if "index" in kernel.names() else "theta"
    needs_one = any("-one, one" in line for line in lines)
    return [f"    one = xp.ones_like({argument})", *lines] if needs_one else lines


def _grid(plan: Plan, basis: str) -> str:
    highest = int(plan.highest_step * plan.step.denominator**2)
    period, _ = points_per_period(plan, "//", "math.gcd")
    text = GRID.format(period=period, basis=basis, highest=highest, arguments=keyword_arguments(plan))
    kernel = plan.on_grid
    where = "theta = 2 pi index/points"
    if not kernel.lines:  # every output is zero
        return text + "\n\ndef _on_grid(index, points, xp):\n    return index\n"
    return text + "\n\n" + "\n".join(_function("_on_grid", "index, points", kernel, basis, where)) + "\n"


def _single_checks(plan: Plan) -> list[Check]:
    """Return the checks at the angles' float32 neighbours, with 2^29 times as much allowed."""
    doubles = checks(plan, [float(np.float32(theta)) for theta in ANGLES])
    return [replace(check, allowed=tuple(a * 2.0**29 for a in check.allowed)) for check in doubles]


def _row(check: Check) -> str:
    return f"    ({check.theta!r}, {check.values!r}, {check.allowed!r}),"
