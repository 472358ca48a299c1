"""What SymPy, mpmath and other libraries are relied on for."""
