from symbalance.exact.amplitude import Amplitude as Amplitude
from symbalance.exact.angles import Angle as Angle
from symbalance.exact.angles import degrees as degrees
from symbalance.exact.phasor import Phasor as Phasor
from symbalance.exact.spectrum import Component as Component
from symbalance.exact.spectrum import Spectrum as Spectrum
from symbalance.exact.symbolic_phasor import SymbolicPhasor as SymbolicPhasor
from symbalance.exact.symbolic_polynomials import SymbolSum as SymbolSum
