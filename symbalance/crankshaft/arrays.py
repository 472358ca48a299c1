"""Type aliases of NumPy arrays in `symbalance.crankshaft`, and the degrees of freedom of a node."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.floating[Any]]
"""Real numbers."""
Complex = NDArray[np.complexfloating[Any, Any]]
"""Complex numbers: amplitudes, shapes, roots."""
DOF = 6
"""Unknowns of a node, in this order: u, v, w, theta_u, theta_v, theta_w."""
