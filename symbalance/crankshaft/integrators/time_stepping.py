"""A fixed-step method on a linear periodic system: everything but a few small products done beforehand.

The rotor between its bearings has constant coefficients, so a step of it is one matrix, the same for the
whole run; only the bearings change with the crank angle, and they touch it at two coordinates each. A
step is therefore, with b the bearing forces at the step's stages,

    seen = (W p, q),    b = gain_k seen + bias_k,    p+ = F p - L b + forced_k,    q+ = E q + H_k b

for the rotor's state p (displacements first) and the housings' q: the Woodbury identity, with the small
inverse, which is the only thing that changes, in `gain_k`, made for all steps at once.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symbalance.crankshaft.arrays import Array


@dataclass(frozen=True)
class LinearSteps:
    """The matrices of all steps of one cycle; `free` is F above W, shapes (m + w, m).

    `units` (state,) is what each part of a state is measured in where states are compared.
    """

    free: Array
    load: Array
    gain: Array
    bias: Array
    forced: Array
    housing_free: Array
    housing_load: Array
    units: Array

    @property
    def steps(self) -> int:
        """The number of steps in a cycle."""
        return len(self.gain)

    @property
    def motion_size(self) -> int:
        """The length of the rotor's state p."""
        return self.free.shape[1]

    @property
    def state_size(self) -> int:
        """The length of the whole state (p, q)."""
        return self.motion_size + len(self.housing_free)

    def march(self, start: Array, cycles: int = 1) -> Array:
        """Return the states (cycles steps + 1, state) from `start`, under the loads."""
        m, count = self.motion_size, self.steps
        states = np.empty((cycles * count + 1, self.state_size))
        states[0] = start
        seen = np.empty(self.gain.shape[2])
        watched = len(self.free) - m
        for k in range(cycles * count):
            i, state = k % count, states[k]
            moved = self.free @ state[:m]
            seen[:watched], seen[watched:] = moved[m:], state[m:]
            force = self.gain[i] @ seen
            force += self.bias[i]
            after = states[k + 1]
            np.subtract(moved[:m], self.load @ force, out=after[:m])
            after[:m] += self.forced[i]
            after[m:] = self.housing_free @ state[m:] + self.housing_load[i] @ force
        return states

    def propagate(self, columns: Array) -> Array:
        """Return states (state, k), or one state, after a cycle without loads: the monodromy's action."""
        m = self.motion_size
        motion, housing = columns[:m], columns[m:]
        for i in range(self.steps):
            moved = self.free @ motion
            force = self.gain[i] @ np.concatenate([moved[m:], housing])
            motion = moved[:m] - self.load @ force
            housing = self.housing_free @ housing + self.housing_load[i] @ force
        return np.concatenate([motion, housing])
