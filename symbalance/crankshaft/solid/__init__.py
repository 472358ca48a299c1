"""Finite elements in three dimensions: a half throw's flexibility, a whole crank's free modes.

    meshing     parts drawn as gmsh solids, meshed as a scikit-fem mesh with curved edges
    elasticity  stiffness and mass of the quadratic tetrahedra
    half_throw  six unit loads on half a throw: its flexibility, and the web's share of it
    reference   natural modes of whole cranks, for comparison
    store       solved flexibilities as data, by geometry

gmsh (GPL) and scikit-fem are tools beside the library: only `meshing` and `elasticity` import them, when
they run.
"""
