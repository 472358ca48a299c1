"""Formulas and documents as data, and a writer for each format: text, LaTeX, HTML, Markdown.

In: formulas, documents made of nodes. Out: text, LaTeX (amsmath and booktabs), HTML with MathML,
Markdown. Knows nothing of engines.

    formula                   formulas as trees: read, derived, printed;  expressions: SymPy's as such
    formula_printing          brackets and signs, which all writers of formulas share
    text_writer, latex_writer, mathml_writer, sympy_writer       a formula in each medium
    line_breaking                                                long formulas over several lines
    symbols, letters, wordlists    letters with units and meaning, Greek, names of functions
    nodes                     a document: headings, facts, tables, formulas, figures, source, details
    fitting                   which exact cells a table has room for;  decimals: numbers in cells
    document_writer           what the writers of documents share
    text_document, latex_document, html_document, markdown_document    a document in each medium
    csv_document, xlsx_document                                  a result's rows for spreadsheets
    latex_characters          any sign in LaTeX
    result                    what every result can do: to_text, to_latex, to_json, to_csv and so on
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
