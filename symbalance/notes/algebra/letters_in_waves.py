"""The letters within sines, cosines and tangents: angles, though nobody has declared them."""

from __future__ import annotations

from symbalance.document.formula import Call, Formula, names, parts_of_kind

WAVES = frozenset({"sin", "cos", "tan"})


def letters_in_waves(node: Formula) -> frozenset[str]:
    """Return the letters in the arguments of a formula's sines, cosines and tangents.

    >>> from symbalance.document.formula import Name
    >>> letters_in_waves(Name("r") * Call("sin", Name("theta")))
    frozenset({'theta'})
    """
    waves = (part for part in parts_of_kind(node, Call) if part.function in WAVES)
    return frozenset(name for wave in waves for name in names(wave.argument))
