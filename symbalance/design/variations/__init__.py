"""Engines whose parts differ: formulas with symbols left in, sensitivities, tolerances, weighed parts.

- `symbolic_order`: one order of the free force and couple with symbols for masses, stations and lengths;
- `sensitivities`: how each order changes with each size of each cylinder, geometry exact;
- `worst_cases`: the worst that tolerances allow, attained and bounded;
- `assign_parts`: which weighed part goes to which cylinder so that least is left.
"""

from symbalance.design.variations.aims import MODES
from symbalance.design.variations.arranging import Assignment, assign_parts
from symbalance.design.variations.derivatives import PARAMETERS, sensitivities
from symbalance.design.variations.extremes import WorstCase, WorstCases, worst_cases
from symbalance.design.variations.formulas import SymbolicOrder, symbolic_order
from symbalance.design.variations.measures import Shaking
from symbalance.design.variations.sensitivity import STEPS, Sensitivities, Sensitivity
from symbalance.design.variations.tolerances import UNITS, Tolerances
from symbalance.design.variations.weighed import Part, PartSet, parse_parts, read_parts

__all__ = [
    "MODES",
    "PARAMETERS",
    "STEPS",
    "UNITS",
    "Assignment",
    "Part",
    "PartSet",
    "Sensitivities",
    "Sensitivity",
    "Shaking",
    "SymbolicOrder",
    "Tolerances",
    "WorstCase",
    "WorstCases",
    "assign_parts",
    "parse_parts",
    "read_parts",
    "sensitivities",
    "symbolic_order",
    "worst_cases",
]
