"""Free forces, couples, firing intervals and lever arms of whole engines that words name.

In: a relation with the words around it. Out: whether its formula is that engine's, or one slip away.
"""
