"""What modules for NumPy and for Numba share: the calls, grids and tests around the formulas."""

from __future__ import annotations

from collections.abc import Iterable

from symbalance.codegen.checks import Check, checks, grid_checks, grid_points
from symbalance.codegen.cosines import LIMIT
from symbalance.codegen.kernels import Line
from symbalance.codegen.plans import Plan
from symbalance.codegen.targets.folding import folded
from symbalance.codegen.targets.grids import repeating
from symbalance.codegen.targets.printing import Spelling, unique
from symbalance.codegen.targets.wording import paragraphs

NUMPY = Spelling(
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
GRID = '''

def on_grid(points, turns=1, *, mass=1.0, radius=1.0, omega=1.0, pitch=1.0):
    """Return the outputs at theta = 2 pi j/points, j = 0, 1, ... over so many whole turns.

    Only one period is computed, from angles that are exact; the rest repeats it.
    """
    if not (points == int(points) >= 1 and turns == int(turns) >= 1):
        raise ValueError(f"points = {{points}}, turns = {{turns}}: must be whole numbers, at least 1")
    points, turns = int(points), int(turns)
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
    if isinstance(theta, np.ma.MaskedArray):
        remedy = "theta.compressed() or theta.astype(float).filled(np.nan)"
        raise TypeError(f"theta is a masked array: its mask would be lost, pass {remedy}")
    theta = np.asarray(theta)
    if theta.dtype.kind not in "fiub":
        raise TypeError(f"theta holds {theta.dtype}: crank angles are real numbers, in radians")
    return theta


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
    return map(float, keywords.values())


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
{grid_rows}

def self_test():
    """Compare with the true values, singly and as an array; raise AssertionError past a bound."""
    together = evaluate(np.array([check[0] for check in CHECKS]))
    for i, (theta, values, allowed) in enumerate(CHECKS):
        alone = evaluate(theta)
        for name, value, off in zip(OUTPUTS, values, allowed):
            one, many = (alone, together) if len(OUTPUTS) == 1 else (alone[name], together[name])
            for found in (float(one), float(many[i])):
                _compare(f"{{name}}({{theta!r}})", found, value, off)
    lost = evaluate(np.array([np.inf, -np.inf, np.nan]))
    for values in [lost] if len(OUTPUTS) == 1 else lost.values():
        if not np.isnan(values).all():
            raise AssertionError(f"not NaN where theta is not finite: {{values}}")
{grid}

def _compare(where, found, true, allowed):
    if not abs(found - true) <= allowed:  # no assert: python -O would leave it out
        raise AssertionError(f"{{where}} = {{found!r}}, true {{true!r}}")


if __name__ == "__main__":
    self_test()
    print("self-test passed:", len(CHECKS), "angles,", ", ".join(OUTPUTS))
'''
GRID_ROWS = """
# The same at theta = 2 pi j/{points}, two turns, for on_grid.
GRID_CHECKS = (
{rows}
)
"""
GRID_TEST = """    grid = on_grid({points}, 2)
    for i, (theta, values, allowed) in enumerate(GRID_CHECKS):
        for name, value, off in zip(OUTPUTS, values, allowed):
            found = grid if len(OUTPUTS) == 1 else grid[name]
            _compare(f"{{name}} on the grid, {{theta!r}}", float(found[i]), value, off)
"""


def docstring(planned: Plan, engine: str) -> list[str]:
    """Return the module's docstring."""
    first, *rest = paragraphs(planned, engine)
    return [f'"""{first}', *rest, '"""']


def constants(spelling: Spelling, planned: Plan) -> list[str]:
    """Return the definitions of every constant."""
    names = ", ".join(repr(o.wave.name) for o in planned.outputs)
    kernels = (planned.near, planned.far, planned.on_grid, planned.tail)
    return [
        f"OUTPUTS = ({names},)",
        f"LIMIT = {LIMIT!r}  # the largest |theta| that is reduced exactly",
        "",
        *spelling.constants(unique(k.constants for k in kernels)),
    ]


def called(name: str, planned: Plan, arguments: str = "theta", zero: str = "theta") -> str:
    """Return what `_outputs` is called with: a base function's values, or `zero` where there is none."""
    if not planned.bases:
        return zero
    return f"{'*' * (len(planned.bases) > 1)}{name}({arguments})"


def base_function(
    spelling: Spelling,
    name: str,
    lines: list[Line],
    bases: tuple[str, ...],
    where: str,
    decorator: str = "",
) -> list[str]:
    """Return the function of the lines that the outputs are made of."""
    if not bases:
        return []
    decorated = [decorator] if decorator else []
    head = [
        "",
        "",
        *decorated,
        f"def {name}(theta):",
        f'    """What the outputs are made of, for {where}."""',
    ]
    return [*head, *spelling.lines(lines, "    "), f"    return {', '.join(bases)}"]


def grid_function(spelling: Spelling, planned: Plan, decorator: str = "") -> list[str]:
    """Return the base function of a grid."""
    if not planned.bases:
        return []
    decorated = [decorator] if decorator else []
    head = ["", "", *decorated, "def _on_grid(index, points):"]
    head.append('    """What the outputs are made of, on a grid."""')
    lines = spelling.lines(planned.on_grid.lines, "    ")
    return [*head, *lines, f"    return {', '.join(planned.bases)}"]


def grid_call(planned: Plan, fill: str) -> str:
    """Return `on_grid`; `fill` computes one period, `size` values of each of `results`."""
    return GRID.format(period=repeating(planned, "//", "math.gcd")[0], fill=fill)


def returned(formulas: list[str]) -> list[str]:
    """Return the statement that returns formulas."""
    if len(formulas) == 1:
        return [f"    return {formulas[0]}"]
    return ["    return (", *(f"        {formula}," for formula in formulas), "    )"]


def self_test(planned: Plan, grid: bool) -> str:
    """Return the checks and the function that makes them; `grid` where there is `on_grid` to check."""
    points = grid_points(planned)
    grid_rows = GRID_ROWS.format(points=points, rows=_rows(grid_checks(planned))) if grid else ""
    return SELF_TEST.format(
        rows=_rows(checks(planned)),
        grid_rows=grid_rows,
        grid=GRID_TEST.format(points=points) if grid else "",
    )


def _rows(found: Iterable[Check]) -> str:
    return "\n".join(f"    ({c.theta!r}, {c.values!r}, {c.allowed!r})," for c in found)


def joined(head: list[str], body: str, functions: list[str], test: str) -> str:
    """Return a module's parts as one text, long lines broken."""
    text = "\n".join(head) + "\n" + body + ARGUMENTS + "\n".join(functions) + "\n" + test
    return folded(text, "# ", bracketed=True)
