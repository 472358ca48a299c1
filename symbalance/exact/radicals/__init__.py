"""Closed forms of real cyclotomic numbers: radicals where they exist, else cosines.

A real number of an abelian field splits exactly into one part for each conjugacy class of even
characters of its Galois group (Z/m)*. The part of a character of order 1 is rational, the square of
a part of order 2 is rational, and the square of a part of order 4 lies in a quadratic field. So

    x = a + sum of +-sqrt(b) + sum of +-sqrt(c + d sqrt(e))

exactly when only characters of order 1, 2 and 4 occur: in-line fives, sixteenths of a turn, ....
Characters of order 3 (sevenths, ninths) admit no real radicals at all (the casus irreducibilis);
those numbers, and deeper towers, are written as rational combinations of cosines or sines instead.

Formulas:
    cos(pi/5) = (1 + sqrt(5))/4
    sin(pi/8) = sqrt(2 - sqrt(2))/2
    cos(pi/12) = (sqrt(6) + sqrt(2))/4
    sin(2 pi/5) = sqrt(10 + 2 sqrt(5))/4
"""

from symbalance.exact.radicals.characters import radical_form
from symbalance.exact.radicals.closed_forms import ZERO_FORM, ClosedForm, multiple_of_pi
from symbalance.exact.radicals.cosines import trigonometric_form
from symbalance.exact.radicals.forms import exact_form, square_root_form

__all__ = [
    "ZERO_FORM",
    "ClosedForm",
    "exact_form",
    "multiple_of_pi",
    "radical_form",
    "square_root_form",
    "trigonometric_form",
]
