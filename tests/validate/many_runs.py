#!/usr/bin/env python3
"""Sweeps random joint sets on several engines, kills parts of them, and compares the bytes of the tables.

usage: many_runs.py PROGRAM [--count N] [--tasks N] [--only ENGINE]... [--package FOLDER]

The engines: the command alone; Slurm (daemons of this test on this machine); GNU parallel; Dask; `batch` over an archive
of the same cases. The table of `batch` comes from its catalogue and from the records of its runs. Each engine does all rows
once, while a part of it is killed: the table must have the bytes of an undisturbed sweep. Each does a fifth of them
again, while one run is killed: one row must be SIGKILL, and all other rows the same. An engine that is not installed is
left out with a message.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import csv
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import slurm_daemons

HERE = Path(__file__).resolve().parent
JOINTS = {"slope": {"height": 6, "angle": 60, "toe": 3, "crest": 6, "base": 2}, "fixed": [[-3, -1.9, 12, -1.9]],
          "sets": [{"dip": dip, "spacing": 2, "trace": 100, "scatter": 0.2, "joint": 1} for dip in (35, 118)]}
CASE = {"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"},
        "analysis": {"step_count": 3, "time_step": "1 ms", "block_materials": [{"like": "limestone"}],
                     "joint_materials": [{"name": "bedding", "friction_angle_deg": 36}]}}
OUTPUTS = "displacement,blocks"
QUIET = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}


class Study:
    """The rows of a sweep in a folder of results."""

    def __init__(self, asked, folder, name, count):
        self.asked, self.folder, self.name, self.count = asked, folder, name, count
        self.sweep = [asked.program, "sweep", "face.json", "--joints", "joints.json", "--over", f"joints:/seed=1:{count}:1",
                      "--over", "joints:/sets/0/dip=normal(35,3)", "--random", str(count), "--out", OUTPUTS, "-o", name]

    def run(self, *options):
        return subprocess.run([*self.sweep, *options], cwd=self.folder, **QUIET).returncode

    def printed(self, *options):
        return subprocess.run([*self.sweep, *options], cwd=self.folder, stdout=subprocess.PIPE, text=True, check=True).stdout

    def table(self):
        table = self.folder / self.name / "table.csv"
        return table.read_text(encoding="utf-8").split("\n") if table.exists() else []

    def results(self):
        """Lines of all journals: the rows done so far."""
        lines = []
        for journal in (self.folder / self.name).glob("journal*.jsonl"):
            lines += journal.read_text(encoding="utf-8").split("\n")[1:-1]
        return lines

    def wait_for(self, share):
        while len(self.results()) < share * self.count:
            time.sleep(0.05)

    def processes(self, *words):
        """Process ids of the program with these words in its command."""
        wanted = [str(self.asked.program).encode(), *[w.encode() for w in words]]
        found = []
        for entry in filter(str.isdigit, os.listdir("/proc")):
            try:
                line = Path("/proc", entry, "cmdline").read_bytes().split(b"\0")
                here = os.readlink(f"/proc/{entry}/cwd") == str(self.folder)
            except OSError:
                continue
            is_program = line[0] == b"keyblock-job" or line[0] == wanted[0]
            if here and is_program and all(any(w in word for word in line) for w in wanted[1:]):
                found.append(int(entry))
        return found


class ArchiveStudy(Study):
    """The same rows as folders of an archive: `keyblock joints` draws the joints of each, and `batch` runs them."""

    def __init__(self, asked, folder, name, count):
        super().__init__(asked, folder, name, count)
        self.archive = folder / f"{name}_archive"
        self.plan = self.rows_of_sweep()
        for job, row in self.plan.items():
            (self.archive / job).mkdir(parents=True)
            joints = {**JOINTS, "seed": int(row["joints:/seed"])}
            joints["sets"] = [{**JOINTS["sets"][0], "dip": float(row["joints:/sets/0/dip"])}, *JOINTS["sets"][1:]]
            statistics = folder / "joints_of_a_row.json"
            statistics.write_text(json.dumps(joints), encoding="utf-8")
            subprocess.run([asked.program, "joints", statistics, "-o", self.archive / job / "drawing.geo"], check=True, **QUIET)
            shutil.copy(folder / "face.json", self.archive / job)
        self.sweep = [asked.program, "batch", self.archive.name, "--run", "--profile", "standard", "-o", name]

    def rows_of_sweep(self):
        """Values of the keys of each row, as the undisturbed sweep of as many rows has written them."""
        with (self.folder / f"undisturbed_{self.count}" / "table.csv").open(encoding="utf-8", newline="") as table:
            return {row["job"]: row for row in csv.DictReader(table)}

    def table(self):
        """The table of a sweep, with verdicts and values of the catalogue."""
        catalogue = self.folder / self.name / "catalogue.json"
        if not catalogue.exists():
            return []
        jobs = {job["job"].split("/")[0]: job for job in json.loads(catalogue.read_text(encoding="utf-8"))["jobs"]}
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(next(iter(self.plan.values())))
        for job, row in self.plan.items():
            writer.writerow([row["joints:/seed"], row["joints:/sets/0/dip"], *self.end_of(jobs[job]), job])
        return text.getvalue().split("\n")

    def end_of(self, job):
        """Verdict, doubt, warnings, displacement and blocks of a job of the catalogue."""
        killed = re.search("ended by (SIG[A-Z]+)", job["message"])
        if killed:
            return "signal", killed[1], "", "", ""
        answer, = job["answers"]
        verdict, _, reason = answer["end"].partition(": ")
        if verdict == "finished" and answer["doubt"]:
            verdict, reason = "doubtful", answer["doubt"]
        record = json.loads((self.folder / self.name / job["outputs"][0] / "run.json").read_text(encoding="utf-8"))
        warnings = " ".join(one["name"] for one in record["warnings"] if ": warning: " in one["first"])
        if record["outcome"]["steps"] == 0:
            return verdict, reason, warnings, "", ""
        found = record["extremes"]["greatest_displacement"]["value"], record["counts"]["blocks"]
        return verdict, reason, warnings, *(str(number).removesuffix(".0") for number in found)  # as tables write numbers


def kill(pid):
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def kill_one_run(study):
    """Kills runs until one has died of it: a run that had written its results is a row like others."""
    study.wait_for(0.2)
    while True:
        runs = study.processes("run", f"{study.name}/jobs/")
        if runs:
            kill(runs[0])
            time.sleep(0.5)
        if any("SIGKILL" in line for line in study.results()):
            return
        time.sleep(0.01)


def alone(study, is_disturbed):
    """The command; it is killed at a third, and resumed."""
    if not is_disturbed:
        study.run()
        return ""
    process = subprocess.Popen(study.sweep, cwd=study.folder, **QUIET)
    study.wait_for(1 / 3)
    process.kill()
    process.wait()
    study.run("--resume")
    return "killed once and resumed"


def by_slurm(study, is_disturbed):
    """sbatch of the script; tasks get the signal of their limit of time, are requeued, and are cancelled."""
    script = study.printed("--slurm", str(study.asked.tasks))
    with slurm_daemons.Slurm(study.folder / f"daemons_{study.name}", os.cpu_count()) as slurm:
        job = slurm.submit(script, study.folder)
        told = disturb(study, slurm, job, script) if is_disturbed else ""
        slurm.wait(job)
    study.run("--merge")
    return told


def disturb(study, slurm, job, script):
    """Disturbs one running task after another in three ways. A cancelled one stays away, and is submitted again."""
    ways = [("signalled", lambda task: ("scancel", "--batch", "--signal=TERM", task)),
            ("requeued", lambda task: ("scontrol", "requeue", task)), ("cancelled", lambda task: ("scancel", task))]
    done = {}
    for i, (word, command) in enumerate(ways):
        study.wait_for((i + 1) / 12)
        k = running_task(slurm, job, done.values())
        slurm.ask(*command(f"{job}_{k}"), limit=3)
        done[word] = k
    slurm.wait(job)
    study.run("--merge")
    if study.table():
        raise SystemExit("slurm: found a table in spite of a cancelled task")
    slurm.wait(slurm.submit(script, study.folder, f"--array={done['cancelled']}"))
    return ", ".join(f"task {k} {word}" for word, k in done.items())


def running_task(slurm, job, others):
    while tasks := slurm.tasks(job):
        for k, state in sorted(tasks.items()):
            if state == "RUNNING" and k not in others:
                return k
        time.sleep(0.1)
    raise SystemExit("slurm: the job ended before all of its disturbances; give more rows")


def by_parallel(study, is_disturbed):
    """The line for GNU parallel; one shard is killed, and parallel starts it again."""
    process = subprocess.Popen(["bash", "-c", study.printed("--parallel", str(study.asked.tasks))], cwd=study.folder, **QUIET)
    if is_disturbed:
        study.wait_for(1 / 8)
        kill(study.processes("sweep", "--shard", f"/{study.asked.tasks}")[0])
    process.wait()
    return "a shard killed" if is_disturbed else ""


def by_dask(study, is_disturbed):
    """kb.sweep with a client; one worker is killed, and Dask gives its task to another one."""
    worker = [study.asked.dask, HERE / "dask_sweep.py", study.name, str(study.count), OUTPUTS]
    environment = {**os.environ, "PYTHONPATH": study.asked.package, "KEYBLOCK_PROGRAM": study.asked.program}
    process = subprocess.Popen([*worker, *(["--kill"] if is_disturbed else [])], cwd=study.folder, env=environment,
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    errors = process.communicate()[1]
    if process.returncode != 0:
        print(errors, file=sys.stderr)
    return "a worker killed" if is_disturbed else ""


def python_with(package):
    """A Python that has Dask and the package; none: an empty text."""
    for python in (sys.executable, "/usr/bin/python3"):
        found = subprocess.run([python, "-c", "import distributed, keyblock"], env={**os.environ, "PYTHONPATH": package}, **QUIET)
        if found.returncode == 0:
            return python
    return ""


def engines(asked):
    asked.dask = python_with(asked.package)
    all_of_them = {"sweep": (alone, ""), "batch": (alone, ""), "slurm": (by_slurm, slurm_daemons.why_not()),
                   "parallel": (by_parallel, "" if shutil.which("parallel") else "GNU parallel is not installed"),
                   "dask": (by_dask, "" if asked.dask else "no Python has distributed and the package keyblock")}
    for name, (work, why_not) in all_of_them.items():
        if asked.only and name not in asked.only:
            continue
        if why_not:
            print(f"{name}: skipped: {why_not}")
        else:
            yield name, work


def study_of(asked, folder, engine, name, count):
    return (ArchiveStudy if engine == "batch" else Study)(asked, folder, name, count)


def check_whole(asked, folder, name, work, whole):
    """All rows, with a part of the engine killed. Returns the number of faults."""
    began = time.monotonic()
    study = study_of(asked, folder, name, name, asked.count)
    told = work(study, True)
    found = study.table()
    is_same = found == whole
    print(f"{name}: {asked.count} rows, {time.monotonic() - began:.0f} s, {told}: {'same bytes' if is_same else 'ANOTHER TABLE'}",
          flush=True)
    if not is_same:
        first = next(((a, b) for a, b in zip(whole, found) if a != b), (len(whole), len(found)))
        print(f"{name}: first difference: expected {first[0]}, found {first[1]}", file=sys.stderr)
    return not is_same


def check_killed_run(asked, folder, name, work, whole):
    """A part of the rows, with one run killed. Returns the number of faults."""
    study = study_of(asked, folder, name, f"{name}_killed", asked.count // 5)
    killer = threading.Thread(target=kill_one_run, args=(study,), daemon=True)
    killer.start()
    work(study, False)
    found = study.table()
    others = [(a, b) for a, b in zip(whole, found) if a != b]
    is_one = len(found) == len(whole) and len(others) == 1 and ",signal,SIGKILL," in others[0][1]
    what = "that row alone" if is_one else f"{len(others)} OTHER ROWS" if others else "NONE WAS FOUND"
    print(f"{name}: {study.count} rows, a run killed: {what}", flush=True)
    return not is_one


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--tasks", type=int, default=8)
    parser.add_argument("--only", action="append")
    parser.add_argument("--package", default="", type=os.path.abspath, help="folder of the package keyblock")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="keyblock_runs_") as name:
        folder = Path(name).resolve()
        (folder / "joints.json").write_text(json.dumps(JOINTS), encoding="utf-8")
        (folder / "face.json").write_text(json.dumps(CASE), encoding="utf-8")
        whole = []
        for count in (asked.count, asked.count // 5):
            study = Study(asked, folder, f"undisturbed_{count}", count)
            study.run()
            whole.append(study.table())
            if len(whole[-1]) != count + 2:
                raise SystemExit(f"{study.name}: expected a table of {count} rows, found {len(whole[-1]) - 2}")
        faults = 0
        for engine, work in engines(asked):
            faults += check_whole(asked, folder, engine, work, whole[0])
            faults += check_killed_run(asked, folder, engine, work, whole[1])
    return min(faults, 1)


if __name__ == "__main__":
    sys.exit(main())
