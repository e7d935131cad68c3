#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares a static run of a plate of about 99,000 unknowns with the bare assembly, factor and solution of such a plate.

Both are whole processes of one thread: processor time, the least of some runs in turn, and the greatest memory. Asked: at
most 4 times the time and 2.5 times the memory. Exit code 1 if one is missed. --functions derived: the same with quadratic
functions, beside the matrix of the linear ones.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

REPEATS = 5
MOST_TIME = 4
MOST_MEMORY = 2.5


def plate(functions, side=0.0101):
    return {"keyblock": 1,
            "blocks": {"blocks": [{"outer": [[0, 0, 1], [2, 0, 1], [2, 1, 1], [0, 1, 1]]}], "measured_points": [[2, 0.5, 1]]},
            "covers": {"mesh": {"kind": "unstructured", "placement": "aligned", "side": side}, "functions": functions,
                       "displacements": [{"along": [[0, 1], [0, 0]]}], "tractions": [{"along": [[2, 0], [2, 1]], "y": -0.001}]},
            "analysis": {"step_count": 1, "time_step": 1, "allowed_displacement_ratio": 0.1, "plane_strain": True,
                         "block_materials": [{"density": 1, "unit_weight": 0, "youngs_modulus": 1000.0, "poissons_ratio": 0.3}],
                         "joint_materials": [{}]}}


def measured(command):
    """Seconds of the processor and megabytes of one process, and what it printed."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    text = process.stdout.read().decode()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise RuntimeError(f"{command[0]} ended with {process.returncode}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, text


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("bare", help="the program bare_plate")
    options.add_argument("--functions", default="constant")
    options.add_argument("--json")
    asked = options.parse_args()
    bare, whole = [], []
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(folder) / "plate.json"
        case.write_text(json.dumps(plate(asked.functions)))
        for turn in range(REPEATS):
            bare.append(measured([asked.bare]))
            out = str(pathlib.Path(folder) / str(turn))
            whole.append(measured([asked.program, "run", str(case), "--threads", "1", "--json", "-o", out]))
    bare_seconds, seconds = (min(run[0] for run in runs) for runs in (bare, whole))
    bare_memory, memory = (min(run[1] for run in runs) for runs in (bare, whole))
    result = {"unknowns": [json.loads(bare[0][2])["unknowns"], json.loads(whole[0][2])["counts"]["unknowns"]],
              "seconds": [bare_seconds, seconds], "megabytes": [bare_memory, memory],
              "time_ratio": seconds / bare_seconds, "memory_ratio": memory / bare_memory}
    print(f"bare: {result['unknowns'][0]} unknowns, {bare_seconds:.2f} s, {bare_memory:.0f} MB")
    print(f"run:  {result['unknowns'][1]} unknowns, {seconds:.2f} s, {memory:.0f} MB")
    print(f"ratio of time {result['time_ratio']:.2f} (asked: {MOST_TIME}), of memory {result['memory_ratio']:.2f} (asked: {MOST_MEMORY})")
    if asked.json:
        pathlib.Path(asked.json).write_text(json.dumps(result, indent=1) + "\n")
    return 0 if result["time_ratio"] <= MOST_TIME and result["memory_ratio"] <= MOST_MEMORY else 1


if __name__ == "__main__":
    sys.exit(main())
