"""Crank webs: from the outline to the flexibility between a web's two faces and the masses at them.

- `arm`: one web in its own axes, near end at the origin, far end along u, mirrored if need be
- `mass_lumping`: its mass, divided between the nodes at its two faces
- `beam_webs`: a radial beam between stubs of journal and pin, or the same with Ker Wilson's lengths
- `fitted`: the same with the paper's six flexibilities, fitted to a solid web
- `sector`: a counterweight from its drawing, a sector's mass, centre and inertia
"""
