"""Where on a page mathematics stands: each passage that may be an equation, and where it ends.

In: a page's text in one form. Out: the segments that may be equations, in order, whole or refused.
"""
