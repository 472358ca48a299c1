"""Reports on a checked page: for readers, for programs, as the author's own page, and as certificates.

In: verdicts. Out: a document for every medium, plain data, an HTML page with what is wrong first, a
table of many pages, and certificates that a separate program verifies.
"""
