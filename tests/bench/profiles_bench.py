#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the cost of a step of profile `standard` over one of `legacy`, on the same files, side by side in one run, one thread.

The cost of a step is the difference of two runs of different length over their steps, so that reading, initial state and writing do
not count. Each run is the fastest of three, in processor time of one thread. The cost of the start is the rest of the shorter run.
Times alone mean nothing on another machine."""
import argparse
import csv
import json
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from processor_time import timed  # noqa: E402

SCENES = [("brick10", "scale_N10_maxd_0.01"), ("brick20", "scale_N20_maxd_0.01"), ("brick50", "scale_N50_maxd_0.01"),
          ("slope5", "slope_N5"), ("slope10", "slope_N10"), ("slope20", "slope_N20")]
REPEATS = 3


def run(program, files, profile, steps, folder):
    command = [program, "run", *map(str, files), "--profile", profile, "--set", f"steps={steps}", "--threads", "1",
               "-o", folder, "--force"]
    done, seconds = timed(command)
    if done.returncode not in (0, 1):
        errors = [line for line in done.stderr.splitlines() if "error" in line]
        raise RuntimeError(errors[-1] if errors else f"exit code {done.returncode}")
    report = json.loads((pathlib.Path(folder) / "run.json").read_text())
    with open(pathlib.Path(folder) / report["steps"]["table"]) as table:
        report["passes"] = [int(row["passes"]) for row in csv.DictReader(table)]
    return report, seconds


def measured(program, files, lengths, folder):
    """Returns the least seconds by profile and number of steps, and the last reports. Profiles and repeats alternate."""
    least, reports = {}, {}
    for _ in range(REPEATS):
        for profile in ("legacy", "standard"):
            for steps in lengths:
                report, seconds = run(program, files, profile, steps, folder)
                least[profile, steps] = min(seconds, least.get((profile, steps), seconds))
                reports[profile] = report
    return least, reports


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path, help="brick and slope files of the scaling study")
    parser.add_argument("--steps", type=int, nargs=2, default=(20, 120))
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    if not arguments.folder.is_dir():
        print(f"{arguments.folder}: not there; standard is not compared with legacy on its scenes")
        return 0
    print(f"{'scene':>9} {'blocks':>7} {'legacy ms':>10} {'standard ms':>12} {'ratio':>6} {'systems':>8} {'most':>5} {'start/step':>11}")
    rows = []
    short, long = arguments.steps
    with tempfile.TemporaryDirectory() as folder:
        for scene, analysis in SCENES:
            files = [arguments.folder / f"{scene}.geo", arguments.folder / f"{analysis}.ana"]
            try:
                least, reports = measured(arguments.program, files, arguments.steps, folder)
            except (RuntimeError, OSError) as error:
                print(f"{scene:>9} {error}")
                continue
            step = {p: (least[p, long] - least[p, short]) / (long - short) for p in ("legacy", "standard")}
            systems = reports["standard"]["passes"]
            start = (least["standard", short] - short * step["standard"]) / step["standard"]
            row = {"scene": scene, "blocks": reports["standard"]["counts"]["blocks"], "legacy": step["legacy"],
                   "standard": step["standard"], "ratio": step["standard"] / step["legacy"],
                   "systems": sum(systems) / len(systems), "most_systems": max(systems), "start_over_step": start}
            rows.append(row)
            print(f"{scene:>9} {row['blocks']:>7} {1e3 * row['legacy']:>10.2f} {1e3 * row['standard']:>12.2f} {row['ratio']:>6.2f} "
                  f"{row['systems']:>8.1f} {row['most_systems']:>5} {row['start_over_step']:>11.1f}", flush=True)
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
