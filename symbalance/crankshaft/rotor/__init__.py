"""Rotors: shafts of any kind as nodes and matrices, their natural modes, whirl and unbalance response.

In: tubes, discs and bearings (`shaft`), or a crank (`symbalance.crankshaft.assemble`). Out: frequencies,
shapes, critical speeds, stability, motion under unbalance; each a result with a document.

    parts, beams, rigid_bodies   material and discs; Timoshenko beams; what a turning body adds at a node
    matrices, assembly           the rotor itself, and how pieces become one;  shafts: straight ones
    rigid_body_mode, constraints rotation as a whole, falsely unstable in linear equations; springs on it
    modes, torsion               natural frequencies at rest; discs and torsion springs
    stationary, whirling         round rotors on any supports: roots, directions, critical speeds
    campbell_diagram, unbalance  frequencies over the speed; motion under unbalance
    documents                    what is written of the results
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
