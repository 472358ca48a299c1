"""What file formats and LaTeX packages put around or for a formula, put into plain LaTeX.

In: the text of a file as its format has it. Out: the same text in plain LaTeX, each character knowing
where it stood. One idea a file: a package, a format, a mark.
"""
