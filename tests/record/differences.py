"""Differences of two texts, JSON documents or sources, each of a kind that says how much it matters."""

from __future__ import annotations

import ast
import difflib
import json
import re
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath

from .exact_strings import is_opposite, relative_difference, values

KINDS = {
    "case missing": "the new record has no such case",
    "case added": "the old record has no such case",
    "arguments": "the case's command line is another one",
    "exit code": "the program ended otherwise",
    "file missing": "something was said or written before and is not now",
    "file added": "something is said or written now and was not before",
    "input": "what the program read is not the same: no difference below it is the program's alone",
    "key removed": "JSON: a key or an item is gone",
    "key added": "JSON: a key or an item is new",
    "type": "JSON: a value of another type, null included",
    "layout": "JSON: other spaces or another order of keys, the same values",
    "spelling": "JSON: an exact string of the same value, written otherwise",
    "digits": "a number that differs by less than 1e-12 of itself",
    "number": "a number that is another one",
    "sign": "a number, or all that differs in a line, with the other sign",
    "whitespace": "only spaces, line breaks or rules",
    "words": "only words or punctuation",
    "numbers": "only numbers, in text",
    "signs": "only plus and minus, in text",
    "formulas": "formulas: letters, functions, operators, exponents",
    "mixed": "words and numbers together",
    "lines removed": "lines that are gone",
    "lines added": "lines that are new",
    "comments": "source: comments and documentation only",
    "code": "source: code that gives the same values, or is not run here",
    "evaluates differently": "source: both were run, and their values differ",
}
"""Every kind, and what it says. In a report a medium stands before it: `json: number`."""
FEW_DIGITS = mpmath.mpf("1e-12")
IDENTITIES = (
    ("line", "link"),
    ("order", "quantity", "of"),
    ("order", "parameter", "cylinder"),
    ("order",),
    ("number",),
)
"""What names an item of a list, so that one that is new does not make all behind it differ."""

_MEDIA = {"json": "json", "tex": "latex", "toml": "toml", "stderr": "stderr"}
_SOURCES = {"py", "c", "h", "mjs", "m"}
_TOKEN = re.compile(
    r"(?P<space>[\s\u2500-\u257f]+)"
    r"|(?P<number>\d+(?:\.\d+)?(?:[eE][+\-\u2212]?\d+)?)"
    r"|(?P<formula>\\[A-Za-z]+|[\u2070-\u209c\u00b2\u00b3\u00b9]+)"
    r"|(?P<hyphen>(?<=[^\W\d_])-(?=[^\W\d_]))"
    r"|(?P<sign>[+\-\u2212\u00b1\u2213])"
    r"|(?P<word>[^\W\d_]+)"
    r"|(?P<punctuation>[.,;:!?'\"\u2026\u2013\u2014])"
    r"|(?P<operator>.)",
    re.DOTALL,
)
_FUNCTIONS = {"cos", "sin", "tan", "sqrt", "atan", "acos", "asin", "exp", "log"}
_PYTHON_COMMENTS = (ast.Module, ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
_COMMENTS = {
    "c": re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL),
    "h": re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL),
    "mjs": re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL),
    "m": re.compile(r"^\s*[%#][^\n]*|\s[%#][^\n]*", re.MULTILINE),
}


@dataclass(frozen=True)
class Difference:
    """One difference between two records."""

    case: str
    kind: str
    place: str = ""
    old: str = ""
    new: str = ""
    note: str = ""


def of_files(case: str, name: str, old: bytes, new: bytes) -> Iterator[Difference]:
    """Yield the differences of one file of a case; nothing if they are equal byte by byte."""
    if old == new:
        return
    suffix = name.rpartition(".")[2]
    medium = "source" if suffix in _SOURCES else _MEDIA.get(suffix, "text")
    place = "" if name == case else name.removeprefix(case)
    texts = old.decode("utf-8", "backslashreplace"), new.decode("utf-8", "backslashreplace")
    parts = (
        of_json(*texts) if medium == "json" else of_source(*texts, suffix) if medium == "source" else None
    )
    for one in parts if parts is not None else of_texts(*texts):
        where = ":".join(filter(None, (place, one.place)))
        yield Difference(case, f"{medium}: {one.kind}", where, one.old, one.new, one.note)


# JSON ------------------------------------------------------------------------------------------------


def of_json(old: str, new: str) -> Iterator[Difference] | None:
    """Return the differences of two JSON documents, None if one of them is none."""
    try:
        # Numbers as they are written: a float would hide digits.
        documents = [json.loads(text, parse_float=_Written, parse_int=_Written) for text in (old, new)]
    except (ValueError, RecursionError):
        return None
    found = list(_of_values(documents[0], documents[1], "$"))
    return iter(found or [Difference("", "layout", "$", "", "", "the same values")])


class _Written(str):
    """A JSON number, kept as its digits."""


def _of_values(old: Any, new: Any, place: str) -> Iterator[Difference]:
    if isinstance(old, dict) and isinstance(new, dict):
        for key in [*old, *(k for k in new if k not in old)]:
            yield from _of_items(old, new, key, f"{place}.{key}")
    elif isinstance(old, list) and isinstance(new, list):
        named = _named(old, new)
        before, after = named or (dict(enumerate(old)), dict(enumerate(new)))
        for key in [*before, *(k for k in after if k not in before)]:
            yield from _of_items(before, after, key, f"{place}[{key}]")
    elif type(old) is type(new) and isinstance(old, str):
        if old != new:
            yield of_strings(old, new, place)
    elif type(old) is not type(new) or old != new:
        kind = "type" if type(old) is not type(new) else "words"
        yield Difference("", kind, place, _short(old), _short(new))


def _of_items(old: dict[Any, Any], new: dict[Any, Any], key: Any, place: str) -> Iterator[Difference]:
    if key not in new:
        yield Difference("", "key removed", place, _short(old[key]))
    elif key not in old:
        yield Difference("", "key added", place, "", _short(new[key]))
    else:
        yield from _of_values(old[key], new[key], place)


def _named(old: list[Any], new: list[Any]) -> tuple[dict[str, Any], dict[str, Any]] | None:
    """Return two lists by what names their items, None where nothing does."""
    items = [*old, *new]
    if not items or not all(isinstance(item, dict) for item in items):
        return None
    for keys in IDENTITIES:
        if all(isinstance(item.get(key), str) for item in items for key in keys):
            sides = [{", ".join(f"{k} {i[k]}" for k in keys): i for i in side} for side in (old, new)]
            if len(sides[0]) == len(old) and len(sides[1]) == len(new):
                return sides[0], sides[1]
    return None


def of_strings(old: str, new: str, place: str) -> Difference:
    """Return the difference of two strings that are not equal: of numbers, if both are."""
    before, after = values(old), values(new)
    if before is None or after is None:
        kind, note = _kind_of_texts(old, new)
        return Difference("", kind, place, _short(old), _short(new), note)
    relative = relative_difference(before, after)
    note = f"relative {mpmath.nstr(relative, 2)}"
    if relative == 0:
        return Difference("", "spelling", place, _short(old), _short(new), "equal to 30 digits")
    kind = "sign" if is_opposite(before, after) else "digits" if relative < FEW_DIGITS else "number"
    return Difference("", kind, place, _short(old), _short(new), note)


def _short(value: Any) -> str:
    text = value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 400 else f"{text[:400]}…"


# Texts -----------------------------------------------------------------------------------------------


def of_texts(old: str, new: str) -> Iterator[Difference]:
    """Yield the differences of two texts, a hunk of lines at a time.

    >>> [(d.kind, d.place) for d in of_texts("a 1\\nb  2\\nas", "a 1\\nb 2\\nat")]
    [('whitespace', 'line 2'), ('words', 'line 3')]
    """
    before, after = old.splitlines(), new.splitlines()
    if before == after:
        yield Difference("", "whitespace", "", "", "", "line ends")
        return
    if _tokens(old) == _tokens(new):
        yield Difference("", "whitespace", "", "", "", "other line breaks, spaces or rules")
        return
    for tag, i, j, k, m in difflib.SequenceMatcher(None, before, after, autojunk=False).get_opcodes():
        if tag == "equal":
            continue
        pairs = [(i, before[i:j], after[k:m])]
        if j - i == m - k:
            pairs = [(i + n, [before[i + n]], [after[k + n]]) for n in range(j - i)]
        for line, was, now in pairs:
            if was != now:
                yield _of_lines(f"line {line + 1}", "\n".join(was), "\n".join(now), tag)


def _of_lines(place: str, old: str, new: str, tag: str) -> Difference:
    if tag != "replace" and (_tokens(old) or _tokens(new)):
        kind = "lines removed" if tag == "delete" else "lines added"
        return Difference("", kind, place, _short(old), _short(new))
    kind, note = _kind_of_texts(old, new)
    return Difference("", kind, place, _short(old), _short(new), note)


def _tokens(text: str) -> list[tuple[str, str]]:
    """Return a text's tokens with their classes: word, number, sign, formula; spaces have none."""
    tokens = []
    for match in _TOKEN.finditer(text):
        kind, token = match.lastgroup, match[0]
        if kind == "word" and (token in _FUNCTIONS or (len(token) == 1 and token not in "aAI")):
            kind = "formula"
        elif kind in ("hyphen", "punctuation"):
            kind = "word"
        elif kind == "operator":
            kind = "formula"
        if kind != "space":
            tokens.append((kind or "", token))
    return tokens


def _kind_of_texts(old: str, new: str) -> tuple[str, str]:
    """Return the kind of the difference of two texts that are not equal, and a note.

    >>> _kind_of_texts("couple 3 cos 2θ", "couple 4 cos 2θ")
    ('numbers', '3 → 4, relative 0.25')
    >>> _kind_of_texts("the couple", "the moment"), _kind_of_texts("1 + x", "1 − x")
    (('words', ''), ('signs', ''))
    """
    before, after = _tokens(old), _tokens(new)
    if before == after:
        return "whitespace", ""

    def are_equal_without(kind: str) -> bool:
        return [t for t in before if t[0] != kind] == [t for t in after if t[0] != kind]

    if are_equal_without("number"):
        pairs = [(a[1], b[1]) for a, b in zip(before, after, strict=False) if a != b]
        return ("numbers", _changed(pairs)) if len(before) == len(after) else ("mixed", "")
    for token, kind in (("sign", "signs"), ("word", "words")):
        if are_equal_without(token):
            return kind, ""
    words = [[t for t in side if t[0] == "word"] for side in (before, after)]
    return ("formulas" if words[0] == words[1] else "mixed"), ""


def _changed(pairs: Sequence[tuple[str, str]]) -> str:
    shown = []
    for old, new in pairs[:3]:
        before, after = (values(x.replace("\u2212", "-")) for x in (old, new))
        size = relative_difference(before, after) if before and after else None
        shown.append(
            f"{old} → {new}" + (f", relative {mpmath.nstr(size, 2)}" if size is not None else "")
        )
    return "; ".join(shown) + ("; …" if len(pairs) > 3 else "")


# Sources ---------------------------------------------------------------------------------------------


def of_source(old: str, new: str, suffix: str) -> Iterator[Difference]:
    """Yield the one difference of two sources: in comments, in code, or in what they evaluate to."""
    if suffix == "py":
        trees = _code(old), _code(new)
        if None not in trees and trees[0] == trees[1]:
            yield Difference("", "comments", *_first_change(old, new))
            return
        place, was, now = _first_change(old, new, changed_code=suffix)
        note = _evaluated(old, new)
        kind = "evaluates differently" if note.startswith("differ") else "code"
        yield Difference("", kind, place, was, now, note)
        return
    stripped = [_COMMENTS[suffix].sub(" ", text).split() for text in (old, new)]
    if stripped[0] == stripped[1]:
        yield Difference("", "comments", *_first_change(old, new))
    else:
        yield Difference("", "code", *_first_change(old, new, changed_code=suffix), "not run")


def _code(text: str) -> str | None:
    """Return a Python source's syntax without documentation, None where it has none."""
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError):
        return None
    for node in ast.walk(tree):
        if isinstance(node, _PYTHON_COMMENTS) and ast.get_docstring(node, clean=False) is not None:
            node.body = node.body[1:] or [ast.Pass()]
    return ast.dump(tree)


def _first_change(old: str, new: str, changed_code: str = "") -> tuple[str, str, str]:
    """Return place, old and new of the first line that differs; with a suffix, the first that is code."""
    before, after = old.splitlines(), new.splitlines()
    first: tuple[str, str, str] | None = None
    for tag, i, j, k, m in difflib.SequenceMatcher(None, before, after, autojunk=False).get_opcodes():
        if tag == "equal":
            continue
        here = (f"line {i + 1}", _short("\n".join(before[i:j])), _short("\n".join(after[k:m])))
        first = first or here
        if not changed_code or _looks_like_code(before[i:j] + after[k:m], changed_code):
            return here
    return first or ("", "", "line ends")


def _looks_like_code(lines: Sequence[str], suffix: str) -> bool:
    marks = {"py": "#", "m": "%"}.get(suffix, "//")
    return any("=" in line.split(marks)[0] or "return" in line for line in lines)


_RUN = """
import importlib.util, inspect, sys
import numpy as np
angles = np.array([0.0, 0.1, 0.9, 1.7, 2.5, 3.6, 4.9, 6.1, -2.0, 11.0, 100.5, 4e6])
SIZES = {"mass": 0.7, "radius": 0.04, "omega": 300.0, "pitch": 0.11}  # not 1: scales would not show
GIVEN = {**SIZES, "xp": np}  # an array-api module's grid asks for its library
def outputs(path):
    spec = importlib.util.spec_from_file_location("emitted", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    found = {}
    for name, argument in (("evaluate", angles), ("on_grid", 97)):
        function = getattr(module, name, None)
        if function is not None:
            known = inspect.signature(function).parameters
            result = function(argument, **{k: v for k, v in GIVEN.items() if k in known})
            several = result if isinstance(result, dict) else {"": result}
            found |= {f"{name} {key}": np.asarray(value, dtype=float) for key, value in several.items()}
    return found
old, new = map(outputs, sys.argv[1:])
if sorted(old) != sorted(new) or any(old[name].shape != new[name].shape for name in old):
    print("differ: outputs", sorted(old), sorted(new))
elif not old:
    print("differ: neither has a function to call")
else:
    worst = 0.0
    for name, a in old.items():
        b = new[name]
        scale = max(np.max(np.abs(a)), np.max(np.abs(b)), 1e-300)
        worst = max(worst, float(np.max(np.abs(a - b)) / scale))
    print(f"{'differ by' if not worst <= 1e-13 else 'values agree to'} {worst:.1e} of the largest")
"""


def _evaluated(old: str, new: str) -> str:
    """Return how the values of two emitted modules compare; what takes a compiler is not run."""
    import tempfile
    from pathlib import Path

    if any("from numba import" in text or "import numba" in text for text in (old, new)):
        return "not run"
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / "old.py", Path(folder) / "new.py"]
        for path, text in zip(paths, (old, new), strict=True):
            path.write_text(text, encoding="utf-8")
        done = subprocess.run(
            [sys.executable, "-c", _RUN, *map(str, paths)], capture_output=True, text=True, check=False
        )
    if done.returncode:
        return "differ: one of them does not run: " + (done.stderr.strip().splitlines() or ["?"])[-1]
    return done.stdout.strip()
