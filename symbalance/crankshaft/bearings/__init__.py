"""Main bearings: oil films, their stiffness and damping over the crank angle, tables, housings in series.

short_film   the short-bearing film in closed form: force, stiffness, damping, static equilibrium
orbits       the periodic orbit of journals under given loads, and the film tangents along it
periodic_newton   that orbit by Newton's method on all its steps together
film_tables  coefficients between the angles of a table; what a table may hold; CSV files
series       film and housing in series: the paper's equivalent coefficients, and the exact ones
"""
