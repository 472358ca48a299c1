from symbalance.exact.angles import Angle as Angle
from symbalance.exact.angles import degrees as degrees
from symbalance.exact.spectrum import Component as Component
