"""Material and rigid discs, of which straight shafts and crankshafts are made. SI units."""

from __future__ import annotations

from dataclasses import dataclass

from symbalance.crankshaft.arguments import check_fields, check_number
from symbalance.errors import SymbalanceError, brief


@dataclass(frozen=True)
class Material:
    """Young's modulus in Pa, Poisson's ratio, density in kg/m^3; forged steel by default."""

    young: float = 206e9
    poisson: float = 0.29
    density: float = 7850.0

    def __post_init__(self) -> None:
        for name in ("young", "poisson", "density"):
            check_number(getattr(self, name), name, "Pa, 1, kg/m^3", signed=True)
        if not self.young > 0:
            raise SymbalanceError(f"young = {brief(self.young)}", "must be positive", "Pa; GPa in files")
        if not 0 <= self.poisson < 0.5:
            what = f"poisson = {brief(self.poisson)}"
            raise SymbalanceError(what, "must lie in [0, 0.5)", "0.29 for steel")
        if not self.density > 0:
            remedy = "kg/m^3, 7850 for steel; 1e-3 where a shaft's mass is not to count"
            raise SymbalanceError(f"density = {brief(self.density)}", "must be positive", remedy)

    @property
    def shear(self) -> float:
        """The shear modulus E/(2 (1 + nu)), in Pa."""
        return self.young / (2 * (1 + self.poisson))


STEEL = Material()
"""Forged steel."""


@dataclass(frozen=True)
class Disc:
    """A rigid disc on a shaft, or `distance` beyond an end of a crank: mass and moments of inertia.

    `polar` about W and `diametral` about a line across it, through its centre of gravity, in kg m^2.
    """

    mass: float
    polar: float
    diametral: float
    distance: float = 0.0
    diameter: float = 0.0
    """The diameter of the shaft that carries it; 0: the end journal's."""

    def __post_init__(self) -> None:
        units = {"mass": "kg", "polar": "kg m^2", "diametral": "kg m^2", "distance": "m", "diameter": "m"}
        check_fields(self, "disc", units.items())
