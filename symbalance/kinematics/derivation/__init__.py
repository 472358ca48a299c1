"""The derivation of one slider-crank's harmonics, step by step."""

from symbalance.kinematics.derivation.request import Step
from symbalance.kinematics.derivation.result import Derivation, derive

__all__ = ["Derivation", "Step", "derive"]
