"""Formulas in the spelling of a language: its functions, its operators, its numbers."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from symbalance.codegen.kernels import Constant, Line
from symbalance.codegen.plans import Plan

CALL = re.compile(r"\b(rint|abs|sqrt|side|cos|sin)\(")


@dataclass(frozen=True)
class Spelling:
    """How a language writes functions (a text with {} for the argument), lines and comments."""

    functions: Mapping[str, str]
    line: str
    constant: str
    comment: str
    elementwise: bool = False

    def formula(self, text: str) -> str:
        """Return a formula in this spelling."""
        found = CALL.search(text)
        if found is None:
            return text.replace("*", ".*").replace("/", "./") if self.elementwise else text
        inner, rest = _split_at_close(text[found.end() :])
        call = self.functions[found.group(1)].format(self.formula(inner))
        return self.formula_head(text[: found.start()]) + call + self.formula(rest)

    def formula_head(self, text: str) -> str:
        """Return what precedes a call."""
        return text.replace("*", ".*").replace("/", "./") if self.elementwise else text

    def outputs(self, planned: Plan, zero: str) -> tuple[list[Line], list[str]]:
        """Return the lines and the formulas of the outputs times scale0, scale1, ....

        Where a formula is linear in its own constants the scale goes into those: that happens once,
        outside the loop over the angles.
        """
        lines, formulas = list(planned.tail.lines), []
        for i, output in enumerate(planned.outputs):
            scale = f"scale{i}"
            if output.scaled:
                own = re.compile(rf"\b{output.prefix}\w+")
                lines = [
                    replace(line, formula=own.sub(rf"({scale}*\g<0>)", line.formula)) for line in lines
                ]
                formulas.append(own.sub(rf"({scale}*\g<0>)", output.formula))
            else:
                formulas.append(f"{scale}*({zero if output.formula == '0.0' else output.formula})")
        return lines, formulas

    def lines(self, lines: Iterable[Line], indent: str) -> list[str]:
        """Return assignments, their notes as comments beside them."""
        written = [(self.line.format(line.name, self.formula(line.formula)), line.note) for line in lines]
        return [indent + self._noted(text, note) for text, note in written]

    def constants(self, constants: Iterable[Constant], indent: str = "") -> list[str]:
        """Return definitions, their notes as comments beside them."""
        written = [(self.constant.format(c.name, repr(c.value)), c.note) for c in constants]
        return [indent + self._noted(text, note) for text, note in written]

    def _noted(self, text: str, note: str) -> str:
        return f"{text}  {self.comment.format(note)}" if note else text


def _split_at_close(text: str) -> tuple[str, str]:
    depth = 1
    for i, character in enumerate(text):
        depth += (character == "(") - (character == ")")
        if depth == 0:
            return text[:i], text[i + 1 :]
    raise ValueError(f"unbalanced formula {text!r}")


def unique(groups: Iterable[Iterable[Constant]]) -> list[Constant]:
    """Return the constants of several kernels, each name once."""
    found: dict[str, Constant] = {}
    for constant in (c for group in groups for c in group):
        if found.setdefault(constant.name, constant).value != constant.value:
            raise ValueError(f"two values for the constant {constant.name}")
    return list(found.values())
