"""Hand derivations in LaTeX, Markdown or text: read into formulas and checked line by line.

In: LaTeX or plain text, what its letters mean, and knowledge of engines (`checking.engines`).
Out: a verdict for every relation, a witness for what is wrong, and the fix. Nothing is ever evaluated,
and nothing of engines is known here.

    reading     a page to equations whose formulas are trees
    algebra     the normal form in which an equation is decided
    checking    verdicts, corrections and reports
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
