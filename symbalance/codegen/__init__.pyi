from symbalance.codegen.evaluators import Evaluator as Evaluator
from symbalance.codegen.evaluators import plan_for as plan_for
from symbalance.codegen.evaluators import to_function as to_function
from symbalance.codegen.requests import OUTPUTS as OUTPUTS
from symbalance.codegen.torque_requests import TORQUES as TORQUES
