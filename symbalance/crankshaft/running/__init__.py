"""The crankshaft as it runs: from an engine to stress against the crank angle at every speed.

configuration  engine -> rotor, stress channels and, at a speed, the periodic system
loading        loads on the rotor: pins, centrifugal forces, weight; bearing loads of a quasi-static crank
oil_films      the oil films of [bearings]: computed, or from a table
about_orbit    the equations for departures from the orbits that films are linear about
speed_sweep    all speeds, each solved once and saved
outcome        what a speed gives: stresses, orbits, bearing loads, orders; as bytes
measured       a measured curve beside the computed one
"""

from symbalance.crankshaft.running.configuration import RunConfiguration, configure_run
from symbalance.crankshaft.running.outcome import SpeedOutcome
from symbalance.crankshaft.running.speed_sweep import run_speeds

__all__ = ["RunConfiguration", "SpeedOutcome", "configure_run", "run_speeds"]
