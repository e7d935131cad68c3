"""Builds the pages of this repository as a site (`make docs`), with Debian's packages alone; nothing is fetched."""

project = "Keyblock"
author = "the authors of Keyblock"
root_doc = "docs/site/index"
extensions = ["myst_parser", "sphinx.ext.mathjax"]
include_patterns = [
    "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "docs/*.md", "docs/**/*.md", "formats/README.md", "formats/**/README.md",
    "src/README.md", "legacy_cases/README.md", "legacy_cases/**/README.md",
]
exclude_patterns = ["build*", "out"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
suppress_warnings = ["toc.not_readable", "myst.header"]  # pages are found by links, as on any forge
html_theme = "furo"
html_title = "Keyblock"
html_static_path = ["static", "/usr/share/javascript/katex"]
mathjax_path = "draw_maths.js"  # KaTeX, from the static files
