"""The running crankshaft: from its geometry to the stress in it against the crank angle.

    crank      geometry: a chain of journals, webs and pins, with flywheel and pulley
    rotor      what the chain becomes: nodes, matrices in coordinates that turn with the crank
    system     the rotor on its bearings under its loads: linear, periodic in the crank angle

Axes: X up, Y right seen from the front, Z rearwards; U, V, W turn with the crank and agree with them at
theta = 0, so that the crank turns by +omega about +W and a throw's angle counts from U towards V. SI.
"""
