"""Results as the fastest functions we can write, in memory or as source in another language.

In: a balance or a torque. Out: a function in memory, or source that runs alone.

    asked, asked_torque   from a result to waves: outputs, surviving orders, proven bounds
    plans                 from waves to a plan: which cosines, which polynomial, or the closed form
    targets               from a plan to text;  evaluators: from text to a function
"""

from symbalance.codegen.asked import OUTPUTS
from symbalance.codegen.asked_torque import TORQUES
from symbalance.codegen.evaluators import Evaluator, planned_for, to_function

__all__ = ["OUTPUTS", "TORQUES", "Evaluator", "planned_for", "to_function"]
