"""The document of a derivation: each step a heading, paragraphs and displayed equations."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from typing import Any

from symbalance.document.fitting import plain_words
from symbalance.document.formula import Equation
from symbalance.document.nodes import Block, Document, Formulas, Heading, Paragraph, inlines
from symbalance.kinematics.derivation.request import LETTERS, LONGEST_IN_FULL, Step
from symbalance.kinematics.derivation.result import Derivation
from symbalance.kinematics.harmonics_document import harmonics_data

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
    """Return the result of a derivation, as `harmonics` gives it, and its steps as text.

    Series are in 1/lam with lam = l/r, whatever the convention of the text.
    """
    return {
        **harmonics_data(derivation.harmonics),
        "convention": derivation.convention,
        "order": derivation.order,
        "power": derivation.power,
        "steps": [
            {"title": step.title, "text": [plain_words(_words(part)) for part in step.parts]}
            for step in derivation.steps
        ],
    }


def _words(part: Paragraph | Equation) -> Any:
    return part if isinstance(part, Equation) else inlines(part.words)
