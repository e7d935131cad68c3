"""The quick part of `make test-web`: a page opens, scrubs and picks, and shows the numbers of its run.

usage: tests/serve/browser_test.py REPOSITORY PROGRAM

Skipped, with a message, without Chromium, node, or the packages of page/.
"""

import os
import subprocess
import sys
from pathlib import Path

from built_page_test import require_tools, skip

QUICK = "opens at the last frame|a click chooses a block|values on the screen equal the record"


def main():
    page = Path(sys.argv[1]) / "page"
    require_tools(page)
    if not Path(os.environ.get("CHROMIUM", "/usr/bin/chromium")).exists():
        skip("no Chromium is installed (Debian package chromium)")
    command = ["npx", "vitest", "run", "--config", "vitest.page.config.ts", "page/page.test", "page/program.test",
               "-t", QUICK]
    environment = {**os.environ, "KEYBLOCK": sys.argv[2]}
    done = subprocess.run(command, cwd=page, env=environment, capture_output=True, text=True)
    if done.returncode != 0 or "3 passed" not in done.stdout:
        sys.exit(done.stdout + done.stderr)


if __name__ == "__main__":
    main()
