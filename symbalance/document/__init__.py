"""How results are written: formulas as trees, symbols, aligned tables, text and LaTeX.

In: formulas, cells, SymPy numbers. Out: Unicode text and LaTeX (amsmath and booktabs alone). Knows
nothing of engines.

    formula, writer           formulas as data, printed by text_writer and latex_writer
    syntax, syntax_printing   formulas as they were read, printed by syntax_text and syntax_latex
    symbols, notation         every symbol with its unit and LaTeX; series' letters and conventions
    expressions               exact numbers in print: roots, fractions, cosines
    letters, wordlists        Greek and function names;  decimals: as tables print them
    grid, plain_tables        columns that line up
    latex_parts               what LaTeX needs;  latex_characters, line_breaking: signs, long lines
    printing                  any result as text, LaTeX or JSON
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
