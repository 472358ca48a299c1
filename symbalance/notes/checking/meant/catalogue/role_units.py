"""The units of what the letters of standard formulas stand for: a crank radius is in metres.

A stiffness is in N/m or in N m, and a few letters stand for a force as well as for a torque: they are
left out here, and with them all formulas that they stand in.
"""

from __future__ import annotations

from collections.abc import Mapping

_ROLES_OF_UNIT = {
    "m": "diameter outer inner radius crank length stroke rod width height wall own_length own_diameter"
    " first_length first_diameter static_deflection arm gyration near far pin arm_of_weight eccentricity"
    " outer_radius inner_radius pitch hang bob wire coil wall_of_weight shift to_big to_small",
    "m^2": "area",
    "m^3": "modulus volume clearance swept total_volume",
    "m^4": "section polar_section second_section",
    "kg": "mass rotating reciprocating balance_mass unbalanced piston_mass rod_mass crank_mass",
    "kg m^2": "inertia first_inertia second_inertia own_inertia other_inertia central",
    "kg m": "unbalance",
    "kg/m^3": "density",
    "s": "period",
    "1/s": "omega omega_high omega_low rotation frequency turn_rate decay driving natural first_speed"
    " second_speed third_speed",
    "m/s": "velocity",
    "m/s^2": "gravity",
    "N": "force weight any_force piston_force rod_force tangential radial_part centrifugal net_force"
    " wheel_load shear_force load_rating bearing_load",
    "N m": "bending torque",
    "J": "swing kinetic cycle_work excess",
    "W": "power effective_power indicated_power lost_power",
    "Pa": "pressure stress shearing shear young effective_pressure indicated_pressure lost_pressure"
    " stress_amplitude mean_stress endurance static_strength shear_stress_allowed",
    "1": "cylinders fluctuation rod_angle crank_angle ratio slenderness slender compression efficiency"
    " damping_ratio tuning decrement order share bank half_bank sector half_sector form_factor"
    " sensitivity bending_safety torsion_safety mass_ratio gear_ratio windings",
}
UNIT_OF_ROLE: Mapping[str, str] = {
    role: unit for unit, roles in _ROLES_OF_UNIT.items() for role in roles.split()
}
"""The unit of each role that has one and always the same."""
