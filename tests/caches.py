"""Fresh caches: the library forgets what it has computed, as in a new process."""

import functools
import gc

_Cache = type(functools.cache(int))


def clear_caches() -> None:
    """Empty every function cache of the library.

    >>> from symbalance.kinematics.slider_crank import acceleration_series
    >>> _ = acceleration_series(2, through=4)
    >>> clear_caches()
    >>> acceleration_series.cache_info().currsize
    0
    """
    for cache in [x for x in gc.get_objects() if type(x) is _Cache]:
        if cache.__wrapped__.__module__.startswith("symbalance"):
            cache.cache_clear()
