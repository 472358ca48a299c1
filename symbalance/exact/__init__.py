"""Exact complex numbers that decide whether they are zero, and two-sided Fourier series of them.

In: fractions of a turn, rational weights, symbols. Out: sums that say, provably, whether they vanish, and
their exact forms.

    angles           exact fractions of a turn, with room for symbols
    amplitude        what every amplitude can do, and the three kinds:  phasor: of a cyclotomic field;
                     symbolic_phasor: with symbols for angles;  decimal_phasor: 40 digits, none exact
    arithmetic       sums and ratios of amplitudes;  symbolic_polynomials: letters for masses and lengths
    radicals         how such a number is written: roots, or cosines where there are none
    exact_forms      what any exact number is printed from
    spectrum         one series for a planar vector: +n turns with the crank, -n against it
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
