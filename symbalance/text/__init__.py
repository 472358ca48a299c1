"""Strict reading of numbers, TOML and CSV files, and writing of files whole or not at all.

In: paths, texts, numbers in any spelling. Out: fractions, tables of TOML, rows of CSV, or a refusal that
names the file, the line, the value, the rule and the remedy. Knows nothing of engines.

    reals          real and complex numbers of many digits, which carry their own precision
    numbers        exact fractions from "360/7", 0.1 or 13.5;  measurements: of any length
    files          a file's text, the TOML in it;  toml_lines: on which line each key stands
    kinds          kinds of values;  key_tables: tables of keys, their reference and JSON Schema
    sections       tables of TOML read as their keys say
    csv_rows       rows of numbers, each with its line
    writing        files that appear whole or not at all
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
