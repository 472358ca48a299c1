from symbalance.text.reals import Complex as Complex
from symbalance.text.reals import Real as Real
