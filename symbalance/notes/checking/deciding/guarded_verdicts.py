"""A page's budget of time and memory: a relation that takes too much, or fails, is undecided."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document.formula import Span
from symbalance.errors import SymbalanceError
from symbalance.notes.checking.deciding.descriptions import undecided, undecided_by_fault
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.reading.equations import ReadNotes

PAGE = Budget(600, 4000)
"""What a whole document may take, where nobody says otherwise."""

RELATIONS, IN_MEMORY = 60, 4
"""A relation may take a 60th of the document's time, 10 s as a rule, and a quarter of its memory: one
that needs more is no line of a derivation, and the others are still to be judged."""


@dataclass
class Guard:
    """Keeps the verdicts on a page within its budget of seconds that the thread computes from now on."""

    document: ReadNotes
    budget: Budget

    def __post_init__(self) -> None:
        self.start = time.thread_time()

    def verdict(self, judge: Callable[[], Verdict], span: Span, line: int = 0) -> Verdict:
        """Return a verdict; one that takes too much, or a fault of the checker, is "undecided"."""
        at = line or self.document.line_of(span[0])
        left = self._time_left()
        if left is not None and left <= 0:
            reason = f"not judged: the document's budget of {self.budget} was spent before; see --budget"
            return undecided(self.document, span, at, reason)
        try:
            return run_within(self._budget_of_relation(left), judge)
        except OverBudgetError as problem:
            reason = f"not judged within its budget of {problem.spent}; --budget gives it more"
            return undecided(self.document, span, at, reason)
        except MemoryError:
            return undecided(self.document, span, at, "not judged: it needs more memory than there is")
        except SymbalanceError:
            raise  # a declaration that cannot be used
        except Exception as problem:
            return undecided_by_fault(self.document, span, at, problem)

    def _time_left(self) -> float | None:
        """Return the seconds left of the document's budget, None where it has no end."""
        if self.budget.seconds is None:
            return None
        return self.budget.seconds - (time.thread_time() - self.start)

    def _budget_of_relation(self, left: float | None) -> Budget:
        seconds, memory = self.budget
        return Budget(
            None if seconds is None or left is None else min(seconds / RELATIONS, left),
            None if memory is None else memory / IN_MEMORY,
        )
