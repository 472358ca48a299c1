"""How a target language writes formulas, assignments, comments and long lines."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from symbalance.codegen.expression_ir import NamedConstant, Statement
from symbalance.codegen.plans import Plan

CALL = re.compile(r"\b(rint|abs|sqrt|side|cos|sin)\(")
WIDTH = 100
"""Columns of generated code, where the language lets a line be broken."""
BREAKS = (" + ", " - ", ", ")


@dataclass(frozen=True)
class Syntax:
    """How a language writes functions (a text with {} for the argument), lines and comments."""

    functions: Mapping[str, str]
    line: str
    constant: str
    comment: str
    elementwise: bool = False

    def formula(self, text: str) -> str:
        """Return a formula in this syntax."""
        call = CALL.search(text)
        if call is None:
            return text.replace("*", ".*").replace("/", "./") if self.elementwise else text
        inner, rest = _split_at_close(text[call.end() :])
        value = self.functions[call.group(1)].format(self.formula(inner))
        return self.operators(text[: call.start()]) + value + self.formula(rest)

    def operators(self, text: str) -> str:
        """Return what precedes a call."""
        return text.replace("*", ".*").replace("/", "./") if self.elementwise else text

    def outputs(self, plan: Plan, zero: str) -> tuple[list[Statement], list[str]]:
        """Return the lines and the formulas of the outputs times scale0, scale1, ....

        Where a formula is linear in its own constants the scale goes into those: that happens once,
        outside the loop over the angles.
        """
        lines, formulas = list(plan.tail.lines), []
        for i, output in enumerate(plan.outputs):
            scale = f"scale{i}"
            if output.is_linear:
                own = re.compile(rf"\b{output.prefix}\w+")
                lines = [
                    replace(line, formula=own.sub(rf"({scale}*\g<0>)", line.formula)) for line in lines
                ]
                formulas.append(own.sub(rf"({scale}*\g<0>)", output.formula))
            else:
                formulas.append(f"{scale}*({zero if output.formula == '0.0' else output.formula})")
        return lines, formulas

    def lines(self, lines: Iterable[Statement], indent: str) -> list[str]:
        """Return assignments, their notes as comments beside them."""
        assignments = [
            (self.line.format(line.name, self.formula(line.formula)), line.note) for line in lines
        ]
        return [indent + self._with_note(text, note) for text, note in assignments]

    def constants(self, constants: Iterable[NamedConstant], indent: str = "") -> list[str]:
        """Return definitions, their notes as comments beside them."""
        definitions = [(self.constant.format(c.name, repr(c.value)), c.note) for c in constants]
        return [indent + self._with_note(text, note) for text, note in definitions]

    def _with_note(self, text: str, note: str) -> str:
        return f"{text}  {self.comment.format(note)}" if note else text


def keyword_arguments(plan: Plan) -> str:
    """Return mass, radius, omega and pitch with their defaults, as Python has keyword arguments."""
    return ", ".join(f"{name}={value!r}" for name, value in plan.defaults.values.items())


def default_numbers(plan: Plan) -> dict[str, str]:
    """Return the defaults of the keywords in a language whose whole numbers have no point."""
    return {name: repr(value).removesuffix(".0") for name, value in plan.defaults.values.items()}


def _split_at_close(text: str) -> tuple[str, str]:
    depth = 1
    for i, character in enumerate(text):
        depth += (character == "(") - (character == ")")
        if depth == 0:
            return text[:i], text[i + 1 :]
    raise ValueError(f"unbalanced formula {text!r}")


def unique(groups: Iterable[Iterable[NamedConstant]]) -> list[NamedConstant]:
    """Return the constants of several kernels, each name once."""
    by_name: dict[str, NamedConstant] = {}
    for constant in (c for group in groups for c in group):
        if by_name.setdefault(constant.name, constant).value != constant.value:
            raise ValueError(f"two values for the constant {constant.name}")
    return list(by_name.values())


def points_per_period(plan: Plan, divide: str = "/", gcd: str = "gcd") -> tuple[str, bool]:
    """Return the formula of how many of `points` to a turn make a period, and whether it calls gcd.

    With the outputs repeating s = a/b times in a turn, the grid repeats after b points/gcd(b points, a).
    """
    times, under = plan.step.numerator, plan.step.denominator
    whole = "points" if under == 1 else f"{under}*points"
    return (whole, False) if times == 1 else (f"{whole}{divide}{gcd}({whole}, {times})", True)


def fold(text: str, note: str, tail: str = "", bracketed: bool = False) -> str:
    r"""Return code with no line over `WIDTH`, as far as it has places to break a line at.

    `note` begins a comment: one that makes its line too long goes before it. `tail` ends a line that goes
    on. `bracketed`: only inside brackets may a line go on.

    >>> print(fold("x = (" + "abcdefgh + "*10 + "z)  # long", "# ", bracketed=True))
    # long
    x = (abcdefgh + abcdefgh + abcdefgh + abcdefgh + abcdefgh + abcdefgh + abcdefgh + abcdefgh
        + abcdefgh + abcdefgh + z)
    """
    lines: list[str] = []
    for line in text.split("\n"):
        if len(line) <= WIDTH:
            lines.append(line)
            continue
        code, mark, rest = line.partition(f"  {note}")
        indent = code[: len(code) - len(code.lstrip())]
        if mark:
            lines.append(indent + note + rest)
        lines += _pieces(code, indent + "    ", tail, bracketed)
    return "\n".join(lines)


def _pieces(code: str, indent: str, tail: str, bracketed: bool) -> Iterator[str]:
    depth = 0
    while len(code) > WIDTH:
        place, depth = _place(code, len(indent), WIDTH - len(tail), depth, bracketed)
        if not place:
            break
        yield code[:place].rstrip() + tail
        code = indent + code[place:].lstrip()
    yield code


def _place(code: str, first: int, last: int, depth: int, bracketed: bool) -> tuple[int, int]:
    """Return the last place to break at between two columns, 0 if there is none, and the depth there."""
    place, depth_there = 0, depth
    for i, character in enumerate(code[:last]):
        if i > first and (depth > 0 or not bracketed) and code.startswith(BREAKS, i):
            place, depth_there = i + code.startswith(",", i), depth
        depth += (character in "([{") - (character in ")]}")
    return place, depth_there
