"""The built pages in the repository equal those built from their sources, byte for byte.

usage: tests/serve/built_page_test.py REPOSITORY

Skipped, with a message, if node is missing or too old, or if `npm ci` was not run in page/.
"""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

LEAST = (20, 19)


def skip(why):
    print(f"skipped: {why}")
    sys.exit(0)


def require_tools(page):
    """Skips the test without node and the packages of page/."""
    node = shutil.which("node")
    if node is None:
        skip("no node is installed")
    version = subprocess.run([node, "--version"], capture_output=True, text=True, check=True).stdout
    found = tuple(int(n) for n in re.match(r"v(\d+)\.(\d+)", version).groups())
    if found < LEAST:
        skip(f"node {version.strip()} is older than {LEAST[0]}.{LEAST[1]}")
    if not (page / "node_modules/vite").is_dir():
        skip("npm ci was not run in page/")


def main():
    page = Path(sys.argv[1]) / "page"
    require_tools(page)
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "page"
        shutil.copytree(page, copy, ignore=shutil.ignore_patterns("node_modules", "built"))
        (copy / "node_modules").symlink_to((page / "node_modules").resolve())
        done = subprocess.run(["npm", "run", "build"], cwd=copy, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stdout + done.stderr)
        differing = [name for name in ("run.html", "serve.html")
                     if (copy / "built" / name).read_bytes() != (page / "built" / name).read_bytes()]
    if differing:
        sys.exit(f"page/built: {', '.join(differing)} differ from what `npm run build` makes")


if __name__ == "__main__":
    main()
