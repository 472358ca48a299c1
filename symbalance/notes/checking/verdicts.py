"""Verdicts: what is said of each relation of a document, in one vocabulary."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from symbalance.document.formula import Formula, Span
from symbalance.notes.reading.equations import Document

HOLDS = "holds"
HOLDS_TO_ORDER = "holds_to_order"
CONDITIONAL = "conditional"
REFUTED = "refuted"
UNDECIDED = "undecided"
DEFINITION = "definition"
UNREADABLE = "unreadable"

VERDICTS = (HOLDS, HOLDS_TO_ORDER, CONDITIONAL, REFUTED, UNDECIDED, DEFINITION, UNREADABLE)
BAD = (REFUTED, UNDECIDED)
FAILING = (*BAD, UNREADABLE)
"""What a document that is right throughout has none of; the unreadable may be forgiven."""


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
    node: Formula
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
    node: Formula | None = None
    fault: str = ""
    """A fault of symbalance that kept the relation from being judged or mended."""
    traceback: str = ""

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
        """Tell whether no relation was seen, or one is refuted, undecided or unreadable."""
        return self.fails()

    def fails(self, *, lenient: bool = False) -> bool:
        """Tell whether the document is not to be relied on; `lenient` forgives the unreadable.

        It does not forgive a document of which nothing could be read: of that nothing was judged.
        """
        failing = BAD if lenient else FAILING
        judged = any(v.verdict != UNREADABLE for v in self.verdicts)
        return not judged or any(v.verdict in failing for v in self.verdicts)

    @property
    def seen(self) -> int:
        """The number of relations seen, whatever their verdict."""
        return len(self.verdicts)

    @property
    def faults(self) -> tuple[Verdict, ...]:
        """The verdicts that a fault of symbalance left undecided, or without a correction."""
        return tuple(v for v in self.verdicts if v.fault)

    def counted(self) -> dict[str, int]:
        """Return how many verdicts of each kind there are, zeros left out."""
        counts = {name: sum(v.verdict == name for v in self.verdicts) for name in VERDICTS}
        return {name: count for name, count in counts.items() if count}

    def at(self, line: int) -> tuple[Verdict, ...]:
        """Return the verdicts whose relation stands on a line, or that cover it."""
        return tuple(v for v in self.verdicts if v.line == line or line in v.lines)
