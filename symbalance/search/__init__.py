"""Search of all cranks and firing orders: the best of them, and a proof that there is none better.

In: how many cylinders on which pins in which banks, when they fire, what is to be small and what must
hold. Out: three counts, the whole Pareto front, each point proved by the exact core, and a certificate.

    problem           the question: pins, rays, moments, what is the same but for a mirror
    objectives        what is asked of a crank, as sums over its pins
    integer_ring      sums of roots of unity as vectors of integers; tables: of what pins add to sums
    star_walk         branch and bound over stars, which Numba compiles; array_walk: the same in NumPy
    magnitudes        exact sizes and their comparison; front: who is worse than whom, decided so
    counting          cranks, stars and classes without a walk
    subtrees          a search in parts, which are jobs; search_result: what comes of it
    tree_size         how long a search would take, from some of its subtrees
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
