#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures whole runs of small files in both profiles: 1,000 steps with all results. Most files of this field are like them.

Each time is the processor time of one process with one thread, the least of some runs in turn. The share of stepping comes
from a second run less a run of one step. The second run writes the first and the last frame alone, without contacts and
pictures. --beside PROGRAM runs another build in turn, and prints the ratio."""
import argparse
import json
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from processor_time import timed  # noqa: E402

SCENES = {"wedge2": ("wedge2_p5_dt1ms/wedge2_p5_dt1ms.geo", "wedge2_p5_dt1ms/wedge2_p5_dt1ms.ana"),
          "brick5": ("scaling/brick5.geo", "scaling/scale_N5_maxd_0.01.ana"),
          "slope5": ("scaling/slope5.geo", "scaling/slope_N5.ana")}
STEPS = 1000
BARE = ["--no-pictures", "--contacts", "none", "--record-every", str(STEPS)]


def seconds(program, files, profile, folder, steps=STEPS, more=()):
    command = [program, "run", *map(str, files), "--profile", profile, "--set", f"steps={steps}", "--threads", "1", "-o", folder,
               "--force", *more]
    done, used = timed(command)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{' '.join(command)}: exit code {done.returncode}\n{done.stderr}")
    return used


def measured(program, beside, files, profile, repeats, folder):
    """Returns the least seconds of the runs: whole, stepping, and of the other program."""
    runs = {"whole": lambda: seconds(program, files, profile, folder),
            "bare": lambda: seconds(program, files, profile, folder, more=BARE),
            "one": lambda: seconds(program, files, profile, folder, steps=1, more=BARE)}
    if beside:
        runs["beside"] = lambda: seconds(beside, files, profile, folder)
    least = {}
    for _ in range(repeats):
        for name, run in runs.items():
            least[name] = min(run(), least.get(name, float("inf")))
    return least


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path, help="runs of the Berkeley program")
    parser.add_argument("--beside", help="another build")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--json", type=pathlib.Path)
    asked = parser.parse_args()
    if not asked.folder.is_dir():
        print(f"{asked.folder}: not there; whole runs of small files are not measured")
        return 0
    of_other = f" {'beside ms':>10} {'ratio':>6}" if asked.beside else ""
    print(f"{'scene':>7} {'profile':>9} {'run ms':>8} {'stepping':>9}{of_other}")
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for scene, names in SCENES.items():
            for profile in ("legacy", "standard"):
                files = [asked.folder / name for name in names]
                least = measured(asked.program, asked.beside, files, profile, asked.repeats, folder)
                row = {"scene": scene, "profile": profile, "seconds": least["whole"],
                       "stepping": (least["bare"] - least["one"]) / least["whole"]}
                text = f"{scene:>7} {profile:>9} {1e3 * row['seconds']:>8.0f} {row['stepping']:>9.2f}"
                if asked.beside:
                    row.update(beside=least["beside"], ratio=least["whole"] / least["beside"])
                    text += f" {1e3 * row['beside']:>10.0f} {row['ratio']:>6.2f}"
                print(text, flush=True)
                rows.append(row)
    if asked.json:
        asked.json.write_text(json.dumps(rows, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
