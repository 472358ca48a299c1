"""The parts of `symbalance bench crankshaft`: the crank it runs, its cases, the runs, their picture."""
