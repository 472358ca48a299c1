"""Source in one function file for GNU Octave and MATLAB."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from symbalance.codegen.checks import (
    KEYWORDS,
    Check,
    checks,
    default_values,
    grid_checks,
    grid_points,
    unit_values,
)
from symbalance.codegen.cosines import LIMIT
from symbalance.codegen.expression_ir import NAME, Kernel, Statement
from symbalance.codegen.plans import Plan
from symbalance.codegen.targets.header_text import identifier, paragraphs
from symbalance.codegen.targets.syntax import Syntax, default_numbers, fold, points_per_period, unique
from symbalance.errors import SymbalanceError

SYNTAX = Syntax(
    {
        "rint": "round({})",
        "abs": "abs({})",
        "sqrt": "sqrt({})",
        "side": "(1 - 2*({} < 0))",
        "cos": "cos({})",
        "sin": "sin({})",
    },
    line="{} = {};",
    constant="{} = {};",
    comment="% {}",
    elementwise=True,
)
WORDS = """
break case catch classdef continue else elseif end for function global if otherwise parfor
persistent return spmd switch try while do until unwind_protect abs sqrt cos sin round gcd double
single class ischar isscalar strcmp repmat isreal isnumeric islogical any all min mod nan inf isnan
error fprintf size nargin varargin varargout numbers evaluate near far outputs on_grid self_test theta
result mass radius omega pitch struct cell2mat struct2cell
"""
RESERVED = frozenset(WORDS.split())
"""Names a function file must not bear: words of the language and what the file itself uses."""
MODULE = """function result = {name}(theta, varargin)
%{upper}  {head}
%
% values = {name}(theta)
% values = {name}(theta, mass, radius, omega, pitch)
%     theta: crank angles, an array of any shape. Trailing arguments may be left out: each is {default}
%     then. {returned} single angles give single values.
{grid_help}% {name}('self-test')
%     compares with the true values, and is an error where one is past its bound.
%
% {about}
    if ischar(theta)
        if strcmp(theta, 'self-test')
            self_test();
            return
        end{grid_call}
        error('%s: unknown; the first argument is crank angles{words}', theta);
    end
    result = evaluate(theta, varargin{{:}});
end

function result = evaluate(theta, mass, radius, omega, pitch)
    if nargin < 2, mass = {mass}; end
    if nargin < 3, radius = {radius}; end
    if nargin < 4, omega = {omega}; end
    if nargin < 5, pitch = {pitch}; end
    if ~(isnumeric(theta) || islogical(theta)) || ~isreal(theta)
        error('theta must be real crank angles, in radians');
    end
    [mass, radius, omega, pitch] = numbers(mass, radius, omega, pitch);
    kind = class(theta);
    theta = double(theta);
{basis}
{outputs}
    if strcmp(kind, 'single')
{singles}
    end
    result = {result};
end
{near}{far}{grid}
function varargout = numbers(varargin)
% The arguments as doubles: int32 would round every value, a letter count as its code.
    for i = 1:nargin
        value = varargin{{i}};
        if ~(isnumeric(value) && isreal(value) && isscalar(value))
            error('mass, radius, omega, pitch, points and turns must be one real number each');
        end
        varargout{{i}} = double(value);
    end
end

function {values} = outputs({arguments}, mass, radius, omega, pitch)
% The outputs in SI units.
{constants}
{scales}
{tail}
end

function self_test()
% Angles, the true values there (mpmath, 50 digits), and what each may be off.
    checks = [
{rows}
    ];
% Of each output, where mass, radius, omega and pitch are 2, 3, 5 and 7 instead of 1.
    units = [{units}];
    together = {check_all};
    other = {check_other};
{at_speed}    angles = single(checks(:, 1));
    rounded = {check_single};
    doubled = {check_doubled};
    for i = 1:size(checks, 1)
        alone = {check_one};
        for j = 1:{count}
            if ~(abs(other(i, j) - units(j)*checks(i, 1 + j)) <= 2*units(j)*checks(i, 1 + {count} + j))
                error('output %d with keywords at %.17g: %.17g', j, checks(i, 1), other(i, j));
            end
            gap = abs(double(rounded(i, j)) - doubled(i, j));
            close = gap <= 2^-23*abs(doubled(i, j)) + checks(i, 1 + {count} + j);
            if ~(close && isa(rounded, 'single'))
                error('output %d at single %.9g: %.9g', j, angles(i), rounded(i, j));
            end
            expected = checks(i, 1 + j);
            allowed = checks(i, 1 + {count} + j);
            for actual = [alone(j), together(i, j)]
                if ~(abs(actual - expected) <= allowed)
                    error('output %d at %.17g: %.17g, true %.17g', j, checks(i, 1), actual, expected);
                end
            end
        end
    end
{check_grid}    lost = {check_lost};
    if ~all(isnan(lost(:)))
        error('not NaN where theta is not finite');
    end
    fprintf('self-test passed: %d angles\\n', size(checks, 1));
end
"""
GRID_HELP = """% values = {name}('grid', points, turns, mass, radius, omega, pitch)
%     the values at theta = 2 pi j/points, j = 0, 1, ... over so many whole turns, a column; only
%     one period is computed, from angles that are exact, and repeated. turns is 1 unless given.
"""
GRID_CALL = """
        if strcmp(theta, 'grid')
            result = on_grid(varargin{:});
            return
        end"""
AT_SPEED = """% The same where none of the four is given.
    at_speed = {values};
    units_at_speed = [{units}];
    for i = 1:size(checks, 1)
        for j = 1:{count}
            unit = units_at_speed(j);
            if ~(abs(at_speed(i, j) - unit*checks(i, 1 + j)) <= 2*unit*checks(i, 1 + {count} + j))
                error('output %d at speed at %.17g: %.17g', j, checks(i, 1), at_speed(i, j));
            end
        end
    end
"""
GRID_TEST = """% The same at theta = 2 pi j/{points}, two turns.
    checks = [
{rows}
    ];
    together = {values};
    other = {others};
    for i = 1:size(checks, 1)
        for j = 1:{count}
            value = checks(i, 1 + j);
            allowed = checks(i, 1 + {count} + j);
            if ~(abs(together(i, j) - value) <= allowed)
                error('output %d on the grid at %.17g: %.17g', j, checks(i, 1), together(i, j));
            end
            if ~(abs(other(i, j) - units(j)*value) <= 2*units(j)*allowed)
                error('output %d on the grid with keywords: %.17g', j, other(i, j));
            end
        end
    end
"""
GRID = """
function result = on_grid(points, turns, mass, radius, omega, pitch)
    if nargin < 2, turns = 1; end
    if nargin < 3, mass = {mass}; end
    if nargin < 4, radius = {radius}; end
    if nargin < 5, omega = {omega}; end
    if nargin < 6, pitch = {pitch}; end
    [points, turns] = numbers(points, turns);
    if ~(points >= 1 && turns >= 1 && points == round(points) && turns == round(turns))
        error('points and turns must be whole numbers, at least 1');
    end
    [mass, radius, omega, pitch] = numbers(mass, radius, omega, pitch);
    count = points*turns;
    period = {period};
    index = (0:min(period, count) - 1)';
{constants}
{lines}
{outputs}
{repeated}
    result = {result};
end
"""


def octave_source(plan: Plan, engine: str, name: str, grid: bool) -> str:
    """Return the function file; `name` is its stem, and the function's name."""
    if identifier(name) != name or name in RESERVED or len(name) > 63:
        remedy = "name it with letters, digits and _, like engine.m"
        raise SymbalanceError(f"--output {name}.m", "is no function's name in Octave", remedy)
    first, *rest = paragraphs(plan, engine)
    outs = [identifier(o.harmonic_sum.name) for o in plan.outputs]
    one = len(outs) == 1
    text = MODULE.format(
        name=name,
        upper=name.upper(),
        head=first,
        about="\n% ".join(rest[1:]).replace("% \n", "%\n"),
        default="the\n%     engine's at its speed" if plan.defaults.at_speed else "1",
        **default_numbers(plan),
        returned="The values have its shape;" if one else "A struct of arrays of its shape, by output;",
        grid_help=GRID_HELP.format(name=name) if grid else "",
        grid_call=GRID_CALL if grid else "",
        words=", ''grid'' or ''self-test''" if grid else " or ''self-test''",
        basis=_basis_lines(plan),
        outputs=_call(plan, outs),
        singles="\n".join(f"        {out} = single({out});" for out in outs),
        result=_result(outs),
        near=_function("near", plan.reduced_range, plan.basis, f"|theta| <= {int(LIMIT)}"),
        far=_function("far", plan.full_range, plan.basis, "any angle"),
        grid=_grid(plan, outs) if grid else "",
        values=_several(outs),
        arguments=", ".join(plan.basis) or "theta",
        scales="\n".join(
            f"    scale{i} = {o.harmonic_sum.unit.formula};" for i, o in enumerate(plan.outputs)
        ),
        **_tail(plan, outs),
        **_checked(plan, outs, grid),
    )
    return fold(text, "% ", " ...")


def _several(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"[{', '.join(names)}]"


def _result(outs: Sequence[str]) -> str:
    """Return the one output, or a struct of several."""
    if len(outs) == 1:
        return outs[0]
    fields = ", ".join(f"'{out}', {out}" for out in outs)
    return f"struct({fields})"


def _call(plan: Plan, outs: Sequence[str]) -> str:
    arguments = ", ".join(plan.basis) or "theta"
    return f"    {_several(outs)} = outputs({arguments}, mass, radius, omega, pitch);"


def _basis_lines(plan: Plan) -> str:
    """Return the lines that compute the basis, near angles at once, far ones where there are any."""
    if not plan.basis:
        return "    theta(~(abs(theta) < inf)) = nan;"
    parts = [f"{base}_far" for base in plan.basis]
    lines = [
        f"{_several(plan.basis)} = near(theta);",
        f"beyond = ~(abs(theta) <= {int(LIMIT)});",
        "if any(beyond(:))",
        f"    {_several(parts)} = far(theta(beyond));",
        *(f"    {base}(beyond) = {part};" for base, part in zip(plan.basis, parts, strict=True)),
        "end",
    ]
    return "\n".join(f"    {line}" for line in lines)


def _constants(plan: Plan, lines: Iterable[Statement], more: Iterable[str] = ()) -> list[str]:
    """Return the definitions of the constants that lines, and formulas more, use."""
    formulas = [*(line.formula for line in lines), *more]
    used = {name for formula in formulas for name in NAME.findall(formula)}
    kernels = (plan.reduced_range, plan.full_range, plan.on_grid, plan.tail)
    return SYNTAX.constants([c for c in unique(k.constants for k in kernels) if c.name in used], "    ")


def _function(name: str, kernel: Kernel, basis: tuple[str, ...], where: str) -> str:
    if not basis:
        return ""
    lines = [
        "",
        f"function {_several(basis)} = {name}(theta)",
        f"% What the outputs are made of, for {where}.",
        *SYNTAX.constants(kernel.constants, "    "),
        *SYNTAX.lines(kernel.lines, "    "),
        "end",
        "",
    ]
    return "\n".join(lines)


def _grid(plan: Plan, outs: Sequence[str]) -> str:
    lines = SYNTAX.lines(plan.on_grid.lines, "    ") or ["    theta = index;"]
    return GRID.format(
        **default_numbers(plan),
        period=points_per_period(plan)[0],
        constants="\n".join(SYNTAX.constants(plan.on_grid.constants, "    ")),
        lines="\n".join(lines),
        outputs=_call(plan, outs),
        repeated="\n".join(f"    {out} = {out}(mod((0:count - 1)', period) + 1);" for out in outs),
        result=_result(outs),
    )


def _tail(plan: Plan, outs: Sequence[str]) -> dict[str, str]:
    lines, formulas = SYNTAX.outputs(plan, "0.0*" + (plan.basis or ("theta",))[0])
    values = (f"    {out} = {SYNTAX.formula(f)};" for out, f in zip(outs, formulas, strict=True))
    return {
        "constants": "\n".join(_constants(plan, lines, formulas)),
        "tail": "\n".join([*SYNTAX.lines(lines, "    "), *values]),
    }


def _checked(plan: Plan, outs: Sequence[str], grid: bool) -> dict[str, str]:
    def values(call: str) -> str:
        return call if len(outs) == 1 else f"cell2mat(struct2cell({call})')"

    def rows(tests: Iterable[Check]) -> str:
        return "\n".join(
            "        " + ", ".join(map(repr, (c.theta, *c.values, *c.allowed))) for c in tests
        )

    points, count = grid_points(plan), str(len(outs))
    keywords = ", ".join(f"{value:g}" for value in KEYWORDS.values())
    ones = ", 1, 1, 1, 1" if plan.defaults.at_speed else ""
    units = ", ".join(map(repr, default_values(plan)))
    at_speed = AT_SPEED.format(units=units, values=values("evaluate(checks(:, 1))"), count=count)
    on_grid = {
        "points": points,
        "rows": rows(grid_checks(plan)),
        "count": count,
        "values": values(f"on_grid({points}, 2{ones})"),
        "others": values(f"on_grid({points}, 2, {keywords})"),
    }
    return {
        "at_speed": at_speed if ones else "",
        "rows": rows(checks(plan)),
        "count": count,
        "check_all": values(f"evaluate(checks(:, 1){ones})"),
        "check_one": values(f"evaluate(checks(i, 1){ones})"),
        "check_other": values(f"evaluate(checks(:, 1), {keywords})"),
        "check_single": values(f"evaluate(angles{ones})"),
        "check_doubled": values(f"evaluate(double(angles){ones})"),
        "units": ", ".join(map(repr, unit_values(plan))),
        "check_grid": GRID_TEST.format(**on_grid) if grid else "",
        "check_lost": values("evaluate([inf; -inf; nan])"),
    }
