"""Source in JavaScript: an ES module without dependencies, for browsers, Node, Deno and Bun."""

from __future__ import annotations

from collections.abc import Iterable

from symbalance.codegen.checks import Check, checks, default_values, grid_checks, grid_points, unit_values
from symbalance.codegen.cosines import LIMIT
from symbalance.codegen.expression_ir import Statement
from symbalance.codegen.plans import Plan
from symbalance.codegen.targets.header_text import paragraphs
from symbalance.codegen.targets.syntax import Syntax, default_numbers, fold, points_per_period, unique

SYNTAX = Syntax(
    {
        "rint": "(({} + MAGIC) - MAGIC)",
        "abs": "Math.abs({})",
        "sqrt": "Math.sqrt({})",
        "side": "({} < 0 ? -1 : 1)",
        "cos": "Math.cos({})",
        "sin": "Math.sin({})",
    },
    line="const {} = {};",
    constant="const {} = {};",
    comment="// {}",
)
MODULE = """/* {head}
 *
 * An ES module: import {{ evaluate }} from this file. Run by node it tests itself.
 */

export const OUTPUTS = [{names}];

const MAGIC = 6755399441055744;  // 1.5 * 2^52: adding it rounds to a whole number
const LIMIT = {limit};  // the largest |theta| that is reduced exactly
{constants}

/**
 * Return the outputs at crank angles theta (radians), in SI units.
 *
 * A number gives a number, an array or a Float64Array a Float64Array, a Float32Array a
 * Float32Array; for several outputs an object of those, by output name.
 *
 * @param {{number | ArrayLike<number>}} theta
 * @param {{{{mass?: number, radius?: number, omega?: number, pitch?: number}}}} [engine]
 */
export function evaluate(theta, engine = {{}}) {{
  const {{ mass, radius, omega, pitch }} = keywords(engine);
  const single = typeof theta === "number";
  if (!single && (theta === null || typeof theta !== "object" || theta.length === undefined)) {{
    throw new TypeError(`theta = ${{theta}}: must be a number or an array, in radians`);
  }}
  const angles = single ? [theta] : theta;
  if (!ArrayBuffer.isView(angles)) {{
    for (let i = 0; i < angles.length; i++) {{
      if (typeof angles[i] !== "number") checkNumbers({{ [`theta[${{i}}]`]: angles[i] }});
    }}
  }}
  const Kind = theta instanceof Float32Array ? Float32Array : Float64Array;
  const results = OUTPUTS.map(() => new Kind(angles.length));
  fill(angles, mass, radius, omega, pitch, ...results);
  return given(single ? results.map((values) => values[0]) : results);
}}
{grid}
/** Return the keywords, {defaults_are} where not given; what is none of them is refused. */
function keywords(engine) {{
  if (engine === null || typeof engine !== "object") {{
    throw new TypeError(`engine = ${{engine}}: must be an object, such as {{ mass: 0.5 }}`);
  }}
  const {{ {arguments}, ...unknown }} = engine;
  for (const name of Object.keys(unknown)) {{
    throw new TypeError(`${{name}}: unknown; the keywords are mass, radius, omega and pitch`);
  }}
  checkNumbers({{ mass, radius, omega, pitch }});
  return {{ mass, radius, omega, pitch }};
}}

function checkNumbers(values) {{
  for (const [name, value] of Object.entries(values)) {{
    if (typeof value !== "number") throw new TypeError(`${{name}} = ${{value}}: must be a number`);
  }}
}}

function given(results) {{
  if (results.length === 1) return results[0];
  return Object.fromEntries(OUTPUTS.map((name, i) => [name, results[i]]));
}}

function fill(angles, mass, radius, omega, pitch, {outs}) {{
{scales}
  for (let i = 0; i < angles.length; i++) {{
    const theta = angles[i];
{basis}{outputs}
  }}
}}
{fill_grid}
// Angles, the true values there (mpmath, 50 digits), and what each may be off.
const CHECKS = [
{rows}
];
// Keywords that tell each from every other, and what they make of a value of 1.
const KEYWORDS = {{ mass: 2, radius: 3, omega: 5, pitch: 7 }};
const UNITS = [{units}];
{defaults}{grid_rows}
/** Compare with the true values, singly and as an array; throw an Error past a bound. */
export function selfTest() {{
  const values = (actual) => OUTPUTS.map((name) => (OUTPUTS.length === 1 ? actual : actual[name]));
  const together = values(evaluate(CHECKS.map(([theta]) => theta){ones}));
  const compare = ([theta, expected, allowed], actual, where, units) => OUTPUTS.forEach((name, j) => {{
    const unit = units ? units[j] : 1, off = units ? 2*unit*allowed[j] : allowed[j];
    if (!(Math.abs(actual[j] - unit*expected[j]) <= off)) {{
      throw new Error(`${{name}}${{where}}(${{theta}}) = ${{actual[j]}}, true ${{unit*expected[j]}}`);
    }}
  }});
  const column = (actual, i) => actual.map((values) => values[i]);
  const singles = Float32Array.from(CHECKS, ([theta]) => theta);
  const rounded = values(evaluate(singles{ones}));
  const doubled = values(evaluate(Float64Array.from(singles){ones}));
  CHECKS.forEach((check, i) => {{
    compare(check, values(evaluate(check[0]{ones})), "");
{at_speed}    compare(check, column(together, i), "");
    compare(check, values(evaluate(check[0], KEYWORDS)), " with keywords", UNITS);
    OUTPUTS.forEach((name, j) => {{  // float32 values are rounded once
      const one = rounded[j][i], other = doubled[j][i];
      const close = Math.abs(one - other) <= 2**-23*Math.abs(other) + check[2][j];
      if (!close || !(rounded[j] instanceof Float32Array)) {{
        throw new Error(`${{name}} at float32 ${{singles[i]}} = ${{one}}, in double ${{other}}`);
      }}
    }});
  }});
{grid_test}  for (const actual of values(evaluate([Infinity, -Infinity, NaN]))) {{
    if (!actual.every(Number.isNaN)) throw new Error(`not NaN where theta is not finite: ${{actual}}`);
  }}
}}

/** Tell whether a runtime was started with this very file, whatever links lead to it. */
function isMain() {{
  if (import.meta.main !== undefined) return import.meta.main;
  const script = globalThis.process?.argv?.[1];
  if (!script) return false;
  const module = globalThis.process.getBuiltinModule?.("node:module");
  const url = globalThis.process.getBuiltinModule?.("node:url");
  if (!module || !url) {{
    return decodeURIComponent(import.meta.url).endsWith(script.replaceAll("\\\\", "/"));
  }}
  try {{
    return module.createRequire(import.meta.url).resolve(script) === url.fileURLToPath(import.meta.url);
  }} catch {{
    return false;
  }}
}}

if (isMain()) {{
  selfTest();
  console.log("self-test passed:", CHECKS.length, "angles,", OUTPUTS.join(", "));
}}
"""
GRID = """
/**
 * Return the outputs at theta = 2 pi j/points, j = 0, 1, ... over so many whole turns.
 *
 * Only one period is computed, from angles that are exact; the rest repeats it.
 */
export function onGrid(points, turns = 1, engine = {{}}) {{
  const {{ mass, radius, omega, pitch }} = keywords(engine);
  if (!(Number.isInteger(points) && Number.isInteger(turns) && points > 0 && turns > 0)) {{
    throw new RangeError(`points = ${{points}}, turns = ${{turns}}: must be whole numbers above 0`);
  }}
  const length = points*turns;
  const period = Math.min({period}, length);
  const results = OUTPUTS.map(() => new Float64Array(length));
  fillGrid(period, points, mass, radius, omega, pitch, ...results);
  for (const values of results) {{
    for (let i = period; i < length; i++) values[i] = values[i - period];
  }}
  return given(results);
}}
{gcd}"""
AT_SPEED = """    compare(check, values(evaluate(check[0])), " at speed", UNITS_AT_SPEED);
"""
GRID_ROWS = """
// The same at theta = 2 pi j/{points}, two turns, for onGrid.
const GRID_CHECKS = [
{rows}
];
"""
GRID_TEST = """  const grid = values(onGrid({points}, 2{grid_ones}));
  GRID_CHECKS.forEach((check, i) => compare(check, column(grid, i), " on the grid"));
  const other = values(onGrid({points}, 2, KEYWORDS));
  GRID_CHECKS.forEach((check, i) => compare(check, column(other, i), " on the grid", UNITS));
"""
GCD = """
function gcd(a, b) {
  return b === 0 ? a : gcd(b, a % b);
}
"""
FILL_GRID = """
function fillGrid(period, points, mass, radius, omega, pitch, {outs}) {{
{scales}
  for (let index = 0; index < period; index++) {{
{lines}
{outputs}
  }}
}}
"""


def javascript_source(plan: Plan, engine: str, grid: bool) -> str:
    """Return the module."""
    first, *rest = paragraphs(plan, engine)
    kernels = [plan.reduced_range, plan.full_range, plan.tail, *([plan.on_grid] if grid else [])]
    period, calls_gcd = points_per_period(plan)
    outs = ", ".join(f"out{i}" for i in range(len(plan.outputs)))
    scales = "\n".join(
        f"  const scale{i} = {o.harmonic_sum.unit.formula};" for i, o in enumerate(plan.outputs)
    )
    on_grid = "\n".join(SYNTAX.lines(plan.on_grid.lines, "    "))
    on_grid = on_grid or "    const theta = 0;  // every output is zero"
    fill_grid = FILL_GRID.format(outs=outs, scales=scales, lines=on_grid, outputs=_outputs(plan, "index"))
    points, at_speed = grid_points(plan), plan.defaults.at_speed
    text = MODULE.format(
        head="\n * ".join([first, *rest]).replace(" * \n", " *\n"),
        defaults_are="the engine's" if at_speed else "1",
        arguments=", ".join(f"{name} = {value}" for name, value in default_numbers(plan).items()),
        defaults=_defaults(plan) if at_speed else "",
        at_speed=AT_SPEED if at_speed else "",
        ones=", ONES" if at_speed else "",
        names=", ".join(f'"{o.harmonic_sum.name}"' for o in plan.outputs),
        limit=int(LIMIT),
        constants="\n".join(SYNTAX.constants(unique(k.constants for k in kernels))),
        grid=GRID.format(period=period, gcd=GCD if calls_gcd else "") if grid else "",
        outs=outs,
        scales=scales,
        basis=_basis_lines(plan),
        outputs=_outputs(plan, "i"),
        fill_grid=fill_grid if grid else "",
        rows=_rows(checks(plan)),
        units=", ".join(map(repr, unit_values(plan))),
        grid_rows=GRID_ROWS.format(points=points, rows=_rows(grid_checks(plan))) if grid else "",
        grid_test=GRID_TEST.format(points=points, grid_ones=", ONES" if at_speed else "") if grid else "",
    )
    return fold(text, "// ")


def _defaults(plan: Plan) -> str:
    """Return the keywords that make units of the defaults, and what the defaults make of a value of 1."""
    units = ", ".join(map(repr, default_values(plan)))
    ones = "{ mass: 1, radius: 1, omega: 1, pitch: 1 }"
    return f"// Where none is given.\nconst ONES = {ones}, UNITS_AT_SPEED = [{units}];\n"


def _rows(rows: Iterable[Check]) -> str:
    return "\n".join(f"  [{c.theta!r}, {list(c.values)}, {list(c.allowed)}]," for c in rows)


def _basis_lines(plan: Plan) -> str:
    """Return the lines of what the outputs are made of, near and far."""
    if not plan.basis:
        return ""
    near, far = (
        "\n".join(_assignments(kernel.lines, plan.basis))
        for kernel in (plan.reduced_range, plan.full_range)
    )
    head = f"    let {', '.join(plan.basis)};\n    if (Math.abs(theta) <= LIMIT) {{\n"
    return f"{head}{near}\n    }} else {{\n{far}\n    }}\n"


def _assignments(lines: Iterable[Statement], basis: tuple[str, ...]) -> list[str]:
    """Return assignments, those of `basis` to variables that are there already."""
    texts = SYNTAX.lines(lines, "      ")
    starts = tuple(f"      const {base} = " for base in basis)
    return [t.replace("const ", "", 1) if t.startswith(starts) else t for t in texts]


def _outputs(plan: Plan, place: str) -> str:
    lines, formulas = SYNTAX.outputs(plan, "0.0*" + (plan.basis or ("theta",))[0])
    stores = (f"    out{i}[{place}] = {SYNTAX.formula(f)};" for i, f in enumerate(formulas))
    return "\n".join([*SYNTAX.lines(lines, "    "), *stores])
