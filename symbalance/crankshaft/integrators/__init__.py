"""Integrators of a linear periodic system: fixed-step Radau IIA and Newmark, and SciPy's.

methods       the fixed-step ones by name
radau         Radau IIA, the bearings as a correction of small rank;  tableau: its nodes and matrix
newmark       average acceleration, likewise
time_stepping what both come to: a few small products a step
first_order   the first-order form, and SciPy's integrators on it
coefficients  the bearings at given angles
"""
