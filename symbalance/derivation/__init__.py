"""The derivation of one slider-crank's harmonics, step by step, as data."""

from symbalance.derivation.result import Derivation, derive
from symbalance.derivation.setting import Prose, Step

__all__ = ["Derivation", "Prose", "Step", "derive"]
