"""Python modules: NumPy alone, and Numba."""

from __future__ import annotations

from symbalance.numeric.checks import checks
from symbalance.numeric.cosines import LIMIT
from symbalance.numeric.kernels import Line
from symbalance.numeric.plans import Plan
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
NUMBA = Spelling(
    {
        "rint": "(({} + MAGIC) - MAGIC)",
        "abs": "abs({})",
        "sqrt": "np.sqrt({})",
        "side": "math.copysign(1.0, {})",
        "cos": "math.cos({})",
        "sin": "math.sin({})",
    },
    line="{} = {}",
    constant="{} = {}",
    comment="# {}",
)
NUMPY_CALL = '''
BLOCK = 16000  # angles at a time: intermediate values of 128 kB stay in cache, on pages in use


def evaluate(theta, *, mass=1.0, radius=1.0, omega=1.0, pitch=1.0, out=None):
{call_doc}
    theta = np.asarray(theta)
    kind = np.float32 if theta.dtype == np.float32 else np.float64
    scales = ({scales})
    if theta.ndim == 0 and out is None:
        values = _at(np.float64(theta))
        return _given([kind(value * scale) for value, scale in zip(values, scales)])
    results = _results(theta, kind, out)
    flat = theta.reshape(-1) if theta.flags.c_contiguous else theta.flat
    for start in range(0, theta.size, BLOCK):
        stop = min(start + BLOCK, theta.size)
        values = _at(np.asarray(flat[start:stop], dtype=np.float64))
        for result, value, scale in zip(results, values, scales):
            np.multiply(value, scale, out=result.reshape(-1)[start:stop], casting="same_kind")
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
NUMBA_CALL = '''
BLOCK = 4096  # angles at a time: one far angle sends its block the slow way, not all


def evaluate(theta, *, mass=1.0, radius=1.0, omega=1.0, pitch=1.0, out=None):
{call_doc}
    theta = np.asarray(theta)
    kind = np.float32 if theta.dtype == np.float32 else np.float64
    results = _results(theta, kind, out)
    flat = np.ascontiguousarray(theta, dtype=kind).reshape(-1)
    _fill(flat, {scales}, {flattened})
    return _given(results)


@njit(error_model="numpy", fastmath={{"contract"}}, nogil=True)
def _fill(theta, {scale_names}, {out_names}):
    for start in range(0, theta.size, BLOCK):
        part = theta[start:start + BLOCK]
        if _fill_near(part, {scale_names}, {out_parts}) < part.size:
            _fill_any(part, {scale_names}, {out_parts})


@njit(error_model="numpy", fastmath={{"contract"}}, nogil=True)
def _fill_near(theta, {scale_names}, {out_names}):
    """Fill as if every angle were within LIMIT, and return how many are."""
    inside = 0
    for i in range(theta.size):
        {near}
        {stores}
        inside += abs(theta[i]) <= LIMIT
    return inside


@njit(error_model="numpy", fastmath={{"contract"}}, nogil=True)
def _fill_any(theta, {scale_names}, {out_names}):
    for i in range(theta.size):
        if abs(theta[i]) <= LIMIT:
            {near}
        else:
            {far}
        {stores}
'''
GRID = '''

def on_grid(points, turns=1, *, mass=1.0, radius=1.0, omega=1.0, pitch=1.0):
    """Return the outputs at theta = 2 pi j/points, j = 0, 1, ... over so many whole turns.

    Only one period is computed, from angles that are exact; the rest repeats it.
    """
    points, turns = int(points), int(turns)
    if points < 1 or turns < 1:
        raise ValueError(f"points = {{points}}, turns = {{turns}}: both must be at least 1")
    period = {under}*points//math.gcd({under}*points, {over})
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


def numpy_source(planned: Plan, engine: str, grid: bool) -> str:
    """Return a module that needs NumPy alone."""
    head = [*_docstring(planned, engine), "", "import math", "", "import numpy as np", ""]
    body = NUMPY_CALL.format(
        call_doc=CALL_DOC.format(note=""),
        scales=", ".join(o.wave.unit.formula for o in planned.outputs) + ",",
        near=_call("_near", planned),
        far=_call("_far", planned),
    )
    bases = ", ".join(planned.bases) or "theta"
    zero = "0.0*" + (planned.bases or ("theta",))[0]
    formulas = [NUMPY.formula(o.formula if o.formula != "0.0" else zero) for o in planned.outputs]
    functions = [
        *_function(NUMPY, "_near", planned.near.lines, planned.bases, "|theta| <= LIMIT"),
        *_function(NUMPY, "_far", planned.far.lines, planned.bases, "any angle"),
        *(_grid_function(planned) if grid else []),
        "",
        "",
        f"def _outputs({bases}):",
        '    """The outputs, with every keyword 1."""',
        *NUMPY.lines(planned.tail.lines, "    "),
        "    return (",
        *(f"        {formula}," for formula in formulas),
        "    )",
    ]
    return _joined(
        [*head, *_constants(NUMPY, planned)],
        body + (_grid(planned, False) if grid else ""),
        functions,
        _self_test(planned),
    )


def numba_source(planned: Plan, engine: str, grid: bool) -> str:
    """Return a module that needs NumPy and Numba; one pass over the angles, no C compiler."""
    head = [*_docstring(planned, engine), "", "import math", "", "import numpy as np"]
    head += ["from numba import njit", "", "MAGIC = 6755399441055744.0  # 1.5 * 2^52: adding it rounds"]
    count = range(len(planned.outputs))
    scales = ", ".join(f"scale{i}" for i in count)
    stored = ", ".join(f"out{i}[i]" for i in count)
    bases = ", ".join(planned.bases)
    at = "np.float64(theta[i])"
    body = NUMBA_CALL.format(
        call_doc=CALL_DOC.format(note=" The first call\n    with a type of angles compiles."),
        scales=", ".join(f"float({o.wave.unit.formula})" for o in planned.outputs),
        flattened=", ".join(f"results[{i}].reshape(-1)" for i in count),
        scale_names=scales,
        out_names=", ".join(f"out{i}" for i in count),
        out_parts=", ".join(f"out{i}[start:start + BLOCK]" for i in count),
        near=f"{bases} = _near({at})" if bases else "pass",
        far=f"{bases} = _far({at})" if bases else "pass",
        stores=f"{stored} = _outputs({bases or at}, {scales})",
    )
    jit = '@njit(error_model="numpy", fastmath={"contract"}, forceinline=True)'
    lines, formulas = NUMBA.outputs(planned, "0.0*" + (planned.bases or ("theta",))[0])
    functions = [
        *_function(NUMBA, "_near", planned.near.lines, planned.bases, "|theta| <= LIMIT", jit),
        *_function(NUMBA, "_far", planned.far.lines, planned.bases, "any angle", jit),
        *(_grid_function(planned) if grid else []),
        "",
        "",
        jit,
        f"def _outputs({bases or 'theta'}, {scales}):",
        *NUMBA.lines(lines, "    "),
        *_returned([NUMBA.formula(f) for f in formulas]),
    ]
    return _joined(
        [*head, *_constants(NUMBA, planned)],
        body + (_grid(planned, True) if grid else ""),
        functions,
        _self_test(planned),
    )


def _docstring(planned: Plan, engine: str) -> list[str]:
    first, *rest = paragraphs(planned, engine)
    return [f'"""{first}', *rest, '"""']


def _constants(spelling: Spelling, planned: Plan) -> list[str]:
    names = ", ".join(repr(o.wave.name) for o in planned.outputs)
    kernels = (planned.near, planned.far, planned.on_grid, planned.tail)
    return [
        f"OUTPUTS = ({names},)",
        f"LIMIT = {LIMIT!r}  # the largest |theta| that is reduced exactly",
        "",
        *spelling.constants(unique(k.constants for k in kernels)),
    ]


def _call(name: str, planned: Plan) -> str:
    if not planned.bases:
        return "theta"
    return f"{'*' * (len(planned.bases) > 1)}{name}(theta)"


def _function(
    spelling: Spelling,
    name: str,
    lines: list[Line],
    bases: tuple[str, ...],
    where: str,
    decorator: str = "",
) -> list[str]:
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


def _grid_function(planned: Plan) -> list[str]:
    if not planned.bases:
        return []
    head = ["", "", "def _on_grid(index, points):", '    """What the outputs are made of, on a grid."""']
    lines = NUMPY.lines(planned.on_grid.lines, "    ")
    return [*head, *lines, f"    return {', '.join(planned.bases)}"]


def _grid(planned: Plan, scaled: bool) -> str:
    scales = ", ".join(o.wave.unit.formula for o in planned.outputs) + ","
    bases = f"{'*' * (len(planned.bases) > 1)}_on_grid(index, points)" if planned.bases else "index"
    values = (
        f"_outputs({bases}, {scales})"
        if scaled
        else f"[s*v for s, v in zip(({scales}), _outputs({bases}))]"
    )
    if scaled and len(planned.outputs) == 1:
        values = f"[{values}]"
    return GRID.format(under=planned.step.denominator, over=planned.step.numerator, values=values)


def _returned(formulas: list[str]) -> list[str]:
    if len(formulas) == 1:
        return [f"    return {formulas[0]}"]
    return ["    return (", *(f"        {formula}," for formula in formulas), "    )"]


def _self_test(planned: Plan) -> str:
    rows = "\n".join(f"    ({c.theta!r}, {c.values!r}, {c.allowed!r})," for c in checks(planned))
    return SELF_TEST.format(rows=rows)


def _joined(head: list[str], body: str, functions: list[str], test: str) -> str:
    return "\n".join(head) + "\n" + body + RESULTS + "\n".join(functions) + "\n" + test
