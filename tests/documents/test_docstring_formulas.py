"""The library proves its own documentation: every formula marked in a docstring, by our own checker.

`tests.docstring_formulas` says how a docstring marks its formulas. The golden file lists them all with
what the checker says of each, so that one that is no longer proved, or a new one that never was, shows
as a difference.
"""

from __future__ import annotations

import re

import pytest

import symbalance as sb
from tests.docstring_formulas import (
    DEFINITION,
    PROVED,
    REFUTED,
    Block,
    Entry,
    blocks,
    counts,
    docstrings,
    judge,
    marked_formulas,
    survey,
)

LEAST_PROVED = 100
_SIGN = re.compile(r" ([+-]) (?!\.\.\.)")
_DIGIT = re.compile(r"(?<![\w^_.])[2-9]|(?<=\^)[2-9]|1")


@pytest.mark.slow
def test_what_the_checker_says_of_every_formula(golden):
    lines = [f"{e.status:10} {e.name}: {e.text}" for e in marked_formulas()]
    golden("docstring_formulas.txt", "\n".join([counts(marked_formulas()), "", *lines, ""]))


@pytest.mark.slow
def test_many_are_proved_and_none_is_refuted():
    proved = {entry.text for entry in survey() if entry.status == PROVED}
    assert len(proved) >= LEAST_PROVED
    assert [entry for entry in survey() if entry.status == REFUTED] == []


@pytest.mark.slow
def test_what_is_marked_is_proved_or_a_definition():
    assert [e for e in marked_formulas() if e.status not in {PROVED, DEFINITION}] == []


HOLDERS = {
    *("Series", "Kinematics", "Order", "Resultant", "OperatingPoint", "TurnMaximum"),
    *("SpeedTable", "over_speeds", "RowFormulas", "RowOrder", "tabulate_row"),
}
"""What holds, or puts into tables, what functions return, whose formulas stand there."""


@pytest.mark.slow
@pytest.mark.parametrize("room", [sb.kinematics, sb.forces])
def test_what_the_rooms_of_formulas_export_has_a_proved_formula(room):
    proved = {entry.name for entry in survey() if entry.status == PROVED}
    things = [getattr(room, name) for name in room.__all__ if name not in HOLDERS]
    names = [f"{thing.__module__}.{thing.__qualname__}" for thing in things]
    assert [name for name in names if name not in proved] == []


def wrong(formula: str) -> str:
    """Return a formula with the last sign of it, or else its last number, changed.

    >>> wrong("sin^2 x = (1 - cos 2 x)/2")
    'sin^2 x = (1 + cos 2 x)/2'
    >>> wrong("u_4 = rho^2 t_4")
    'u_4 = rho^3 t_4'
    """
    head, equals, tail = formula.rpartition("=")
    signs = list(_SIGN.finditer(tail))
    if signs:
        place = signs[-1].start(1)
        return head + equals + tail[:place] + ("+" if tail[place] == "-" else "-") + tail[place + 1 :]
    digits = list(_DIGIT.finditer(re.sub(r"_\d+", lambda m: "_" * len(m[0]), tail)))
    if digits:
        place = digits[-1].start()
        return head + equals + tail[:place] + str(int(tail[place]) + 1) + tail[place + 1 :]
    return f"{formula} + 1"


def undetected(name: str) -> list[str]:
    """Return the formulas of a docstring that stay proved with a fault in them."""
    (text,) = (d.text for d in docstrings() if d.name == name)
    faulty = [
        judge(Block((wrong(formula),), block.definitions, block.symbols))[-1]
        for block in blocks(text)[0]
        for formula in block.formulas
    ]
    return [entry.text for entry in faulty if entry.status == PROVED]


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    [
        "symbalance.kinematics.mechanisms.rod_masses.RodSplit",
        "symbalance.kinematics.coefficients",
        "symbalance.forces.free_forces.balance",
        "symbalance.torque.star_diagrams",
    ],
)
def test_a_planted_fault_is_caught(name):
    assert undetected(name) == []


@pytest.mark.rare  # the checker looks for a correction of each: two minutes
def test_a_planted_fault_is_caught_in_every_formula():
    assert [f for name in sorted({e.name for e in marked_formulas()}) for f in undetected(name)] == []


def test_a_letter_stands_for_what_the_library_computes():
    def status(formula: str) -> str:
        return judge(Block((formula,), (), ()))[-1].status

    assert status("A_2 = rho + rho^3/4 + ...") == PROVED
    assert status("A_2 = rho - rho^3/4 + ...") == REFUTED
    assert status("k_3 = -9 R_3") == PROVED
    assert status("k_3 = 9 R_3") == REFUTED


def test_a_name_that_is_given_its_value_is_no_proof():
    (block,), _ = blocks("Formulas:\n    y = 2 x\n    y + x = 3 x    a remark\n    with x a number")
    assert [entry.status for entry in judge(block)] == [DEFINITION, PROVED]


def test_equations_that_are_not_marked_are_counted():
    text = "Return y, with y = 2 x.\n\n>>> y = 2\n"
    assert blocks(text) == ([], ["Return y, with y = 2 x."])


def test_an_entry_has_its_latex():
    (block,), _ = blocks("Formulas:\n    sin^2 x = (1 - cos 2 x)/2\n    with x an angle")
    (entry,) = judge(block)
    assert entry == Entry("", block.formulas[0], entry.latex, PROVED)
    assert entry.latex == r"\sin^{2} x = \frac{1 - \cos 2 x}{2}"
