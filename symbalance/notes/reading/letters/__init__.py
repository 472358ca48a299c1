"""Letters however they are written: one name for each, and which signs are one letter.

In: a page's text. Out: the same text with its letters spelled as the parser knows them: lambda as λ,
Fmax and F2x as one letter each, the l that a scanner took for a 1, sen as sin.
"""
