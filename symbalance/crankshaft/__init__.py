"""The running crankshaft: from its geometry to the stress in it against the crank angle.

    crank        geometry: a chain of journals, webs and pins, flywheel, pulley; `checks` of it
    equations    the rotating-frame equations of a node, derived with SymPy, beside the published ones
    rotor        what the chain becomes: nodes, matrices in coordinates that turn with the crank
    beams, bodies, webs, solid, gathering, assembly   from one to the other: Timoshenko beams, webs as
                 elements (from a meshed half throw, fitted, or by formula), bodies that turn
    shafts, torsion, modes, campbell, spin            straight rotors, chains, natural frequencies, whirl
    rotor_facts, *_document  what is written of rotors' results
    system       the rotor on its bearings under its loads: linear, periodic in the crank angle
    bearings     short films about orbits, tables, housings in series; `frames` turns them with the crank
    integrators, steady, transient, harmonic_balance, reduction   its motion, and what is stable
    files, loads, stress     engine-file tables; forces on the pins; section loads, fillets, fatigue
    running, reports         speed by speed from file to outcome; a run's document, pictures, CSV

Axes: X up, Y right seen from the front, Z rearwards; U, V, W turn with the crank and agree with them at
theta = 0, so that the crank turns by +omega about +W and a throw's angle counts from U towards V. SI.
"""
