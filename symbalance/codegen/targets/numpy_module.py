"""A Python module that needs NumPy alone: blocks of angles through the formulas, in cache."""

from __future__ import annotations

from symbalance.codegen.plans import Plan
from symbalance.codegen.targets.grids import repeating
from symbalance.codegen.targets.python_parts import (
    CALL_DOC,
    NUMPY,
    base_function,
    called,
    constants,
    docstring,
    grid_call,
    grid_function,
    joined,
    self_test,
)

NUMPY_CALL = '''
BLOCK = 16000  # angles at a time: intermediate values of 128 kB stay in cache, on pages in use


def evaluate(theta, *, mass=1.0, radius=1.0, omega=1.0, pitch=1.0, out=None):
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
        for result, value, scale in zip(results, _outputs({bases}), scales):
            np.multiply(value, scale, out=result[start:stop])
""".strip("\n")


def numpy_source(planned: Plan, engine: str, grid: bool) -> str:
    """Return a module that needs NumPy alone."""
    calls = ["import math", ""] if grid and repeating(planned)[1] else []
    head = [*docstring(planned, engine), "", *calls, "import numpy as np", ""]
    scales = ", ".join(o.wave.unit.formula for o in planned.outputs) + ","
    fill = GRID_FILL.format(scales=scales, bases=called("_on_grid", planned, "index, points", "index"))
    body = NUMPY_CALL.format(
        call_doc=CALL_DOC.format(note=""),
        scales=scales,
        near=called("_near", planned),
        far=called("_far", planned),
    )
    bases = ", ".join(planned.bases) or "theta"
    zero = "0.0*" + (planned.bases or ("theta",))[0]
    formulas = [NUMPY.formula(o.formula if o.formula != "0.0" else zero) for o in planned.outputs]
    functions = [
        *base_function(NUMPY, "_near", planned.near.lines, planned.bases, "|theta| <= LIMIT"),
        *base_function(NUMPY, "_far", planned.far.lines, planned.bases, "any angle"),
        *(grid_function(NUMPY, planned) if grid else []),
        "",
        "",
        f"def _outputs({bases}):",
        '    """The outputs, with every keyword 1."""',
        *NUMPY.lines(planned.tail.lines, "    "),
        "    return (",
        *(f"        {formula}," for formula in formulas),
        "    )",
    ]
    return joined(
        [*head, *constants(NUMPY, planned)],
        body + (grid_call(planned, fill) if grid else ""),
        functions,
        self_test(planned, grid),
    )
