"""What the words of a page say to mathematics: cases, sections, items, degrees without a sign.

In: the text between relations, and numbers as they were typed. Out: how far a premise reaches, which
case is open, how a number is written. Nothing is decided here.
"""
