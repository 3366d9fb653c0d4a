"""Sphinx settings: the documentation, built without a network."""

import os
import sys
from importlib.metadata import version as installed_version
from pathlib import Path

_here = Path(__file__).parent
sys.path[:0] = [str(_here / "extensions"), str(_here.parent / "tests" / "support" / "studies")]
os.environ["COLUMNS"] = "100"  # argparse wraps the help at this width

project = "stewart-sym"
author = "the stewart-sym authors"
version = release = installed_version("stewart-sym")

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "numpydoc",
    "mathml",
    "directives",
    "notebooks",
    "narrow_windows",
]
source_suffix = {".md": "markdown"}
exclude_patterns = ["_build", "tables"]
nitpicky = True
# Types of other packages, whose documentation would have to be fetched.
nitpick_ignore_regex = [
    ("py:.*", r"(numpy|np|casadi|sympy|collections|pathlib|os|types|Array|NDArray|ArrayLike)\b.*"),
    ("py:.*", r"stewart_sym\.(\w+\.)*_\w+"),
]

myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 3

autodoc_typehints = "none"  # the sections name them
autodoc_member_order = "bysource"
autosummary_generate = False
numpydoc_show_class_members = False
add_module_names = False

html_theme = "furo"
html_title = "stewart-sym"
html_static_path = ["static"]
html_css_files = ["wide.css"]
html_search_scorer = str(Path(__file__).parent / "static" / "scorer.js")
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
html_math_renderer = "mathml"
# Typographic quotes and dashes would change options such as --help.
smartquotes = False
# Comments contain results, so their contrast must be sufficient.
pygments_style = "default"
pygments_dark_style = "monokai"
