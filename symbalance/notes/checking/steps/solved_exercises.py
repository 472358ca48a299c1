r"""Equations and inequalities that are solved one after the other: 2x > 6 ⇔ x > 3. -2x > 6 ⇔ x < -3.

Each is an exercise of its own, with a letter of its own: what the one came to is not so in the next. That
they are exercises is seen where nothing but a stop, a new line or a label parts them, and both are solved
behind an arrow.
"""

from __future__ import annotations

from collections.abc import Iterator

from symbalance.document.formula import Formula, Name, names
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_GAP = re.compile(
    r"[\s$)\]]*(?:[.;。；]|\n)[\s$.;\\\[\]*_>-]*(?:(?:\(?(?:[a-h]|[ivx]{1,4}|[0-9]{1,2})[).:])[\s$\\\[\]*_]*)?"
)
"""Between the end of one exercise and the next: a stop or a new line, and perhaps a label."""
_ARROW = re.compile(
    r"[\s$&,]*(?:\\(?:[Ll]ong)?(?:[Rr]ightarrow|Leftrightarrow|leftrightarrow)(?![A-Za-z])|\\Longleftrightarrow(?![A-Za-z])"
    r"|\\(?:iff|implies)(?![A-Za-z])|[⇔⟺⇒⟹]|<?=+>)[\s$&,]*(?:\\q?quad[\s$]*)?"
)

_OR = re.compile(
    r"[\s$,)]*(?:\\text\s*\{\s*)?(?:or|oder|ou|o|u|または|\\lor|\\vee|∨)(?![A-Za-z])[\s$(}]*"
)
"""Between two solutions of one exercise."""


class SolvedExercises:
    """The exercises of a page in which an equation or inequality of one letter is solved by arrows."""

    def __init__(self, state: JudgingState) -> None:
        self.state = state
        self._before: dict[int, list[Chain]] = {}
        last: list[Chain] = []
        for exercise in self._exercises():
            if last and self._is_next(last, exercise):
                self._before[exercise[0].start] = last
            last = exercise

    def enter(self, chain: Chain) -> None:
        """Forget what the exercise before has said of its letter, where the next one begins."""
        before = self._before.get(chain.start)
        if before is None:
            return
        definitions = self.state.definitions
        own = {id(side.node) for each in before for side in each.sides}
        lines = {line for each in before for line in each.lines}
        start, end = before[0].start, before[-1].end

        def is_of_it(node: Formula, line: int) -> bool:
            is_within = start <= node.span[0] < end if node.span[0] else line in lines
            return id(node) in own or is_within

        definitions.ranges = [r for r in definitions.ranges if not is_of_it(r.right, r.line)]
        definitions.premises = [p for p in definitions.premises if not is_of_it(p.right, p.line)]
        definitions.cases = [c for c in definitions.cases if not start <= c.start < end]
        for name in chain.letters & definitions.values.keys():
            entries = definitions.values[name]
            others = [e for e in entries if not is_of_it(e.definition.node, e.definition.line)]
            if others:
                definitions.values[name] = others
            else:
                definitions.forget_all(name)

    def _exercises(self) -> Iterator[list[Chain]]:
        """Yield the runs of relations of one letter with arrows between them, in order."""
        run: list[Chain] = []
        text = self.state.document.text
        for chain in self.state.sections.in_order:
            is_of_it = bool(run) and chain.letters == run[0].letters
            if is_of_it and any(p.fullmatch(text, run[-1].end, chain.start) for p in (_ARROW, _OR)):
                run.append(chain)
                continue
            if len(run) > 1:
                yield run
            run = [chain] if _is_to_be_solved(chain) else []
        if len(run) > 1:
            yield run

    def _is_next(self, before: list[Chain], exercise: list[Chain]) -> bool:
        """Tell whether one exercise stands right behind another one about the same letter."""
        text = self.state.document.text
        is_apart = _GAP.fullmatch(text, before[-1].end, exercise[0].start) is not None
        return is_apart and before[0].letters == exercise[0].letters


def _is_to_be_solved(chain: Chain) -> bool:
    """Tell whether a chain is a relation of one letter that does not give it by itself."""
    if len(chain.letters) != 1 or not all(
        r.sign == "=" or r.sign in SATISFIED_BY for r in chain.relations
    ):
        return False
    nodes = [side.node for side in chain.sides]
    is_given = any(isinstance(node, Name) for node in nodes) and any(not names(node) for node in nodes)
    return bool(chain.relations) and not is_given
