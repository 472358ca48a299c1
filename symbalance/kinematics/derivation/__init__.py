"""Derivation of one slider-crank's harmonics, step by step as a person would write it."""

from symbalance.kinematics.derivation.request import Step
from symbalance.kinematics.derivation.result import Derivation, derive

__all__ = ["Derivation", "Step", "derive"]
