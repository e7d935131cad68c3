#!/usr/bin/env python3
"""Runs the commands of Markdown pages and compares the numbers that the pages quote.

usage: docs/run_pages.py PROGRAM [--all] PAGE…

The blocks marked ```sh of a page run in order in one fresh folder, in bash, until the first fault. `keyblock` is
PROGRAM there, and each path of the repository that a block names (docs/…, legacy_cases/…, examples/…) is copied into
the folder, with all of its folder if it is a pattern. Comments of a block say what to expect:

    # exits with N    the block ends with this exit code instead of 0
    # long            the block runs with --all alone; so do the later blocks of its page

A block marked ```text behind it shows output, shortened by lines and by dots (…). Each number in it has to occur in
what the block before printed, to 1 %. The words of each line have to occur too, in their order. A block without a mark
runs if it begins with "$ ": such lines are commands, the others are output.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"^( *)```(sh|text) *\n(.*?)^ *``` *$", re.S | re.M)
SESSION = re.compile(r"^    \$ .*\n(?:    .*\n)*", re.M)
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")


def blocks_of(page):
    """(line, kind, text) of the marked blocks, then of those that begin with "$ "."""
    text = page.read_text(encoding="utf-8")
    for found in BLOCK.finditer(text):
        indent = found.group(1)
        lines = [line[len(indent):] if line.startswith(indent) else line for line in found.group(3).split("\n")]
        yield text.count("\n", 0, found.start()) + 1, found.group(2), "\n".join(lines)
    for found in SESSION.finditer(text):
        lines = [line[4:] for line in found.group().split("\n")]
        begin = text.count("\n", 0, found.start()) + 1
        yield begin, "sh", "\n".join(line[2:] for line in lines if line.startswith("$ "))
        yield begin, "text", "\n".join(line for line in lines if not line.startswith("$ "))


def copy_named(text, folder):
    for name in set(re.findall(r"(?<![\w/.-])(?:docs|legacy_cases|examples)/[\w./-]*\w", text)):
        if not (ROOT / name).exists():  # a pattern: its whole folder
            name = os.path.dirname(name)
        source, target = ROOT / name, folder / name
        if target.exists():
            continue
        if source.is_dir():
            shutil.copytree(source, target)
        elif source.is_file():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)


def numbers_missing(text, output):
    printed = [float(n) for n in NUMBER.findall(output)]
    return [n for n in NUMBER.findall(text)
            if not any(abs(abs(p) - abs(float(n))) <= 0.01 * abs(float(n)) for p in printed)]


def plain(text):
    """The text with # instead of each number, and single spaces."""
    return re.sub(r"\s+", " ", NUMBER.sub("#", text)).strip()


def words_missing(text, output):
    printed = plain(output)
    parts = [plain(part) for line in text.split("\n") for part in line.split("…")]
    return [part for part in parts if part not in printed]


def run_page(page, program, with_long):
    """The first fault of the page, or nothing."""
    with tempfile.TemporaryDirectory(prefix="keyblock_page_") as name:
        folder = Path(name)
        (folder / "bin").mkdir()
        (folder / "bin" / "keyblock").symlink_to(program)
        place = folder / "page"
        place.mkdir()
        environment = dict(os.environ, PATH=f"{folder / 'bin'}{os.pathsep}{os.environ['PATH']}", NO_COLOR="1")
        output = ""
        for line, kind, text in blocks_of(page):
            if kind == "text":
                missing = numbers_missing(text, output) + words_missing(text, output)
                if missing:
                    return f"{page}:{line}: the commands before did not print {', '.join(missing)}\n{output}"
                continue
            if re.search(r"^ *# long\b", text, re.M) and not with_long:
                return None
            copy_named(text, place)
            wanted = re.search(r"# exits with (\d+)", text)
            done = subprocess.run(["bash", "-euo", "pipefail", "-c", text], cwd=place, env=environment,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            output = done.stdout
            if done.returncode != (int(wanted.group(1)) if wanted else 0):
                return f"{page}:{line}: the block exits with {done.returncode}\n{output}"
    return None


def main(arguments):
    with_long = "--all" in arguments
    arguments = [a for a in arguments if a != "--all"]
    if len(arguments) < 2:
        sys.exit("usage: docs/run_pages.py PROGRAM [--all] PAGE…")
    program = Path(arguments[0]).resolve()
    faults = 0
    for page in map(Path, arguments[1:]):
        began = time.monotonic()
        fault = run_page(page, program, with_long)
        print(f"{page}: {'fault' if fault else 'ok'}, {time.monotonic() - began:.1f} s")
        if fault:
            faults += 1
            print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
