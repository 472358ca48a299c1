"""Long work as independent jobs: on one core, on several, on a cluster; kept when finished, restartable.

In: a function, the values to do it on, what a finished one is recognised by. Out: an outcome for each, in
their order, whatever was killed meanwhile. Knows no engine.

    running        jobs, their outcomes, and what becomes of a killed worker
    pools          processes of this machine, or a Dask cluster
    store          finished results in a folder;  digests: of inputs and of the program, their keys
    progress       how much is done, and how long the rest may take
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
