"""Handbook sheets of engines, a page each or compared on one: as SVG, LaTeX and PDF.

A sheet is made of drawings of whole pages, so it is the same in SVG and in TeX.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from symbalance.design.comparison import EngineComparison
from symbalance.design.comparison import compare as compare_engines
from symbalance.document.shapes import Drawing
from symbalance.document.svg_writer import drawing_svg, style
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError
from symbalance.forces.free_forces import Balance, balance


@dataclass(frozen=True, repr=False)
class Sheet:
    """Handbook sheets, each a page or more: `pages` are drawings of A4."""

    pages: tuple[Drawing, ...]

    def __repr__(self) -> str:
        first, *further = self.pages
        more = f" and {len(further)} pages more" if further else ""
        return f"Sheet: {first.title.removeprefix('Sheet of ')}{more}"

    def latex(self) -> str:
        """Return a LaTeX document of the pages, which needs TikZ."""
        from symbalance.pages.sheet_files import sheets_latex

        return sheets_latex(self.pages)

    def pdf(self) -> bytes:
        """Return a PDF, by pdflatex or lualatex; refused where neither is installed."""
        from symbalance.pages.sheet_files import sheets_pdf

        return sheets_pdf(self.pages)

    def svg(self, page: int = 1) -> str:
        """Return a page as an SVG file of its own."""
        if not (isinstance(page, int) and 1 <= page <= len(self.pages)):
            rule = f"must be a whole number, 1 to {len(self.pages)}"
            raise SymbalanceError(f"page = {page}", rule, "as page=1")
        return drawing_svg(self.pages[page - 1], standalone=True)

    def _repr_html_(self) -> str:
        pages = "".join(drawing_svg(page, styled=False) for page in self.pages)
        return f"<style>{style()}</style>{pages}"


def sheet(
    *subjects: Engine | Balance | EngineComparison, order: int = 12, compare: bool = False
) -> Sheet:
    """Return the sheets of engines or balances, each on a page of its own, or of a comparison.

    With `compare` engines stand on one sheet, side by side above one table. `order` is the highest
    for engines; balances and comparisons have their own, and their speed.

    >>> from symbalance.engine.catalogue import load
    >>> sheet(load("inline-3"))
    Sheet: inline-3
    >>> len(sheet(load("inline-3"), load("v8-90")).pages)
    2
    >>> sheet(load("inline-3"), load("v8-90"), compare=True, order=4)
    Sheet: Comparison of inline-3, v8-90
    """
    if not subjects:
        raise SymbalanceError("sheet()", "needs an engine or a balance", "as sheet(load('v8-90'))")
    if compare:
        engines: list[Engine] = []
        for each in subjects:
            if isinstance(each, EngineComparison):
                rule = "is a comparison already"
                raise SymbalanceError("sheet(compare=True)", rule, "leave compare out, or give engines")
            engines.append(each.engine if isinstance(each, Balance) else each)
        return Sheet(_comparison(compare_engines(engines, order)))
    return Sheet(tuple(page for each in subjects for page in _pages(each, order)))


def _pages(subject: Engine | Balance | EngineComparison, order: int) -> Sequence[Drawing]:
    if isinstance(subject, EngineComparison):
        return _comparison(subject)
    from symbalance.pages.engine_sheet import engine_pages

    result = subject if isinstance(subject, Balance) else balance(checked_engine(subject), order)
    return engine_pages(result)


def _comparison(comparison: EngineComparison) -> tuple[Drawing, ...]:
    from symbalance.pages.comparison_sheet import comparison_pages

    return comparison_pages(comparison)
