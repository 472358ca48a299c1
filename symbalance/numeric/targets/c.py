"""C99: a header and a source that need the standard library alone."""

from __future__ import annotations

from symbalance.numeric.checks import checks
from symbalance.numeric.cosines import LIMIT
from symbalance.numeric.kernels import Line
from symbalance.numeric.plans import Plan
from symbalance.numeric.targets.printing import Spelling, unique
from symbalance.numeric.targets.wording import identifier, paragraphs

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
HEADER = """/* {head}
 */
#ifndef {guard}
#define {guard}

#include <stddef.h>

#ifdef __cplusplus
extern "C" {{
#endif

/* Write n values of each output at n crank angles theta (radians). Arrays must not overlap. */
{prototype_double};
{prototype_float};

#ifdef __cplusplus
}}
#endif

#endif
"""
SOURCE = """/* {title}; see {name}.h.
 *
 * Compile with optimisation for the machine it runs on:
 *     cc -std=gnu99 -O3 -march=native -fno-math-errno -c {name}.c
 * (any C99 will do; gnu99 lets gcc fuse multiply and add, which is faster).
 *     cc -std=c99 -O2 -D{macro}_SELF_TEST {name}.c -lm && ./a.out
 */
#include "{name}.h"

#include <math.h>

#ifdef __FAST_MATH__
#error "the reduction of angles needs IEEE arithmetic: compile without -ffast-math"
#endif

#define MAGIC 6755399441055744.0 /* 1.5 * 2^52: adding it rounds to a whole number */
#define LIMIT {limit} /* the largest |theta| that is reduced exactly */
#define BLOCK 4096 /* angles at a time: one far angle sends its block the slow way, not all */

{constants}

{functions}
"""
LOOPS = """
static size_t near_{kind}(size_t n, const {kind} *restrict theta, {scale_parameters}, {out_parameters}) {{
    size_t inside = 0;
    for (size_t i = 0; i < n; i++) {{
        const double angle = theta[i];
        {near}
{stores}
        inside += fabs(angle) <= LIMIT;
    }}
    return inside;
}}

static void any_{kind}(size_t n, const {kind} *restrict theta, {scale_parameters}, {out_parameters}) {{
    for (size_t i = 0; i < n; i++) {{
        const double angle = theta[i];
        {declared}
        if (fabs(angle) <= LIMIT) {{
            {near_again}
        }} else {{
            {far}
        }}
{stores}
    }}
}}

{prototype} {{
{scales}
    (void)mass, (void)radius, (void)omega, (void)pitch;
    for (size_t start = 0; start < n; start += BLOCK) {{
        const size_t size = n - start < BLOCK ? n - start : BLOCK;
        if (near_{kind}(size, theta + start, {scale_names}, {outs}) < size) {{
            any_{kind}(size, theta + start, {scale_names}, {outs});
        }}
    }}
}}
"""
SELF_TEST = """
#ifdef {macro}_SELF_TEST
#include <stdio.h>

/* Angles, the true values there (mpmath, 50 digits), and what each may be off. */
static const double checks[][{columns}] = {{
{rows}
}};

int main(void) {{
    const size_t n = sizeof checks / sizeof checks[0];
    int failed = 0;
    for (size_t i = 0; i < n; i++) {{
        double found[{count}];
        {name}(1, checks[i], 1.0, 1.0, 1.0, 1.0, {pointers});
        for (size_t j = 0; j < {count}; j++) {{
            const double value = checks[i][1 + j], off = checks[i][1 + {count} + j];
            if (!(fabs(found[j] - value) <= off)) {{
                printf("output %zu at %.17g: %.17g, true %.17g\\n", j, checks[i][0], found[j], value);
                failed = 1;
            }}
        }}
    }}
    const double lost[] = {{INFINITY, NAN}};
    for (size_t i = 0; i < 2; i++) {{
        double found[{count}];
        {name}(1, lost + i, 1.0, 1.0, 1.0, 1.0, {pointers});
        for (size_t j = 0; j < {count}; j++) {{
            failed |= !isnan(found[j]);
        }}
    }}
    printf(failed ? "self-test FAILED\\n" : "self-test passed: %zu angles\\n", n);
    return failed;
}}
#endif
"""


def c_sources(planned: Plan, engine: str, name: str, grid: bool) -> dict[str, str]:
    """Return the header and the source, by the ending of their files' names."""
    name = identifier(name)
    macro = name.upper()
    outs = [identifier(o.wave.name) for o in planned.outputs]
    head = "\n * ".join(paragraphs(planned, engine)).replace(" * \n", " *\n")
    prototypes = {kind: _prototype(name, kind, outs) for kind in ("double", "float")}
    header = HEADER.format(
        head=head,
        guard=f"{macro}_H",
        prototype_double=prototypes["double"],
        prototype_float=prototypes["float"],
    )
    kernels = (planned.near, planned.far, planned.tail)
    source = SOURCE.format(
        title=next(paragraphs(planned, engine)).split(";")[0],
        name=name,
        macro=macro,
        limit=repr(LIMIT),
        constants="\n".join(C.constants(unique(k.constants for k in kernels))),
        functions=_functions(planned, outs, prototypes) + _self_test(planned, name, macro),
    )
    return {".h": header, ".c": source}


def _prototype(name: str, kind: str, outs: list[str]) -> str:
    suffix = "" if kind == "double" else "_float"
    pointers = ", ".join(f"{kind} *{out}" for out in outs)
    keywords = "double mass, double radius, double omega, double pitch"
    return f"void {name}{suffix}(size_t n, const {kind} *theta,\n    {keywords},\n    {pointers})"


def _functions(planned: Plan, outs: list[str], prototypes: dict[str, str]) -> str:
    count = range(len(outs))
    bases = planned.bases
    scales = ", ".join(f"scale{i}" for i in count)
    lines, formulas = C.outputs(planned, "0.0*" + (bases or ("theta",))[0])
    parts = [
        *_base_function("near", planned.near.lines, bases, "|theta| <= LIMIT"),
        *_base_function("far", planned.far.lines, bases, "any angle"),
        f"static inline void outputs({', '.join(f'double {b}' for b in bases or ('theta',))},",
        f"    {', '.join(f'double scale{i}' for i in count)}, double *restrict value) {{",
        *C.lines(lines, "    "),
        *(f"    value[{i}] = {C.formula(f)};" for i, f in enumerate(formulas)),
        "}",
    ]
    pointers = ", ".join(f"&{b}" for b in bases)
    declared = f"double {', '.join(bases)};" if bases else ""
    call = f"outputs({', '.join(bases) or 'angle'}, {scales}, value);"
    stores = [f"double value[{len(outs)}];", call]
    for kind in ("double", "float"):
        stored = [f"out{i}[i] = {'' if kind == 'double' else '(float)'}value[{i}];" for i in count]
        units = [
            f"    const double scale{i} = {o.wave.unit.formula};" for i, o in enumerate(planned.outputs)
        ]
        parts.append(
            LOOPS.format(
                kind=kind,
                scale_parameters=", ".join(f"double scale{i}" for i in count),
                out_parameters=", ".join(f"{kind} *restrict out{i}" for i in count),
                near=f"{declared} near(angle, {pointers});" if bases else "",
                near_again=f"near(angle, {pointers});" if bases else "",
                far=f"far(angle, {pointers});" if bases else "",
                declared=declared,
                stores="\n".join(f"        {line}" for line in [*stores, *stored]),
                prototype=prototypes[kind],
                scales="\n".join(units),
                scale_names=scales,
                outs=", ".join(f"{out} + start" for out in outs),
            )
        )
    return "\n".join(parts)


def _base_function(name: str, lines: list[Line], bases: tuple[str, ...], where: str) -> list[str]:
    if not bases:
        return []
    pointers = ", ".join(f"double *restrict {b}_" for b in bases)
    return [
        f"/* What the outputs are made of, for {where}. */",
        f"static inline void {name}(double theta, {pointers}) {{",
        *C.lines(lines, "    "),
        *(f"    *{b}_ = {b};" for b in bases),
        "}",
        "",
    ]


def _self_test(planned: Plan, name: str, macro: str) -> str:
    rows = [
        "    {" + ", ".join(map(repr, (c.theta, *c.values, *c.allowed))) + "}," for c in checks(planned)
    ]
    count = len(planned.outputs)
    return SELF_TEST.format(
        macro=macro,
        columns=1 + 2 * count,
        rows="\n".join(rows),
        count=count,
        name=name,
        pointers=", ".join(f"found + {i}" for i in range(count)),
    )
