r"""How many nodes a search would walk, estimated from some of its subtrees, without walking all.

A random beginning is drawn pin by pin: of the k beginnings that go on from the last, one, each with the
chance 1/k. The subtree below it is walked whole, with every bound. Nodes times the product of the k is,
on average, the nodes of the whole tree:

    E[k_1 k_2 ... k_d nodes] = sum over all beginnings of their nodes,

since each beginning is drawn with the chance 1/(k_1 ... k_d). The spread of these products gives the
error of their mean. D. E. Knuth, Estimating the efficiency of backtrack programs, Mathematics of
Computation 29 (1975). Branches that bounds cut early make a few subtrees much of the whole: an error
above a third says that too few of them were met, and that the mean is likely to be too low.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from random import Random

from symbalance.jobs.digests import digest
from symbalance.search.subtrees import SearchPart, SearchSpec, beginnings, search_part
from symbalance.text.numbers import checked_whole


@dataclass(frozen=True)
class TreeSize:
    """Nodes of a search, estimated from `samples` subtrees of which `walked` nodes were walked.

    `error` is the standard error of the mean, in nodes.
    """

    nodes: float
    error: float
    samples: int
    walked: int


def estimate_nodes(spec: SearchSpec, depth: int, samples: int, seed: int = 1) -> TreeSize:
    """Return the nodes of a search, from so many subtrees that begin with `depth` pins.

    What a front would cut is not known beforehand: only conditions count.

    >>> from symbalance.search.cranks_search import search_cranks, search_spec
    >>> asked = {"strokes": 2, "limit": ["couple.1<=1"], "compiled": False}
    >>> size = estimate_nodes(search_spec(8, **asked), 3, 200)
    >>> abs(size.nodes - search_cranks(8, **asked).tally.nodes) < 3 * size.error
    True
    """
    checked_whole(samples, "samples", 2, 10**6, "subtrees that are walked")
    checked_whole(depth, "depth", 1, spec.problem.pin_count, "pins of a beginning")
    random, sizes, walked = Random(seed), [], 0
    mark = digest(spec)  # parts of one mark share their tables
    for _ in range(samples):
        total = 0.0
        for place, pattern in enumerate(spec.problem.patterns):
            prefix, weight = (0,), 1
            while len(prefix) < depth and weight:
                longer = list(beginnings(spec, pattern.capacity, prefix))
                weight *= len(longer)
                prefix = random.choice(longer) if longer else prefix
                total += weight  # the nodes of the beginnings themselves
            if weight:
                nodes = search_part(SearchPart(spec, place, prefix, mark))["nodes"]
                walked += nodes
                total += weight * max(0, nodes - depth)
        sizes.append(total)
    mean = sum(sizes) / samples
    spread = sum((size - mean) ** 2 for size in sizes) / (samples - 1)
    return TreeSize(mean, sqrt(spread / samples), samples, walked)
