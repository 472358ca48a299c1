"""Kinds of relations that are no plain step: equations solved below, dead centres, open series.

In: a relation and `judging_state`, what is known where it stands. Out: the verdict of its kind, or
nothing where it is not of that kind.
"""
