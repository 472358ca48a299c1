"""Results as numeric functions that hold only what the scene needs."""

from symbalance.numeric.harmonic_function import HarmonicFunction, to_function

__all__ = ["HarmonicFunction", "to_function"]
