"""The fixed text of the C sources."""

from __future__ import annotations

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

/* The same for float arrays, computed in double and rounded once. */
{prototype_float};
{prototype_grid}
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

static int differs(const double *check, const double *found, const double *unit) {{
    int failed = 0;
    for (size_t j = 0; j < {count}; j++) {{
        const double scale = unit ? unit[j] : 1.0, value = scale * check[1 + j];
        const double off = (unit ? 2.0 : 1.0) * scale * check[1 + {count} + j];
        if (!(fabs(found[j] - value) <= off)) {{
            printf("output %zu at %.17g: %.17g, true %.17g\\n", j, check[0], found[j], value);
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
            double found[{count}];
            for (size_t j = 0; j < {count}; j++) {{
                found[j] = values[j][i];
                failed |= !isnan(values[j][MANY]);
            }}
            failed |= differs(checks[row[i]], found, other ? units : NULL);
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
{grid_checks}
int main(void) {{
    int failed = 0;
    for (size_t i = 0; i < ANGLES; i++) {{
        double found[{count}];
        {name}(1, checks[i], 1.0, 1.0, 1.0, 1.0, {pointers});
        failed |= differs(checks[i], found, NULL);
    }}
    failed |= arrays_differ();
    failed |= floats_differ();
{grid}    const double lost[] = {{INFINITY, NAN}};
    for (size_t i = 0; i < 2; i++) {{
        double found[{count}];
        {name}(1, lost + i, 1.0, 1.0, 1.0, 1.0, {pointers});
        for (size_t j = 0; j < {count}; j++) {{
            failed |= !isnan(found[j]);
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
            double found[{count}];
            for (size_t j = 0; j < {count}; j++) {{
                found[j] = values[j][i];
                failed |= !isnan(values[j][2 * {points}]);
            }}
            failed |= differs(grid_checks[i], found, other ? units : NULL);
        }}
    }}
    return failed;
}}
"""
GRID_TEST = """    failed |= grids_differ();
"""
