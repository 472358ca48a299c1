"""Verdicts on the relations of a document, with witnesses, differences and corrections."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import partial
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.formula import Formula, Span
from symbalance.document.result import Result
from symbalance.notes.reading.equations import ReadNotes
from symbalance.text import lazy_patterns as re

if TYPE_CHECKING:
    from symbalance.document import nodes
    from symbalance.document.nodes import Words
    from symbalance.notes.checking.deciding.equality import Decision

HOLDS = "holds"
HOLDS_TO_ORDER = "holds_to_order"
CONDITIONAL = "conditional"
REFUTED = "refuted"
UNDECIDED = "undecided"
DEFINITION = "definition"
PREMISE = "premise"
CONDITION = "condition"
RANGE = "range"
CONTRADICTION = "contradiction"
UNREADABLE = "unreadable"
NOT_MATHEMATICS = "not_mathematics"
"""No verdict, but counted: a relation sign between words, in a tag or in program code."""

PROVED_WORDS = (HOLDS, HOLDS_TO_ORDER, CONDITIONAL)
STATED = (DEFINITION, PREMISE, CONDITION, RANGE)
"""What a relation may be that claims nothing: it gives a letter its value (definition), is taken as given
(premise), is an equation to be solved (condition), or says where a letter lies (range)."""
BAD = (REFUTED, CONTRADICTION, UNDECIDED)
VERDICTS = (*PROVED_WORDS, REFUTED, CONTRADICTION, UNDECIDED, *STATED, UNREADABLE)
FAILING = (*BAD, UNREADABLE)
"""What a document that is right throughout has none of; the unreadable may be forgiven."""
UNDECLARED = re.compile(r"letter (\S+) is not declared")
"""In the reason of what is unreadable: the letter that nobody has given a meaning."""
DECLARES_NOTHING = "Declares nothing: "
"""Before a report's remark on a line of the symbols file that names no letter."""
TO_ITS_RIGHT = "the relation to its right"
"""Begins the reason of an arrow that fails because the relation it leads to does: that one is listed."""
MOST_LETTERS = 12
"""Letters that a report names of them; a draft of the symbols file has all."""


DECLARE_IT = "declare what it means"
"""What the reason ends with where a letter is on one side only that nobody declared."""


@dataclass(frozen=True, slots=True)
class Difference:
    """One coefficient in which a line differs: of which term, what is claimed and what is exact.

    The nodes are the same as formulas; None for the constant term, and for a number that has no form.
    """

    term: str
    claimed: str
    exact: str
    term_node: Formula | None = field(default=None, repr=False)
    claimed_node: Formula | None = field(default=None, repr=False)
    exact_node: Formula | None = field(default=None, repr=False)


@dataclass(frozen=True, slots=True)
class Fault:
    """A piece of a line that is wrong, and what should stand there; `node` is that as a formula."""

    line: int
    column: int
    source: str
    should: str
    kind: str = ""
    node: Formula | None = field(default=None, repr=False)
    is_first: bool = True
    """Whether nothing stands before it that a sign would join it to."""


@dataclass(frozen=True, slots=True)
class Fix:
    """The smallest change that makes a line true; `node` is the whole corrected side, proved.

    `of_left` tells that it is the left side of the relation that is corrected. `words` say what is wrong
    as a teacher would.
    """

    kind: str
    text: str
    node: Formula
    faults: tuple[Fault, ...] = ()
    of_left: bool = False
    words: str = ""


@dataclass(frozen=True, slots=True, repr=False)
class Verdict(Result):
    """The verdict on one relation, or of a piece of a line bound to a quantity."""

    kind: ClassVar[str] = "verdict"

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
    exact_node: Formula | None = None
    """`exact` as a formula."""
    cell: tuple[int, int] | None = None
    """In a notebook: the cell, from 1, and the line in it."""
    fault: str = ""
    """A fault of symbalance that kept the relation from being judged or corrected."""
    traceback: str = ""
    is_unjudged: bool = False
    """Whether judging was not finished: by its budget, or by a fault."""
    sign: str = ""
    """Of an arrow between two relations: ⇒ or ⇔. Its `source` is the relation to its right."""
    left: str = ""
    """The relation to the left of an arrow."""
    decision: Decision | None = field(default=None, repr=False, compare=False)
    """What it rests on: the two sides' normal forms, which are drawn and certified."""

    def __reduce__(self) -> tuple[Any, ...]:
        """Leave out the decision, whose forms belong to this process's calculation."""
        values = {each.name: getattr(self, each.name) for each in fields(self)}
        return partial(type(self), **{**values, "decision": None}), ()

    @property
    def is_bad(self) -> bool:
        """Tell whether the verdict makes the check fail."""
        return self.verdict in BAD

    def summary(self) -> str:
        """Return the line, its verdict and the correction, in one line."""
        from symbalance.notes.checking.reports.report_document import verdict_summary

        return verdict_summary(self)

    def document(self) -> nodes.Document:
        """Return what stands, the verdict on it with its reasons, and what should stand."""
        from symbalance.notes.checking.reports.report_document import verdict_document

        return verdict_document(self)

    def data(self) -> dict[str, Any]:
        """Return the verdict with its witness, differences and correction as texts."""
        from symbalance.notes.checking.reports.report_data import verdict_data

        return verdict_data(self)

    def records(self) -> list[dict[str, Any]]:
        """Return the verdict as one row."""
        from symbalance.notes.checking.reports.report_data import verdict_records

        return verdict_records((self,))


@dataclass(frozen=True, slots=True, repr=False)
class Checked(Result):
    """A derivation with all its verdicts, in the order of their lines."""

    derivation: ReadNotes
    verdicts: tuple[Verdict, ...]
    remarks: tuple[Words, ...] = ()
    """What a reader must know before the verdicts: what they rest on, what is still to be declared."""
    unread_letters: int = 0
    """How many lines of the symbols file declare nothing, as what they name is no letter."""

    kind: ClassVar[str] = "check"

    def summary(self) -> str:
        """Return how many relations were seen and how many verdicts there are of each kind."""
        from symbalance.notes.checking.reports.report_document import report_summary

        return report_summary(self)

    def document(self) -> nodes.Document:
        """Return the counts, then every relation with its verdict, its reasons and its correction."""
        from symbalance.notes.checking.reports.report_document import report_document

        return report_document(self)

    def browser_document(self) -> nodes.Document:
        """Return the author's own page, typeset, each relation marked; what is wrong stands first."""
        from symbalance.notes.checking.reports.marked_page import marked_page

        return marked_page(self)

    def data(self) -> dict[str, Any]:
        """Return the counts, and an entry for each relation and each line that continues one."""
        from symbalance.notes.checking.reports.report_data import report_data

        return report_data(self)

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each verdict."""
        from symbalance.notes.checking.reports.report_data import verdict_records

        return verdict_records(self.verdicts)

    @property
    def failed(self) -> bool:
        """Tell whether no relation was seen, or one is of the verdicts that fail."""
        return self.fails()

    def fails(self, *, lenient: bool = False) -> bool:
        """Tell whether the document is not to be relied on; `lenient` forgives the unreadable.

        It does not forgive a document of which nothing could be read: of that nothing was judged.
        """
        failing = BAD if lenient else FAILING
        is_judged = any(v.verdict != UNREADABLE for v in self.verdicts)
        is_unread = bool(self.unread_letters) and not lenient
        return not is_judged or is_unread or any(v.verdict in failing for v in self.verdicts)

    @property
    def relation_count(self) -> int:
        """The number of relation signs seen, those of no mathematics among them."""
        return len(self.verdicts) + len(self.derivation.not_mathematics)

    @property
    def faults(self) -> tuple[Verdict, ...]:
        """The verdicts that a fault of symbalance left undecided, or without a correction."""
        return tuple(v for v in self.verdicts if v.fault)

    def counts(self) -> dict[str, int]:
        """Return how many verdicts of each kind there are, zeros left out."""
        counts = {name: sum(v.verdict == name for v in self.verdicts) for name in VERDICTS}
        counts[NOT_MATHEMATICS] = len(self.derivation.not_mathematics)
        return {name: count for name, count in counts.items() if count}

    def at(self, line: int) -> tuple[Verdict, ...]:
        """Return the verdicts whose relation stands on a line, or that cover it."""
        return tuple(v for v in self.verdicts if v.line == line or line in v.lines)
