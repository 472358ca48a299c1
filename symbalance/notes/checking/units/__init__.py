"""Units and dimensions of a page: kg mm, rpm and hp at letters, at numbers and in the words beside them.

In: letters' units and numbers as typed. Out: the dimension of a formula, and the units in which a
result's number is meant where the arithmetic alone does not say.
"""
