"""Numbers, values and words of arithmetic as people write them, put into the signs the parser knows.

In: a page's text. Out: the same text with decimal commas, ranges, "twice R", 478 : 4, lists of values and
lines that a paragraph's end cuts in one form.
"""
