"""The document of worst cases: largest force and couple by order, attained and proved."""

from __future__ import annotations

from fractions import Fraction

from symbalance.design.variations.legend import AS_BUILT, Entry, as_decimal, letters_entry, unit_formulas
from symbalance.design.variations.tolerances import PARTS_OF, UNITS
from symbalance.design.variations.worst_case_search import WorstCase, WorstCases
from symbalance.document.decimals import decimal
from symbalance.document.formula import Name, number
from symbalance.document.nodes import Block, Cell, Column, Document, Facts, Table, Words, blocks
from symbalance.forces.rows import plane

MET = 1e-6
"""A bound within this part of what is attained is the worst itself."""
ROUNDING = 1e-15
"""Of m r omega^2: no bound is told apart from what is attained by less."""
_COLUMNS = tuple(map(Column, ("order", "of", "as drawn", "worst", "at most", "RSS")))


def worst_cases_document(result: WorstCases) -> Document:
    """Return worst cases as a document: what is reached and what is proved, of force and couple."""
    speed = "" if result.rpm is None else f", at {as_decimal(result.rpm)} rpm"
    force, couple = unit_formulas(result.engine, result.rpm is not None)
    titles: dict[str, Words] = {
        "force": ("Force, unit ", force),
        "couple": (f"Couple about {plane(result.reference)}, unit ", couple),
        "rotating force": ("Force of the rotating masses' errors alone, unit ", force),
        "rotating couple": ("Couple of the rotating masses' errors alone, unit ", couple),
    }
    tables = [
        Table(title, _COLUMNS, _rows(result, quantity), keys=2, empty="none")
        for quantity, title in titles.items()
        if not quantity.startswith("rotating") or any(w.quantity == quantity for w in result)
    ]
    title = f"{result.engine.name}: the worst within tolerances{speed}"
    return Document(title, blocks(*tables, _legend(result)), lead=_tolerance_words(result))


def _tolerance_words(result: WorstCases) -> Words:
    """Return the tolerances, plus or minus."""
    parts: list[Words] = []
    for name in UNITS:
        value = getattr(result.tolerances, name)
        if not value:
            continue
        parts.append((", " if parts else "") + f"{name} ±")
        if isinstance(value, str):
            parts += [f"{as_decimal(Fraction(value[:-1]))} % of ", Name(PARTS_OF[name])]
        else:
            unit = {"degrees": "°"}.get(UNITS[name], f" {UNITS[name]}")
            parts.append(f"{as_decimal(value)}{unit}")
    return ("every cylinder: ", *(parts or ["without errors"]))  # type: ignore[return-value]


def _rows(result: WorstCases, quantity: str) -> tuple[tuple[Cell, ...], ...]:
    scale = result.scale.couple if quantity.endswith("couple") else result.scale.force
    return tuple(
        (number(worst.order), worst.of, *map(decimal, values))
        for worst in result
        if worst.quantity == quantity and any(values := _values(worst, scale))
    )


def _values(worst: WorstCase, scale: float) -> tuple[float, ...]:
    met = worst.bound <= worst.attained * (1 + MET) + ROUNDING * scale
    return worst.nominal, worst.attained, worst.attained if met else worst.bound, worst.statistical


def _legend(result: WorstCases) -> Block:
    of = {worst.of for worst in result}
    entries: list[Entry] = [
        ("as drawn", "the engine without errors"),
        ("worst", "reached by an engine within the tolerances, another one in each row"),
        ("at most", "proved for every engine within the tolerances"),
        ("RSS", "root of the sum of squares of the single effects to first order, an estimate"),
    ]
    if "largest" in of:
        entries.append(("largest", "the largest modulus over a turn"))
    if of - {"largest"}:
        entries.append((", ".join(sorted(of - {"largest"})), "the amplitude of this component"))
    entries.append(letters_entry(result.engine))
    return Facts((*entries, *([AS_BUILT] if result.engine.balancers else [])), "How to read it")
