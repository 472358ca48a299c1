"""Source in C99: a header and a source file that need the standard library alone."""

from __future__ import annotations

from collections.abc import Iterable
from hashlib import sha256
from textwrap import wrap

from symbalance.codegen.checks import Check, checks, default_values, grid_checks, grid_points, unit_values
from symbalance.codegen.cosines import LIMIT
from symbalance.codegen.expression_ir import Statement
from symbalance.codegen.plans import Plan
from symbalance.codegen.targets.header_text import WIDTH, comment_text, identifier, paragraphs
from symbalance.codegen.targets.syntax import Syntax, fold, points_per_period, unique
from symbalance.errors import SymbalanceError

C = Syntax(
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
floats_differ grids_differ at_speed_differs
"""
RESERVED = frozenset(WORDS.split())
"""Names the function must not bear: words of C and C++, and what the source itself uses."""
MARK = "0x" + 15 * "-" + "ULL"
"""Stands for the mark until both texts are written: as long as it, and no number."""
HEADER = """/* {head}
 */
#ifndef {guard}
#define {guard}

/* The mark of this run: {stem}.c compiles with the header that was written with it, and no other. */
#define {macro}_MARK {mark}

#include <stddef.h>

#ifdef __cplusplus
extern "C" {{
#endif

/* Write n values of each output at n crank angles theta (radians). Arrays must not overlap. */
{prototype_double};

/* The same for float arrays, computed in double and rounded once. */
{prototype_float};
{prototype_grid}{at_speed}
#ifdef __cplusplus
}}
#endif

#endif
"""
SOURCE = """/* {title}; see {stem}.h.
 *
 * Compile with optimisation for the machine it runs on:
 *     cc -std=gnu99 -O3 -march=native -fno-math-errno -c "{stem}.c"
 * (any C99 will do; gnu99 lets gcc fuse multiply and add, which is faster). Self-test:
 *     cc -std=c99 -O2 -D{macro}_SELF_TEST "{stem}.c" -lm && ./a.out
 */
#include "{stem}.h"

#if !defined({macro}_MARK) || {macro}_MARK != {mark}
#error "{stem}.h is not the header that was written with this source: write both anew"
#endif

#include <float.h>
#include <math.h>

#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || defined(__ASSOCIATIVE_MATH__) \\
    || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "angles are reduced by sums as written, and lost as NaN: no -ffast-math nor part of it"
#endif
/* FLT_EVAL_METHOD: 0, doubles are evaluated as doubles; 1, 16, 32 and 64 widen narrower types alone
 * (16 where the machine computes in _Float16). 2, long doubles, rounds twice; below 0 nothing is known.
 */
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 1 && FLT_EVAL_METHOD != 16 \\
    && FLT_EVAL_METHOD != 32 && FLT_EVAL_METHOD != 64
#error "the reduction of angles needs IEEE doubles: on x86 -msse2 -mfpmath=sse"
#endif
/* An array of negative size: the constants must be doubles, no -fsingle-precision-constant. */
typedef char constants_are_doubles[sizeof 1.0 == sizeof(double) ? 1 : -1];

/* A loop becomes vectors only if all it calls is inlined, however long. */
#ifdef __GNUC__
#define INLINE static inline __attribute__((always_inline))
#else
#define INLINE static inline
#endif

#define MAGIC 6755399441055744.0 /* 1.5 * 2^52: adding it rounds to a whole number */
#define LIMIT {limit} /* the largest |theta| that is reduced exactly */
#define BLOCK 4096 /* angles at a time: one far angle sends its block the slow way, not all */

{constants}

{functions}
"""
AT_SPEED_PROTOTYPE = """
/* {words} */
#define {macro}_MASS {mass}
#define {macro}_RADIUS {radius}
#define {macro}_OMEGA {omega}
#define {macro}_PITCH {pitch}

/* Write n values of each output at n crank angles, with these. Arrays must not overlap. */
{prototype};
"""
AT_SPEED = """
{prototype} {{
    {name}(n, theta, {macro}_MASS, {macro}_RADIUS, {macro}_OMEGA, {macro}_PITCH, {outs});
}}
"""
AT_SPEED_CHECKS = """
/* Compare with the values at the engine's own speed. */
static int at_speed_differs(void) {{
    static const double unit[{count}] = {{{units}}};
    int failed = 0;
    for (size_t i = 0; i < ANGLES; i++) {{
        double actual[{count}];
        {name}_at_speed(1, checks[i], {pointers});
        failed |= differs(checks[i], actual, unit);
    }}
    return failed;
}}
"""
AT_SPEED_TEST = """    failed |= at_speed_differs();
"""
GRID_PROTOTYPE = """
/* Write points * turns values of each output at theta = 2 pi j/points, j = 0, 1, ...: so many whole
 * turns. One period is computed, from angles that are exact; the rest repeats it.
 */
{prototype};
"""
GRID = """
{functions}{gcd}
{prototype} {{
{scales}
    (void)mass, (void)radius, (void)omega, (void)pitch;
    const size_t count = points * turns, period = {period};
    const size_t size = period < count ? period : count;
    for (size_t i = 0; i < size; i++) {{
{stores}
    }}
    for (size_t i = size; i < count; i++) {{
{copies}
    }}
}}
"""
GCD = """
static size_t gcd(size_t a, size_t b) {
    return b == 0 ? a : gcd(b, a % b);
}
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
{either}
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

/* Of each output, where mass, radius, omega and pitch are 2, 3, 5 and 7 instead of 1. */
static const double units[{count}] = {{{units}}};

/* Several blocks: near angles, far ones among them, near ones, and one angle more. */
enum {{ ANGLES = sizeof checks / sizeof checks[0], MANY = 3 * BLOCK + 1 }};
static double angles[MANY], values[{count}][MANY + 1];
static float singles[MANY], rounded[{count}][MANY + 1];
static size_t row[MANY];

static int differs(const double *check, const double *actual, const double *unit) {{
    int failed = 0;
    for (size_t j = 0; j < {count}; j++) {{
        const double scale = unit ? unit[j] : 1.0, value = scale * check[1 + j];
        const double off = (unit ? 2.0 : 1.0) * scale * check[1 + {count} + j];
        if (!(fabs(actual[j] - value) <= off)) {{
            printf("output %zu at %.17g: %.17g, true %.17g\\n", j, check[0], actual[j], value);
            failed = 1;
        }}
    }}
    return failed;
}}

/* Place a check's angle at each of MANY places, and NaN wherever a value is to be written, or is not. */
static void prepare(void) {{
    for (size_t i = 0, next = 0; i < MANY; i++) {{
        do {{
            row[i] = next++ % ANGLES;
        }} while (i / BLOCK != 1 && !(fabs(checks[row[i]][0]) <= LIMIT));
        angles[i] = checks[row[i]][0];
        singles[i] = (float)angles[i];
    }}
    for (size_t j = 0; j < {count}; j++) {{
        for (size_t i = 0; i <= MANY; i++) {{
            values[j][i] = NAN, rounded[j][i] = NAN;
        }}
    }}
}}

/* Compare arrays of several blocks, with every keyword 1 and with others. */
static int arrays_differ(void) {{
    int failed = 0;
    for (size_t other = 0; other < 2; other++) {{
        prepare();
        if (other) {{
            {name}(MANY, angles, 2.0, 3.0, 5.0, 7.0, {values});
        }} else {{
            {name}(MANY, angles, 1.0, 1.0, 1.0, 1.0, {values});
        }}
        for (size_t i = 0; i < MANY; i++) {{
            double actual[{count}];
            for (size_t j = 0; j < {count}; j++) {{
                actual[j] = values[j][i];
                failed |= !isnan(values[j][MANY]);
            }}
            failed |= differs(checks[row[i]], actual, other ? units : NULL);
        }}
    }}
    return failed;
}}

/* Compare float arrays, which are rounded once, with double ones at the same angles. */
static int floats_differ(void) {{
    int failed = 0;
    prepare();
    for (size_t i = 0; i < MANY; i++) {{
        angles[i] = singles[i];
    }}
    {name}(MANY, angles, 2.0, 3.0, 5.0, 7.0, {values});
    {name}_float(MANY, singles, 2.0, 3.0, 5.0, 7.0, {rounded});
    for (size_t j = 0; j < {count}; j++) {{
        failed |= !isnan(rounded[j][MANY]);
        for (size_t i = 0; i < MANY; i++) {{
            const double off = units[j] * checks[row[i]][1 + {count} + j];
            if (!(fabs(rounded[j][i] - values[j][i]) <= FLT_EPSILON * fabs(values[j][i]) + off)) {{
                printf("output %zu at %.9g: %.9g as float\\n", j, singles[i], rounded[j][i]);
                failed = 1;
            }}
        }}
    }}
    return failed;
}}
{grid_checks}{at_speed_checks}
int main(void) {{
    int failed = 0;
    for (size_t i = 0; i < ANGLES; i++) {{
        double actual[{count}];
        {name}(1, checks[i], 1.0, 1.0, 1.0, 1.0, {pointers});
        failed |= differs(checks[i], actual, NULL);
    }}
    failed |= arrays_differ();
    failed |= floats_differ();
{grid}{at_speed}    const double lost[] = {{INFINITY, NAN}};
    for (size_t i = 0; i < 2; i++) {{
        double actual[{count}];
        {name}(1, lost + i, 1.0, 1.0, 1.0, 1.0, {pointers});
        for (size_t j = 0; j < {count}; j++) {{
            failed |= !isnan(actual[j]);
        }}
    }}
    printf("self-test %s: %d angles\\n", failed ? "FAILED" : "passed", (int)ANGLES);
    return failed;
}}
#endif
"""
GRID_CHECKS = """
/* The same at theta = 2 pi j/{points}, two turns, for {name}_on_grid. */
static const double grid_checks[][{columns}] = {{
{rows}
}};

static int grids_differ(void) {{
    int failed = 0;
    for (size_t other = 0; other < 2; other++) {{
        prepare();
        if (other) {{
            {name}_on_grid({points}, 2, 2.0, 3.0, 5.0, 7.0, {values});
        }} else {{
            {name}_on_grid({points}, 2, 1.0, 1.0, 1.0, 1.0, {values});
        }}
        for (size_t i = 0; i < 2 * {points}; i++) {{
            double actual[{count}];
            for (size_t j = 0; j < {count}; j++) {{
                actual[j] = values[j][i];
                failed |= !isnan(values[j][2 * {points}]);
            }}
            failed |= differs(grid_checks[i], actual, other ? units : NULL);
        }}
    }}
    return failed;
}}
"""
GRID_TEST = """    failed |= grids_differ();
"""


def c_sources(plan: Plan, engine: str, stem: str, grid: bool) -> dict[str, str]:
    """Return the header and the source, by the ending of their files' names; `stem` is the names'."""
    name = identifier(stem)
    if name in RESERVED or comment_text(stem) != stem:
        remedy = "name it with letters, digits and _, like engine.c"
        raise SymbalanceError(f"--output {stem}.c", "is no function's name in C", remedy)
    outs = [identifier(o.harmonic_sum.name) for o in plan.outputs]
    head = "\n * ".join(paragraphs(plan, engine)).replace(" * \n", " *\n")
    prototypes = {kind: _prototype(name, kind, outs) for kind in ("double", "float", "grid")}
    header = HEADER.format(
        head=head,
        stem=stem,
        macro=name.upper(),
        mark=MARK,
        guard=f"{name.upper()}_H",
        prototype_double=prototypes["double"],
        prototype_float=prototypes["float"],
        prototype_grid=GRID_PROTOTYPE.format(prototype=prototypes["grid"]) if grid else "",
        at_speed=_at_speed_prototype(plan, name, outs) if plan.defaults.at_speed else "",
    )
    kernels = (plan.reduced_range, plan.full_range, plan.tail, *([plan.on_grid] if grid else []))
    functions = [_functions(plan, prototypes, outs)]
    functions += [_grid(plan, prototypes["grid"], outs)] if grid else []
    functions += [_at_speed(name, outs)] if plan.defaults.at_speed else []
    source = SOURCE.format(
        title=next(paragraphs(plan, engine)).split(";")[0],
        stem=stem,
        macro=name.upper(),
        mark=MARK,
        limit=repr(LIMIT),
        constants="\n".join(C.constants(unique(k.constants for k in kernels))),
        functions="".join(functions) + _self_test(plan, name, grid),
    )
    return _marked({".h": header, ".c": fold(source, "/* ")})


def _marked(texts: dict[str, str]) -> dict[str, str]:
    """Return a pair of files with the digest of both in the place of its mark.

    The two are put in place one after the other, and may be copied singly: a header of other outputs
    than its source's would compile with it, and shift what is computed into the wrong array.
    """
    total = sha256("\0".join(texts.values()).encode("utf-8")).hexdigest()
    return {ending: text.replace(MARK, f"0x{total[:15]}ULL") for ending, text in texts.items()}


def _prototype(name: str, kind: str, outs: list[str]) -> str:
    """Return a function's head; `kind` is "double", "float", "grid" or, without keywords, "speed"."""
    suffix = {"double": "", "float": "_float", "grid": "_on_grid", "speed": "_at_speed"}[kind]
    number = "float" if kind == "float" else "double"
    first = "size_t points, size_t turns" if kind == "grid" else f"size_t n, const {number} *theta"
    pointers = ", ".join(f"{number} *{out}" for out in outs)
    keywords = "double mass, double radius, double omega, double pitch"
    if kind == "speed":
        return fold(f"void {name}{suffix}({first},\n    {pointers})", "/* ")
    return fold(f"void {name}{suffix}({first},\n    {keywords},\n    {pointers})", "/* ")


def _at_speed_prototype(plan: Plan, name: str, outs: list[str]) -> str:
    """Return the sizes and the speed of an engine as macros, and the function that takes them."""
    numbers = {each: repr(value) for each, value in plan.defaults.values.items()}
    prototype = _prototype(name, "speed", outs)
    words = "\n * ".join(wrap(f"The engine at {plan.defaults.words()}.", WIDTH))
    return AT_SPEED_PROTOTYPE.format(words=words, macro=name.upper(), prototype=prototype, **numbers)


def _at_speed(name: str, outs: list[str]) -> str:
    """Return the function of an engine's own sizes and speed."""
    prototype = _prototype(name, "speed", outs)
    return AT_SPEED.format(prototype=prototype, name=name, macro=name.upper(), outs=", ".join(outs))


def _functions(plan: Plan, prototypes: dict[str, str], outs: list[str]) -> str:
    count = range(len(outs))
    basis = plan.basis
    scales = ", ".join(f"scale{i}" for i in count)
    lines, formulas = C.outputs(plan, "0.0*" + (basis or ("theta",))[0])
    parts = [
        *_base_function("near", "theta", plan.reduced_range.lines, basis, "|theta| <= LIMIT"),
        *_base_function("far", "theta", plan.full_range.lines, basis, "any angle"),
        f"INLINE void outputs({', '.join(f'double {b}' for b in basis or ('theta',))},",
        f"    {', '.join(f'double scale{i}' for i in count)}, double *restrict value) {{",
        *C.lines(lines, "    "),
        *(f"    value[{i}] = {C.formula(f)};" for i, f in enumerate(formulas)),
        "}",
    ]
    for kind in ("double", "float"):
        stores = [f"out{i}[i] = {'' if kind == 'double' else '(float)'}value[{i}];" for i in count]
        loops = LOOPS.format(
            kind=kind,
            scale_parameters=", ".join(f"double scale{i}" for i in count),
            out_parameters=", ".join(f"{kind} *restrict out{i}" for i in count),
            near="\n".join(_call_lines("near", "angle", basis)),
            either="\n".join(_either(basis)),
            stores="\n".join([*_values(plan, "angle"), *(f"        {line}" for line in stores)]),
            prototype=prototypes[kind],
            scales=_scales(plan),
            scale_names=scales,
            outs=", ".join(f"{out} + start" for out in outs),
        )
        parts.append("\n".join(line for line in loops.split("\n") if line.strip() or not line))
    return "\n".join(parts)


def _call_lines(
    function: str, arguments: str, basis: tuple[str, ...], indent: str = "        "
) -> list[str]:
    """Return the lines that declare the basis and have a function write them."""
    if not basis:
        return []
    return [
        f"{indent}double {', '.join(basis)};",
        f"{indent}{function}({arguments}, {', '.join(f'&{b}' for b in basis)});",
    ]


def _either(basis: tuple[str, ...]) -> list[str]:
    if not basis:
        return []
    declared, near = _call_lines("near", "angle", basis)
    far = near.replace("near(", "far(")
    return [
        declared,
        "        if (fabs(angle) <= LIMIT) {",
        f"    {near}",
        "        } else {",
        f"    {far}",
        "        }",
    ]


def _values(plan: Plan, argument: str) -> list[str]:
    count = range(len(plan.outputs))
    arguments = [*(plan.basis or (argument,)), *(f"scale{i}" for i in count), "value"]
    return [f"        double value[{len(count)}];", f"        outputs({', '.join(arguments)});"]


def _scales(plan: Plan) -> str:
    rows = (
        f"    const double scale{i} = {o.harmonic_sum.unit.formula};" for i, o in enumerate(plan.outputs)
    )
    return "\n".join(rows)


def _base_function(
    name: str, arguments: str, lines: Iterable[Statement], basis: tuple[str, ...], where: str
) -> list[str]:
    if not basis:
        return []
    pointers = ", ".join(f"double *restrict {b}_" for b in basis)
    parameters = ", ".join(f"double {argument}" for argument in arguments.split(", "))
    return [
        f"/* What the outputs are made of, for {where}. */",
        f"INLINE void {name}({parameters}, {pointers}) {{",
        *C.lines(lines, "    "),
        *(f"    *{b}_ = {b};" for b in basis),
        "}",
        "",
    ]


def _grid(plan: Plan, prototype: str, outs: list[str]) -> str:
    """Return the function for evenly spaced angles."""
    basis, lines = plan.basis, plan.on_grid.lines
    functions = _base_function("on_grid", "index, points", lines, basis, "theta = 2 pi index/points")
    period, calls_gcd = points_per_period(plan)
    stores = [f"        {out}[i] = value[{j}];" for j, out in enumerate(outs)]
    called = _call_lines("on_grid", "(double)i, (double)points", basis)
    return GRID.format(
        functions="\n".join(functions),
        gcd=GCD if calls_gcd else "",
        prototype=prototype,
        scales=_scales(plan),
        period=period,
        stores="\n".join([*called, *_values(plan, "(double)i"), *stores]),
        copies="\n".join(f"        {out}[i] = {out}[i - period];" for out in outs),
    )


def _self_test(plan: Plan, name: str, grid: bool) -> str:
    count = len(plan.outputs)
    rows = "\n".join(map(_row, checks(plan)))
    grid_rows = "\n".join(map(_row, grid_checks(plan))) if grid else ""
    shared = {"name": name, "count": count, "columns": 1 + 2 * count, "points": grid_points(plan)}
    values = ", ".join(f"values[{i}]" for i in range(count))
    grid_test = GRID_CHECKS.format(rows=grid_rows, values=values, **shared)
    pointers = ", ".join(f"actual + {i}" for i in range(count))
    at_speed = AT_SPEED_CHECKS.format(
        units=", ".join(map(repr, default_values(plan))), pointers=pointers, name=name, count=count
    )
    return SELF_TEST.format(
        macro=name.upper(),
        rows=rows,
        units=", ".join(map(repr, unit_values(plan))),
        values=values,
        rounded=", ".join(f"rounded[{i}]" for i in range(count)),
        pointers=pointers,
        at_speed_checks=at_speed if plan.defaults.at_speed else "",
        at_speed=AT_SPEED_TEST if plan.defaults.at_speed else "",
        grid_checks=grid_test if grid else "",
        grid=GRID_TEST if grid else "",
        **shared,
    )


def _row(check: Check) -> str:
    return "    {" + ", ".join(map(repr, (check.theta, *check.values, *check.allowed))) + "},"
