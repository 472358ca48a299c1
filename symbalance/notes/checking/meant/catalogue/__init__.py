"""Standard formulas of engines and shafts, by the words that name them: the bending stress is M/W.

What is here is elementary and can be derived; `tests/independent/test_known_formulas.py` does so for each
formula by a route of its own (integrals over the section, eigenvalues, the path of a piston).

    roles         letters and what they stand for, what is known of a quantity
    strength      sections, stresses, beams, springs
    vibration     natural frequencies, damping, magnification, critical speeds
    inertia       moments of inertia, the masses of a rod
    crank_drive   forces, torque, speeds and volumes of one cylinder
    work          mean torque, power, flywheels
    crank_torque  torque of the mass forces, cycles, flywheels, the masses of a rod, loads on pins
    balance       counterweights, what they leave, resultants
    engine_rates  firings per second and per turn, frequencies of orders, speeds of balance shafts
    locomotives   wheels, tractive force and swaying couple of two cranks at right angles
    two_cylinders the forces of two cylinders on one pin, along and across the line between them
    counterweights  moments of counterweights and balance shafts, the shapes of weights
"""

from symbalance.notes.checking.meant.catalogue.balance import BALANCE
from symbalance.notes.checking.meant.catalogue.counterweights import COUNTERWEIGHTS
from symbalance.notes.checking.meant.catalogue.crank_drive import CRANK_DRIVE
from symbalance.notes.checking.meant.catalogue.crank_torque import CRANK_TORQUE
from symbalance.notes.checking.meant.catalogue.engine_rates import ENGINE_RATES
from symbalance.notes.checking.meant.catalogue.inertia import INERTIA
from symbalance.notes.checking.meant.catalogue.locomotives import LOCOMOTIVES
from symbalance.notes.checking.meant.catalogue.roles import OTHER_LENGTHS as OTHER_LENGTHS
from symbalance.notes.checking.meant.catalogue.roles import ROLES as ROLES
from symbalance.notes.checking.meant.catalogue.roles import Quantity as Quantity
from symbalance.notes.checking.meant.catalogue.strength import STRENGTH
from symbalance.notes.checking.meant.catalogue.two_cylinders import TWO_CYLINDERS
from symbalance.notes.checking.meant.catalogue.vibration import VIBRATION
from symbalance.notes.checking.meant.catalogue.work import WORK

QUANTITIES = (
    *STRENGTH, *VIBRATION, *INERTIA, *CRANK_DRIVE, *WORK, *CRANK_TORQUE, *BALANCE, *LOCOMOTIVES,
    *TWO_CYLINDERS, *COUNTERWEIGHTS, *ENGINE_RATES,
)  # fmt: skip
"""All quantities, each name once."""
