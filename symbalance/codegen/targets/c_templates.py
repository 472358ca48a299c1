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

static int differs(const double *check, const double *found) {{
    int failed = 0;
    for (size_t j = 0; j < {count}; j++) {{
        const double value = check[1 + j], off = check[1 + {count} + j];
        if (!(fabs(found[j] - value) <= off)) {{
            printf("output %zu at %.17g: %.17g, true %.17g\\n", j, check[0], found[j], value);
            failed = 1;
        }}
    }}
    return failed;
}}
{grid_checks}
int main(void) {{
    const size_t n = sizeof checks / sizeof checks[0];
    int failed = 0;
    for (size_t i = 0; i < n; i++) {{
        double found[{count}];
        {name}(1, checks[i], 1.0, 1.0, 1.0, 1.0, {pointers});
        failed |= differs(checks[i], found);
    }}
{grid}    const double lost[] = {{INFINITY, NAN}};
    for (size_t i = 0; i < 2; i++) {{
        double found[{count}];
        {name}(1, lost + i, 1.0, 1.0, 1.0, 1.0, {pointers});
        for (size_t j = 0; j < {count}; j++) {{
            failed |= !isnan(found[j]);
        }}
    }}
    printf("self-test %s: %zu angles\\n", failed ? "FAILED" : "passed", n);
    return failed;
}}
#endif
"""
GRID_CHECKS = """
/* The same at theta = 2 pi j/{points}, two turns, for {name}_on_grid. */
static const double grid_checks[][{columns}] = {{
{rows}
}};
"""
GRID_TEST = """    double on_grid[{count}][2 * {points}];
    {name}_on_grid({points}, 2, 1.0, 1.0, 1.0, 1.0, {pointers});
    for (size_t i = 0; i < 2 * {points}; i++) {{
        double found[{count}];
        for (size_t j = 0; j < {count}; j++) {{
            found[j] = on_grid[j][i];
        }}
        failed |= differs(grid_checks[i], found);
    }}
"""
