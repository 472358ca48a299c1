"""Base class of results, which all show as text, LaTeX, HTML, Markdown, JSON, CSV and in notebooks.

A result's class derives from `Result` and gives four things: `kind`, `summary()`, `document()` and
`data()`; `records()` where a table of plain numbers makes sense of it. Beside the module stands
KIND.schema.json, which describes every key of `data()`. Everything else follows.

>>> from symbalance.engine.catalogue import load
>>> from symbalance.forces.free_forces import balance
>>> balance(load("inline-4"), 4)
Balance of inline-4 to order 4: free force of order 2, 4; no free couple
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar, overload

from symbalance.errors import SymbalanceError, brief, printable, visible

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

Item = TypeVar("Item")


class Result:
    """Base class of all results: shown as text, LaTeX, HTML, Markdown, JSON, CSV and in notebooks."""

    __slots__ = ()

    kind: ClassVar[str] = ""
    """The result's name in JSON: "balance"."""
    schema_version: ClassVar[int] = 1
    """Counts up when a key of the JSON changes its meaning or goes; new keys do not count."""

    record_keys: ClassVar[tuple[str, ...]] = ()
    """The keys of `records()`, where there may be none of them: a table of no rows has its heads."""

    def summary(self) -> str:
        """Return the result in one line that a person reads."""
        raise NotImplementedError

    def document(self) -> Document:
        """Return what is written of the result, in any medium."""
        raise NotImplementedError

    def browser_document(self) -> Document:
        """Return what is written of the result where it can be opened and folded: in HTML."""
        return self.document()

    def data(self) -> dict[str, Any]:
        """Return the result as numbers, strings, lists and dicts; exact numbers are strings."""
        raise NotImplementedError

    def records(self) -> list[dict[str, Any]]:
        """Return the result as rows of plain values, for `pandas.DataFrame` or `polars.DataFrame`."""
        raise NotImplementedError

    @classmethod
    def json_schema(cls) -> dict[str, Any]:
        """Return the JSON Schema (draft 2020-12) of what `to_json` writes of such results.

        It says of every key its type, its unit and what it means. It stands beside the module of the
        class, as KIND.schema.json; refused for a class that has none.
        """
        from importlib.resources import files

        package = sys.modules[cls.__module__].__package__
        file = files(package) / f"{cls.kind}.schema.json" if package else None
        if file is None or not file.is_file():
            remedy = f"put {cls.kind}.schema.json beside its module"
            raise SymbalanceError(cls.__name__, "has no JSON Schema", remedy)
        return json.loads(file.read_text(encoding="utf-8"))

    def __repr__(self) -> str:
        return printable(self.summary())

    def _repr_html_(self) -> str:
        return to_html(self)

    def _repr_latex_(self) -> str:
        return to_latex(self)

    def _repr_markdown_(self) -> str:
        return to_markdown(self)


class SequenceResult(Result, Sequence[Item]):
    """A result that is a row of things, its `items`: it counts, indexes and compares like them."""

    items: tuple[Item, ...]

    def __len__(self) -> int:
        return len(self.items)

    @overload
    def __getitem__(self, place: int) -> Item: ...
    @overload
    def __getitem__(self, place: slice) -> tuple[Item, ...]: ...
    def __getitem__(self, place: int | slice) -> Item | tuple[Item, ...]:
        return self.items[place]

    def __eq__(self, other: object) -> bool:
        """Tell whether the things are those of another row, such as a list."""
        return isinstance(other, Sequence) and list(self) == list(other)

    def __hash__(self) -> int:
        return hash(self.items)


def to_text(result: Result, *, width: int = 80, full: bool = False) -> str:
    """Return a result as text for a terminal of `width` columns, 40 or more.

    `full` shows what a short document names in its last line.
    """
    from symbalance.document.text_document import document_text

    if not isinstance(width, int) or width < 40:
        raise SymbalanceError(
            f"width = {width}", "must be a whole number, 40 or more", "80 is the default"
        )
    return document_text(_checked(result).document().unfolded(full), width)


def to_latex(
    result: Any, *, standalone: bool = False, full: bool = False, label: str | None = None
) -> str:
    r"""Return a result as LaTeX: a fragment, or with `standalone` a document that compiles alone.

    `full` shows what a short document names in its last line.

    A fragment needs amsmath and booktabs. With a `label` its tables float under captions, labelled
    tab:LABEL-force and so on: what each is about, numbered from the second of that name. Components,
    series and SymPy expressions give a formula for math mode, which takes no label.

    >>> from symbalance.kinematics.slider_crank import acceleration_series
    >>> print(to_latex(acceleration_series(6, 7)))
    \frac{9}{128 \lambda^{5}} + \frac{45}{512 \lambda^{7}} + \cdots
    """
    if isinstance(result, Result):
        from symbalance.document.latex_document import document_latex

        document = result.document().unfolded(full)
        return document_latex(document, standalone=standalone, label=label)
    if label is not None:
        raise SymbalanceError(f"label = {brief(label)}", "is for the tables of a result", "leave it out")
    from symbalance.document.latex_writer import formula_latex

    return formula_latex(_formula(result))


def to_html(result: Any, *, standalone: bool = False) -> str:
    """Return a result as HTML: an article, or with `standalone` a whole page; formulas as MathML."""
    if isinstance(result, Result):
        from symbalance.document.html_document import document_html

        return document_html(result.browser_document(), standalone=standalone)
    from symbalance.document.mathml_writer import formula_mathml

    return formula_mathml(_formula(result))


def to_markdown(result: Result) -> str:
    """Return a result as Markdown, formulas between dollar signs."""
    from symbalance.document.markdown_document import document_markdown

    return document_markdown(_checked(result).document())


def to_json(result: Result) -> str:
    """Return a result as a JSON document for other programs: exact numbers as strings.

    Its first key, `schema`, names the kind of result and the version of its keys, which
    `result.json_schema()` describes one by one.
    """
    checked = _checked(result)
    schema = {"result": checked.kind, "version": checked.schema_version}
    text = json.dumps({"schema": schema, **checked.data()}, indent=1, ensure_ascii=False)
    # What is in a file's words stays in them, but no terminal obeys it: outside of strings is none of it.
    return text if not _HIDDEN.search(text) else _HIDDEN.sub(_json_escape, text)


def _json_escape(match: re.Match[str]) -> str:
    if "\ud800" <= match[0] <= "\udfff" or match[0] == visible(match[0]):
        return match[0]
    units = match[0].encode("utf-16-be")
    return "".join(f"\\u{units[i : i + 2].hex()}" for i in range(0, len(units), 2))


_HIDDEN = re.compile(
    "[^\n -~\u00a1-\u00ac\u00ae-\u02ff\u0370-\u05ff\u0900-\u0fff\u3041-\u3163\u3165-\ud7ff]"
)
"""Characters that may be of those that `visible` writes by their codes; the others are quickly passed."""


def to_csv(result: Result) -> str:
    r"""Return a result's records as CSV, one table under a row of heads.

    RFC 4180: lines end in CR LF; write it with `newline=""`. Numbers are decimals with a point. A text
    that a spreadsheet would take for a formula has an apostrophe before it.

    >>> from symbalance.kinematics.slider_crank import harmonics
    >>> print(to_csv(harmonics("force", 2, 1)).replace("\r", ""), end="")
    order,function,power,coefficient,value
    1,cos,0,1,1.0
    2,cos,1,1,1.0
    """
    from symbalance.document.csv_document import result_csv

    return result_csv(_checked(result))


def to_xlsx(result: Result) -> bytes:
    """Return a result's records as the bytes of an Excel workbook; needs the extra `xlsx`.

    `Path("balance.xlsx").write_bytes(sb.to_xlsx(result))` writes it: one sheet, the rows of `to_csv`, its
    heads in bold, numbers as numbers, texts never as formulas.
    """
    from symbalance.document.xlsx_document import result_xlsx

    return result_xlsx(_checked(result))


def _checked(result: Any) -> Result:
    """Return a result, or refuse what is none."""
    if isinstance(result, Result):
        return result
    what = (result if isinstance(result, type) else type(result)).__name__
    raise SymbalanceError(what, "is no result that can be printed", "give a balance or another result")


def _formula(value: Any) -> Any:
    """Return a value's formula: its own, or that of a SymPy expression."""
    if hasattr(value, "as_formula") and not isinstance(value, type):
        return value.as_formula()
    import sympy

    if isinstance(value, sympy.Expr):
        from symbalance.document.expressions import formula_of

        return formula_of(value)
    return _checked(value)
