"""Motions of the piston and the rod that words name, with the place of the crank.

In: a relation with the words around it. Out: whether its formula is that motion there, or one slip away.
"""
