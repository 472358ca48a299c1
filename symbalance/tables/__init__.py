"""Results as people and programs read them: text for a terminal, LaTeX for a document, JSON."""
