"""The crankshaft as it runs: from an engine to stress against the crank angle at every speed.

holding      what holds the free rotor in place: thrust bearing, driveline
loading      the right side: pins, centrifugal forces, weight, the load's torque
reactions    main bearing loads of a quasi-static crank, from which films are made
films        the oil films of [bearings]: computed or from a table
setting      engine -> rotor, channels and, at a speed, the periodic system
outcome      what a speed gives: stresses, orbits, bearing loads, orders
saved        outcomes on disk, one file a speed, each whole or not at all
sweep        all speeds, finished ones kept
measured     a measured curve beside the computed one
"""

from symbalance.crankshaft.running.configuration import RunConfiguration, configure_run
from symbalance.crankshaft.running.outcome import SpeedOutcome
from symbalance.crankshaft.running.speed_sweep import run_speeds

__all__ = ["RunConfiguration", "SpeedOutcome", "configure_run", "run_speeds"]
