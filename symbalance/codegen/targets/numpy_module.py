"""A Python module that needs NumPy alone: blocks of angles through the formulas, in cache.

The calls, grids and self-test around its formulas serve the module for Numba too (`numba_module`).
"""

from __future__ import annotations

from collections.abc import Iterable

from symbalance.codegen.checks import (
    KEYWORDS,
    Check,
    checks,
    default_values,
    grid_checks,
    grid_points,
    unit_values,
)
from symbalance.codegen.cosines import LIMIT
from symbalance.codegen.expression_ir import Statement
from symbalance.codegen.plans import Plan
from symbalance.codegen.targets.header_text import paragraphs
from symbalance.codegen.targets.syntax import Syntax, fold, keyword_arguments, points_per_period, unique

NUMPY = Syntax(
    {
        "rint": "np.rint({})",
        "abs": "np.abs({})",
        "sqrt": "np.sqrt({})",
        "side": "np.copysign(1.0, {})",
        "cos": "np.cos({})",
        "sin": "np.sin({})",
    },
    line="{} = {}",
    constant="{} = {}",
    comment="# {}",
)
WHOLE = '''

def _whole(name, value):
    """Return a whole number, at least 1, or refuse what is none: True too, nan and None."""
    try:
        number = int(value)
        fits = bool(number == value >= 1) and "bool" not in type(value).__name__
    except (TypeError, ValueError, OverflowError):
        fits = False
    if not fits:
        raise ValueError(f"{{name}} = {{value!r}}: must be a whole number, at least 1")
    return number
'''
"""How numbers of points and turns are read in Python; part of a template, so braces are doubled."""
GRID = (
    '''

def on_grid(points, turns=1, *, {arguments}):
    """Return the outputs at theta = 2 pi j/points, j = 0, 1, ... over so many whole turns.

    Only one period is computed, from angles that are exact; the rest repeats it.
    """
    points, turns = _whole("points", points), _whole("turns", turns)
    mass, radius, omega, pitch = _numbers(mass=mass, radius=radius, omega=omega, pitch=pitch)
    results = [np.empty(points*turns) for _ in OUTPUTS]
    size = min({period}, points*turns)
{fill}
    for result in results:
        done = size
        while done < result.size:  # whole periods, twice as many each time
            more = min(done, result.size - done)
            result[done:done + more] = result[:more]
            done += more
    return _given(results)
'''
    + WHOLE
)
CALL_DOC = '''
    """Return the outputs at crank angles `theta` (radians, any shape), in SI units.

    One array in theta's shape for one output, a dict of arrays by name for several. float32 angles give
    float32 values, all others float64. `out` takes the values instead of new arrays: an array (for
    several outputs a dict of them), of theta's shape, that type, and in C order; it may overlap
    theta. The keywords are one number each. TypeError or ValueError: what is no angle (a masked array
    is refused: its mask would be lost), no number, or does not fit.{note}
    """
'''.strip("\n")
ARGUMENTS = '''

def _crank_angles(theta):
    """Return theta as an array of real numbers, or refuse what is none."""
    if isinstance(theta, np.ma.MaskedArray) or isinstance(theta, (list, tuple)) and _has_mask(theta):
        remedy = "theta.compressed() or theta.astype(float).filled(np.nan)"
        raise TypeError(f"theta is a masked array: its mask would be lost, pass {remedy}")
    theta = np.asarray(theta)
    if theta.dtype.kind not in "fiub":
        raise TypeError(f"theta holds {theta.dtype}: crank angles are real numbers, in radians")
    return theta


def _has_mask(angles):
    """Tell whether a list, or one inside it, holds a masked array or `np.ma.masked`."""
    kinds = set(map(type, angles))  # few, however long the list
    if any(issubclass(kind, np.ma.MaskedArray) for kind in kinds):
        return True
    lists = [kind for kind in kinds if issubclass(kind, (list, tuple))]
    return bool(lists) and any(_has_mask(a) for a in angles if isinstance(a, (list, tuple)))


def _numbers(**keywords):
    """Return the values of keywords as floats, or refuse what is not one real number."""
    for name, value in keywords.items():
        if type(value) in (float, int):
            continue
        array = np.asarray(value)  # of a Fraction, and its like: one object
        number = array.dtype.kind == "O" and hasattr(value, "__float__")
        is_real = array.dtype.kind in "fiu" or number
        if array.ndim or not is_real or isinstance(value, np.ma.MaskedArray):
            raise TypeError(f"{name} = {value!r}: must be one real number, in SI units")
    try:
        return list(map(float, keywords.values()))
    except OverflowError:
        most = float(np.finfo(float).max)
        names = " and ".join(name for name, value in keywords.items() if abs(value) > most)
        raise ValueError(f"{names} is beyond every double: {most:.2g} is the largest") from None


def _results(theta, kind, out):
    """Return the arrays to fill: new ones, or `out`, refused where it does not fit."""
    if out is None:
        return [np.empty(theta.shape, kind) for _ in OUTPUTS]
    if len(OUTPUTS) > 1 and not (isinstance(out, dict) and set(out) == set(OUTPUTS)):
        raise ValueError(f"out must be a dict of arrays for {', '.join(OUTPUTS)}")
    results = [out] if len(OUTPUTS) == 1 else [out[name] for name in OUTPUTS]
    for i, result in enumerate(results):
        if not isinstance(result, np.ndarray) or isinstance(result, np.ma.MaskedArray):
            kinds = type(result).__name__
            raise TypeError(f"out is a {kinds}: must be a NumPy array without a mask")
        fits = result.shape == theta.shape and result.dtype == kind
        if not (fits and result.flags.c_contiguous and result.flags.writeable):
            kinds = f"{kind.__name__} array of shape {theta.shape}"
            raise ValueError(f"out must be a {kinds} in C order that may be written")
        if any(np.may_share_memory(result, other) for other in results[:i]):
            raise ValueError("out: two outputs share memory, give each an array of its own")
    return results


def _apart(theta, results):
    """Return theta, copied where results would be written over it before it is read."""
    return theta.copy() if any(np.may_share_memory(theta, result) for result in results) else theta


def _given(results):
    return results[0] if len(OUTPUTS) == 1 else dict(zip(OUTPUTS, results))
'''
SELF_TEST = '''

# Angles, the true values there (mpmath, 50 digits), and what each may be off.
CHECKS = (
{rows}
)
# Keywords that tell each from every other, and what they make of a value of 1.
KEYWORDS = {keywords!r}
UNITS = ({units},)
{defaults}{grid_rows}

def self_test():
    """Compare with the true values: single angles, arrays of several blocks, float32, keywords.

    AssertionError where a value is past its bound.
    """
    theta = np.array([check[0] for check in CHECKS])
    for i in range(len(CHECKS)):
        _compare("alone", evaluate(CHECKS[i][0]{ones}), CHECKS, [i])
    _compare("together", evaluate(theta{ones}), CHECKS, range(len(CHECKS)))
{at_speed}    _compare("with keywords", evaluate(theta, **KEYWORDS), CHECKS, range(len(CHECKS)), UNITS)
    near = np.flatnonzero(np.abs(theta) <= LIMIT)
    row = np.resize(near, 3*BLOCK + 1)
    row[BLOCK:2*BLOCK] = np.resize(np.arange(len(CHECKS)), BLOCK)  # this block has far angles too
    empty = [np.full(row.size, np.nan) for _ in OUTPUTS]
    _compare("in blocks", evaluate(theta[row], out=_given(empty){ones}), CHECKS, row)
    _compare_single(theta)
    lost = evaluate(np.array([np.inf, -np.inf, np.nan]))
    for values in [lost] if len(OUTPUTS) == 1 else lost.values():
        if not np.isnan(values).all():
            raise AssertionError(f"not NaN where theta is not finite: {{values}}")
{grid}

def _compare(where, actual, checks, rows, units=(1.0,)*len(OUTPUTS)):
    """Compare values with those of rows of checks, in units; a unit that is not 1 is a rounding more."""
    for j, (name, unit) in enumerate(zip(OUTPUTS, units)):
        values = np.ravel(actual if len(OUTPUTS) == 1 else actual[name])
        true, allowed = (np.array([check[k][j] for check in checks])[rows] for k in (1, 2))
        allowed = unit*allowed if unit == 1.0 else 2.0*unit*allowed
        wrong = np.flatnonzero(~(np.abs(values - unit*true) <= allowed))
        if wrong.size:  # no assert: python -O would leave it out
            i = wrong[0]
            at = f"{{name}} {{where}}, theta = {{checks[rows[i]][0]!r}}"
            raise AssertionError(f"{{at}}: {{float(values[i])!r}}, true {{float(unit*true[i])!r}}")


def _compare_single(theta):
    """Compare values at float32 angles, which are rounded once, with those at the same doubles."""
    single = theta.astype(np.float32)
    values, true = evaluate(single{ones}), evaluate(single.astype(np.float64){ones})
    for j, name in enumerate(OUTPUTS):
        one, other = (values, true) if len(OUTPUTS) == 1 else (values[name], true[name])
        allowed = 2.0**-23*np.abs(other) + np.array([check[2][j] for check in CHECKS])
        if one.dtype != np.float32 or not np.all(np.abs(one - other) <= allowed):
            raise AssertionError(f"{{name}} at float32 angles: {{one}}, in double {{other}}")


if __name__ == "__main__":
    self_test()
    print("self-test passed:", len(CHECKS), "angles,", ", ".join(OUTPUTS))
'''
AT_SPEED = """    _compare("at speed", evaluate(theta), CHECKS, range(len(CHECKS)), UNITS_AT_SPEED)
"""
GRID_ROWS = """
# The same at theta = 2 pi j/{points}, two turns, for on_grid.
GRID_CHECKS = (
{rows}
)
"""
FINER = 4099
"""A prime above every order: a grid so many times finer has a period of more than a block."""
GRID_TEST = """    _compare("on the grid", on_grid({points}, 2{ones}), GRID_CHECKS, range({twice}))
    finer = on_grid({points}*{finer}, **KEYWORDS)
    every = [(finer if len(OUTPUTS) == 1 else finer[name])[::{finer}] for name in OUTPUTS]
    _compare("on a fine grid", _given(every), GRID_CHECKS, range({points}), UNITS)
"""


def docstring(plan: Plan, engine: str) -> list[str]:
    """Return the module's docstring."""
    first, *rest = paragraphs(plan, engine)
    return [f'"""{first}', *rest, '"""']


def constants(syntax: Syntax, plan: Plan) -> list[str]:
    """Return the definitions of every constant."""
    names = ", ".join(repr(o.harmonic_sum.name) for o in plan.outputs)
    kernels = (plan.reduced_range, plan.full_range, plan.on_grid, plan.tail)
    return [
        f"OUTPUTS = ({names},)",
        f"LIMIT = {LIMIT!r}  # the largest |theta| that is reduced exactly",
        "",
        *syntax.constants(unique(k.constants for k in kernels)),
    ]


def basis_call(name: str, plan: Plan, arguments: str = "theta", zero: str = "theta") -> str:
    """Return what `_outputs` is called with: a base function's values, or `zero` where there is none."""
    if not plan.basis:
        return zero
    return f"{'*' * (len(plan.basis) > 1)}{name}({arguments})"


def base_function(
    syntax: Syntax,
    name: str,
    lines: list[Statement],
    basis: tuple[str, ...],
    where: str,
    decorator: str = "",
) -> list[str]:
    """Return the function of the lines that the outputs are made of."""
    if not basis:
        return []
    decorated = [decorator] if decorator else []
    head = [
        "",
        "",
        *decorated,
        f"def {name}(theta):",
        f'    """What the outputs are made of, for {where}."""',
    ]
    return [*head, *syntax.lines(lines, "    "), f"    return {', '.join(basis)}"]


def grid_function(syntax: Syntax, plan: Plan, decorator: str = "") -> list[str]:
    """Return the base function of a grid."""
    if not plan.basis:
        return []
    decorated = [decorator] if decorator else []
    head = ["", "", *decorated, "def _on_grid(index, points):"]
    head.append('    """What the outputs are made of, on a grid."""')
    lines = syntax.lines(plan.on_grid.lines, "    ")
    return [*head, *lines, f"    return {', '.join(plan.basis)}"]


def grid_call(plan: Plan, fill: str) -> str:
    """Return `on_grid`; `fill` computes one period, `size` values of each of `results`."""
    period = points_per_period(plan, "//", "math.gcd")[0]
    return GRID.format(period=period, fill=fill, arguments=keyword_arguments(plan))


def return_statement(formulas: list[str]) -> list[str]:
    """Return the statement that returns formulas."""
    if len(formulas) == 1:
        return [f"    return {formulas[0]}"]
    return ["    return (", *(f"        {formula}," for formula in formulas), "    )"]


def self_test_text(plan: Plan, grid: bool) -> str:
    """Return the checks and the function that makes them; `grid` where there is `on_grid` to check."""
    points = grid_points(plan)
    grid_rows = GRID_ROWS.format(points=points, rows=_rows(grid_checks(plan))) if grid else ""
    at_speed = plan.defaults.at_speed
    ones = ", **ONES" if at_speed else ""
    test = GRID_TEST.format(points=points, twice=2 * points, finer=FINER, ones=ones)
    return SELF_TEST.format(
        rows=_rows(checks(plan)),
        keywords=KEYWORDS,
        units=", ".join(map(repr, unit_values(plan))),
        grid_rows=grid_rows,
        grid=test if grid else "",
        defaults=defaults_text(plan) if at_speed else "",
        at_speed=AT_SPEED if at_speed else "",
        ones=ones,
    )


def defaults_text(plan: Plan) -> str:
    """Return the keywords that make units of the defaults, and what the defaults make of a value of 1."""
    units = ", ".join(map(repr, default_values(plan)))
    ones = dict.fromkeys(KEYWORDS, 1.0)
    return f"# Where none is given.\nONES, UNITS_AT_SPEED = {ones!r}, ({units},)\n"


def _rows(rows: Iterable[Check]) -> str:
    return "\n".join(f"    ({c.theta!r}, {c.values!r}, {c.allowed!r})," for c in rows)


def module_text(head: list[str], body: str, functions: list[str], test: str) -> str:
    """Return a module's parts as one text, long lines broken."""
    text = "\n".join(head) + "\n" + body + ARGUMENTS + "\n".join(functions) + "\n" + test
    return fold(text, "# ", bracketed=True)


NUMPY_CALL = '''
BLOCK = 16000  # angles at a time: intermediate values of 128 kB stay in cache, on pages in use


def evaluate(theta, *, {arguments}, out=None):
{call_doc}
    theta = _crank_angles(theta)
    mass, radius, omega, pitch = _numbers(mass=mass, radius=radius, omega=omega, pitch=pitch)
    kind = np.float32 if theta.dtype.kind == "f" and theta.dtype.itemsize == 4 else np.float64
    scales = ({scales})
    if theta.ndim == 0 and out is None:
        values = _at(np.float64(theta))
        return _given([kind(value * scale) for value, scale in zip(values, scales)])
    results = _results(theta, kind, out)
    theta = _apart(theta, results)
    flat = theta.reshape(-1) if theta.flags.c_contiguous else theta.flat
    filled = [np.asarray(result).reshape(-1) for result in results]
    for start in range(0, theta.size, BLOCK):
        stop = min(start + BLOCK, theta.size)
        values = _at(np.asarray(flat[start:stop], dtype=np.float64))
        for result, value, scale in zip(filled, values, scales):
            np.multiply(value, scale, out=result[start:stop], casting="same_kind")
    return _given(results)


def _at(theta):
    """Return the outputs at a block of angles, with every keyword 1."""
    if np.max(theta) <= LIMIT and np.min(theta) >= -LIMIT:
        return _outputs({near})
    with np.errstate(invalid="ignore", over="ignore"):
        far = ~(np.abs(theta) <= LIMIT)
        near, beyond = _outputs({near}), _outputs({far})
        return tuple(np.where(far, b, a) for a, b in zip(near, beyond))
'''
GRID_FILL = """
    scales = ({scales})
    for start in range(0, size, BLOCK):
        stop = min(start + BLOCK, size)
        index = np.arange(start, stop, dtype=np.float64)
        for result, value, scale in zip(results, _outputs({basis}), scales):
            np.multiply(value, scale, out=result[start:stop])
""".strip("\n")


def numpy_source(plan: Plan, engine: str, grid: bool) -> str:
    """Return a module that needs NumPy alone."""
    calls = ["import math", ""] if grid and points_per_period(plan)[1] else []
    head = [*docstring(plan, engine), "", *calls, "import numpy as np", ""]
    scales = ", ".join(o.harmonic_sum.unit.formula for o in plan.outputs) + ","
    fill = GRID_FILL.format(scales=scales, basis=basis_call("_on_grid", plan, "index, points", "index"))
    body = NUMPY_CALL.format(
        arguments=keyword_arguments(plan),
        call_doc=CALL_DOC.format(note=""),
        scales=scales,
        near=basis_call("_near", plan),
        far=basis_call("_far", plan),
    )
    basis = ", ".join(plan.basis) or "theta"
    zero = "0.0*" + (plan.basis or ("theta",))[0]
    formulas = [NUMPY.formula(o.formula if o.formula != "0.0" else zero) for o in plan.outputs]
    functions = [
        *base_function(NUMPY, "_near", plan.reduced_range.lines, plan.basis, "|theta| <= LIMIT"),
        *base_function(NUMPY, "_far", plan.full_range.lines, plan.basis, "any angle"),
        *(grid_function(NUMPY, plan) if grid else []),
        "",
        "",
        f"def _outputs({basis}):",
        '    """The outputs, with every keyword 1."""',
        *NUMPY.lines(plan.tail.lines, "    "),
        "    return (",
        *(f"        {formula}," for formula in formulas),
        "    )",
    ]
    return module_text(
        [*head, *constants(NUMPY, plan)],
        body + (grid_call(plan, fill) if grid else ""),
        functions,
        self_test_text(plan, grid),
    )
