"""Every fault that one line of a module can have: a sign, an operator, a bound, a dropped term.

Faults are edits of the text at a place that the syntax tree names, so that a fault is one changed line
and the rest of the file stays as it is written.
"""

from __future__ import annotations

import ast
import re
from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from random import Random
from typing import Any


@dataclass(frozen=True)
class Fault:
    """One line of a module with one thing wrong."""

    path: str
    line: int
    kind: str
    before: str
    after: str
    statement: int
    """First line of the statement it stands in: what is known to run is known by that, or by the line."""
    home: tuple[str, int]
    """Name and first line of the function it stands in; `<module>` for what runs at import."""

    def planted_in(self, source: str) -> str:
        """Return the module's text with the fault in it."""
        lines = source.splitlines(keepends=True)
        ending = lines[self.line - 1][len(lines[self.line - 1].rstrip("\r\n")) :]
        if lines[self.line - 1] != self.before + ending:
            raise ValueError(f"{self.path}:{self.line}: is not the line that the fault was made for")
        lines[self.line - 1] = self.after + ending
        return "".join(lines)


@dataclass(frozen=True)
class _Edit:
    """Bytes of the source from `start` to `end`, replaced."""

    kind: str
    node: ast.AST
    start: int
    end: int
    text: str


TWINS = {
    "min": "max",
    "sin": "cos",
    "sinh": "cosh",
    "floor": "ceil",
    "any": "all",
    "real": "imag",
    "vertical": "lateral",
    "forward": "backward",
    "force": "couple",
}
"""Names that stand for each other's opposite."""
_TWIN_OF = TWINS | {value: key for key, value in TWINS.items()}

_COMPARISONS = {
    ast.Lt: ("<", "<="),
    ast.LtE: ("<=", "<"),
    ast.Gt: (">", ">="),
    ast.GtE: (">=", ">"),
    ast.Eq: ("==", "!="),
    ast.NotEq: ("!=", "=="),
}
_OPERATORS = {
    ast.Add: ("+", "-", "plus and minus"),
    ast.Sub: ("-", "+", "plus and minus"),
    ast.Mult: ("*", "/", "times and over"),
    ast.Div: ("/", "*", "times and over"),
    ast.FloorDiv: ("//", "%", "times and over"),
    ast.Mod: ("%", "//", "times and over"),
    ast.Pow: ("**", "*", "times and over"),
}
_TYPE_TESTS = {"isinstance", "issubclass", "getattr", "hasattr", "setattr", "cast", "field", "attach"}
"""Calls whose arguments, exchanged, only raise: nothing would be learnt of the tests."""


def faults_of(path: str, source: str) -> list[Fault]:
    """Return every single-line fault of a module.

    >>> for fault in faults_of("m.py", "def f(a, b):\\n    return a + b\\n"):
    ...     print(fault.kind, "|", fault.after.strip())
    dropped term | return b
    dropped term | return a
    plus and minus | return a - b
    """
    data = source.encode()
    reader = _Reader(data, ast.parse(source))
    lines = source.splitlines()
    faults: dict[tuple[int, str], Fault] = {}
    for edit in reader.edits():
        line = bisect_right(reader.starts, edit.start)
        if "\n" in edit.text or edit.end > reader.starts[line]:
            continue  # more than one line
        start, end = edit.start - reader.starts[line - 1], edit.end - reader.starts[line - 1]
        old = lines[line - 1].encode()
        new = (old[:start] + edit.text.encode() + old[end:]).decode()
        if new != lines[line - 1]:
            statement, home = reader.places[edit.node]
            fault = Fault(path, line, edit.kind, lines[line - 1], new, statement, home)
            faults.setdefault((line, new), fault)
    return list(faults.values())


def is_another_program(fault: Fault, source: str) -> bool:
    """Return whether the module with the fault can be read, and says something else."""
    try:
        return ast.dump(ast.parse(fault.planted_in(source))) != ast.dump(ast.parse(source))
    except SyntaxError:
        return False


class _Reader:
    """One module's syntax tree, with the place of each node in the bytes of the source."""

    def __init__(self, data: bytes, tree: ast.Module) -> None:
        self.data = data
        starts = [0]
        for line in data.splitlines(keepends=True):
            starts.append(starts[-1] + len(line))
        self.starts = starts
        self.places: dict[ast.AST, tuple[int, tuple[str, int]]] = {}
        self.returns: dict[tuple[str, int], list[ast.expr]] = {}
        self.nodes: list[ast.AST] = []
        for statement in tree.body:
            self._enter(statement, 1, ("<module>", 0))

    def _enter(self, node: ast.AST, statement: int, home: tuple[str, int]) -> None:
        """Note the places of a node and of all below it, except where a fault would mean nothing."""
        if isinstance(node, ast.stmt):
            statement = node.lineno
        self.places[node] = (statement, home)
        if isinstance(node, ast.Raise | ast.Assert | ast.Import | ast.ImportFrom | ast.JoinedStr):
            return  # a message is no result
        if isinstance(node, ast.If) and ast.unparse(node.test).endswith("TYPE_CHECKING"):
            return
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            return
        self.nodes.append(node)
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            for below in (*node.args.defaults, *node.args.kw_defaults, *node.decorator_list):
                if below is not None:
                    self._enter(below, statement, home)
            first = min([node.lineno, *(d.lineno for d in node.decorator_list)])
            for below in node.body:
                self._enter(below, statement, (node.name, first))
            return
        if isinstance(node, ast.Return) and node.value is not None:
            self.returns.setdefault(home, []).append(node.value)
        for name, value in ast.iter_fields(node):
            if name in ("annotation", "returns", "type_params"):
                continue
            for below in value if isinstance(value, list) else [value]:
                if isinstance(below, ast.AST) and hasattr(below, "lineno"):
                    self._enter(below, statement, home)
                elif isinstance(below, ast.AST):  # comprehension, arguments, keyword, operator
                    self.places[below] = (statement, home)
                    self.nodes.append(below)
                    for deeper in ast.iter_child_nodes(below):
                        self._enter(deeper, statement, home)

    # Bytes of nodes

    def start(self, node: Any) -> int:
        return self.starts[node.lineno - 1] + node.col_offset

    def end(self, node: Any) -> int:
        return self.starts[node.end_lineno - 1] + node.end_col_offset

    def text(self, node: Any) -> str:
        return self.data[self.start(node) : self.end(node)].decode()

    def grouped(self, node: Any) -> str:
        """Return the text of a node, in parentheses unless it is one name, number or call."""
        plain = isinstance(node, ast.Name | ast.Constant | ast.Call | ast.Attribute | ast.Subscript)
        return self.text(node) if plain else f"({self.text(node)})"

    def replaced(self, kind: str, node: Any, text: str) -> _Edit:
        return _Edit(kind, node, self.start(node), self.end(node), text)

    def between(self, kind: str, node: Any, left: Any, right: Any, old: str, new: str) -> Iterator[_Edit]:
        """Replace an operator that stands between two nodes."""
        start, end = self.end(left), self.start(right)
        gap = self.data[start:end].decode()
        match = re.search(rf"(?<![^\s)\]]){re.escape(old)}(?![^\s(\[\-+~\w\"'.]|=)", gap) or re.search(
            re.escape(old), gap
        )
        if match and "#" not in gap:
            shift = len(gap[: match.start()].encode())
            yield _Edit(kind, node, start + shift, start + shift + len(old), new)

    # Kinds of fault

    def edits(self) -> Iterator[_Edit]:
        for node in self.nodes:
            match node:
                case ast.BinOp():
                    yield from self._arithmetic(node)
                case ast.AugAssign(op=ast.Add() | ast.Sub()):
                    old, new = ("+=", "-=") if isinstance(node.op, ast.Add) else ("-=", "+=")
                    yield from self.between("plus and minus", node, node.target, node.value, old, new)
                case ast.AugAssign(op=ast.Mult()):
                    yield from self.between("times and over", node, node.target, node.value, "*=", "/=")
                case ast.UnaryOp(op=ast.USub()):
                    yield self.replaced("sign", node, self.grouped(node.operand))
                case ast.UnaryOp(op=ast.Not()):
                    yield self.replaced("condition negated", node, self.grouped(node.operand))
                case ast.Subscript():
                    yield from self._index(node)
                case ast.Compare():
                    yield from self._comparison(node)
                case ast.BoolOp():
                    old, new = ("and", "or") if isinstance(node.op, ast.And) else ("or", "and")
                    for left, right in pairwise(node.values):
                        yield from self.between("and and or", node, left, right, old, new)
                case ast.Constant():
                    yield from self._constant(node)
                case ast.Call():
                    yield from self._call(node)
                case ast.Return(value=ast.expr() as value):
                    yield from self._return(node, value)
                case ast.IfExp():
                    body, orelse = self.grouped(node.body), self.grouped(node.orelse)
                    swapped = f"{orelse} if {self.text(node.test)} else {body}"
                    yield self.replaced("another branch", node, swapped)
                    yield self.replaced("condition negated", node.test, f"not ({self.text(node.test)})")
                case ast.If() | ast.While():
                    yield self.replaced("condition negated", node.test, f"not ({self.text(node.test)})")
                case ast.comprehension():
                    for test in node.ifs:
                        yield self.replaced("condition negated", test, f"(not ({self.text(test)}))")
                case ast.Name() if node.id in _TWIN_OF and isinstance(node.ctx, ast.Load):
                    yield self.replaced("twin", node, _TWIN_OF[node.id])
                case ast.Attribute() if node.attr in _TWIN_OF and isinstance(node.ctx, ast.Load):
                    end = self.end(node)
                    start = end - len(node.attr.encode())
                    yield _Edit("twin", node, start, end, _TWIN_OF[node.attr])
                case ast.Break():
                    yield self.replaced("break and continue", node, "continue")
                case ast.Continue():
                    yield self.replaced("break and continue", node, "break")

    def _arithmetic(self, node: ast.BinOp) -> Iterator[_Edit]:
        if _is_text(node.left) or _is_text(node.right):
            return  # text that is put together: the exchange would only raise
        left, right = self.grouped(node.left), self.grouped(node.right)
        if isinstance(node.op, ast.Add | ast.Sub):
            minus = "-" if isinstance(node.op, ast.Sub) else ""
            yield self.replaced("dropped term", node, f"({minus}{right})" if minus else right)
            yield self.replaced("dropped term", node, left)
        elif isinstance(node.op, ast.Mult | ast.Div):
            if isinstance(node.op, ast.Mult):
                yield self.replaced("dropped factor", node, right)
                yield self.replaced("sign", node, f"(-({self.text(node)}))")
            yield self.replaced("dropped factor", node, left)
        for operator, (old, new, kind) in _OPERATORS.items():
            if isinstance(node.op, operator):
                yield from self.between(kind, node, node.left, node.right, old, new)

    def _index(self, node: ast.Subscript) -> Iterator[_Edit]:
        index = node.slice
        if isinstance(index, ast.Slice):
            for bound in (index.lower, index.upper):
                if bound is not None:
                    shift = "- 1" if bound is index.lower and not _is_number(bound, 0) else "+ 1"
                    yield self.replaced("index", bound, f"{self.grouped(bound)} {shift}")
        elif isinstance(index, ast.Constant) and isinstance(index.value, int):
            yield self.replaced("index", index, str(index.value + 1))
        elif isinstance(index, ast.UnaryOp | ast.BinOp):
            yield self.replaced("index", index, f"{self.text(index)} - 1")

    def _comparison(self, node: ast.Compare) -> Iterator[_Edit]:
        for operator, left, right in zip(
            node.ops, [node.left, *node.comparators], node.comparators, strict=False
        ):
            if type(operator) in _COMPARISONS:
                old, new = _COMPARISONS[type(operator)]
                yield from self.between("comparison", node, left, right, old, new)
            elif isinstance(operator, ast.In):
                yield from self.between("condition negated", node, left, right, "in", "not in")
            elif isinstance(operator, ast.Is):
                yield from self.between("condition negated", node, left, right, "is", "is not")

    def _constant(self, node: ast.Constant) -> Iterator[_Edit]:
        value = node.value
        if isinstance(value, bool):
            yield self.replaced("constant", node, str(not value))
        elif isinstance(value, int):
            yield self.replaced("constant", node, str(value + 1))
            if value > 1:
                yield self.replaced("constant", node, str(value - 1))
        elif isinstance(value, float):
            yield self.replaced("constant", node, repr(round(value * 1.2, 12) or 0.1))

    def _call(self, node: ast.Call) -> Iterator[_Edit]:
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        if name in _TYPE_TESTS or any(isinstance(a, ast.Starred) for a in node.args):
            return
        for left, right in pairwise(node.args):
            if _is_text(left) or _is_text(right):
                continue
            text = f"{self.text(right)}{self._gap(left, right)}{self.text(left)}"
            yield _Edit("exchanged arguments", node, self.start(left), self.end(right), text)
        if name == "range" and node.args:
            last = node.args[min(len(node.args), 2) - 1]
            yield self.replaced("bound", last, f"{self.text(last)} + 1")
            yield self.replaced("bound", last, f"{self.text(last)} - 1")
            if len(node.args) > 1:
                yield self.replaced("bound", node.args[0], f"{self.text(node.args[0])} + 1")

    def _gap(self, left: Any, right: Any) -> str:
        return self.data[self.end(left) : self.start(right)].decode()

    def _return(self, node: ast.Return, value: ast.expr) -> Iterator[_Edit]:
        _, home = self.places[node]
        for other in self.returns.get(home, ()):
            if other is not value and "\n" not in self.text(other):
                yield self.replaced("another branch", value, self.text(other))


def _is_text(node: ast.expr) -> bool:
    return isinstance(node, ast.JoinedStr | ast.List | ast.Tuple) or (
        isinstance(node, ast.Constant) and isinstance(node.value, str | bytes)
    )


def _is_number(node: ast.expr, value: int) -> bool:
    return isinstance(node, ast.Constant) and node.value == value


def choose(faults: Sequence[Fault], count: int, rng: Random, read: Callable[[str], str]) -> list[Fault]:
    """Choose faults evenly over modules and over kinds, never two on one line; `read` gives a text."""
    by_module: dict[str, dict[str, list[Fault]]] = {}
    for fault in faults:
        by_module.setdefault(fault.path, {}).setdefault(fault.kind, []).append(fault)
    chosen: list[Fault] = []
    lines: set[tuple[str, int]] = set()
    taken: dict[str, int] = {}
    modules: list[str] = []
    while len(chosen) < count and by_module:
        if not modules:
            modules = sorted(by_module)
            rng.shuffle(modules)
        path = modules.pop()
        kinds = by_module[path]
        while kinds:
            fewest = min(taken.get(kind, 0) for kind in kinds)
            kind = rng.choice(sorted(kind for kind in kinds if taken.get(kind, 0) == fewest))
            fault = kinds[kind].pop(rng.randrange(len(kinds[kind])))
            if not kinds[kind]:
                del kinds[kind]
            if (path, fault.line) not in lines and is_another_program(fault, read(path)):
                lines.add((path, fault.line))
                taken[kind] = taken.get(kind, 0) + 1
                chosen.append(fault)
                break
        if not kinds:
            del by_module[path]
            modules = [module for module in modules if module != path]
    return chosen
