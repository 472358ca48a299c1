"""Verdicts as text, JSON, LaTeX and Markdown."""
