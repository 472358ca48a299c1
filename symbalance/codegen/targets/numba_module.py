"""A Python module that needs NumPy and Numba: one loop that the compiler turns into vectors."""

from __future__ import annotations

from hashlib import sha256

from symbalance.codegen.plans import Plan
from symbalance.codegen.targets.numpy_module import (
    CALL_DOC,
    base_function,
    constants,
    docstring,
    grid_call,
    grid_function,
    module_text,
    return_statement,
    self_test_text,
)
from symbalance.codegen.targets.syntax import Syntax, keyword_arguments

NUMBA = Syntax(
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
CONTENT = "0" * 16
"""Stands for the digest of a module's text until that is known."""
COMPILE = '''
CONTENT = "{content}"  # a digest of this text: compiled code of another is never taken for its own


def _compiled(function, **options):
    """Compile under a name that only this text's functions have, in a module that is always there."""
    function.__qualname__, function.__module__ = f"{function.__name__}_{CONTENT}", "numba"
    return njit(error_model="numpy", fastmath={"contract"}, **options)(function)


def _inlined(function):
    return _compiled(function, forceinline=True)


def _kept(function):
    """Compile, and keep it for other processes: in NUMBA_CACHE_DIR, beside this file, or at home."""
    try:
        kept = _compiled(function, nogil=True, cache=True)
    except (OSError, RuntimeError):  # none of these can be written, or this text is in no file
        return _compiled(function, nogil=True)
    if hasattr(kept, "_cache"):  # Numba's own name for it
        kept._cache = _Kept(kept._cache)
    return kept


class _Kept:
    """What Numba keeps code in; a damaged file, or a full disk, costs a compilation and no more.

    Numba reads and writes at the first call, and raises whatever unpickling or the disk raises. Damaged
    code is compiled again and written anew; code that cannot be written is used and not kept.
    """

    def __init__(self, cache):
        self._of_numba = cache

    def __getattr__(self, name):
        return getattr(self._of_numba, name)

    def load_overload(self, *key):
        try:
            return self._of_numba.load_overload(*key)
        except Exception:  # unpickling what is damaged raises anything
            return None

    def save_overload(self, *code):
        try:
            self._of_numba.save_overload(*code)
        except Exception:
            self._save_afresh(*code)

    def _save_afresh(self, *code):
        try:
            self._of_numba.flush()  # a damaged index is read before code is added to it
            self._of_numba.save_overload(*code)
        except Exception:
            return
'''
NUMBA_CALL = '''
BLOCK = 4096  # angles at a time: one far angle sends its block the slow way, not all


def evaluate(theta, *, {arguments}, out=None):
{call_doc}
    theta = _crank_angles(theta)
    mass, radius, omega, pitch = _numbers(mass=mass, radius=radius, omega=omega, pitch=pitch)
    kind = np.float32 if theta.dtype.kind == "f" and theta.dtype.itemsize == 4 else np.float64
    results = _results(theta, kind, out)
    flat = np.ascontiguousarray(_apart(theta, results), dtype=kind).reshape(-1)
    _fill(flat, {scales}, {flattened})
    return _given(results)


@_kept
def _fill(theta, {scale_names}, {out_names}):
    for start in range(0, theta.size, BLOCK):
        part = theta[start:start + BLOCK]
        if _fill_near(part, {scale_names}, {out_parts}) < part.size:
            _fill_any(part, {scale_names}, {out_parts})


@_compiled
def _fill_near(theta, {scale_names}, {out_names}):
    """Fill as if every angle were within LIMIT, and return how many are."""
    inside = 0
    for i in range(theta.size):
        {near}
        {stores}
        inside += abs(theta[i]) <= LIMIT
    return inside


@_compiled
def _fill_any(theta, {scale_names}, {out_names}):
    for i in range(theta.size):
        if abs(theta[i]) <= LIMIT:
            {near}
        else:
            {far}
        {stores}
'''
GRID_FILL = """
    filled = [result[:size] for result in results]
    _fill_grid(np.float64(points), {scales}, *filled)
""".strip("\n")
GRID_LOOP = """

@_kept
def _fill_grid(points, {scale_names}, {out_names}):
    for i in range(out0.size):
        index = np.float64(i)
        {basis}
        {stores}
"""


NOTE = """ The first call
    with a type of angles compiles, unless the code was kept by an earlier process."""


def numba_source(plan: Plan, engine: str, grid: bool) -> str:
    """Return a module that needs NumPy and Numba; one pass over the angles, no C compiler."""
    head = [*docstring(plan, engine), "", "import math", "", "import numpy as np"]
    head += ["from numba import njit", "", "MAGIC = 6755399441055744.0  # 1.5 * 2^52: adding it rounds"]
    count = range(len(plan.outputs))
    scales = ", ".join(f"scale{i}" for i in count)
    stores = ", ".join(f"out{i}[i]" for i in count)
    basis = ", ".join(plan.basis)
    at = "np.float64(theta[i])"
    values = ", ".join(f"float({o.harmonic_sum.unit.formula})" for o in plan.outputs)
    body = NUMBA_CALL.format(
        arguments=keyword_arguments(plan),
        call_doc=CALL_DOC.format(note=NOTE),
        scales=values,
        flattened=", ".join(f"np.asarray(results[{i}]).reshape(-1)" for i in count),
        scale_names=scales,
        out_names=", ".join(f"out{i}" for i in count),
        out_parts=", ".join(f"out{i}[start:start + BLOCK]" for i in count),
        near=f"{basis} = _near({at})" if basis else "pass",
        far=f"{basis} = _far({at})" if basis else "pass",
        stores=f"{stores} = _outputs({basis or at}, {scales})",
    )
    loop = GRID_LOOP.format(
        scale_names=scales,
        out_names=", ".join(f"out{i}" for i in count),
        basis=f"{basis} = _on_grid(index, points)" if basis else "pass",
        stores=f"{stores} = _outputs({basis or 'index'}, {scales})",
    )
    jit = "@_inlined"
    lines, formulas = NUMBA.outputs(plan, "0.0*" + (plan.basis or ("theta",))[0])
    functions = [
        *base_function(NUMBA, "_near", plan.reduced_range.lines, plan.basis, "|theta| <= LIMIT", jit),
        *base_function(NUMBA, "_far", plan.full_range.lines, plan.basis, "any angle", jit),
        *(grid_function(NUMBA, plan, jit) if grid else []),
        "",
        "",
        jit,
        f"def _outputs({basis or 'theta'}, {scales}):",
        *NUMBA.lines(lines, "    "),
        *return_statement([NUMBA.formula(f) for f in formulas]),
    ]
    text = module_text(
        [*head, *constants(NUMBA, plan)],
        COMPILE.replace("{content}", CONTENT)
        + body
        + (grid_call(plan, GRID_FILL.format(scales=values)) + loop if grid else ""),
        functions,
        self_test_text(plan, grid),
    )
    return text.replace(CONTENT, sha256(text.encode()).hexdigest()[: len(CONTENT)], 1)
