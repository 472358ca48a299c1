"""Standard formulas of engines and shafts, by the words that name them: the bending stress is M/W.

What is here is elementary and can be derived; `tests/independent/test_known_formulas.py` does so for each
formula by a route of its own (integrals over the section, eigenvalues, the path of a piston).

    roles         letters and what they stand for, what is known of a quantity
    shaft_roles   more letters, of shafts, mounts and fatigue
    role_units    the units of what letters stand for
    strength      sections, stresses, beams, springs
    fatigue       stresses that swing, notches, factors of safety
    vibration     natural frequencies, damping, magnification, critical speeds
    resonance     the top of a resonance curve, half-power points, unbalance
    machine_parts hollow shafts under stress, keys, struts, sliding speeds, more beams
    forced        what mounts pass on, phases, whirl, tuned dampers and pendulums
    trains        discs on shafts, mounts in numbers, gears, critical speeds of bending, springs
    inertia       moments of inertia, the masses of a rod
    crank_drive   forces, torque, speeds and volumes of one cylinder
    work          mean torque, power, flywheels
    crank_torque  torque of the mass forces, cycles, flywheels, the masses of a rod, loads on pins
    balance       counterweights, what they leave, resultants
    engine_rates  firings per second and per turn, frequencies of orders, speeds of balance shafts
    locomotives   wheels, tractive force and swaying couple of two cranks at right angles
    two_cylinders the forces of two cylinders on one pin, along and across the line between them
    vibration_roles  letters of trains, rotors and pendulums
    torsion       trains of three discs, gears by the speeds, a shaft's own inertia
    oscillations  harmonic motion, decay of peaks, pendulums and suspensions, undamped absorbers
    rotors        turning discs, critical speeds, what unbalances do to mounts and bearings
    round_bodies  half discs and rings, their masses and inertia, the stress of a turning rim
    bearings      the rating life of rolling bearings
    plain_quotients  one letter over another: stress, density, stiffness
    cycle_roles   letters of gas cycles and of two speeds
    wheels        thin rims, what a flywheel gives off, compression ratio, safety against yielding
    gas_cycles    the efficiency of the Otto cycle, adiabatic compression
    damping_numbers  the quality factor, the decrement of a light damping
    counterweights  moments of counterweights and balance shafts, the shapes of weights
"""

from collections.abc import Mapping

from symbalance.notes.checking.meant.catalogue.balance import BALANCE
from symbalance.notes.checking.meant.catalogue.bearings import BEARINGS
from symbalance.notes.checking.meant.catalogue.counterweights import COUNTERWEIGHTS
from symbalance.notes.checking.meant.catalogue.crank_drive import CRANK_DRIVE
from symbalance.notes.checking.meant.catalogue.crank_torque import CRANK_TORQUE
from symbalance.notes.checking.meant.catalogue.cycle_roles import CYCLE_ROLES
from symbalance.notes.checking.meant.catalogue.damping_numbers import DAMPING_NUMBERS
from symbalance.notes.checking.meant.catalogue.engine_rates import ENGINE_RATES
from symbalance.notes.checking.meant.catalogue.fatigue import FATIGUE
from symbalance.notes.checking.meant.catalogue.forced import FORCED
from symbalance.notes.checking.meant.catalogue.gas_cycles import GAS_CYCLES
from symbalance.notes.checking.meant.catalogue.inertia import INERTIA
from symbalance.notes.checking.meant.catalogue.locomotives import LOCOMOTIVES
from symbalance.notes.checking.meant.catalogue.machine_parts import PARTS
from symbalance.notes.checking.meant.catalogue.oscillations import OSCILLATIONS
from symbalance.notes.checking.meant.catalogue.plain_quotients import PLAIN_QUOTIENTS
from symbalance.notes.checking.meant.catalogue.resonance import RESONANCE
from symbalance.notes.checking.meant.catalogue.roles import OTHER_LENGTHS as OTHER_LENGTHS
from symbalance.notes.checking.meant.catalogue.roles import ROLES as FIRST_ROLES
from symbalance.notes.checking.meant.catalogue.roles import Quantity as Quantity
from symbalance.notes.checking.meant.catalogue.roles import Role
from symbalance.notes.checking.meant.catalogue.rotors import ROTORS
from symbalance.notes.checking.meant.catalogue.round_bodies import ROUND_BODIES
from symbalance.notes.checking.meant.catalogue.shaft_roles import SHAFT_ROLES
from symbalance.notes.checking.meant.catalogue.strength import STRENGTH
from symbalance.notes.checking.meant.catalogue.torsion import TORSION
from symbalance.notes.checking.meant.catalogue.trains import TRAINS
from symbalance.notes.checking.meant.catalogue.two_cylinders import TWO_CYLINDERS
from symbalance.notes.checking.meant.catalogue.vibration import VIBRATION
from symbalance.notes.checking.meant.catalogue.vibration_roles import VIBRATION_ROLES
from symbalance.notes.checking.meant.catalogue.wheels import WHEELS
from symbalance.notes.checking.meant.catalogue.work import WORK

ROLES: Mapping[str, Role] = {**FIRST_ROLES, **SHAFT_ROLES, **VIBRATION_ROLES, **CYCLE_ROLES}
"""What letters stand for, each role once."""
QUANTITIES = (
    *STRENGTH, *PARTS, *FATIGUE, *VIBRATION, *FORCED, *RESONANCE, *TRAINS, *INERTIA, *CRANK_DRIVE,
    *WORK, *CRANK_TORQUE, *BALANCE, *LOCOMOTIVES, *TWO_CYLINDERS, *COUNTERWEIGHTS, *ENGINE_RATES,
    *ROUND_BODIES, *TORSION, *OSCILLATIONS, *ROTORS, *BEARINGS, *PLAIN_QUOTIENTS,
    *GAS_CYCLES, *DAMPING_NUMBERS, *WHEELS,
)  # fmt: skip
"""All quantities, each name once."""
