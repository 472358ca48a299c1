"""What modules for NumPy and for Numba share: the calls, grids and tests around the formulas."""

from __future__ import annotations

from symbalance.numeric.checks import checks
from symbalance.numeric.cosines import LIMIT
from symbalance.numeric.kernels import Line
from symbalance.numeric.plans import Plan
from symbalance.numeric.targets.folding import folded
from symbalance.numeric.targets.grids import repeating
from symbalance.numeric.targets.printing import Spelling, unique
from symbalance.numeric.targets.wording import paragraphs

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
    points, turns = int(points), int(turns)
    if points < 1 or turns < 1:
        raise ValueError(f"points = {{points}}, turns = {{turns}}: both must be at least 1")
    period = {period}
    index = np.arange(min(period, points*turns), dtype=np.float64)
    values = {values}
    return _given([np.resize(value, points*turns) for value in values])
'''
CALL_DOC = '''
    """Return the outputs at crank angles `theta` (radians, any shape), in SI units.

    One array in theta's shape for one output, a dict of arrays by name for several. float32 angles give
    float32 values, all others float64. `out` takes the values instead of new arrays: an array (for
    several outputs a dict of them), of theta's shape, that type, and in C order.{note}
    """
'''.strip("\n")
RESULTS = '''

def _results(theta, kind, out):
    """Return the arrays to fill: new ones, or `out`, refused where it does not fit."""
    if theta.dtype.kind not in "fiub":
        raise TypeError(f"theta holds {theta.dtype}: crank angles are real numbers, in radians")
    if out is None:
        return [np.empty(theta.shape, kind) for _ in OUTPUTS]
    results = [out] if len(OUTPUTS) == 1 else [out[name] for name in OUTPUTS]
    for result in results:
        if result.shape != theta.shape or result.dtype != kind or not result.flags.c_contiguous:
            raise ValueError(f"out must be a {kind.__name__} array of shape {theta.shape} in C order")
    return results


def _given(results):
    return results[0] if len(OUTPUTS) == 1 else dict(zip(OUTPUTS, results))
'''
SELF_TEST = '''

# Angles, the true values there (mpmath, 50 digits), and what each may be off.
CHECKS = (
{rows}
)


def self_test():
    """Compare with the true values, singly and as an array; raise AssertionError past a bound."""
    angles = np.array([check[0] for check in CHECKS])
    together = evaluate(angles)
    for i, (theta, values, allowed) in enumerate(CHECKS):
        alone = evaluate(theta)
        for name, value, off in zip(OUTPUTS, values, allowed):
            one, many = (alone, together) if len(OUTPUTS) == 1 else (alone[name], together[name])
            for found in (float(one), float(many[i])):
                assert abs(found - value) <= off, f"{{name}}({{theta!r}}) = {{found!r}}, true {{value!r}}"
    lost = evaluate(np.array([np.inf, -np.inf, np.nan]))
    for values in [lost] if len(OUTPUTS) == 1 else lost.values():
        assert np.isnan(values).all(), f"not NaN where theta is not finite: {{values}}"


if __name__ == "__main__":
    self_test()
    print("self-test passed:", len(CHECKS), "angles,", ", ".join(OUTPUTS))
'''


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


def called(name: str, planned: Plan) -> str:
    """Return what `_outputs` is called with: a base function's values."""
    if not planned.bases:
        return "theta"
    return f"{'*' * (len(planned.bases) > 1)}{name}(theta)"


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


def grid_function(planned: Plan) -> list[str]:
    """Return the base function of a grid."""
    if not planned.bases:
        return []
    head = ["", "", "def _on_grid(index, points):", '    """What the outputs are made of, on a grid."""']
    lines = NUMPY.lines(planned.on_grid.lines, "    ")
    return [*head, *lines, f"    return {', '.join(planned.bases)}"]


def grid_call(planned: Plan, scaled: bool) -> str:
    """Return `on_grid`; `scaled` where `_outputs` takes the scales itself."""
    scales = ", ".join(o.wave.unit.formula for o in planned.outputs) + ","
    bases = f"{'*' * (len(planned.bases) > 1)}_on_grid(index, points)" if planned.bases else "index"
    values = (
        f"_outputs({bases}, {scales})"
        if scaled
        else f"[s*v for s, v in zip(({scales}), _outputs({bases}))]"
    )
    if scaled and len(planned.outputs) == 1:
        values = f"[{values}]"
    return GRID.format(period=repeating(planned, "//", "math.gcd")[0], values=values)


def returned(formulas: list[str]) -> list[str]:
    """Return the statement that returns formulas."""
    if len(formulas) == 1:
        return [f"    return {formulas[0]}"]
    return ["    return (", *(f"        {formula}," for formula in formulas), "    )"]


def self_test(planned: Plan) -> str:
    """Return the checks and the function that makes them."""
    rows = "\n".join(f"    ({c.theta!r}, {c.values!r}, {c.allowed!r})," for c in checks(planned))
    return SELF_TEST.format(rows=rows)


def joined(head: list[str], body: str, functions: list[str], test: str) -> str:
    """Return a module's parts as one text, long lines broken."""
    text = "\n".join(head) + "\n" + body + RESULTS + "\n".join(functions) + "\n" + test
    return folded(text, "# ", bracketed=True)
