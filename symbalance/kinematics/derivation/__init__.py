"""The derivation of one slider-crank's harmonics, step by step, as data, text and LaTeX."""

from symbalance.kinematics.derivation.document import derivation_latex, derivation_text
from symbalance.kinematics.derivation.result import Derivation, derive
from symbalance.kinematics.derivation.setting import Prose, Step

__all__ = ["Derivation", "Prose", "Step", "derivation_latex", "derivation_text", "derive"]
