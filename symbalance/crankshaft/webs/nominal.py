"""The nominal web: a radial beam of the web's rectangle between stubs of journal and pin.

Journal and pin reach to the web's mid-plane with their own sections; the web is a beam from axis to axis,
`thickness` by `width`, with shear and Saint-Venant torsion. It is what a beam program gives when every
part is drawn as a beam, and it is too soft by far for stocky webs: see `derivations/crankshaft-model.md`.
"""

from __future__ import annotations

import numpy as np

from symbalance.crankshaft.beams import ALONG_W, circular, flexibility, rectangular
from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.webs.arm import Arm, chained

ALONG_U = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
"""A beam along the arm: its own y is the arm's v (across), its z the arm's w (through the web)."""


def nominal_flexibility(arm: Arm) -> Array:
    """Return the flexibility (6, 6) of the far face of a web drawn as three beams; own axes, SI."""
    return chained([stub(arm, near=True), radial(arm), stub(arm, near=False)])


def stub(arm: Arm, *, near: bool) -> tuple[Array, Array]:
    """Return the flexibility and lever of journal or pin from the web's face to its mid-plane."""
    part, half = (arm.near if near else arm.far), arm.web.thickness / 2
    section = circular(part.diameter, part.bore, arm.material.poisson)
    return flexibility(section, arm.material, half, ALONG_W), np.array([0.0, 0.0, half])


def radial(arm: Arm) -> tuple[Array, Array]:
    """Return the flexibility and lever of the web itself from axis to axis."""
    section = rectangular(arm.web.width, arm.web.thickness, arm.material.poisson)
    return flexibility(section, arm.material, arm.reach, ALONG_U), np.array([arm.reach, 0.0, 0.0])
