"""A page of an engine in motion: one HTML file with drawings, orders and tables, which opens from disk.

In: an `Engine` or a `Balance`. Out: a `Page`, whose `html` is the file.

    moving_page     the page: template, drawings, the emitted functions and the data, put together
    engine_data     what its script computes from;  script/: what moves, is drawn, edited and saved
    packing         a page made small
    sentence        what shakes and what would cure it, in words
    words           its words in English and Japanese
    sheets          handbook sheets: `engine_sheet`, `comparison_sheet`, `sheet_layout`;
                    sheet_files: as LaTeX and PDF
    atlas           a page of each engine under a table of all;  published_tables: what books say of them
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
