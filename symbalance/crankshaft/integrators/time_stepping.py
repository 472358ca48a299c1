"""Time stepping of a linear periodic system by precomputed matrices: a few small products a step.

The rotor between its bearings has constant coefficients, so a step of it is one matrix, the same for the
whole run; only the bearings change with the crank angle, and they touch it at two coordinates each. A
step is therefore, with b the bearing forces at the step's stages,

    s = (W p, q),    b = gain_k s + bias_k,    p+ = F p - L b + forcing_k,    q+ = E q + H_k b

for the rotor's state p (displacements first) and the housings' q: the Woodbury identity, with the small
inverse, which is the only thing that changes, in `gain_k`, computed for all steps at once.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symbalance.crankshaft.arrays import Array


@dataclass(frozen=True)
class LinearSteps:
    """The matrices of all steps of one cycle; `free` is F above W, shapes (m + w, m).

    `units` (state,) are those in which the parts of states are compared.
    """

    free: Array
    load: Array
    gain: Array
    bias: Array
    forcing: Array
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
        journals = np.empty(self.gain.shape[2])
        count_free = len(self.free) - m
        for k in range(cycles * count):
            i, state = k % count, states[k]
            after_free = self.free @ state[:m]
            journals[:count_free], journals[count_free:] = after_free[m:], state[m:]
            force = self.gain[i] @ journals
            force += self.bias[i]
            after = states[k + 1]
            np.subtract(after_free[:m], self.load @ force, out=after[:m])
            after[:m] += self.forcing[i]
            after[m:] = self.housing_free @ state[m:] + self.housing_load[i] @ force
        return states

    def propagate(self, columns: Array) -> Array:
        """Return states (state, k), or one state, after a cycle without loads: the monodromy's action."""
        m = self.motion_size
        motion, housing = columns[:m], columns[m:]
        for i in range(self.steps):
            after_free = self.free @ motion
            force = self.gain[i] @ np.concatenate([after_free[m:], housing])
            motion = after_free[:m] - self.load @ force
            housing = self.housing_free @ housing + self.housing_load[i] @ force
        return np.concatenate([motion, housing])
