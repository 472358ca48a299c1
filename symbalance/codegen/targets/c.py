"""C99: a header and a source that need the standard library alone."""

from __future__ import annotations

from collections.abc import Iterable

from symbalance.codegen.checks import Check, checks, grid_checks, grid_points, unit_values
from symbalance.codegen.cosines import LIMIT
from symbalance.codegen.kernels import Line
from symbalance.codegen.plans import Plan
from symbalance.codegen.targets.c_templates import (
    GCD,
    GRID,
    GRID_CHECKS,
    GRID_PROTOTYPE,
    GRID_TEST,
    HEADER,
    LOOPS,
    SELF_TEST,
    SOURCE,
)
from symbalance.codegen.targets.folding import folded
from symbalance.codegen.targets.grids import repeating
from symbalance.codegen.targets.printing import Spelling, unique
from symbalance.codegen.targets.wording import identifier, paragraphs, plain
from symbalance.errors import SymbalanceError

C = Spelling(
    {
        "rint": "(({} + MAGIC) - MAGIC)",
        "abs": "fabs({})",
        "sqrt": "sqrt({})",
        "side": "copysign(1.0, {})",
        "cos": "cos({})",
        "sin": "sin({})",
    },
    line="const double {} = {};",
    constant="static const double {} = {};",
    comment="/* {} */",
)
WORDS = """
auto break case char const continue default do double else enum extern float for goto if inline int
long register restrict return short signed sizeof static struct switch typedef union unsigned void
volatile while class new delete this template namespace using try catch throw public private near
far outputs on_grid gcd near_double near_float any_double any_float main printf differs checks theta
n points turns mass radius omega pitch fabs sqrt sin cos copysign isnan
constants_are_doubles grid_checks units angles values singles rounded row prepare arrays_differ
floats_differ grids_differ
"""
TAKEN = frozenset(WORDS.split())
"""Names the function must not bear: words of C and C++, and what the source itself uses."""


def c_sources(planned: Plan, engine: str, stem: str, grid: bool) -> dict[str, str]:
    """Return the header and the source, by the ending of their files' names; `stem` is the names'."""
    name = identifier(stem)
    if name in TAKEN or plain(stem) != stem:
        remedy = "name it with letters, digits and _, like engine.c"
        raise SymbalanceError(f"--output {stem}.c", "is no function's name in C", remedy)
    outs = [identifier(o.wave.name) for o in planned.outputs]
    head = "\n * ".join(paragraphs(planned, engine)).replace(" * \n", " *\n")
    prototypes = {kind: _prototype(name, kind, outs) for kind in ("double", "float", "grid")}
    header = HEADER.format(
        head=head,
        guard=f"{name.upper()}_H",
        prototype_double=prototypes["double"],
        prototype_float=prototypes["float"],
        prototype_grid=GRID_PROTOTYPE.format(prototype=prototypes["grid"]) if grid else "",
    )
    kernels = (planned.near, planned.far, planned.tail, *([planned.on_grid] if grid else []))
    functions = [_functions(planned, prototypes, outs)]
    functions += [_grid(planned, prototypes["grid"], outs)] if grid else []
    source = SOURCE.format(
        title=next(paragraphs(planned, engine)).split(";")[0],
        stem=stem,
        macro=name.upper(),
        limit=repr(LIMIT),
        constants="\n".join(C.constants(unique(k.constants for k in kernels))),
        functions="".join(functions) + _self_test(planned, name, grid),
    )
    return {".h": header, ".c": folded(source, "/* ")}


def _prototype(name: str, kind: str, outs: list[str]) -> str:
    """Return a function's head; `kind` is "double", "float" or "grid"."""
    suffix = {"double": "", "float": "_float", "grid": "_on_grid"}[kind]
    number = "float" if kind == "float" else "double"
    first = "size_t points, size_t turns" if kind == "grid" else f"size_t n, const {number} *theta"
    pointers = ", ".join(f"{number} *{out}" for out in outs)
    keywords = "double mass, double radius, double omega, double pitch"
    return folded(f"void {name}{suffix}({first},\n    {keywords},\n    {pointers})", "/* ")


def _functions(planned: Plan, prototypes: dict[str, str], outs: list[str]) -> str:
    count = range(len(outs))
    bases = planned.bases
    scales = ", ".join(f"scale{i}" for i in count)
    lines, formulas = C.outputs(planned, "0.0*" + (bases or ("theta",))[0])
    parts = [
        *_base_function("near", "theta", planned.near.lines, bases, "|theta| <= LIMIT"),
        *_base_function("far", "theta", planned.far.lines, bases, "any angle"),
        f"INLINE void outputs({', '.join(f'double {b}' for b in bases or ('theta',))},",
        f"    {', '.join(f'double scale{i}' for i in count)}, double *restrict value) {{",
        *C.lines(lines, "    "),
        *(f"    value[{i}] = {C.formula(f)};" for i, f in enumerate(formulas)),
        "}",
    ]
    for kind in ("double", "float"):
        stored = [f"out{i}[i] = {'' if kind == 'double' else '(float)'}value[{i}];" for i in count]
        loops = LOOPS.format(
            kind=kind,
            scale_parameters=", ".join(f"double scale{i}" for i in count),
            out_parameters=", ".join(f"{kind} *restrict out{i}" for i in count),
            near="\n".join(_called("near", "angle", bases)),
            either="\n".join(_either(bases)),
            stores="\n".join([*_values(planned, "angle"), *(f"        {line}" for line in stored)]),
            prototype=prototypes[kind],
            scales=_scales(planned),
            scale_names=scales,
            outs=", ".join(f"{out} + start" for out in outs),
        )
        parts.append("\n".join(line for line in loops.split("\n") if line.strip() or not line))
    return "\n".join(parts)


def _called(function: str, arguments: str, bases: tuple[str, ...], indent: str = "        ") -> list[str]:
    """Return the lines that declare the bases and have a function write them."""
    if not bases:
        return []
    return [
        f"{indent}double {', '.join(bases)};",
        f"{indent}{function}({arguments}, {', '.join(f'&{b}' for b in bases)});",
    ]


def _either(bases: tuple[str, ...]) -> list[str]:
    if not bases:
        return []
    declared, near = _called("near", "angle", bases)
    far = near.replace("near(", "far(")
    return [
        declared,
        "        if (fabs(angle) <= LIMIT) {",
        f"    {near}",
        "        } else {",
        f"    {far}",
        "        }",
    ]


def _values(planned: Plan, argument: str) -> list[str]:
    count = range(len(planned.outputs))
    arguments = [*(planned.bases or (argument,)), *(f"scale{i}" for i in count), "value"]
    return [f"        double value[{len(count)}];", f"        outputs({', '.join(arguments)});"]


def _scales(planned: Plan) -> str:
    rows = (f"    const double scale{i} = {o.wave.unit.formula};" for i, o in enumerate(planned.outputs))
    return "\n".join(rows)


def _base_function(
    name: str, arguments: str, lines: Iterable[Line], bases: tuple[str, ...], where: str
) -> list[str]:
    if not bases:
        return []
    pointers = ", ".join(f"double *restrict {b}_" for b in bases)
    parameters = ", ".join(f"double {argument}" for argument in arguments.split(", "))
    return [
        f"/* What the outputs are made of, for {where}. */",
        f"INLINE void {name}({parameters}, {pointers}) {{",
        *C.lines(lines, "    "),
        *(f"    *{b}_ = {b};" for b in bases),
        "}",
        "",
    ]


def _grid(planned: Plan, prototype: str, outs: list[str]) -> str:
    """Return the function for evenly spaced angles."""
    bases, lines = planned.bases, planned.on_grid.lines
    functions = _base_function("on_grid", "index, points", lines, bases, "theta = 2 pi index/points")
    period, calls_gcd = repeating(planned)
    stored = [f"        {out}[i] = value[{j}];" for j, out in enumerate(outs)]
    called = _called("on_grid", "(double)i, (double)points", bases)
    return GRID.format(
        functions="\n".join(functions),
        gcd=GCD if calls_gcd else "",
        prototype=prototype,
        scales=_scales(planned),
        period=period,
        stores="\n".join([*called, *_values(planned, "(double)i"), *stored]),
        copies="\n".join(f"        {out}[i] = {out}[i - period];" for out in outs),
    )


def _self_test(planned: Plan, name: str, grid: bool) -> str:
    count = len(planned.outputs)
    rows = "\n".join(map(_row, checks(planned)))
    grid_rows = "\n".join(map(_row, grid_checks(planned))) if grid else ""
    shared = {"name": name, "count": count, "columns": 1 + 2 * count, "points": grid_points(planned)}
    values = ", ".join(f"values[{i}]" for i in range(count))
    grid_test = GRID_CHECKS.format(rows=grid_rows, values=values, **shared)
    return SELF_TEST.format(
        macro=name.upper(),
        rows=rows,
        units=", ".join(map(repr, unit_values(planned))),
        values=values,
        rounded=", ".join(f"rounded[{i}]" for i in range(count)),
        pointers=", ".join(f"found + {i}" for i in range(count)),
        grid_checks=grid_test if grid else "",
        grid=GRID_TEST if grid else "",
        **shared,
    )


def _row(check: Check) -> str:
    return "    {" + ", ".join(map(repr, (check.theta, *check.values, *check.allowed))) + "},"
