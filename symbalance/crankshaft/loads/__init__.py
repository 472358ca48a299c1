r"""Forces of the connecting rods on the crank pins against the crank angle: gas and inertia.

In a cylinder's own frame (height along its axis, + lateral where the pin moves to after p = 0; numbers
height + i lateral) the piston's equilibrium along its axis and the rod's moments about its pin give, at
constant omega, the force of the rod on its pin

    P = F - i (F tan phi + J_x omega^2 phi''/(l cos phi)),     F = -(p - p_0) A - m r omega^2 y''(p),

y, phi and their derivatives in closed form from the mechanism, m the reciprocating mass with the rod's
share, J_x what the rod's two end masses lack of its moment of inertia. In turning coordinates that is
P e^(i (bank - theta)). The side thrust is the wall's, not the crank's.

The big end's rotating share is no part of P: it sits as mass on its pin's node, whose omega^2 F_M then
holds its centrifugal force. A link rod bears on its link pin, so that the master's rod gives the crank
pin its force too, and the master's piston the moment of it.

    motion       y and phi of any mechanism for arrays of crank angles
    cylinders    P of every cylinder
    pins         the six loads at every pin, turning coordinates; big ends, harmonics
"""

from symbalance.crankshaft.loads.cylinders import RodForces, firing_crank_angles, rod_forces
from symbalance.crankshaft.loads.pins import PinLoads, big_end_masses, pin_loads

__all__ = [
    "PinLoads",
    "RodForces",
    "big_end_masses",
    "firing_crank_angles",
    "pin_loads",
    "rod_forces",
]
