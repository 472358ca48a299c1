"""How results are written: formulas as trees, documents as nodes, and a writer for each medium.

In: formulas, documents, SymPy numbers. Out: text, LaTeX (amsmath and booktabs alone), HTML, Markdown.
Knows nothing of engines.

    formula                   formulas as trees: read, derived, printed
    formula_printing          brackets and signs, which all writers share
    text_writer, latex_writer, mathml_writer, sympy_writer      a formula in each medium
    expressions               SymPy expressions as formulas: roots, fractions, cosines
    line_breaking             long formulas over several lines
    symbols                   every symbol with its unit and LaTeX
    letters, wordlists        Greek and function names, letters in print;  decimals: as tables print them
    latex_characters          any sign in LaTeX
    nodes, result             a document's parts;  what every result can do
    text_document, latex_document, html_document, markdown_document     a document in each medium
    fitting                   which exact cells of a table give way to decimals
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
