"""The pressure traces of the worked engines: one zone of ideal gas, heat by Wiebe's function.

    python derivations/crankshaft/pressures.py       writes diesel.csv beside this file

From intake closing at bottom dead centre to exhaust opening dp = -g p dV/V + (g - 1) dQ/V, the heat
Q = Q_t (1 - exp(-6.9 x^(m + 1))), x = (theta - start)/duration; then a cosine blow-down to the
exhaust's pressure. Sizes are estimates of a turbocharged truck diesel at full load. Source: Heywood,
Internal Combustion Engine Fundamentals, ch. 9 (the Wiebe function; 6.9 = -ln 0.001 burns 99.9 %).
"""

from __future__ import annotations

from math import cos, exp, pi, sin, sqrt
from pathlib import Path

RATIO, COMPRESSION, GAMMA = 3.2, 16.0, 1.33
INTAKE, EXHAUST = 1.5, 1.6
HEAT, START, DURATION, SHAPE = 34.0, -6.0, 75.0, 0.7
OPENING = 150


def volume(degrees: float) -> float:
    """Return V/V_c."""
    angle = degrees * pi / 180
    way = 1 - cos(angle) + RATIO - sqrt(RATIO**2 - sin(angle) ** 2)
    return 1 + (COMPRESSION - 1) * way / 2


def burnt(degrees: float) -> float:
    """Return the share of the heat released, in p V at the swept volume."""
    x = (degrees - START) / DURATION
    return 0.0 if x <= 0 else (COMPRESSION - 1) * HEAT * (1 - exp(-6.9 * x ** (SHAPE + 1)))


def closed(step: float = 0.05) -> dict[int, float]:
    """Return the pressure in bar at whole degrees up to the exhaust's opening, by Heun's method."""
    pressure, found = INTAKE, {-180: INTAKE}
    for i in range(round((OPENING + 180) / step)):
        here, there = -180 + i * step, -180 + (i + 1) * step
        v0, v1 = volume(here), volume(there)
        heat = (GAMMA - 1) * (burnt(there) - burnt(here))
        guess = pressure + (heat - GAMMA * pressure * (v1 - v0)) / v0
        pressure += (heat - GAMMA * (pressure + guess) / 2 * (v1 - v0)) / ((v0 + v1) / 2)
        if abs(there - round(there)) < step / 4:
            found[round(there)] = pressure
    return found


def trace() -> list[tuple[int, float]]:
    """Return (degrees after firing, bar) of a whole cycle."""
    found = closed()
    opened = found[OPENING]
    for angle in range(OPENING, 540):
        if angle < 230:
            share = (1 - cos(pi * (angle - OPENING) / 80)) / 2
            found[angle] = opened + (EXHAUST - opened) * share
        else:
            share = (1 - cos(pi * min(max((angle - 350) / 20, 0), 1))) / 2
            found[angle] = EXHAUST + (INTAKE - EXHAUST) * share
    return [(a, found[a]) for a in sorted(found) if abs(a) <= 60 or a % 4 == 0]


def main() -> None:
    """Write the trace."""
    lines = ["degrees after firing top dead centre,bar absolute", *(f"{a},{p:.4f}" for a, p in trace())]
    Path(__file__).with_name("diesel.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
