"""Discs in a row on shafts, whose equations of motion a page leaves out: "the three equations".

    J_1 φ̈_1 + k_1 (φ_1 - φ_2) = 0
    J_2 φ̈_2 - k_1 (φ_1 - φ_2) + k_2 (φ_2 - φ_3) = 0
    J_3 φ̈_3 - k_2 (φ_2 - φ_3) = 0

The letters say which discs and shafts there are: inertias with the numbers 1 to n, and stiffnesses with 1
to n - 1 and no other.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction
from itertools import pairwise

from symbalance.document.formula import Formula, Name, Negative, Number, Sum
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.motions.equations_of_motion import EquationOfMotion
from symbalance.notes.checking.motions.trial_solutions import FreeVibration, Trial
from symbalance.notes.checking.premises.impossible_values import number_of

_INERTIAS = ("J", "I", "Theta", "m")
_STIFFNESSES = ("k", "c", "C", "K")
FEWEST, MOST = 2, 4
"""Discs in a row."""
_HALVINGS = 100
"""Steps to a natural frequency: of the bound above all 2⁻¹⁰⁰ is left, little beside the lowest."""
_AS_ROUNDED = 3
"""Half units of the last place by which a ratio may be off that was worked out from rounded numbers."""


def chain_of_discs(
    letters: Collection[str], amplitude: str, frequency: str, wave: Formula, line: int
) -> FreeVibration | None:
    """Return the free vibration of a chain of discs that a page's letters are of; None for no or several.

    The amplitudes have the stem that is given: A_ for A_1 and A_2.
    """
    rows: list[FreeVibration] = []
    for inertia in _INERTIAS:
        for stiffness in _STIFFNESSES:
            count = _numbered(letters, inertia)
            if FEWEST <= count <= MOST and _numbered(letters, stiffness) == count - 1:
                rows.append(
                    _chain(count, f"{inertia}_", f"{stiffness}_", amplitude, frequency, wave, line)
                )
    return rows[0] if len(rows) == 1 else None


def _numbered(letters: Collection[str], stem: str) -> int:
    """Return how many letters J_1, J_2, … there are from 1 on; 0 where one is missing."""
    numbers = sorted(
        int(name[len(stem) + 1 :])
        for name in letters
        if name.startswith(f"{stem}_") and name[len(stem) + 1 :].isdecimal()
    )
    return len(numbers) if numbers == list(range(1, len(numbers) + 1)) else 0


def _chain(
    count: int, inertia: str, stiffness: str, amplitude: str, frequency: str, wave: Formula, line: int
) -> FreeVibration:
    equations: list[EquationOfMotion] = []
    for n in range(1, count + 1):
        factors: dict[tuple[str, int], Formula] = {(f"disc_{n}", 2): Name(f"{inertia}{n}")}
        springs: list[Formula] = []
        for shaft, other in ((n - 1, n - 1), (n, n + 1)):
            if 1 <= other <= count:
                springs.append(Name(f"{stiffness}{shaft}"))
                factors[f"disc_{other}", 0] = Negative(Name(f"{stiffness}{shaft}"))
        factors[f"disc_{n}", 0] = Sum(tuple(springs)) if len(springs) > 1 else springs[0]
        equations.append(EquationOfMotion(factors, Number(Fraction(0)), line, ""))
    trials = tuple(
        Trial(f"disc_{n}", f"{amplitude}{n}", frequency, wave, line) for n in range(1, count + 1)
    )
    return FreeVibration(tuple(equations), trials)


def is_ratio_of_mode(
    pair: tuple[str, str], ratio: Number, vibration: FreeVibration, knowledge: Knowledge
) -> bool | None:
    """Tell whether two amplitudes have a ratio in one of the natural modes, to the digits printed.

    None where the page gives an inertia or a stiffness no number.
    """
    inertias = [_size(each.factors[trial.moving, 2], knowledge) for each, trial in _discs(vibration)]
    shafts = [
        _size(each.factors[following.moving, 0], knowledge)
        for (each, _), (_, following) in pairwise(_discs(vibration))
    ]
    if not all(inertias) or not all(shafts):
        return None
    one, other = (vibration.amplitudes.index(name) for name in pair)
    half = float(ratio.last_place or 0) / 2
    for square in _squares(inertias, shafts):
        row = _amplitudes(square, inertias, shafts)
        if row[other] and abs(row[one] / row[other] - float(ratio.value)) <= half * _AS_ROUNDED:
            return True
    return False


def _discs(vibration: FreeVibration) -> list[tuple[EquationOfMotion, Trial]]:
    return list(zip(vibration.equations, vibration.trials, strict=True))


def _size(node: Formula, knowledge: Knowledge) -> float:
    value = number_of(node, knowledge)
    return 0.0 if value is None else abs(float(value))


def _amplitudes(square: float, inertias: Sequence[float], shafts: Sequence[float]) -> list[float]:
    """Return the amplitudes from the first disc on, which has 1: a shaft carries all discs before it."""
    row, torque = [1.0], 0.0
    for inertia, shaft in zip(inertias, shafts, strict=False):
        torque += square * inertia * row[-1]
        row.append(row[-1] - torque / shaft)
    return row


def _squares(inertias: Sequence[float], shafts: Sequence[float]) -> list[float]:
    """Return the squares of the natural frequencies but 0, from the lowest on.

    With 0, as many of them lie below ω² as the sign changes along the discs' amplitudes at ω, with the
    torque that is wanted behind the last disc (Sturm's count, on Holzer's table): none is missed, however
    close together or far apart they are.
    """

    def count_below(square: float) -> int:
        row = _amplitudes(square, inertias, shafts)
        wanted = -sum(inertia * own for inertia, own in zip(inertias, row, strict=True))
        signs = [each > 0 for each in (*row, wanted) if each]
        return sum(one != other for one, other in pairwise(signs))

    roots: list[float] = []
    for count in range(1, len(inertias)):
        low, high = 0.0, 4 * max(shafts) / min(inertias)
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            low, high = (low, middle) if count_below(middle) > count else (middle, high)
        roots.append(low)
    return roots
