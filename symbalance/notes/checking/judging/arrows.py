r"""Arrows between two relations, F = 0 ⇒ x = 3: each has a verdict of its own, that of its conclusion.

What an arrow claims is that the relation to its right is true, given what stands left of it. So it holds
where that holds, or is the relation to its left rearranged; it is refuted where that is refuted. Of ⇔ the
converse counts too, which only a rearrangement shows. An arrow to or from words is no relation.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document.formula import Name, parts_of_kind
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.declared.sidecar import Declarations
from symbalance.notes.checking.declared.symbols import meaning_of
from symbalance.notes.checking.judging.rearrangements import rearrangement
from symbalance.notes.checking.verdicts import (
    CONDITIONAL,
    CONTRADICTION,
    DEFINITION,
    HOLDS,
    PROVED_WORDS,
    REFUTED,
    STATED,
    TO_ITS_RIGHT,
    UNDECIDED,
    UNREADABLE,
    Checked,
    Verdict,
)
from symbalance.notes.reading.equations import Chain, ReadNotes, Unreadable
from symbalance.text import lazy_patterns as re

IMPLIES, EQUIVALENT = "⇒", "⇔"
WIDEST_GAP = 200
"""Characters between two relations with an arrow between them."""
COMPARISON = Budget(2)
"""For the relations of one arrow; what takes longer is not shown."""
MOST_COMPARED = 400
"""Arrows of one page whose relations are compared with each other."""
_ARROW = re.compile(
    r"(?P<both>[⇔⟺]|\\(?:Leftrightarrow|Longleftrightarrow|iff)(?![A-Za-z])|(?:<|&lt;)=+(?:>|&gt;)"
    r"|&(?:hArr|iff|Leftrightarrow|DoubleLeftRightArrow|#8660|#[xX]21[dD]4);)"
    r"|(?P<one>[⇒⟹]|\\(?:Rightarrow|Longrightarrow|implies)(?![A-Za-z])|=+(?:>|&gt;)"
    r"|&(?:rArr|Rightarrow|DoubleRightArrow|#8658|#[xX]21[dD]2);)"
)
_SETTING = (
    r"[\s$&,.;:()\[\]{}|*_`~。、，；-]|\\[,;:! \\()\[\]]|<[^<>\n]{1,80}>|(?<=\n)>|^>"
    r"|\\(?:begin|end|label|tag|hspace|vspace)\*?\{[^{}\n]{0,40}\}"
    r"|\\(?:q?quad|displaystyle|left|right|boxed|fbox|nonumber|notag|hfill|par|noindent|medskip|smallskip"
    r"|bigskip|item)(?![A-Za-z])"
)
_REMARK = r"\([^()\n=]{1,60}\)|\\(?:text|mathrm|mbox|textrm)\s?\{[^{}\n=]{0,60}\}"
_BEFORE = re.compile(rf"(?:{_REMARK}|{_SETTING})*+(?:[^\W\d_]{{1,20}}\.?(?:{_SETTING})*+){{0,3}}")
_HENCE = (
    r"(?:so|hence|thus|then|therefore|also|that|we|it|get|have|follows|daher|somit|folglich|wir|erhalten|folgt"
    r"|donc|alors)(?![A-Za-z])"
)
_BEHIND = re.compile(
    rf"(?:{_SETTING}|{_HENCE}|\\(?:text|mathrm|mbox|textrm)\s?\{{\s*(?:{_HENCE}\s*){{1,3}}\}})*+"
)
_OWN_SPACE = re.compile(
    r"\\(?:re)?(?:newcommand|def)\*?\s*\{?(?P<name>\\[A-Za-z]+)\}?\s*"
    r"\{(?:\s|\\[,;:! ]|\\q?quad(?![a-z])|\\hspace\*?\{[^{}]*\})+\}"
)
"""A macro of the page's own that is a space: \\newcommand{\\fsp}{\\qquad}."""
_OR = re.compile(r"[\s$,)]*(?:\\text\s*\{\s*)?(?:or|oder|ou|o|eller|または|\\lor|\\vee|∨)(?![A-Za-z])")
WRONG = (REFUTED, CONTRADICTION)
_NOT_READ = f"{TO_ITS_RIGHT} is not read"


@dataclass(frozen=True, slots=True)
class Arrow:
    """An arrow, where it stands, and what stands on either side of it."""

    sign: str
    start: int
    end: int
    left: Chain | Unreadable
    right: Chain | Unreadable


def arrows_of(page: ReadNotes) -> Iterator[Arrow]:
    """Yield the arrows between two relations of a page, in its order."""
    if not _ARROW.search(page.text):
        return
    chains: list[Chain | Unreadable] = [chain for chain in page.chains if chain.relations]
    parts = sorted([*chains, *page.unreadable], key=_span)
    spaces = [re.escape(match["name"]) for match in _OWN_SPACE.finditer(page.text)]
    own_space = re.compile(rf"(?:{'|'.join(spaces)})(?![A-Za-z])" if spaces else "(?!)")
    reach, before = 0, None
    for part in parts:
        start, end = _span(part)
        if before is not None and reach <= start <= reach + WIDEST_GAP:
            arrow = _between(page.text, reach, start, own_space)
            if arrow is not None:
                sign = EQUIVALENT if arrow["both"] else IMPLIES
                yield Arrow(sign, arrow.start(), arrow.end(), before, part)
        if end >= reach:
            reach, before = end, part


def _span(part: Chain | Unreadable) -> tuple[int, int]:
    return (part.start, part.end) if isinstance(part, Chain) else part.span


def _between(text: str, start: int, end: int, own_space: re.Pattern[str]) -> re.Match[str] | None:
    """Return the one arrow in what parts two relations, None where there is more than how it is set."""
    arrows = list(_ARROW.finditer(text, start, end))
    if len(arrows) != 1:
        return None
    (arrow,) = arrows
    before, behind = (
        own_space.sub(" ", part) for part in (text[start : arrow.start()], text[arrow.end() : end])
    )
    is_set = _BEFORE.fullmatch(before) is not None and _BEHIND.fullmatch(behind) is not None
    return arrow if is_set and before.count("\n\n") + behind.count("\n\n") <= 2 else None


def with_arrows(checked: Checked, declarations: Declarations) -> Checked:
    """Return a checked page with a verdict on each arrow between two relations.

    On its line an arrow is numbered behind all the relations: theirs are what they are without it.
    """
    arrows = list(arrows_of(checked.derivation))
    if not arrows:
        return checked
    judge = _ArrowJudge(checked, declarations)
    numbers: dict[int, int] = {}
    for verdict in checked.verdicts:
        numbers[verdict.line] = max(numbers.get(verdict.line, 0), verdict.link)
    own: list[Verdict] = []
    for arrow in arrows:
        verdict = judge.verdict(arrow)
        numbers[verdict.line] = numbers.get(verdict.line, 0) + 1
        own.append(replace(verdict, link=numbers[verdict.line]))
    every = sorted((*checked.verdicts, *own), key=lambda v: (v.line, bool(v.piece), v.span))
    return replace(checked, verdicts=tuple(every))


@dataclass
class _ArrowJudge:
    checked: Checked
    declarations: Declarations
    comparisons: int = 0

    def __post_init__(self) -> None:
        self.page = self.checked.derivation
        self.verdicts = {v.span: v for v in self.checked.verdicts if not v.piece}
        self.line_starts = [0, *(m.end() for m in re.finditer("\n", self.page.text))]

    def verdict(self, arrow: Arrow) -> Verdict:
        """Return the verdict on an arrow: that of the relation to its right, given that to its left."""
        word, reason, more = self._outcome(arrow)
        line = bisect_left(self.line_starts, arrow.start + 1)
        return Verdict(
            line=line,
            link=1,
            source=self._source(arrow.right, first=True),
            verdict=word,
            reason=reason,
            order=more.order if more and word == more.verdict else "",
            assumption=more.assumption if more and word == more.verdict else "",
            witness=more.witness if more and word == REFUTED else {},
            lines=(line,),
            column=arrow.start - self.line_starts[line - 1] + 1,
            inline=isinstance(arrow.right, Chain) and arrow.right.inline,
            span=(arrow.start, arrow.end),
            cell=self.page.cell_of(line),
            left=self._source(arrow.left, first=False),
            sign=arrow.sign,
        )

    def _source(self, part: Chain | Unreadable, *, first: bool) -> str:
        """Return the relation next to an arrow as it is typed: the first of a chain, or the last."""
        if isinstance(part, Unreadable):
            return self.page.typed(part.span)
        near = part.sides[:2] if first else part.sides[-2:]
        return self.page.typed((near[0].span[0], near[1].span[1]))

    def _of(self, chain: Chain, k: int) -> Verdict | None:
        """Return the verdict on a chain's relation."""
        return self.verdicts.get(chain.sides[k + 1].span)

    def _outcome(self, arrow: Arrow) -> tuple[str, str, Verdict | None]:
        """Return an arrow's verdict, its reason, and the verdict that its order and witness are from."""
        left, right = arrow.left, arrow.right
        if isinstance(right, Unreadable):
            return UNREADABLE, _NOT_READ, None
        conclusion = self._of(right, 0)
        if conclusion is None:
            return UNDECIDED, f"{TO_ITS_RIGHT} has no verdict", None
        if isinstance(left, Unreadable):
            if arrow.sign == EQUIVALENT and conclusion.verdict not in WRONG:
                return UNDECIDED, "the relation to its left is not read", None
            return *self._by_conclusion(right, conclusion), conclusion
        return self._by_both(left, right, arrow.sign, conclusion)

    def _by_both(
        self, left: Chain, right: Chain, sign: str, conclusion: Verdict
    ) -> tuple[str, str, Verdict | None]:
        """Return the outcome of an arrow between two relations that were read."""
        by_conclusion = (*self._by_conclusion(right, conclusion), conclusion)
        is_wrong = conclusion.verdict in WRONG
        steps = (self._of(left, k) for k in range(len(left.relations)))
        is_left_wrong = any(step is not None and step.verdict in WRONG for step in steps)
        is_proved = sign == IMPLIES and conclusion.verdict in PROVED_WORDS
        if is_proved or (is_wrong and not is_left_wrong):
            return by_conclusion
        conditions, unsaid = self._rearranged(left, right, sign)
        if conditions is not None:
            word, assumption = CONDITIONAL if conditions else HOLDS, ", ".join(conditions)
            reason = "what follows from the relation to its left, which is refuted" if is_wrong else ""
            return word, reason, replace(conclusion, verdict=word, assumption=assumption)
        if is_wrong:
            why = f"both relations are refuted: whether one follows is not shown{unsaid}"
            return UNDECIDED, why, None
        if conclusion.verdict == DEFINITION and (product := self._written_as_product(left, right)):
            return UNDECIDED, f"{product} may be one letter or a product: write a space or a dot", None
        if sign == EQUIVALENT and conclusion.verdict != UNDECIDED:
            return UNDECIDED, f"the converse, from right to left, is not shown{unsaid}", None
        return by_conclusion

    def _written_as_product(self, left: Chain, right: Chain) -> str:
        """Return a word that was read as one letter and holds the conclusion's lone letter, ab and a."""
        head = right.sides[0].node
        if not isinstance(head, Name) or len(plain_letter(head.name)) > 1:
            return ""
        if _OR.match(self.page.text, right.end):
            return ""
        words = (part for side in left.sides for part in parts_of_kind(side.node, Name))
        typed = (self.page.typed(word.span) for word in words if word.name != head.name)
        return next((t for t in typed if t.isalpha() and plain_letter(head.name) in t), "")

    def _by_conclusion(self, right: Chain, conclusion: Verdict) -> tuple[str, str]:
        """Return the verdict and reason of an arrow as those of the relation to its right."""
        word, why = conclusion.verdict, f": {conclusion.reason}" if conclusion.reason else ""
        head = right.sides[0].node
        if word in WRONG:
            return word, f"{TO_ITS_RIGHT}, {self._source(right, first=True)}, is wrong{why}"
        if word == UNDECIDED:
            return word, f"{TO_ITS_RIGHT} is undecided{why}"
        if word == DEFINITION and isinstance(head, Name):
            return word, f"its conclusion introduces {plain_letter(head.name)}"
        return word, f"its conclusion is a {word}" if word in STATED else ""

    def _rearranged(self, left: Chain, right: Chain, sign: str) -> tuple[tuple[str, ...] | None, str]:
        """Return on what conditions one relation is the other rearranged, None if not shown.

        And what to say where it was not looked for to the end, "" where it was.
        """
        if self.comparisons >= MOST_COMPARED:
            return None, f"; only the first {MOST_COMPARED} arrows of a page are compared"
        self.comparisons += 1
        symbols = self.declarations.symbols_at(right.lines[0])
        positive = meaning_of(symbols)[0].positive
        compare = partial(rearrangement, left, right, positive, is_both_ways=sign == EQUIVALENT)
        try:
            return run_within(COMPARISON, compare), ""
        except OverBudgetError as problem:
            return None, f" within {problem.spent}"
