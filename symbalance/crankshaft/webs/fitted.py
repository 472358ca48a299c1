"""Webs as beams whose six flexibilities are fitted to those of the half throw meshed as a solid.

The web is the nominal one's chain (stub, radial beam, stub), with the beam's six section flexibilities f
(stretch, two shears, twist, two bendings) free. A section's loads under a load at the far end are
statically determinate, so that the far end's flexibility is linear in them,

    S = S_stubs + sum over k of f_k integral h_k h_k' du,

h_k the k-th section load per unit end load. Non-negative least squares (scipy.optimize.nnls) on the
entries S_ij/sqrt(S_ii S_jj) of the solid's web: no iteration over models.
"""

from __future__ import annotations

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.rotor.beams import transfer
from symbalance.crankshaft.webs.arm import Arm, chain_flexibility
from symbalance.crankshaft.webs.beam_webs import stub
from symbalance.errors import MissingPartError

NAMES = ("stretch", "shear across", "shear through", "twist", "bend through", "bend in plane")
"""The six section loads of a beam along u: N, shear along v and w, torque, moments about v and w."""


def fitted_flexibility(arm: Arm, target: Array, *, stubs: bool = False) -> Array:
    """Return the flexibility (6, 6) of the six-parameter web nearest to `target`, own axes."""
    constant, terms = _parts(arm, stubs)
    return constant + np.tensordot(fitted_parameters(arm, target, stubs=stubs), terms, 1)


def fitted_parameters(arm: Arm, target: Array, *, stubs: bool = False) -> Array:
    """Return the six section flexibilities (1/EA, 1/GA_v, 1/GA_w, 1/GJ, 1/EI_v, 1/EI_w), none negative.

    With `stubs` journal and pin are elastic up to the web's mid-plane, as in the nominal web; the default
    takes them as rigid within the web, so that all of the web's flexibility lies in the six.
    """
    try:
        from scipy.optimize import nnls
    except ImportError as err:
        remedy = "pip install 'symbalance[crankshaft]'"
        raise MissingPartError("webs = 'fitted'", "SciPy is not installed", remedy) from err
    constant, terms = _parts(arm, stubs)
    scale = 1 / np.sqrt(np.outer(np.diag(target), np.diag(target)))
    columns = np.array([(term * scale).ravel() for term in terms]).T
    size = np.linalg.norm(columns, axis=0)
    side = ((target - constant) * scale).ravel()
    return nnls(columns / size, side)[0] / size


def _parts(arm: Arm, stubs: bool) -> tuple[Array, Array]:
    half = np.array([0.0, 0.0, arm.web.thickness / 2])
    rigid = (np.zeros((DOF, DOF)), half)
    ends = [stub(arm, near=True), stub(arm, near=False)] if stubs else [rigid, rigid]
    radial = (np.zeros((DOF, DOF)), np.array([arm.reach, 0.0, 0.0]))
    return chain_flexibility([ends[0], radial, ends[1]]), _unit_terms(arm)


def _unit_terms(arm: Arm) -> Array:
    """Return the integrals of h_k h_k' along the radial beam: (6, 6, 6), two Gauss points exact."""
    places, weights = np.polynomial.legendre.leggauss(2)
    terms = np.zeros((DOF, DOF, DOF))
    for place, weight in zip((places + 1) / 2, weights / 2 * arm.reach, strict=True):
        to_end = transfer(np.array([(1 - place) * arm.reach, 0.0, arm.web.thickness / 2]))
        for k in range(DOF):
            terms[k] += weight * np.outer(to_end[:, k], to_end[:, k])
    return terms
