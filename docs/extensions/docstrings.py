r"""Docstrings of the package as reST: they are plain text, meant to be read beside the code.

Paragraphs stay paragraphs, `marked` words become code, indented blocks stay as they stand unless every
line of them is a formula that `formulas` can show, doctests are highlighted, and lines that begin with
"Source:" or "Units:" become fields. Below the heading "Formulas:" each equation stands beside what this
library's checker proves of it, where the tests' survey of docstrings can be imported.

>>> print(rest("Return x*y.\n\n    F = m a\n\nSource: Newton, 1687."))
Return x\*y.
<BLANKLINE>
.. math::
<BLANKLINE>
   F = m a
<BLANKLINE>
:Source: Newton, 1687.
<BLANKLINE>
<BLANKLINE>
"""

from __future__ import annotations

import re
from functools import cache
from inspect import cleandoc
from textwrap import dedent, indent
from typing import Any

from extensions.formulas import mathml

_FIELD = re.compile(r"^(Sources?|Units?): ")
_CODE = re.compile(r"`([^`\n]+(?:\n[^`\n]+)?)`")
_SPECIAL = re.compile(r"[\\*_|`]")
_GOES_ON = re.compile(r"([=≈+]|- )")
_ITEM = re.compile(r"^- ")


def rest(text: str, name: str = "") -> str:
    """Return a docstring as reST; `name` is the qualified name of what it describes."""
    blocks = _blocks(cleandoc(text))
    entries = {_key(entry.text): entry for entry in entries_of(name)}
    parts: list[str] = []
    for before, block in zip(["", *blocks], blocks, strict=False):
        is_formulas = before.endswith("Formulas:") and block.startswith("    ")
        parts.append(_formula_table(dedent(block), entries) if is_formulas else _block(block))
    return "".join(part + "\n\n" for part in parts)


def first_sentence(text: str) -> str:
    r"""Return what a docstring says in its first sentence, as one line of reST.

    >>> print(first_sentence("Return A_n, e.g. of n = 2.\n\nMore."))
    Return A\_n, e.g. of n = 2.
    """
    paragraph = " ".join(cleandoc(text).split("\n\n")[0].split())
    sentence = re.match(r".*?(?:[.?!](?= [A-Z`])|$)", paragraph)
    return _inline(sentence[0] if sentence else paragraph)


def _blocks(text: str) -> list[str]:
    """Return paragraphs, tables, indented blocks (inner blank lines too) and doctests."""
    blocks: list[list[str]] = [[]]
    for line in text.splitlines():
        last = blocks[-1]
        inside = bool(last) and last[0].startswith("    ")
        whole = bool(last) and last[0].startswith((">>> ", "=="))  # ends at a blank line only
        begins = bool(_FIELD.match(line)) or line.startswith(">>> ")
        if not line.strip():
            if inside:
                last.append("")
            elif last:
                blocks.append([])
        elif last and not whole and (begins or line.startswith("    ") != inside):
            blocks.append([line])
        else:
            last.append(line)
    return ["\n".join(block).rstrip() for block in blocks if any(block)]


def _block(block: str) -> str:
    if block.startswith(">>> "):
        return ".. code-block:: pycon\n\n" + indent(block, "   ")
    if block.startswith("=="):
        return ".. code-block:: none\n\n" + indent(block, "   ")
    if block.startswith("    "):
        return _code_or_formulas(dedent(block))
    if field := _FIELD.match(block):
        return f":{field[1]}: " + _inline(block[field.end() :]).replace("\n", "\n   ")
    if _ITEM.match(block):
        return "\n".join(_item(line) for line in block.splitlines())
    return _inline(block)


def _item(line: str) -> str:
    return "- " + _inline(line[2:]) if _ITEM.match(line) else "  " + _inline(line.strip())


def _code_or_formulas(block: str) -> str:
    if ">>> " in block:
        return ".. code-block:: pycon\n\n" + indent(block, "   ")
    formulas = [_bare(line) for line in block.splitlines() if line.strip()]
    if all(mathml(formula, words=False) for formula in formulas):
        return "\n\n".join(f".. math::\n\n   {formula}" for formula in formulas)
    return ".. code-block:: none\n\n" + indent(block, "   ")


def _formula_table(block: str, entries: dict[str, Any]) -> str:
    """Return the block below "Formulas:" as a table, each equation with the survey's verdict."""
    lines = [line for line in block.splitlines() if line.strip()]
    where = next((k for k, line in enumerate(lines) if line.startswith("with ")), len(lines))
    equations: list[list[str]] = []
    for line in lines[:where]:
        if _GOES_ON.match(line) and equations:
            equations[-1].append(line)
        else:
            equations.append([line])
    rows = ""
    for equation in equations:
        text, _, remark = equation[0].partition("    ")
        plain = " ".join([_bare(text), *map(_bare, equation[1:])])
        entry = entries.get(_key(plain))
        latex = entry.latex if entry else ""
        cell = f":math:`{role_text(latex)}`" if latex and mathml(latex) else f"``{plain}``"
        rows += (
            f"   * - {cell}\n     - {_inline(remark.strip())}\n     - {entry.status if entry else ''}\n"
        )
    conditions = _inline("\n".join(lines[where:]))
    return f".. list-table::\n   :class: formulas\n\n{rows}\n{conditions}"


def _key(text: str) -> str:
    """Return an equation's text as it is compared: without spaces and final marks."""
    return "".join(text.split()).rstrip(".,;:")


def role_text(latex: str) -> str:
    """Return LaTeX as the text of a role: backslashes are kept there, a final one is not allowed."""
    return " ".join(latex.split()).rstrip("\\")


def _bare(line: str) -> str:
    return line.strip().rstrip(".,;:")


def _inline(text: str) -> str:
    """Return a paragraph with its code marked and every other sign meant as it stands."""
    parts: list[str] = []
    start = 0
    for code in _CODE.finditer(text):
        parts += [_escape(text[start : code.start()]), f"``{' '.join(code[1].split())}``"]
        start = code.end()
        parts += ["\\ "] if text[start : start + 1].isalnum() else []
    parts.append(_escape(text[start:]))
    lines = "".join(parts).splitlines()
    return "\n".join(re.sub(r"^(\s*)([-+.:#(]|\w+[.)])(?=\s|\.\.|$)", r"\1\\\2", line) for line in lines)


def _escape(text: str) -> str:
    return _SPECIAL.sub(r"\\\g<0>", text)


# --- what the package proves of its own docstrings ---


@cache
def _survey() -> tuple[Any, ...]:
    """Return the docstrings' formulas and what is proved of each, by the survey of the tests."""
    from tests.docstring_formulas import survey

    return tuple(survey())


def entries_of(name: str) -> list[Any]:
    """Return the survey's entries of one docstring that are marked as formulas, in their order."""
    return [entry for entry in _survey() if entry.name == name and "not marked" not in entry.reason]


def all_entries() -> tuple[Any, ...]:
    """Return all entries of the survey."""
    return _survey()


# --- the extension ---


def _process(_app: Any, _what: str, name: str, value: Any, _options: Any, lines: list[str]) -> None:
    home = f"{getattr(value, '__module__', '')}.{getattr(value, '__qualname__', '')}"
    lines[:] = rest("\n".join(lines), home if entries_of(home) else name).splitlines()


def setup(app: Any) -> dict[str, bool]:
    """Convert every docstring that autodoc shows."""
    app.connect("autodoc-process-docstring", _process)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
