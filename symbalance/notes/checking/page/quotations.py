"""Lines that quote what stands above: > F2 = 4318 N in the answer to a mail claims nothing anew.

A quoted relation that repeats one above has the verdict of that one, and says which line it repeats; what
is quoted and stands nowhere above is judged as any other line. Nor does a quotation prove anything: what
is true only because the same formula is given above stays given.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, field, replace
from functools import cached_property

from symbalance.document.formula import Formula, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.verdicts import BAD, CONTRADICTION, PROVED_WORDS, STATED, Verdict
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_MARKED = re.compile(r"^[ ]{0,3}>(?!=)[^\n]*$", re.MULTILINE)
_SET_OFF = re.compile(
    r"\[quote\b[^\]\n]*\].*?\[/quote\]|<blockquote\b[^<>]*>.*?</blockquote\s*>|^#\+begin_quote\b.*?^#\+end_quote",
    re.IGNORECASE | re.DOTALL | re.MULTILINE,
)
_WORST = (REFUTED, CONTRADICTION, UNDECIDED)


@dataclass
class Quotations:
    """The quotations of a page, and the relations that have been judged so far."""

    document: ReadNotes
    judged: dict[Formula, list[tuple[Chain, list[Verdict]]]] = field(default_factory=dict)
    """The chains with their verdicts, by each formula that stands behind a relation sign in them."""

    @cached_property
    def _spans(self) -> list[tuple[int, int]]:
        """The quoted stretches of the page, in order; those that overlap are one."""
        text, spans = self.document.text, list[tuple[int, int]]()
        for span in sorted(m.span() for p in (_MARKED, _SET_OFF) for m in p.finditer(text)):
            if spans and span[0] <= spans[-1][1]:
                spans[-1] = (spans[-1][0], max(spans[-1][1], span[1]))
            else:
                spans.append(span)
        return spans

    def is_quoted(self, place: int) -> bool:
        """Tell whether a place of the text is quoted from above or from another's letter."""
        before = bisect_right(self._spans, place, key=lambda span: span[0]) - 1
        return before >= 0 and place < self._spans[before][1]

    def note(self, chain: Chain, verdicts: list[Verdict]) -> None:
        """Note a chain with its verdicts, one a relation."""
        if len(verdicts) == len(chain.relations):
            for node in {side.node for side in chain.sides[1:]}:
                self.judged.setdefault(node, []).append((chain, verdicts))

    def verdicts(self, chain: Chain) -> list[Verdict] | None:
        """Return the verdicts on a chain that quotes a wrong one above, None for any other."""
        if not chain.relations or not self.is_quoted(chain.sides[0].span[0]):
            return None
        repeated = [self._repeated(chain, k) for k in range(len(chain.relations))]
        above = [verdict for verdict in repeated if verdict is not None]
        if len(above) < len(repeated) or not any(verdict.verdict in BAD for verdict in above):
            return None
        return [self._verdict(chain, k, verdict) for k, verdict in enumerate(above)]

    def without_echoes(self, chain: Chain, verdicts: list[Verdict]) -> list[Verdict]:
        """Return the verdicts on a chain; what is proved by a formula that it only quotes is given."""
        if not verdicts or not self.is_quoted(chain.sides[0].span[0]):
            return verdicts
        return [
            verdict if (above := self._only_stated(chain, k, verdict)) is None else above
            for k, verdict in enumerate(verdicts[: len(chain.relations)])
        ] + verdicts[len(chain.relations) :]

    def repeats_stated(self, chain: Chain) -> bool:
        """Tell whether a chain quotes a formula that is only given above."""
        above = self._repeated(chain, 0) if self.is_quoted(chain.sides[0].span[0]) else None
        return above is not None and above.verdict in STATED

    def _only_stated(self, chain: Chain, k: int, verdict: Verdict) -> Verdict | None:
        """Return the verdict as something given, if it is proved by what the same formula says above."""
        if verdict.verdict not in PROVED_WORDS or verdict.assumption:
            return None
        above = self._repeated(chain, k) or self._in_other_signs(chain, k)
        if above is None or above.verdict not in STATED:
            return None
        stated = Decision(above.verdict, f"quotes line {above.line}")
        return describe(self.document, chain, k, stated)

    def _in_other_signs(self, chain: Chain, k: int) -> Verdict | None:
        """Return the verdict on the nearest formula above of the same letter in the same letters.

        F = m r ω² (1 + r/l) may be quoted as F = (1 + r/l) m r ω².
        """
        left, letters = chain.sides[k].node, names(chain.sides[k + 1].node)
        near = [
            (earlier.lines[0], verdicts[n])
            for chains in self.judged.values()
            for earlier, verdicts in chains
            for n, side in enumerate(earlier.sides[:-1])
            if side.node == left
            and names(earlier.sides[n + 1].node) == letters
            and letters
            and earlier.lines[0] < chain.lines[0]
        ]
        return max(near, key=lambda each: each[0], default=(0, None))[1]

    def _repeated(self, chain: Chain, k: int) -> Verdict | None:
        """Return the worst verdict on what the k-th relation of a chain repeats from above."""
        left, right, sign = chain.sides[k].node, chain.sides[k + 1].node, chain.relations[k].sign
        for earlier, verdicts in reversed(self.judged.get(right, ())):
            nodes = [side.node for side in earlier.sides]
            first = next((n for n, node in enumerate(nodes) if node == left), len(nodes))
            last = next((n for n in range(first + 1, len(nodes)) if nodes[n] == right), 0)
            signs = {relation.sign for relation in earlier.relations[first:last]}
            if last and (sign in signs) and earlier.lines[0] < chain.lines[0]:
                way = verdicts[first:last]
                return min(
                    way, key=lambda v: _WORST.index(v.verdict) if v.verdict in _WORST else len(_WORST)
                )
        return None

    def _verdict(self, chain: Chain, k: int, above: Verdict) -> Verdict:
        word = above.verdict.replace("_", " ")
        reason = f"quotes line {above.line}" + (f", which is {word}" if above.verdict in BAD else "")
        decision = above.decision or Decision(above.verdict)
        repeated = replace(decision, status=above.verdict, reason=reason)
        verdict = describe(self.document, chain, k, repeated)
        return replace(
            verdict, verdict=above.verdict, exact=above.exact, fix=None, assumption=above.assumption
        )
