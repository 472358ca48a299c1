"""What is written of a derivation: its steps, each a heading, paragraphs and displayed equations."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from typing import Any

from symbalance.document.formula import Equation
from symbalance.document.nodes import Block, Document, Formulas, Heading, Paragraph, inlines
from symbalance.kinematics.derivation.result import Derivation
from symbalance.kinematics.derivation.setting import LETTERS, LONGEST_IN_FULL, Step

_SUBJECTS = {
    "displacement": "Piston displacement",
    "velocity": "Piston velocity",
    "acceleration": "Piston acceleration",
    "force": "Inertia force",
    "rod-angle": "Rod angle",
}


def derivation_document(derivation: Derivation) -> Document:
    """Return a derivation as a document, its steps numbered.

    >>> from symbalance.kinematics.derivation import derive
    >>> derivation_document(derive("velocity", 4)).title
    'Piston velocity of one slider-crank, harmonics to order 4'
    """
    letters = LETTERS[derivation.convention]
    about = f", {letters.meaning}."
    if max(derivation.order, derivation.power + 1) > LONGEST_IN_FULL:
        about += (
            f" Beyond order {LONGEST_IN_FULL} the derivation is shortened: of long lines only the first"
            " terms are written out, of every coefficient two."
        )
    subject = _SUBJECTS[derivation.quantity]
    title = f"{subject} of one slider-crank, harmonics to order {derivation.order}"
    blocks = [block for k, step in enumerate(derivation.steps, 1) for block in _blocks(k, step)]
    return Document(title, (Paragraph(("Convention: ", letters.ratio, about)), *blocks))


def _blocks(place: int, step: Step) -> Iterator[Block]:
    """Yield a step's heading, its paragraphs and, together, the equations that follow one another."""
    yield Heading(f"{place}. {step.title}")
    for are_equations, parts in groupby(step.parts, lambda part: isinstance(part, Equation)):
        if are_equations:
            yield Formulas(tuple(part for part in parts if isinstance(part, Equation)))
        else:
            yield from (part for part in parts if isinstance(part, Paragraph))


def derivation_data(derivation: Derivation) -> dict[str, Any]:
    """Return the result of a derivation and its steps as text.

    `harmonics` has each order's coefficient as a series in 1/lam (SymPy reads it), lam = l/r whatever the
    convention of the text, with the powers kept; `function` is cos or sin.
    """
    from symbalance.document.fitting import plain_words

    found = derivation.harmonics
    return {
        "quantity": derivation.quantity,
        "convention": derivation.convention,
        "order": derivation.order,
        "power": derivation.power,
        "function": found.function,
        "constant": str(found.constant.in_lam()),
        "harmonics": [
            {"order": str(n), "series": str(series.in_lam()), "through": series.through}
            for n, series in found.terms.items()
        ],
        "steps": [
            {"title": step.title, "text": [plain_words(_words(part)) for part in step.parts]}
            for step in derivation.steps
        ],
    }


def _words(part: Paragraph | Equation) -> Any:
    return part if isinstance(part, Equation) else inlines(part.words)


def derivation_records(derivation: Derivation) -> list[dict[str, Any]]:
    """Return a row for each power of 1/lam in each order: the coefficient as a fraction and a float."""
    return [
        {
            "order": n,
            "function": derivation.harmonics.function,
            "power": power,
            "coefficient": str(value),
            "value": float(value),
        }
        for n, series in derivation.harmonics.terms.items()
        for power, value in sorted(series.terms.items())
    ]
