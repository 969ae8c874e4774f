"""The documentation site; `cargo xtask site` builds it."""

import os
import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "_extensions"))

import gallery  # noqa: E402
import site_content  # noqa: E402

import schlupf  # noqa: E402

project = "schlupf"
author = "The schlupf developers"
copyright = author
version = release = schlupf.__version__

extensions = [
    "myst_nb",
    "numpydoc",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx_copybutton",
    "sphinx_design",
    "sphinxcontrib.bibtex",
    "site_content",
    "gallery",
    "python_reference",
    "references",
    "site_checks",
]
exclude_patterns = ["_extensions", "_static", "requirements.txt"]
bibtex_bibfiles = ["references.bib", os.path.relpath(site_content.cited(), HERE)]
nitpicky = False

# Pages.
myst_enable_extensions = ["amsmath", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 4
# Sketches of JSON with "…" in it are not JSON.
suppress_warnings = ["misc.highlighting_failure"]

# Equations, without a server of others; with all extensions, which are not copied.
mathjax_path = "mathjax/tex-svg-full.js"

# Notebooks. A result is reused as long as neither the package nor what it reads has changed.
nb_execution_mode = "cache"
nb_execution_cache_path = str(site_content.cache())
nb_execution_timeout = 300
nb_execution_raise_on_error = True
nb_merge_streams = True
# A warning of a cell is one of the build.
nb_output_stderr = "warn"
nb_render_markdown_format = "myst"
os.environ["IPYTHONDIR"] = str(site_content.kernels())
os.environ["MATPLOTLIBRC"] = str(HERE / "matplotlibrc")

# The Python package.
autodoc_member_order = "bysource"
toc_object_entries_show_parents = "hide"
# Types of attributes; those of arguments are in the text.
autodoc_typehints = "description"
autodoc_typehints_description_target = "documented"
numpydoc_show_class_members = False
numpydoc_class_members_toctree = False

# Appearance.
html_theme = "pydata_sphinx_theme"
html_title = "schlupf"
html_static_path = ["_static"]
html_css_files = ["site.css"]
# The explorer, where it was built.
html_extra_path = [str(path) for path in [gallery.EXPLORER] if path.exists()]
html_show_sourcelink = False
html_copy_source = False
html_theme_options = {
    "header_links_before_dropdown": 8,
    "navigation_with_keys": False,
    "secondary_sidebar_items": ["page-toc"],
    "show_prev_next": True,
    "navbar_persistent": ["search-button"],
    "footer_start": ["copyright"],
    "footer_end": ["sphinx-version"],
}
html_sidebars = {page: [] for page in ("index", "command", "python")}
copybutton_exclude = ".linenos, .gp, .go"
