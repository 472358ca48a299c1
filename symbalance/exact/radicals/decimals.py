"""A real cyclotomic number to any number of digits."""

from symbalance.exact.phasor import Phasor
from symbalance.text.reals import Real


def evaluated(number: Phasor, digits: int) -> Real:
    """Return a real cyclotomic number to `digits` significant digits, whatever cancels in it."""
    return number.real_value(digits)
