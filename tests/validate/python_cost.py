#!/usr/bin/env python3
"""Measures runs from Python: cost beside the command, cost of frames, memory of 1,000 runs, and Ctrl-C in a large solve.

usage: python_cost.py PROGRAM    with the package keyblock on PYTHONPATH

Fails if a recorded run costs over 2 % more than `keyblock run`: in instructions, or in processor time of user mode if
the system permits no counters. Fails if a frame of 4,901 blocks costs over 1 ms, or if 900 runs leave over 4 MiB. Fails
too if KeyboardInterrupt comes over 1 s after the signal while 1e6 unknowns are cut, factored or solved.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import gc
import json
import os
import resource
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "python"))

MOST_SHARE = 0.02
MOST_MS = 1.0
MOST_KIB = 4096
MOST_SECONDS = 1.0
RUNS = 1000
ROUNDS = 9
SHARES = (0.1, 0.3, 0.5, 0.7, 0.9)  # of the time of a phase
STEPS = "3000"

RECORD = f"""import sys, keyblock as kb
kb.record("slope.json", sys.argv[1], settings={{"steps": {STEPS}}}, context=kb.Context(1))"""


def instructions(command):
    """Instructions of a command in user mode."""
    counted = subprocess.run(["perf", "stat", "-x", ",", "-e", "instructions:u", *command], text=True, check=True,
                             stdout=subprocess.DEVNULL, stderr=subprocess.PIPE).stderr.split("\n")
    return float(next(line.split(",")[0] for line in counted if "instructions" in line))


def user_seconds(command):
    """Processor time of a command in user mode [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def measure():
    """Returns a function that measures a command, and its unit."""
    try:
        instructions(["true"])
        return instructions, "instructions"
    except (OSError, ValueError, subprocess.CalledProcessError):  # no perf, or not permitted
        return user_seconds, f"s in user mode, the least of {ROUNDS}"


def cost(program):
    """Returns the number of faults. The command and Python alternate; loading the package is counted apart."""
    subprocess.run([program, "new", "slope"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    measured, unit = measure()
    alone, python, loading = [], [], []
    for i in range(ROUNDS):
        alone.append(measured([program, "run", "slope.json", "--set", f"steps={STEPS}", "--threads", "1", "-o", f"command{i}"]))
        python.append(measured([sys.executable, "-c", RECORD, f"python{i}"]))
        loading.append(measured([sys.executable, "-c", "import keyblock"]))
    command, package, load = map(min, (alone, python, loading))  # the least disturbed of each
    share = (package - load) / command - 1
    print(f"a recorded run: command {command:.4g}, Python {package:.4g}, of these {load:.3g} to load the package ({unit}): "
          f"{share:+.2%} without loading, at most {MOST_SHARE:.0%}", flush=True)
    return share > MOST_SHARE


def frame(kb, wall):
    """Returns the number of faults. All arrays of a frame are made with it."""
    Path("wall.json").write_text(json.dumps(wall), encoding="utf-8")
    run = kb.Run("wall.json", settings={"start": "sudden"})
    times = []
    for i in range(200):
        if i % 20 == 0:
            time.sleep(1)  # another program on the same processor slows this one down
        began = time.process_time()
        run.frame().vertices
        times.append(time.process_time() - began)
    least, usual = 1e3 * min(times), 1e3 * statistics.median(times)
    print(f"a frame of {run.plan.blocks} blocks: {least:.2f} ms at least, {usual:.2f} usually, at most {MOST_MS}", flush=True)
    return least > MOST_MS


def resident_kib():
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") // 1024


def memory(kb):
    """Returns the number of faults."""
    plan = kb.Plan(kb.read(kb.new("block", "block.json")))
    sizes = []
    for i in range(RUNS):
        run = kb.Run(plan, threads=1)
        run.go_on()
        run.frame().displacement
        if (i + 1) % (RUNS // 10) == 0:
            gc.collect()
            sizes.append(resident_kib())
    growth = sizes[-1] - sizes[0]
    print(f"{RUNS} runs: {sizes[0]} KiB after {RUNS // 10}, {sizes[-1]} after all: {growth:+d} KiB, at most {MOST_KIB}")
    return growth > MOST_KIB


def large_beam(side):
    """A clamped NMM beam under its weight: one linear solve."""
    block = {"material": 1, "outer": [[0, 0, 1], [10, 0, 1], [10, 1, 1], [0, 1, 1]]}
    return {"keyblock": 2, "units": {"length": "m", "mass": "kg", "time": "s"},
            "blocks": {"blocks": [block], "measured_points": [[10, 0.5, 1]]},
            "covers": {"functions": "constant", "mesh": {"side": side}, "displacements": [{"along": [[0, 1], [0, 0]]}]},
            "analysis": {"velocity_carry_over": 0, "step_count": 1, "time_step": 1,
                         "block_materials": [{"like": "sandstone"}], "joint_materials": [{"friction_angle_deg": 30}]}}


def seconds_to_interrupt(context, later, work):
    """Sends SIGINT some seconds into the work.

    Returns the time until KeyboardInterrupt, or nothing if the work ended first; and the length of the work.
    """
    timer = threading.Timer(later, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    began = time.monotonic()
    try:
        work(context)
    except KeyboardInterrupt:
        return time.monotonic() - began - later, later
    finally:
        timer.cancel()
    return None, time.monotonic() - began


def interrupts(kb):
    """Returns the number of faults. The run assembles, orders, factors and solves; its length decides the moments."""
    Path("beam.json").write_text(json.dumps(large_beam("4.25 mm")), encoding="utf-8")
    case = kb.read("beam.json")
    began = time.monotonic()
    plan = kb.Plan(case)
    cut = time.monotonic() - began
    kb.Run(plan, threads=1).go_on()
    run = time.monotonic() - began - cut
    print(f"{plan.unknowns} unknowns: cut in {cut:.1f} s, run in {run:.1f} s")
    faults = 0
    for name, length, work in (("cutting", cut, lambda c: kb.Plan(case, context=c)),
                               ("the run", run, lambda c: kb.Run(plan, context=c).go_on())):
        for share in SHARES:
            for _ in range(3):  # shorter if the machine was busier before
                seconds, taken = seconds_to_interrupt(kb.Context(1), share * length, work)
                if seconds is not None:
                    break
                length = min(length, taken)
            print(f"Ctrl-C at {share:.0%} of {name}: " + ("it ended first" if seconds is None else f"heard after {seconds:.2f} s"))
            faults += seconds is None or seconds > MOST_SECONDS
            while kb._keyblock.left_behind():
                time.sleep(0.1)
    return faults


def main():
    try:
        import keyblock as kb
        from support import wall_of
    except ImportError:
        print("skipped: the package keyblock is not on PYTHONPATH")
        return 0
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell ignores it in what it starts with &
    program = os.path.abspath(sys.argv[1])
    os.environ["KEYBLOCK_PROGRAM"] = program
    with tempfile.TemporaryDirectory(prefix="keyblock_cost_") as folder:
        os.chdir(folder)
        faults = cost(program) + frame(kb, wall_of(70, 70)) + memory(kb) + interrupts(kb)
        os.chdir("/")
    return min(faults, 1)


if __name__ == "__main__":
    sys.exit(main())
