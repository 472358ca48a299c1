from symbalance.forces.free_forces import Balance as Balance
from symbalance.forces.free_forces import Order as Order
from symbalance.forces.free_forces import Resultant as Resultant
from symbalance.forces.free_forces import balance as balance
from symbalance.forces.inline_sums import inline_couple as inline_couple
from symbalance.forces.inline_sums import inline_sum as inline_sum
from symbalance.forces.shaft_moments import shaft_moment as shaft_moment
