"""The Python blocks of docs/python.md, and the scripts of examples/python in short form.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import io
import json
import os
import re
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).parent))
from support import ROOT, Folder  # noqa: E402

sys.path.insert(0, str(ROOT / "docs"))
from run_pages import numbers_missing  # noqa: E402

EXAMPLES = {  # arguments of the short form, and a pattern of the output
    "sliding_angles": (["5"], r"largest error: [0-9.]+e-(0[7-9]|1\d)"),
    "old_file": ([], r"finished"),
    "slope_safety": (["1"], r"(?s)finished [a-z_ ]+0\.9[34].*probability of failure: 1\.00 of 1 joint sets"),  # 0.41 with a free back
    "intensity_table": (["2"], r"arc_crack_30"),
    "own_criterion": ([], r"step 75, time 0.75: 3 pictures"),
    "beam_study": (["0.5"], r"-0\.0226"),
}
NOTEBOOKS = ("sliding_angles", "old_file", "own_criterion")  # the others have the text of scripts that run above
FIGURES = {
    "sliding_velocity": (["0.5"], r"largest difference [0-9.]+e-0[3-9] m/s"),
    "sliding_block": (["2"], r"largest difference [0-9.]+e-0[6-9] m"),
    "cook_membrane": (["1"], r"derived +\d+: -\d"),
}


def plots_are_here():
    try:
        import matplotlib  # noqa: F401
        import pandas  # noqa: F401
    except ImportError:
        return False
    return True


@unittest.skipUnless(plots_are_here(), "matplotlib or pandas is not installed")
class Page(Folder):
    def test_each_block_runs_and_prints_the_numbers_shown(self):
        page = (ROOT / "docs/python.md").read_text(encoding="utf-8")
        for name in ("docs", "legacy_cases"):
            os.symlink(ROOT / name, self.folder / name)
        names, printed, blocks = {}, "", 0
        for kind, text in re.findall(r"^```(python|text)\n(.*?)^```$", page, re.S | re.M):
            if kind == "text":
                self.assertEqual(numbers_missing(text, printed), [], printed)
                continue
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                exec(compile(text, f"docs/python.md, block {blocks + 1}", "exec"), names)
            printed = out.getvalue()
            blocks += 1
        self.assertGreater(blocks, 8)

    def test_examples_run(self):
        for name in ("docs", "legacy_cases"):
            os.symlink(ROOT / name, self.folder / name)
        for folder, known in (("python", EXAMPLES), ("figures", FIGURES)):
            scripts = sorted(p.stem for p in (ROOT / "examples" / folder).glob("*.py"))
            self.assertEqual(scripts, sorted(known))
            for name in scripts:
                arguments, pattern = known[name]
                done = subprocess.run([sys.executable, "-B", ROOT / "examples" / folder / f"{name}.py", *arguments],
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                self.assertEqual(done.returncode, 0, f"{name}\n{done.stdout}")
                self.assertRegex(done.stdout, pattern, name)

    def test_notebooks_are_those_of_the_scripts_and_run(self):
        made = subprocess.run([sys.executable, "-B", ROOT / "docs/make_notebooks.py", "--check"], capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stdout)
        for name in ("docs", "legacy_cases"):
            os.symlink(ROOT / name, self.folder / name)
        (self.folder / "examples/notebooks").mkdir(parents=True)
        for name in NOTEBOOKS:
            arguments, pattern = EXAMPLES[name]
            cells = json.loads((ROOT / f"examples/notebooks/{name}.ipynb").read_text(encoding="utf-8"))["cells"]
            os.chdir(self.folder / "examples/notebooks")
            names, out = {}, io.StringIO()
            with contextlib.redirect_stdout(out), mock.patch("sys.argv", ["kernel", "-f", "kernel.json"]):
                for cell in (cell for cell in cells if cell["cell_type"] == "code"):
                    exec(compile("".join(cell["source"]), f"{name}.ipynb, {cell['id']}", "exec"), names)
                    if cell["id"] == "cell-2":  # which drops the arguments of Jupyter
                        self.assertEqual(sys.argv, ["kernel"])
                        sys.argv += arguments
            self.assertRegex(out.getvalue(), pattern, name)


if __name__ == "__main__":
    unittest.main()
