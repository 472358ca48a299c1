"""Engines whose parts differ: formulas with symbols left in, sensitivities, tolerances, weighed parts.

- `symbolic_order`: one order of the free force and couple with symbols for masses, stations and lengths;
- `sensitivities`: how each order changes with each size of each cylinder, geometry exact;
- `worst_cases`: the worst that tolerances allow, attained and bounded;
- `assign_parts`: which weighed part goes to which cylinder so that least is left.
"""

from symbalance.variations.aims import MODES
from symbalance.variations.arranging import Assignment, assign_parts
from symbalance.variations.derivatives import PARAMETERS, sensitivities
from symbalance.variations.extremes import WorstCase, worst_cases
from symbalance.variations.formulas import SymbolicOrder, symbolic_order
from symbalance.variations.measures import Shaking
from symbalance.variations.sensitivity import STEPS, Sensitivity
from symbalance.variations.shares import first_sizes
from symbalance.variations.tolerances import UNITS, Tolerances
from symbalance.variations.weighed import Part, PartSet, parse_parts, read_parts

__all__ = [
    "MODES",
    "PARAMETERS",
    "STEPS",
    "UNITS",
    "Assignment",
    "Part",
    "PartSet",
    "Sensitivity",
    "Shaking",
    "SymbolicOrder",
    "Tolerances",
    "WorstCase",
    "assign_parts",
    "first_sizes",
    "parse_parts",
    "read_parts",
    "sensitivities",
    "symbolic_order",
    "worst_cases",
]
