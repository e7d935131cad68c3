#!/usr/bin/env python3
"""Runs a sweep over random joint sets in several ways and compares the bytes of the tables.

usage: many_runs.py PROGRAM [--count N] [--tasks N]

The ways: one process; the script for Slurm; the line for GNU parallel, and shards on Dask, if these are installed.
Tasks of Slurm are started as Slurm does, killed once (SIGKILL) and queued again. Each table has to equal the first.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

JOINTS = {"slope": {"height": 6, "angle": 60, "toe": 3, "crest": 6, "base": 2}, "fixed": [[-3, -1.9, 12, -1.9]],
          "sets": [{"dip": dip, "spacing": 2, "trace": 100, "scatter": 0.2, "joint": 1} for dip in (35, 118)]}
CASE = {"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"},
        "analysis": {"step_count": 3, "time_step": "1 ms", "block_materials": [{"like": "limestone"}],
                     "joint_materials": [{"name": "bedding", "friction_angle_deg": 36}]}}


def start(script, folder, **more):
    return subprocess.Popen(["bash", "-c", script], cwd=folder, env={**os.environ, **more}, start_new_session=True,
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def by_slurm(command, folder, tasks):
    """Two tasks at a time; the first two are killed with all their processes, and come again."""
    script = subprocess.run([*command, "--slurm", str(tasks)], cwd=folder, stdout=subprocess.PIPE, text=True, check=True).stdout
    killed = [start(script, folder, SLURM_ARRAY_TASK_ID=str(k)) for k in (1, 2)]
    time.sleep(3)
    for task in killed:
        os.killpg(task.pid, signal.SIGKILL)
        task.wait()
    for first in range(1, tasks + 1, 2):
        running = [start(script, folder, SLURM_ARRAY_TASK_ID=str(k)) for k in (first, first + 1) if k <= tasks]
        if any(task.wait() for task in running):
            raise SystemExit("a task of the script failed")
    subprocess.run([*command, "--merge"], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def by_parallel(command, folder, tasks):
    line = subprocess.run([*command, "--parallel", str(tasks)], cwd=folder, stdout=subprocess.PIPE, text=True, check=True).stdout
    start(line, folder).wait()


def by_dask(command, folder, tasks):
    from distributed import Client
    with Client(n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
        shards = [[*command, "--jobs", "1", "--shard", f"{k}/{tasks}"] for k in range(1, tasks + 1)]
        client.gather([client.submit(subprocess.run, shard, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                     pure=False) for shard in shards])
    subprocess.run([*command, "--merge"], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--tasks", type=int, default=8)
    asked = parser.parse_args()
    ways = {"slurm": by_slurm}
    if shutil.which("parallel"):
        ways["parallel"] = by_parallel
    try:
        import distributed  # noqa: F401
        ways["dask"] = by_dask
    except ImportError:
        pass
    with tempfile.TemporaryDirectory(prefix="keyblock_runs_") as name:
        folder = Path(name)
        (folder / "joints.json").write_text(json.dumps(JOINTS), encoding="utf-8")
        (folder / "face.json").write_text(json.dumps(CASE), encoding="utf-8")
        sweep = [asked.program, "sweep", "face.json", "--joints", "joints.json", "--over", f"joints:/seed=1:{asked.count}:1",
                 "--over", "joints:/sets/0/dip=normal(35,3)", "--random", str(asked.count), "--out", "displacement,blocks"]
        subprocess.run([*sweep, "-o", "whole"], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        whole = (folder / "whole/table.csv").read_bytes()
        faults = 0
        for way, work in ways.items():
            began = time.monotonic()
            work([*sweep, "-o", way], folder, asked.tasks)
            table = folder / way / "table.csv"
            is_same = table.exists() and table.read_bytes() == whole
            faults += not is_same
            print(f"{way}: {asked.count} rows, {time.monotonic() - began:.0f} s, {'same bytes' if is_same else 'ANOTHER TABLE'}")
    return faults


if __name__ == "__main__":
    sys.exit(main())
