"""Webs as beams, for use without a mesher: of their nominal sizes, or of Ker Wilson's equivalent lengths.

W. Ker Wilson, Practical Solution of Torsional Vibration Problems, vol. 1 (Chapman & Hall, 1956), gives a
throw the torsional length of journal and pin each lengthened by 0.4 diameters (0.2 into either web), and
of a web of the length R - 0.2 (D_j + D_p) bent in its plane:

    L_e = D^4 [ (L_j + 0.4 D_j)/D_j^4 + (L_p + 0.4 D_p)/D_p^4 + (R - 0.2 (D_j + D_p))/(h W^3) ],

the throw's flexibility (both webs in the last term) being 32 L_e/(pi G D^4); h is a web's thickness, W
its width. It is assumed in this form: the print was not seen.

The bending, axial and shear terms are a beam's of the same clear length and stubs: no published formula
gives all six. Its error against the solid is in `derivations/crankshaft-model.md`.

The nominal web is what a beam program gives when every part is drawn as a beam: a radial beam of the
web's rectangle from axis to axis, with shear and Saint-Venant torsion, between stubs of journal and pin
that reach to the web's mid-plane. It is too soft by far for stocky webs.
"""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.crank import Journal, Pin
from symbalance.crankshaft.rotor.beams import ALONG_W, circular, flexibility, rectangular
from symbalance.crankshaft.webs.arm import Arm, chain_flexibility

INTO = 0.2
"""How far a journal or pin works into the web, in diameters."""
WEB_ASSUMPTION = "flexibility of the webs: Ker Wilson's equivalent lengths, not compared with the print"
"""What a report says of a run with webs by formula."""
ALONG_U = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
"""A beam along the arm: its own y is the arm's v (across), its z the arm's w (through the web)."""


def formula_flexibility(arm: Arm) -> Array:
    """Return the flexibility (6, 6) of the far face by Ker Wilson's lengths; own axes, SI."""
    return chain_flexibility([_stub(arm, arm.near), *_clear_web(arm), _stub(arm, arm.far)])


def _stub(arm: Arm, part: Journal | Pin) -> tuple[Array, Array]:
    """Return a stub half a web long with the flexibility of 0.2 diameters of journal or pin."""
    section, half = circular(part.diameter, part.bore, arm.material.poisson), arm.web.thickness / 2
    share = INTO * part.diameter / half
    return share * flexibility(section, arm.material, half, ALONG_W), np.array([0.0, 0.0, half])


def _clear_web(arm: Arm) -> list[tuple[Array, Array]]:
    """Return rigid, elastic and rigid parts of the web, the elastic one between the overlaps."""
    clear = clear_length(arm)
    rigid = np.zeros((DOF, DOF))
    start = (arm.reach - clear) * arm.near.diameter / (arm.near.diameter + arm.far.diameter)
    web, material = arm.web, arm.material
    section = rectangular(web.width, web.thickness, material.poisson)
    in_plane = pi * material.shear * web.thickness * web.width**3 / 16  # the formula has both webs
    section = replace(section, bend_z=in_plane / material.young)
    lengths = (start, clear, arm.reach - clear - start)
    levers = [np.array([length, 0.0, 0.0]) for length in lengths]
    return [
        (rigid, levers[0]),
        (flexibility(section, material, clear, ALONG_U), levers[1]),
        (rigid, levers[2]),
    ]


def clear_length(arm: Arm) -> float:
    """Return R - 0.2 (D_j + D_p), kept above a tenth of the reach where journal and pin overlap."""
    return max(arm.reach - INTO * (arm.near.diameter + arm.far.diameter), 0.1 * arm.reach, 1e-9)


def ker_wilson_torsion(journal: Journal, pin: Pin, thickness: float, width: float, shear: float) -> float:
    """Return a whole throw's torsional flexibility by Ker Wilson's formula, rad/(N m)."""
    parts = (journal.length + 0.4 * journal.diameter) / (journal.diameter**4 - journal.bore**4)
    parts += (pin.length + 0.4 * pin.diameter) / (pin.diameter**4 - pin.bore**4)
    clear = pin.radius - INTO * (journal.diameter + pin.diameter)
    return 32 / (pi * shear) * (parts + clear / (thickness * width**3))


def nominal_flexibility(arm: Arm) -> Array:
    """Return the flexibility (6, 6) of the far face of a web drawn as three beams; own axes, SI."""
    return chain_flexibility([stub(arm, near=True), radial_beam(arm), stub(arm, near=False)])


def stub(arm: Arm, *, near: bool) -> tuple[Array, Array]:
    """Return the flexibility and lever of journal or pin from the web's face to its mid-plane."""
    part, half = (arm.near if near else arm.far), arm.web.thickness / 2
    section = circular(part.diameter, part.bore, arm.material.poisson)
    return flexibility(section, arm.material, half, ALONG_W), np.array([0.0, 0.0, half])


def radial_beam(arm: Arm) -> tuple[Array, Array]:
    """Return the flexibility and lever of the web itself from axis to axis."""
    section = rectangular(arm.web.width, arm.web.thickness, arm.material.poisson)
    return flexibility(section, arm.material, arm.reach, ALONG_U), np.array([arm.reach, 0.0, 0.0])
