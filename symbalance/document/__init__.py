"""How results are written: formulas as trees, symbols, aligned tables, text and LaTeX.

In: formulas, cells, SymPy numbers. Out: Unicode text and LaTeX (amsmath and booktabs alone). Knows
nothing of engines.

    formula                   formulas as trees: read, derived, printed
    formula_printing          brackets and signs, which all writers share
    text_writer, latex_writer, mathml_writer, sympy_writer      a formula in each medium
    expressions               SymPy expressions as formulas: roots, fractions, cosines
    line_breaking             long formulas over several lines
    symbols                   every symbol with its unit and LaTeX
    letters, wordlists        Greek and function names, letters in print;  decimals: as tables print them
    grid                      columns that line up
    latex_parts               what LaTeX needs;  latex_characters: any sign in LaTeX
    printing                  any result as text, LaTeX or JSON
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
