"""Results as the fastest functions we can write, in memory or as source in another language.

From a balance to waves (`asked`, `asked_torque`: outputs, surviving
orders, proven bounds), from waves to a plan
(`plans`: which cosines, which polynomial, or the closed form), from a plan to text (`targets`), and
from text to a function (`evaluators`).
"""

from symbalance.codegen.asked import OUTPUTS
from symbalance.codegen.asked_torque import TORQUES
from symbalance.codegen.evaluators import Evaluator, planned_for, to_function

__all__ = ["OUTPUTS", "TORQUES", "Evaluator", "planned_for", "to_function"]
