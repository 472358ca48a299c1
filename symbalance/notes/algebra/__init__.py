"""Exact algebra of hand-written formulas: a normal form in which equality is decided.

In: formula trees and what their letters stand for. Out: normal forms, of which it is decided whether two
are equal (proved, refuted, or left open), series, harmonics, and values at points.

    domain, polynomials, zero       generators, Laurent polynomials in them, and the test for zero
    forms, roots, functions         quotients of polynomials, and what may be applied to them
    derivatives, series             rates of change, and expansion in a small letter
    evaluation                      a formula's tree to its form
    values, tree_values             numbers at exact points, to 40 digits
    harmonics, number_formulas      back to formulas that people read
"""
