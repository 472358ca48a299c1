"""Sphinx extensions that make the site's pages: formulas, API, commands, derivations."""
