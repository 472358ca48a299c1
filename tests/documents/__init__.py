"""What is printed: results in every medium, golden files, derivations, README."""
