"""Solid models: a half throw's flexibility and a whole crank's free modes, meshed and solved elsewhere.

    drawing     journals, pins, webs and counterweights as gmsh solids
    meshing     a gmsh session and what it meshes, as a scikit-fem mesh with curved edges
    elasticity  stiffness and mass of the quadratic tetrahedra
    half_throw  six unit loads on half a throw: its flexibility, and the web's share of it
    free_modes  natural modes of a whole crank
    store       solved flexibilities as data, by geometry

gmsh (GPL) and scikit-fem are tools beside the library: only `meshing` and `elasticity` import them, when
they run.
"""
