"""The page's relations in order, each given its verdict.

In: a document, its declarations and a provider of engines. Out: a verdict for every relation: `judge`
goes through the page, `one_relation` gives the verdict, `appeals` and `open_reasons` are heard before a
refutation stands.
"""
