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
    >>> print(sentence(balance(load("inline-3"), 2)))  # doctest: +ELLIPSIS
    Free of forces to order 2. First-order couple 1.732: ...
    """
    parts = []
    for of in ("force", "couple"):
        all_sizes = sizes_of_orders(balance, of)
        sizes = {n: s for n, s in all_sizes.items() if s >= NEGLIGIBLE}
        # An order that is there, however small, is not free of.
        parts += _free(of, sizes, min(all_sizes, default=0), balance, language)
        first = Resultant(getattr(balance, of), 1)
        if 1 in sizes:
            parts.append(_cure(of, _amount(balance, of, sizes[1]), first, language))
    return " ".join(parts) if language == "en" else "".join(parts)


def _amount(balance: Balance, of: str, size: float) -> str:
    """Return a size in figures: over one piston's first order, and in N or N m at an operating point."""
    point = balance.operating_point
    unit = None if point is None else point.force if of == "force" else point.couple
    if unit is None:
        return figure(size)
    return f"{figure(size)} ({figure(size * float(unit))} {'N' if of == 'force' else 'N m'})"


def sizes_of_orders(balance: Balance, of: str) -> dict[int, float]:
    """Return the size of each order, over one piston's first order (couples: times the pitch)."""
    spectrum = getattr(balance, of)
    sizes = {}
    for order in spectrum.orders():
        parts = [spectrum.component(order, name).decimal(20) for name in ("vertical", "lateral")]
        sizes[order] = abs(float(balance.share(order))) * max(hypot(float(c), float(s)) for c, s in parts)
    return sizes


_SAID = {
    "en": {
        "none": "Free of {of}s to order {highest}.",
        "small": "All {of}s below 10⁻⁶ of one piston's first order.",
        "free": "Free of {of}s up to order {below}.",
        "force": "Largest {of}: order {order}, {size} of one piston's first order.",
        "couple": "Largest {of}: order {order}, {size} of one piston's first order times the pitch.",
    },
    "ja": {
        "none": "{highest}次までの{of}はない。",
        "small": "{of}は1気筒の1次慣性力の10⁻⁶倍未満。",
        "free": "{below}次以下の{of}はない。",
        "force": "最大の{of}は{order}次で、1気筒の1次慣性力の{size}倍。",
        "couple": "最大の{of}は{order}次で、1気筒の1次慣性力×ピッチの{size}倍。",
    },
}


def _free(of: str, sizes: dict[int, float], least: int, balance: Balance, language: str) -> list[str]:
    """Return up to which order there is nothing, and the largest of what there is."""
    said, name = _SAID[language], NAMES[language][of]
    if not least:
        return [said["none"].format(of=name, highest=balance.highest)]
    if not sizes:
        return [said["small"].format(of=name)]
    free = [said["free"].format(of=name, below=least - 1)] if least > 1 else []
    largest = max(sizes, key=lambda n: sizes[n])
    if of == "couple" and largest == 1:  # its cure says how large it is
        return free
    return [*free, said[of].format(of=name, order=largest, size=_amount(balance, of, sizes[largest]))]


def _cure(of: str, size: str, first: Resultant, language: str) -> str:
    """Return what balances the first order: counterweights what turns with the crank, a shaft the rest."""
    forward, backward = first.forward.is_zero(), first.backward.is_zero()
    if language == "ja":
        name = NAMES["ja"][of]
        if backward:
            return f"1次{name}{size}はすべてクランクと同じ向きに回り、カウンターウェイトで釣り合う。"
        if forward:
            return f"1次{name}{size}はすべて逆向きに回り、逆転バランスシャフト1本で釣り合う。"
        return (
            f"1次{name}{size}:同じ向きの成分はカウンターウェイト、逆向きの成分は逆転シャフトで釣り合う。"
        )
    head = f"First-order {of} {size}"
    if backward:
        return f"{head}, all of it with the crank: counterweights balance it."
    if forward:
        return f"{head}, all of it against the crank: a shaft that turns backward balances it."
    return f"{head}: counterweights balance the part with the crank, a backward shaft the other."
