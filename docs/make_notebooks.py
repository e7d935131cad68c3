#!/usr/bin/env python3
"""Writes the notebooks in examples/notebooks from the scripts in examples/python.

usage: docs/make_notebooks.py [--check]    --check writes nothing, and fails if a notebook differs from its script

The docstring of a script becomes the first cell, as text. A line `# %%` begins a further cell of code.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import ast
import json
import sys
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
SETUP = """import os
import sys

if os.path.basename(os.getcwd()) == "notebooks":
    os.chdir("../..")  # the repository, whose files the cells read
sys.argv = sys.argv[:1]  # Jupyter has arguments of its own"""


def cell(kind, text, number):
    lines = text.strip().splitlines(keepends=True)
    code = {"execution_count": None, "outputs": []} if kind == "code" else {}
    return {"cell_type": kind, "id": f"cell-{number}", "metadata": {}, **code, "source": lines}


def notebook_of(script):
    """Text of the notebook of a script."""
    text = script.read_text(encoding="utf-8")
    docstring = ast.parse(text).body[0]
    title = ast.get_docstring(ast.parse(text)).rpartition("\nSPDX-License-Identifier")[0]
    title = "\n\n".join(part.strip() for part in title.split("\n\n") if not part.startswith("    python3 "))
    code = "".join(text.splitlines(keepends=True)[docstring.end_lineno:])
    parts = [("markdown", f"# {title}"), ("code", SETUP), *(("code", part) for part in code.split("# %%\n") if part.strip())]
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return json.dumps({"cells": [cell(*part, i) for i, part in enumerate(parts, 1)],
                       "metadata": {"kernelspec": kernel, "language_info": {"name": "python"}},
                       "nbformat": 4, "nbformat_minor": 5}, indent=1, ensure_ascii=False) + "\n"


def main():
    folder = EXAMPLES / "notebooks"
    texts = {folder / f"{script.stem}.ipynb": notebook_of(script) for script in sorted((EXAMPLES / "python").glob("*.py"))}
    stale = [path for path in sorted({*texts, *folder.glob("*.ipynb")})
             if not path.exists() or path.read_text(encoding="utf-8") != texts.get(path)]
    for path in stale:
        if "--check" in sys.argv:
            print(f"{path}: error: expected the notebook of examples/python; docs/make_notebooks.py writes it")
        elif path in texts:
            folder.mkdir(exist_ok=True)
            path.write_text(texts[path], encoding="utf-8")
        else:
            path.unlink()
    return int("--check" in sys.argv and bool(stale))


if __name__ == "__main__":
    sys.exit(main())
