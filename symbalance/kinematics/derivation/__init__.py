"""Step-by-step derivation of a slider-crank's harmonics, as one would write it by hand."""

from symbalance.kinematics.derivation.request import Step
from symbalance.kinematics.derivation.result import Derivation, derive

__all__ = ["Derivation", "Step", "derive"]
