"""Sphinx configuration of the documentation: everything is built from this checkout, offline."""

import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE), str(HERE.parent)]

import symbalance  # noqa: E402

project = "symbalance"
author = "the symbalance authors"
version = release = symbalance.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "extensions.formulas",
    "extensions.docstrings",
    "extensions.generated_pages",
    "extensions.atlas_pages",
]
exclude_patterns = ["_build", "extensions", "command-line.md"]

html_theme = "furo"
html_title = f"symbalance {release}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_math_renderer = "symbalance"
html_copy_source = False
html_show_sourcelink = False
html_show_copyright = False

myst_enable_extensions = ["dollarmath", "amsmath"]
myst_heading_anchors = 4
myst_links_external_new_tab = False
suppress_warnings = ["myst.header"]

autodoc_member_order = "bysource"
autodoc_typehints_format = "short"
autodoc_preserve_defaults = True
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 88
toc_object_entries = False
highlight_language = "text"
