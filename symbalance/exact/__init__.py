"""Amplitudes in whose normal form a zero is decided, and two-sided series of them.

In: fractions of a turn, rational weights, symbols. Out: sums that say, provably, whether they vanish, and
their exact forms.

    angles           exact fractions of a turn, with room for symbols
    phasor           numbers of a cyclotomic field;  decimal_phasor: 40 digits, where none is exact
    arithmetic       sums and products of either kind;  symbol_sums: with letters for masses, lengths
    radicals         how such a number is written: roots, or cosines where there are none
    spectrum         one series for a planar vector: +n turns with the crank, -n against it
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
