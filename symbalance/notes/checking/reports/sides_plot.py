"""Drawing of the two sides of a refuted relation over one letter, where they part, as a small SVG."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from symbalance.document.letters import plain_letter
from symbalance.document.nodes import Figure
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.checking.deciding.equality import Decision

POINTS = 49
WIDTH, HEIGHT, MARGIN = 340, 170, 22
CLOSE = 0.03
"""Of the height of the picture: sides that differ by less are drawn as their difference."""
ANGLES = ("theta", "phi", "varphi", "vartheta", "alpha", "psi")
"""Letters that run over a turn; the first of them that a relation holds is drawn over."""
TURN = Fraction(6283185, 1_000_000)
Curve = list[tuple[float, float]]


def plot_sides(decision: Decision | None, witness: Mapping[str, str]) -> Figure | None:
    """Return both sides over an angle or another letter, the others as in the witness; None without one.

    Points where a side has no real value are left out; fewer than a third of them are no curve.
    """
    if decision is None or decision.left is None or decision.right is None:
        return None
    point = _point(witness)
    letters = list(dict.fromkeys((*values.letters(decision.left), *values.letters(decision.right))))
    if not point or not letters or not set(letters) <= point.keys():
        return None
    letter = next((name for name in ANGLES if name in letters), letters[0])
    low, high = (Fraction(0), TURN) if letter in ANGLES else _around(point[letter])
    places = [low + (high - low) * k / (POINTS - 1) for k in range(POINTS)]
    sides = [_curve(form, point, letter, places) for form in (decision.left, decision.right)]
    if min(map(len, sides)) < POINTS // 3:
        return None
    others = ", ".join(
        f"{plain_letter(name)} = {float(value):.6g}"
        for name, value in point.items()
        if name != letter and name in letters
    )
    where = f" at {others}" if others else ""
    sign = plain_letter(letter)
    shows = f"Both sides over {sign}{where}: solid the left side, dashed the right one"
    if (difference := _difference(sides)) is not None:
        sides = [[(x, 0.0) for x, _ in difference], difference]
        shows = f"Dashed: the right side less the left one over {sign}{where}; they differ by little"
    return Figure(
        "sides.svg", _svg(sides, (float(low), float(high)), sign, letter in ANGLES, shows), shows, shows
    )


def _point(witness: Mapping[str, str]) -> dict[str, Fraction]:
    """Return the letters' values at a witness; empty where one is no plain number."""
    point: dict[str, Fraction] = {}
    for name, text in witness.items():
        if name in ("left", "right"):
            continue
        try:
            point[name] = Fraction(text)
        except ValueError:
            return {}
    return point


def _around(value: Fraction) -> tuple[Fraction, Fraction]:
    """Return a range about a letter's value, on its own side of zero."""
    if not value:
        return Fraction(-1), Fraction(1)
    ends = (value / 2, value * 2)
    return min(ends), max(ends)


def _curve(form: Form, point: Mapping[str, Fraction], letter: str, places: Sequence[Fraction]) -> Curve:
    """Return the points of a side that are real numbers."""
    curve: Curve = []
    for place in places:
        try:
            value = complex(values.value(form, {**point, letter: place}))
        except (NoFormError, KeyError, ZeroDivisionError, TypeError, OverflowError, ValueError):
            continue
        if abs(value.imag) < 1e-9 * max(1.0, abs(value)) and abs(value) < 1e12:
            curve.append((float(place), value.real))
    return curve


def _difference(sides: Sequence[Curve]) -> Curve | None:
    """Return the right side less the left where the two, drawn together, could not be told apart."""
    left, right = (dict(curve) for curve in sides)
    curve = [(x, right[x] - y) for x, y in left.items() if x in right]
    heights = [y for side in sides for _, y in side]
    most = max((abs(y) for _, y in curve), default=0.0)
    return curve if curve and 0 < most < CLOSE * (max(heights) - min(heights)) else None


def _svg(
    sides: Sequence[Curve], span: tuple[float, float], letter: str, is_angle: bool, shows: str
) -> str:
    """Return two curves in one frame, the axis with its ends named."""
    heights = [y for curve in sides for _, y in curve]
    low, high = min(heights), max(heights)
    pad = 0.06 * (high - low) or abs(high) or 1.0
    low, high = low - pad, high + pad

    def across(x: float) -> float:
        return MARGIN + (x - span[0]) / (span[1] - span[0]) * (WIDTH - 2 * MARGIN)

    def down(y: float) -> float:
        return MARGIN / 2 + (high - y) / (high - low) * (HEIGHT - 1.5 * MARGIN)

    paths = [" ".join(f"{across(x):.1f},{down(y):.1f}" for x, y in curve) for curve in sides]
    ends = ("0", "360°") if is_angle else (f"{span[0]:.3g}", f"{span[1]:.3g}")
    base = HEIGHT - MARGIN
    most = max(abs(low + pad), abs(high - pad))
    zero = (
        f'<line x1="{MARGIN}" x2="{WIDTH - MARGIN}" y1="{down(0):.1f}" y2="{down(0):.1f}" stroke="#bbb"/>'
        if low < 0 < high
        else ""
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" '
        f'height="{HEIGHT}" role="img" aria-label="{_escaped(shows)}">'
        f'<rect x="{MARGIN}" y="{MARGIN / 2}" width="{WIDTH - 2 * MARGIN}" height="{base - MARGIN / 2}" '
        f'fill="#fff" stroke="#999"/>{zero}'
        f'<polyline points="{paths[0]}" fill="none" stroke="#1a4f8b" stroke-width="2"/>'
        f'<polyline points="{paths[1]}" fill="none" stroke="#b3261e" stroke-width="2" '
        'stroke-dasharray="6 4"/>'
        f'<text x="{MARGIN}" y="{HEIGHT - 7}">{_escaped(ends[0])}</text>'
        f'<text x="{WIDTH - MARGIN}" y="{HEIGHT - 7}" text-anchor="end">{_escaped(ends[1])}</text>'
        f'<text x="{WIDTH / 2}" y="{HEIGHT - 7}" text-anchor="middle">{_escaped(letter)}</text>'
        f'<text x="{MARGIN + 4}" y="{MARGIN / 2 + 13}">±{most:.3g}</text></svg>'
    )


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
