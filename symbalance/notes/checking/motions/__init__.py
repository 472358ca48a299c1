"""Motions as wholes: their series, means, largest values and equations of motion.

In: a formula over an angle or the time. Out: coefficients of its harmonics, its extremes, and the
natural frequencies of the differential equations that a page writes.
"""
