from symbalance.forces.free_forces import Balance as Balance
from symbalance.forces.free_forces import balance as balance
from symbalance.forces.shafts import shaft_moment as shaft_moment
from symbalance.forces.summation import inline_couple as inline_couple
from symbalance.forces.summation import inline_sum as inline_sum
