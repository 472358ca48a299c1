"""The derivation of one slider-crank's harmonics, step by step."""

from symbalance.kinematics.derivation.result import Derivation, derive
from symbalance.kinematics.derivation.setting import Step

__all__ = ["Derivation", "Step", "derive"]
