"""Against routes that share no code with the library: quadrature, geometry, rigid bodies, brute force."""
