"""The running crankshaft: from its geometry to the stress in it against the crank angle.

In: an engine file with [crankshaft], [bearings] and [running], or a crank or shaft built in Python. Out:
natural frequencies, whirl, critical speeds; periodic motion and stability; bearing loads, stresses, life.

    rotor        shafts of any kind: matrices, natural modes, torsion, Campbell diagram, whirl, unbalance
    crank        a crank's geometry;  `geometry_checks` of it;  webs, solid: the flexibility of its webs
    assembly     from the geometry to a rotor
    equations    the equations of a node in turning axes, derived, beside the published ones
    bearings     oil films, their tangents along a journal's orbit, housings in series
    system       a rotor on its bearings under its loads, periodic in the crank angle;  frames: its axes
    integrators, steady, transient, harmonic_balance, reduction   its motion, and whether it is stable
    files, loads, stress   engine files; forces of the rods on the pins; section loads, fillets, fatigue
    running, reports       speed by speed from file to outcome; a run's document, pictures, CSV

Axes: X up, Y right seen from the front, Z rearwards; U, V, W turn with the crank and agree with them at
theta = 0, so that the crank turns by +omega about +W and a throw's angle counts from U towards V. SI.
"The paper" is that of J. Mizuhaya and others, quoted in `equations.published`.
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
