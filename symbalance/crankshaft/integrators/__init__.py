"""Integrators of a linear periodic system: fixed-step Radau IIA and Newmark, and SciPy's.

methods       the fixed-step ones by name
radau         Radau IIA, the bearings as a correction of small rank
newmark       average acceleration, likewise
marching      what both come to: a few small products a step
checked       what a system must be
films         films and housings at a step's stages
tableau       Radau IIA's nodes and matrix
from_scipy    SciPy's on the first-order form
first_order   that form; the bearings' forces of a state
coefficients  the bearings at given angles
"""
