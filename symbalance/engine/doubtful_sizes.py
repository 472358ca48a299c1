"""Sizes that no engine has: metres written for mm, grams for kg; said in a line, and not refused.

A length is judged by itself. A mass is judged beside the stroke: pistons of model engines, of racing
engines and of ships' engines alike weigh some hundred to some thousand kg for each cubic metre that a
cube of their stroke would have, so that a factor of a thousand shows.
"""

from __future__ import annotations

from symbalance.engine.crank_train import CrankTrain
from symbalance.engine.engine import Engine

LENGTHS = {"bore": (1, 3000), "stroke": (1, 5000), "rod": (1, 20_000), "pitch": (1, 10_000)}
"""mm: model engines of a tenth of a cubic centimetre have strokes of 5 mm, ships' engines of 4 m."""
DENSITIES = (5, 100_000)
"""kg of reciprocating mass for a cubic metre of stroke cubed. A ship's engine of long stroke has some
600, a car's 700, a racing engine of short stroke 5,000; compressors of the shortest ten times that."""
LONGEST_ROD = 25
"""Strokes: no connecting rod comes near, and one written in another unit is far above."""
CUBIC_MM = 1e-9


def doubtful_size(engine: Engine) -> str:
    """Return what is doubtful about an engine's sizes, in a line; empty if nothing is.

    >>> from symbalance.engine.builders import inline
    >>> four = inline("1-3-4-2")
    >>> doubtful_size(four.with_sizes(stroke="0.09"))
    'stroke = 0.09 mm: is below 1 mm, less than any engine has; sizes are in mm, and 0.09 m are 90 mm'
    >>> doubtful_size(four.with_sizes(stroke=90, reciprocating_mass="0.52"))
    ''
    """
    trains = dict.fromkeys((*(c.sizes for c in engine.cylinders), CrankTrain(pitch=engine.pitch)))
    bore = () if engine.bore is None else (CrankTrain(bore=engine.bore),)
    return next((words for train in (*trains, *bore) if (words := _doubtful(train))), "")


def _doubtful(train: CrankTrain) -> str:
    lengths = (_of_length(key, train) for key in LENGTHS)
    return next(filter(None, (*lengths, _of_rod(train), _of_mass(train))), "")


def _of_length(key: str, train: CrankTrain) -> str:
    (least, most), size = LENGTHS[key], getattr(train, key)
    if size is None or least <= size <= most:
        return ""
    said = f"{key} = {float(size):.6g} mm"
    if size > most:
        return f"{said}: is above {most} mm, more than any engine has; sizes are in mm"
    metres = f"{float(size):.6g} m are {float(size * 1000):.6g} mm"
    return f"{said}: is below {least} mm, less than any engine has; sizes are in mm, and {metres}"


def _of_rod(train: CrankTrain) -> str:
    rod, stroke = train.rod, train.stroke
    if rod is None or stroke is None or rod <= LONGEST_ROD * stroke:
        return ""
    said = f"rod = {float(rod):.6g} mm"
    return f"{said}: is more than {LONGEST_ROD} strokes of {float(stroke):.6g} mm; sizes are in mm"


def _of_mass(train: CrankTrain) -> str:
    mass, stroke = train.reciprocating_mass, train.stroke
    if not mass or stroke is None:
        return ""
    density = float(mass) / (float(stroke) ** 3 * CUBIC_MM)
    if DENSITIES[0] <= density <= DENSITIES[1]:
        return ""
    how = "less" if density < DENSITIES[0] else "more"
    said = f"reciprocating_mass = {float(mass):.6g} kg: is far {how} than pistons of a stroke of"
    grams = f", and {float(mass):.6g} g are {float(mass / 1000):.6g} kg" if how == "more" else ""
    return f"{said} {float(stroke):.6g} mm have; masses are in kg{grams}"
