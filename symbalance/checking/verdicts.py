"""Verdicts: what is said of each relation of a document, in one vocabulary."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from symbalance.reading.equations import Document
from symbalance.reading.syntax import Node, Span

HOLDS = "holds"
HOLDS_TO_ORDER = "holds_to_order"
CONDITIONAL = "conditional"
REFUTED = "refuted"
UNDECIDED = "undecided"
DEFINITION = "definition"
UNREADABLE = "unreadable"

VERDICTS = (HOLDS, HOLDS_TO_ORDER, CONDITIONAL, REFUTED, UNDECIDED, DEFINITION, UNREADABLE)
BAD = (REFUTED, UNDECIDED)


@dataclass(frozen=True, slots=True)
class Difference:
    """One coefficient in which a line differs: of which term, what is claimed and what is exact."""

    term: str
    claimed: str
    exact: str


@dataclass(frozen=True, slots=True)
class Fault:
    """A piece of a line that is wrong, and what should stand there."""

    line: int
    column: int
    source: str
    should: str
    kind: str = ""


@dataclass(frozen=True, slots=True)
class Fix:
    """The smallest change found that makes a line true; `node` is the whole corrected side, proved."""

    kind: str
    text: str
    node: Node
    faults: tuple[Fault, ...] = ()


@dataclass(frozen=True, slots=True)
class Verdict:
    """What is said of one relation, or of a piece of a line bound to a quantity."""

    line: int
    link: int
    source: str
    verdict: str
    reason: str = ""
    order: str = ""
    assumption: str = ""
    claimed: str = ""
    exact: str = ""
    witness: Mapping[str, str] = field(default_factory=dict)
    differences: tuple[Difference, ...] = ()
    fix: Fix | None = None
    lines: tuple[int, ...] = ()
    column: int = 1
    bind: str = ""
    piece: bool = False
    inline: bool = False
    notes: tuple[str, ...] = ()
    tag: str = ""
    span: Span = (0, 0)
    node: Node | None = None

    @property
    def is_bad(self) -> bool:
        """Tell whether the verdict makes the check fail."""
        return self.verdict in BAD


@dataclass(frozen=True, slots=True)
class Checked:
    """A document with all its verdicts, in the order of their lines."""

    document: Document
    verdicts: tuple[Verdict, ...]

    @property
    def failed(self) -> bool:
        """Tell whether anything is refuted or undecided."""
        return any(v.is_bad for v in self.verdicts)

    def counted(self) -> dict[str, int]:
        """Return how many verdicts of each kind there are, zeros left out."""
        counts = {name: sum(v.verdict == name for v in self.verdicts) for name in VERDICTS}
        return {name: count for name, count in counts.items() if count}

    def at(self, line: int) -> tuple[Verdict, ...]:
        """Return the verdicts whose relation stands on a line, or that cover it."""
        return tuple(v for v in self.verdicts if v.line == line or line in v.lines)
