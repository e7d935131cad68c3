"""Builds the pages of this repository as a site (`make docs`), with Debian's packages alone; nothing is fetched."""
import posixpath
import re
import shutil
from pathlib import Path

project = "Keyblock"
author = "the authors of Keyblock"
root_doc = "docs/site/index"
extensions = ["myst_parser", "sphinx.ext.mathjax"]
include_patterns = [
    "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "docs/*.md", "docs/**/*.md", "formats/README.md", "formats/**/README.md",
    "src/README.md", "legacy_cases/README.md", "legacy_cases/fronts/README.md", "legacy_cases/berkeley_tables/README.md",
]
exclude_patterns = ["build*", "out"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
suppress_warnings = ["toc.not_readable", "myst.header"]  # pages are found by links, as on any forge
smartquotes = False  # options keep both of their dashes
html_theme = "furo"
html_title = "Keyblock"
html_static_path = ["static", "/usr/share/javascript/katex"]
html_css_files = ["site.css"]
mathjax_path = "draw_maths.js"  # KaTeX, from the static files


def lead_to_manual(app, page, text):
    """Lets links to the README of a case lead to its page of the verification manual, which has the same text and the values."""
    folder = posixpath.dirname(page)

    def target(match):
        case = re.fullmatch(r"legacy_cases/(\w+)/README\.md", posixpath.normpath(posixpath.join(folder, match[1])))
        manual = f"docs/verification/{case[1]}.md" if case else ""
        if not case or not (Path(app.srcdir) / manual).is_file():
            return match[0]
        return f"]({posixpath.relpath(manual, folder or '.')}{match[2] or ''})"
    text[0] = re.sub(r"\]\(([^()\s#]+)(#[^()\s]*)?\)", target, text[0])


def copy_pictures(app, error):
    """Copies the pictures of <img> tags, which Sphinx leaves out, to where the tags look for them."""
    for page in [] if error else app.env.found_docs:
        for name in re.findall(r'<img src="([^":]+)"', Path(app.env.doc2path(page)).read_text(encoding="utf-8")):
            picture = posixpath.normpath(posixpath.join(posixpath.dirname(page), name))
            target = Path(app.outdir) / picture
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(Path(app.srcdir) / picture, target)


def setup(app):
    app.connect("source-read", lead_to_manual)
    app.connect("build-finished", copy_pictures)
