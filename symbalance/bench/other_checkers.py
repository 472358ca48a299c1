"""The same single lines judged by this checker, by SymPy, and by latex2sympy2_extended with math-verify.

`single_lines.toml` holds relations of other people's pages, as they were typed, that are true or false
whatever stands around them. Each program gets both sides. SymPy reads no LaTeX by itself: `simplify` and
`equals` are given what this checker has read. math-verify and its reader are measured where they are
installed (`pip install math-verify`); nothing else needs them.

A line is read rightly if both sides have the values that are listed, judged rightly if what is true is
called equal and what is false different. Silently wrong is the opposite of the truth without a word;
everything else (refused, undecided, out of time) is no answer.
"""

from __future__ import annotations

import multiprocessing
import time
import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from importlib.util import find_spec
from typing import Any

LIMIT = 10.0
"""Seconds for a line, after which there is no answer."""
CLOSE = 1e-9
PROVED, DIFFERENT, NO_ANSWER = "proved", "shown different", "no answer"
OURS = "symbalance"
SIMPLIFY, EQUALS = "SymPy simplify, read by symbalance", "SymPy equals, read by symbalance"
LATEX_SIMPLIFY = "latex2sympy2_extended, SymPy simplify"
MATH_VERIFY = "latex2sympy2_extended, math-verify"
WAYS = (OURS, SIMPLIFY, EQUALS, LATEX_SIMPLIFY, MATH_VERIFY)
NEEDS = {LATEX_SIMPLIFY: "latex2sympy2_extended", MATH_VERIFY: "math_verify"}


@dataclass(frozen=True)
class SingleLine:
    """A relation that stands alone: both sides as typed, the truth, and their values at a point."""

    left: str
    right: str
    is_true: bool
    point: Mapping[str, float]
    values: tuple[float, float]


@dataclass(frozen=True)
class Answer:
    """What a program made of a line: whether it read it rightly, its answer, its processor time."""

    is_read: bool
    answer: str
    seconds: float


def single_lines() -> list[SingleLine]:
    """Return the lines that come with the package.

    >>> len(single_lines()) > 100
    True
    """
    source = (files("symbalance.bench") / "single_lines.toml").read_text(encoding="utf-8")
    return [
        SingleLine(row["left"], row["right"], row["is_true"], row["point"], tuple(row["values"]))
        for row in tomllib.loads(source)["line"]
    ]


@dataclass(frozen=True)
class Comparison:
    """The table of all programs, and a line on each that is not installed."""

    lines: Sequence[SingleLine]
    answers: Mapping[str, Sequence[Answer]]
    missing: Sequence[str]

    def counts(self, way: str) -> tuple[int, int, int, int]:
        """Return how many lines are read rightly, judged rightly, silently wrong, not answered."""
        read = right = wrong = 0
        for line, given in zip(self.lines, self.answers[way], strict=True):
            read += given.is_read
            right += given.answer == (PROVED if line.is_true else DIFFERENT)
            wrong += given.answer == (DIFFERENT if line.is_true else PROVED)
        return read, right, wrong, len(self.lines) - right - wrong

    def text(self) -> str:
        """Return the table, with processor times in seconds and over that of this checker."""
        false = sum(not line.is_true for line in self.lines)
        title = f"{len(self.lines)} single lines of other people's pages, {false} of them false"
        columns = ("read rightly", "judged rightly", "silently wrong", "no answer", "CPU s", "ratio")
        rows = [title, "─" * len(title), f"{'':<40}" + "".join(f"{each:>16}" for each in columns)]
        own = sum(each.seconds for each in self.answers[OURS])
        for way, given in self.answers.items():
            seconds = sum(each.seconds for each in given)
            cells = [*map(str, self.counts(way)), f"{seconds:.2f}", f"{seconds / own:.1f}"]
            rows.append(f"{way:<40}" + "".join(f"{cell:>16}" for cell in cells))
        return "\n".join([*rows, *self.missing])


def compare_checkers(every: int = 1, ways: Sequence[str] = WAYS) -> Comparison:
    """Let every program that is installed judge every so-many-th line, each in a process of its own."""
    lines = single_lines()[::every]
    absent = {way: NEEDS[way] for way in ways if way in NEEDS and find_spec(NEEDS[way]) is None}
    missing = [f"{way}: not installed; pip install math-verify" for way in absent]
    answers = {way: list(_answers(way, lines)) for way in ways if way not in absent}
    return Comparison(lines, answers, missing)


def _answers(way: str, lines: Sequence[SingleLine]) -> Iterator[Answer]:
    """Yield the answers of a program, whose process is ended and begun anew at the limit."""
    context = multiprocessing.get_context("spawn")

    def begin() -> tuple[Any, Any]:
        pipe, far_end = context.Pipe()
        process = context.Process(target=_serve, args=(far_end, way), daemon=True)
        process.start()
        pipe.recv()
        return pipe, process

    pipe, process = begin()
    try:
        for line in lines:
            pipe.send(line)
            if pipe.poll(LIMIT):
                yield pipe.recv()
            else:
                process.kill()
                process.join()
                yield Answer(False, NO_ANSWER, LIMIT)
                pipe, process = begin()
    finally:
        process.kill()
        process.join()


def _serve(pipe: Any, way: str) -> None:
    judge = _JUDGES[way]
    judge(SingleLine("x", "x", True, {"x": 0.5}, (0.5, 0.5)))  # loads what it needs, untimed
    pipe.send("ready")
    while True:
        line = pipe.recv()
        start = time.process_time()
        try:
            is_read, answer = judge(line)
        except Exception:  # whatever a program stumbles over, it has not answered
            is_read, answer = False, NO_ANSWER
        pipe.send(Answer(is_read, answer, time.process_time() - start))


# The programs


def _by_symbalance(line: SingleLine) -> tuple[bool, str]:
    from symbalance.notes.checking import check
    from symbalance.notes.checking.verdicts import PROVED_WORDS, REFUTED

    checked = check(f"$$ {line.left} = {line.right} $$", dict.fromkeys(line.point, "variable"))
    if len(checked.verdicts) != 1:
        return False, NO_ANSWER
    word = checked.verdicts[0].verdict
    answer = PROVED if word in PROVED_WORDS else DIFFERENT if word == REFUTED else NO_ANSWER
    chains = checked.derivation.chains
    is_read = len(chains) == 1 and _have_values(line, [side.node for side in chains[0].sides])
    return is_read, answer


def _have_values(line: SingleLine, nodes: Sequence[Any]) -> bool:
    """Tell whether formulas of ours have the values listed, by the arithmetic of Python's floats."""
    from symbalance.notes.checking.repair.numeric_filter import NumericFilter

    numeric = NumericFilter({name: [complex(value)] for name, value in line.point.items()}, 1)
    return _agree(line, [numeric.values(node)[0] for node in nodes])


def _agree(line: SingleLine, values: Sequence[complex]) -> bool:
    pairs = zip(values, line.values, strict=True)
    return all(abs(complex(a) - b) <= CLOSE * max(abs(b), 1.0) for a, b in pairs)


def _sides_by_symbalance(line: SingleLine) -> tuple[Any, Any, bool]:
    from symbalance.bench.sympy_decisions import SympyConverter
    from symbalance.notes.reading import read_document

    page = read_document(f"$$ {line.left} = {line.right} $$", "", lambda _: set(line.point))
    (chain,) = page.chains
    left, right = (SympyConverter().of(side.node) for side in chain.sides)
    return left, right, _have_values(line, [side.node for side in chain.sides])


def _by_simplify(line: SingleLine) -> tuple[bool, str]:
    left, right, is_read = _sides_by_symbalance(line)
    return is_read, _simplified(left - right)


def _by_equals(line: SingleLine) -> tuple[bool, str]:
    left, right, is_read = _sides_by_symbalance(line)
    is_zero = (left - right).equals(0)
    return is_read, NO_ANSWER if is_zero is None else PROVED if is_zero else DIFFERENT


def _simplified(difference: Any) -> str:
    import sympy

    rest = sympy.simplify(difference)
    if rest == 0:
        return PROVED
    letters = sorted(rest.free_symbols, key=str)
    point = {letter: sympy.Rational(3 + 2 * k, 7 + k) for k, letter in enumerate(letters)}
    value = sympy.N(rest.subs(point), 30)
    return DIFFERENT if value.is_number and abs(value) > sympy.Float("1e-20") else NO_ANSWER


def _by_latex_simplify(line: SingleLine) -> tuple[bool, str]:
    from latex2sympy2_extended import latex2sympy  # pyright: ignore[reportMissingImports]

    left, right = latex2sympy(line.left), latex2sympy(line.right)
    is_read = _agree(line, [_value(left, line.point), _value(right, line.point)])
    return is_read, _simplified(left - right)


def _by_math_verify(line: SingleLine) -> tuple[bool, str]:
    from math_verify import parse, verify  # pyright: ignore[reportMissingImports]

    left, right = (parse(f"${side}$") for side in (line.left, line.right))
    if not left or not right:
        return False, NO_ANSWER
    try:
        is_read = _agree(line, [_value(left[0], line.point), _value(right[0], line.point)])
    except (TypeError, ValueError, AttributeError):  # it has read something that has no value there
        is_read = False
    return is_read, PROVED if verify(left, right) else DIFFERENT


def _value(expression: Any, point: Mapping[str, float]) -> complex:
    """Return the value of what another reader has read, its letters by the names we have for them."""
    from symbalance.notes.reading import canonical_name

    names = {letter: canonical_name(str(letter)) for letter in expression.free_symbols}
    return complex(expression.subs({letter: point[name] for letter, name in names.items()}).doit())


_JUDGES: Mapping[str, Callable[[SingleLine], tuple[bool, str]]] = {
    OURS: _by_symbalance,
    SIMPLIFY: _by_simplify,
    EQUALS: _by_equals,
    LATEX_SIMPLIFY: _by_latex_simplify,
    MATH_VERIFY: _by_math_verify,
}
