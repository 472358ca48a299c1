"""One formula's tokens to all the trees it may mean, the usual one first."""

from __future__ import annotations

from collections import deque
from collections.abc import Collection, Sequence

from symbalance.document.formula import Formula, children
from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.terms import Terms
from symbalance.notes.reading.tokens import Token

MOST_READINGS = 8
_MOST_TRIALS = 24
DEEPEST_TREE = 100


def read_tokens(
    tokens: Sequence[Token], names: Collection[str], end: int, latex: bool = False
) -> tuple[tuple[Formula, ...], tuple[str, ...]]:
    """Return the readings of one expression and the remarks on the usual one."""
    first, readings, refusal = _read(tokens, names, (), latex, end)
    waiting, trials, notes = deque(_other_scripts(first, ())), 0, first.notes
    while waiting and len(readings) < MOST_READINGS and trials < _MOST_TRIALS:
        script = waiting.popleft()
        trials += 1
        cursor, found, _ = _read(tokens, names, script, latex, end)
        notes = notes if readings else cursor.notes
        readings.extend(node for node in found if node not in readings)
        if len(waiting) < _MOST_TRIALS:
            waiting.extend(_other_scripts(cursor, script))
    if refusal and not readings:
        raise refusal
    return tuple(readings), tuple(notes)


def _read(
    tokens: Sequence[Token], names: Collection[str], script: Sequence[int], latex: bool, end: int
) -> tuple[Terms, list[Formula], ReadingError | None]:
    """Return the tree that a script of choices leads to, in a list that is empty on a refusal."""
    cursor = Terms(tokens, names, script, latex, end)
    try:
        node = cursor.contents()
        if cursor.now is not None:
            raise cursor.unexpected()
        if _is_too_deep(node):
            raise ReadingError(node.span[0], "a formula nested too deeply", "write it in parts")
    except ReadingError as refusal:
        return cursor, [], refusal
    return cursor, [node], None


def _other_scripts(cursor: Terms, script: Sequence[int]) -> list[tuple[int, ...]]:
    """Return the scripts that differ from the one followed at one later place."""
    taken = [option for option, _ in cursor.taken[: len(script) + _MOST_TRIALS]]
    scripts: list[tuple[int, ...]] = []
    for site in range(len(script), len(taken)):
        others = range(1, cursor.taken[site][1])
        scripts.extend((*taken[:site], other) for other in others)
    return scripts


def _is_too_deep(node: Formula) -> bool:
    level = [node]
    for _ in range(DEEPEST_TREE):
        level = [part for parent in level for part in children(parent)]
        if not level:
            return False
    return True
