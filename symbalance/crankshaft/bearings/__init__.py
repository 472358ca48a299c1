"""Main bearings: oil films, their tangents against the crank angle, tables, housings in series.

short_film   the short-bearing film in closed form: force, stiffness, damping, static equilibrium
orbits       the periodic orbit of journals under given loads, and the film tangents along it
closing      that orbit by Newton's method on all its steps together
periodic     coefficients between the angles of a table; what a table may hold
csv_table    tables from a CSV file
series       film and housing in series: the paper's equivalent coefficients, and the exact ones
"""
