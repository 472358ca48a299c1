r"""Branch-free reduction of crank angles up to 2^50 rad: whole turns are subtracted first, exactly.

M = 99532 turns are I + eps radians with I whole and eps = -5.8e-6, for 2 I/M is a convergent of 4 pi.
With N = rint(theta/2 pi M), below 2^31,

    theta - N I        is exact: both are multiples of theta's last place, and the difference is smaller;
    N eps = N eps_1 + N eps_2 + N eps_3, of so few bits that N eps_1 is exact, and while N < 2^14 N eps_2;
    g is N eps on the grid 2^-32;
    theta' = theta - N I - g     is exact, below 2^20, for that grid is theta's own where N is not 0;
    beyond = (N eps_1 - g) + N eps_2 + N eps_3     is below 2^-32, and errs by less than 2^-60.

The crank angle modulo 2 pi (and 4 pi: M is even) is theta' - beyond. The lines for |theta| <= 2^20 take
theta' as their angle and `beyond` where they correct for the last bits of the period anyway.
"""

from __future__ import annotations

import re
from dataclasses import replace

from symbalance.codegen.cosines import split_on_grids
from symbalance.codegen.expression_ir import Kernel, Statement
from symbalance.text.reals import pi

FARTHEST_ANGLE = 2.0**50
"""The largest |theta| in radians the lines reduce; doubles lie 1/4 rad apart there."""
TURNS = 99532
"""So many turns are nearly a whole number of radians."""
FOLD, CREST = re.compile(r"x(\d+)"), re.compile(r"r\d+p")
STEP = re.compile(r"[\d.]+\*")
DISPLACEMENT = {
    "pa": "{} - beyond_1",
    "pd": "{}",
    "rest": "((pd - pe) - beyond_2) + ({}) - beyond_3",
    "pr": "pe + rest",
    "lost": "(pe - pr) + rest",
}
"""A displacement near dead centre takes the parts one by one: its differences stay exact."""
GRID = 4294967296.0
"""Steps to a radian of the grid of g: so few that a difference below 2^20 rad is exact on it."""


def extend_range(near: Kernel) -> Kernel:
    """Return the lines for |theta| <= 2^20 made good for |theta| <= 2^50.

    `theta` itself is assigned to: for languages that let a name be used again.
    """
    if not near.lines:
        return near
    kernel = Kernel(list(near.constants), [])
    span = 2 * pi(60) * TURNS
    rest = span - round(span)
    first, second, third = split_on_grids(rest, 39, 39, 2)
    per = kernel.constant("PER_RADIAN_MANY", 1 / span, f"times {TURNS} turns in a radian")
    whole = kernel.constant("MANY_TURNS", round(span), f"{TURNS} turns in radians, cut in four")
    part = kernel.constant("MANY_TURNS_REST", rest, "what lies beyond the whole number")
    names = [
        kernel.constant("MANY_TURNS_2", first, "of so few bits that times `many` it is exact"),
        kernel.constant("MANY_TURNS_3", second),
        kernel.constant("MANY_TURNS_4", third),
    ]
    kernel.line("many", f"rint(theta*{per})", f"times {TURNS} turns")
    kernel.line("g", f"rint(many*{part}*{GRID!r})/{GRID!r}", "exact from here to theta")
    kernel.line("beyond_1", f"many*{names[0]} - g", "exact: what theta leaves out")
    kernel.line("beyond_2", f"many*{names[1]}", "and more of that")
    kernel.line("beyond_3", f"many*{names[2]}")
    kernel.line("beyond", "beyond_1 + (beyond_2 + beyond_3)")
    kernel.line("theta", f"(theta - many*{whole}) - g", "below 2^20, by whole turns the same angle")
    corrected = [new for line in near.lines for new in _correct(line)]
    reductions = sum(line.formula.startswith("rint(theta*") for line in near.lines)
    if sum("beyond" in line.formula for line in corrected if line.name not in ("pa", "pe")) != reductions:
        raise ValueError("a reduction of theta has no place for what lies beyond it")
    kernel.lines += corrected
    return kernel.pruned({line.name for line in near.lines})


def _correct(line: Statement) -> list[Statement]:
    """Return a line with the rest of the angle put in, where the period's own rest is."""
    folded = FOLD.fullmatch(line.name)
    if folded:
        step = STEP.match(line.formula)
        more = f" + {step[0] if step else ''}side{folded[1]}*beyond"
        return [replace(line, formula=line.formula + more)]
    if CREST.fullmatch(line.name):
        return [replace(line, formula=f"{line.formula} - beyond")]
    if line.name in DISPLACEMENT:
        changed = replace(line, formula=DISPLACEMENT[line.name].format(line.formula))
        return [changed, Statement("pe", "pd - beyond_2")] if line.name == "pd" else [changed]
    return [line]
