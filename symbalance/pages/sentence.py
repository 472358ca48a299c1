"""What shakes, how much, and what would cure it: an engine's balance in a sentence or three."""

# Japanese letters are twice as wide as the linter counts.
# ruff: noqa: E501
from __future__ import annotations

from math import hypot

from symbalance.drawing.charts import figure
from symbalance.forces.free_forces import NEGLIGIBLE, Balance, Resultant

NAMES = {"en": {"force": "force", "couple": "couple"}, "ja": {"force": "慣性力", "couple": "慣性偶力"}}


def sentence(balance: Balance, language: str = "en") -> str:
    """Return what is left free, the largest of it, and what balances the lowest orders.

    >>> from symbalance.engine.catalogue import load
    >>> from symbalance.forces.free_forces import balance
    >>> sentence(balance(load("v8-90"), 4))
    'Free of forces up to order 3. Largest force: order 4, 0.02318 of one piston\\'s first order. \
First-order couple 3.162, all of it with the crank: counterweights balance it.'
    """
    parts = []
    for of in ("force", "couple"):
        sizes = {n: s for n, s in _sizes(balance, of).items() if s >= NEGLIGIBLE}
        parts += _free(of, sizes, balance.highest, language)
        first = Resultant(getattr(balance, of), 1)
        if 1 in sizes:
            parts.append(_cure(of, sizes[1], first, language))
    return " ".join(parts) if language == "en" else "".join(parts)


def _sizes(balance: Balance, of: str) -> dict[int, float]:
    """Return the size of each order, over one piston's first order (couples: times the pitch)."""
    spectrum = getattr(balance, of)
    sizes = {}
    for order in spectrum.orders():
        parts = [spectrum.component(order, name).decimal(20) for name in ("vertical", "lateral")]
        sizes[order] = abs(float(balance.share(order))) * max(hypot(float(c), float(s)) for c, s in parts)
    return sizes


def _free(of: str, sizes: dict[int, float], highest: int, language: str) -> list[str]:
    if language == "ja":
        name = NAMES["ja"][of]
        if not sizes:
            return [f"{highest}次までの{name}はない。"]
        least, largest = min(sizes), max(sizes, key=lambda n: sizes[n])
        free = f"{least - 1}次以下の{name}はない。" if least > 1 else ""
        if of == "couple" and largest == 1:
            return [free] if free else []
        unit = "1気筒の1次慣性力の" if of == "force" else "1気筒の1次慣性力×ピッチの"
        return [f"{free}最大の{name}は{largest}次で、{unit}{figure(sizes[largest])}倍。"]
    plural = of + "s"
    if not sizes:
        return [f"Free of {plural} to order {highest}."]
    least, largest = min(sizes), max(sizes, key=lambda n: sizes[n])
    free = [f"Free of {plural} up to order {least - 1}."] if least > 1 else []
    if of == "couple" and largest == 1:
        return free
    unit = "one piston's first order" + ("" if of == "force" else " times the pitch")
    return [*free, f"Largest {of}: order {largest}, {figure(sizes[largest])} of {unit}."]


def _cure(of: str, size: float, first: Resultant, language: str) -> str:
    """Return what balances the first order: counterweights what turns with the crank, a shaft the rest."""
    forward, backward = first.forward.is_zero(), first.backward.is_zero()
    if language == "ja":
        name = NAMES["ja"][of]
        if backward:
            return (
                f"1次{name}{figure(size)}はすべてクランクと同じ向きに回り、カウンターウェイトで釣り合う。"
            )
        if forward:
            return f"1次{name}{figure(size)}はすべて逆向きに回り、逆転バランスシャフト1本で釣り合う。"
        return f"1次{name}{figure(size)}:同じ向きの成分はカウンターウェイト、逆向きの成分は逆転シャフトで釣り合う。"
    head = f"First-order {of} {figure(size)}"
    if backward:
        return f"{head}, all of it with the crank: counterweights balance it."
    if forward:
        return f"{head}, all of it against the crank: a shaft that turns backward balances it."
    return f"{head}: counterweights balance the part with the crank, a backward shaft the other."
