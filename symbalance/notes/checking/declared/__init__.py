"""What a page's letters are declared to be, and what they stand for: roles, the symbols file, proposals.

In: a symbols file and the words around letters. Out: each letter's role, formulas for letters such as r
= s/2, and the quantities of engines a line may be bound to, by a provider that the caller hands in.
"""
