"""The document of an assignment: each cylinder's parts, the residual by order, the criterion."""

from __future__ import annotations

from symbalance.design.variations.assignment import Assignment
from symbalance.design.variations.legend import Entry, as_decimal, letters_entry, unit_formulas
from symbalance.document.decimals import decimal
from symbalance.document.formula import Upright, number
from symbalance.document.nodes import Block, Cell, Column, Document, Facts, Table, Words

NOTHING = 1e-9
"""A bound this small beside what was reached is rounding of 0."""


def assignment_document(result: Assignment) -> Document:
    """Return an assignment as a document: the places, the criterion, what is left of each order."""
    speed = "" if result.rpm is None else f", at {as_decimal(result.rpm)} rpm"
    kinds = list(next(iter(result.places.values())))
    places = tuple(
        (number(cylinder), *(names[kind] for kind in kinds)) for cylinder, names in result.places.items()
    )
    where = Table("Which part goes to which cylinder", tuple(map(Column, ("cylinder", *kinds))), places)
    title = f"{result.engine.name}: weighed parts to cylinders{speed}"
    return Document(title, (where, _criterion(result), _residual_table(result), _legend(result)))


def _criterion(result: Assignment) -> Block:
    force, _ = _units(result)
    rows: list[tuple[Cell, ...]] = [
        ("these places", decimal(result.criterion)),
        ("as listed", decimal(result.as_listed)),
        ("at random", decimal(result.at_random)),
    ]
    if not result.proved:
        rows.append(("any arrangement, at least", decimal(result.bound)))
    return Table(("What they leave, root mean square in ", force), _CRITERION, tuple(rows))


_CRITERION = (Column("arrangement"), Column("criterion"))


def _residual_table(result: Assignment) -> Block:
    force, couple = _units(result)
    pairs = zip(result.residual, result.residual_as_listed, strict=True)
    rows = tuple(
        (number(best.order), *map(decimal, (best.force, best.couple, first.force, first.couple)))
        for best, first in pairs
    )
    title = ("What they leave, largest over a turn, force in ", force, ", couple in ", couple)
    return Table(title, _RESIDUAL, rows, empty="none: these orders leave nothing")


_RESIDUAL = tuple(map(Column, ("order", "force", "couple", "force as listed", "couple as listed")))


def _units(result: Assignment) -> tuple[Upright, Upright]:
    return unit_formulas(result.engine, result.rpm is not None, Upright("kg"))  # type: ignore[return-value]


def _gap(result: Assignment) -> str:
    """Return how far the best possible may lie below what was reached, in words."""
    if result.bound < NOTHING * result.criterion:
        return "with no bound proved above 0"
    return f"within {100 * (result.criterion / result.bound - 1):.2g} % of the best possible"


def _legend(result: Assignment) -> Block:
    criterion: Words = (
        "root mean square over a turn of the force, and of the couple as a force at a lever of ",
        decimal(result.lever),
        " pitches",
    )
    counting = "their whole masses" if result.whole else "what they differ from the mean of their set by"
    proof = "no arrangement leaves less: all were compared"
    best = (
        proof if result.proved else f"the best known, {_gap(result)}: not all arrangements were compared"
    )
    entries: tuple[Entry, ...] = (
        ("these places", best),
        ("as listed", "each part in the cylinder of its place in the list"),
        ("at random", "root mean square over all arrangements"),
        ("criterion", criterion),
        ("orders counted", ", ".join(map(str, result.orders))),
        ("parts count with", counting),
        letters_entry(result.engine),
    )
    return Facts(entries, "How to read it")
