"""The assignment problem: each row to a column of its own at least cost.

Shortest augmenting paths with potentials (H. W. Kuhn, Naval Research Logistics Quarterly 2 (1955),
83-97; R. Jonker and A. Volgenant, Computing 38 (1987), 325-340).
"""

from __future__ import annotations

from collections.abc import Sequence


def least_matching(costs: Sequence[Sequence[float]]) -> tuple[int, ...]:
    """Return, for each column, the row that it goes to when the sum of costs[row][column] is least.

    >>> least_matching([[4.0, 1.0, 3.0], [2.0, 0.0, 5.0], [3.0, 2.0, 2.0]])
    (1, 0, 2)
    """
    count = len(costs)
    rows, columns = [0.0] * (count + 1), [0.0] * (count + 1)
    owner = [count] * (count + 1)  # the row of each column; the last column is a place to start from
    for row in range(count):
        _augment(costs, row, rows, columns, owner)
    return tuple(owner[:count])


def _augment(
    costs: Sequence[Sequence[float]], row: int, rows: list[float], columns: list[float], owner: list[int]
) -> None:
    """Give one more row a column, moving others along the cheapest path."""
    count = len(costs)
    owner[count] = row
    column, before = count, [count] * count
    least, used = [float("inf")] * count, [False] * (count + 1)
    while True:
        used[column] = True
        here, nearest, step = owner[column], count, float("inf")
        for j in range(count):
            if used[j]:
                continue
            cost = costs[here][j] - rows[here] - columns[j]
            if cost < least[j]:
                least[j], before[j] = cost, column
            if least[j] < step:
                nearest, step = j, least[j]
        for j in range(count + 1):
            if used[j]:
                rows[owner[j]] += step
                columns[j] -= step
            elif j < count:
                least[j] -= step
        column = nearest
        if owner[column] == count:
            break
    while column != count:
        owner[column] = owner[before[column]]
        column = before[column]
