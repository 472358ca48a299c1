r"""The torque on the crank: inertia exact in lambda, gas from a pressure trace or an ideal cycle.

Torque is positive on the crank in the sense of rotation; the frame gets the opposite. theta is the crank
angle, a cylinder's own angle theta + throw - bank. One cylinder's harmonics are `symbalance.kinematics`.

    inertia_balance  their sum over a layout, order by order;  groups: where cylinders are not alike
    roll             the rods' part, and the whole moment that rolls the frame
    stars            star diagrams of all orders, halves in a four-stroke, closed or not: exact
    pressure         pressure traces;  csv_file reads them,  ideal makes them
    tangential       gas torque of one cylinder, work and harmonics;  gas sums it over a layout
    running          whole torque, mean, fluctuation, energy;  flywheel sizes what evens it
    torque_document, running_document, gas_document, pressure_document   what is written of results
    torque_data   torques as plain values
"""

from symbalance.forces.shafts import has_shafts_aside, shaft_moment
from symbalance.kinematics.inertia import torque_left_out, torque_series, torque_values
from symbalance.torque.csv_file import parse_pressure, read_pressure
from symbalance.torque.flywheel import Fluctuation, flywheel_inertia, speed_fluctuation
from symbalance.torque.gas import GasOrder, GasTorque, gas_torque, tangential_pressure
from symbalance.torque.ideal import IdealCycle, ideal_cycle
from symbalance.torque.inertia_balance import TorqueBalance, TorqueOrder, inertia_torque
from symbalance.torque.pressure import PressureTrace, pressure_trace
from symbalance.torque.roll import (
    TorqueReport,
    beside_moment,
    has_rods,
    rod_couple,
    rod_torque,
    roll_moment,
    torque_report,
)
from symbalance.torque.running import CrankTorque, crank_torque
from symbalance.torque.stars import FiringStars, Star, firing_pin_passings, firing_stars
from symbalance.torque.tangential import AMBIENT, TangentialPressure

__all__ = [
    "AMBIENT",
    "CrankTorque",
    "FiringStars",
    "Fluctuation",
    "GasOrder",
    "GasTorque",
    "IdealCycle",
    "PressureTrace",
    "Star",
    "TangentialPressure",
    "TorqueBalance",
    "TorqueOrder",
    "TorqueReport",
    "beside_moment",
    "crank_torque",
    "firing_pin_passings",
    "firing_stars",
    "flywheel_inertia",
    "gas_torque",
    "has_rods",
    "has_shafts_aside",
    "ideal_cycle",
    "inertia_torque",
    "parse_pressure",
    "pressure_trace",
    "read_pressure",
    "rod_couple",
    "rod_torque",
    "roll_moment",
    "shaft_moment",
    "speed_fluctuation",
    "tangential_pressure",
    "torque_left_out",
    "torque_report",
    "torque_series",
    "torque_values",
]
