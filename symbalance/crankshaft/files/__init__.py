"""Engine files' tables for the running crankshaft: [crankshaft], [bearings], [running], read strictly.

crank_keys  the keys of the three tables: kind, unit, range, default, meaning; reference, JSON Schema
geometry    [crankshaft] and the layout -> Crank
supports    [bearings] -> clearance, oil, housing, thrust bearing
operation   [running] -> bore, speeds, pressure, rods, damping, strength, measured curves
engines     all of a file together
"""

from symbalance.crankshaft.files.engines import RunningEngine, read_running_engine

__all__ = ["RunningEngine", "read_running_engine"]
