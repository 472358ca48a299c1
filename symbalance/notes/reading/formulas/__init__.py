"""One formula's text to every tree it may mean: tokens, the parser, and what stands at a formula's end.

In: a passage's text and the letters that are declared. Out: formula trees, or why it cannot be read.
"""
