"""Sphinx extensions that make this site's pages from the package: formulas, API, commands, derivations."""
