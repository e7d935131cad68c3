#!/usr/bin/env python3
"""Runs three cases with each numeric key of the case file changed: a run ends, or it is refused with a reason.

usage: every_key.py PROGRAM [--every N] [--jobs N] [--sweeps]

Keys are those of `keyblock formats --schema`: present in a case, or new in an object of it. Each gets values around its
own, and values that no case should have. A run fails if the program crashes, says nothing, or takes more than 60 s.
With --sweeps `keyblock sweep --over` then makes the same runs, one sweep per key. Its rows must end as the runs, with the same reasons.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import collections
import csv
import itertools
import json
import re
import resource
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

KINDS = ("slope", "tunnel", "beam")
SECONDS = 60
ENDS = {0: "ran", 1: "doubtful", 3: "refused", 4: "no result", 5: "limit"}


def types_of(schema):
    kind = schema.get("type", [])
    return {kind} if isinstance(kind, str) else set(kind)


def numeric_keys(schema, value, pointer=""):
    """(pointer, value or None) of the numeric keys that the case has or could have; of lists the first and the last item."""
    if types_of(schema) & {"number", "integer"}:
        yield pointer, value
    if isinstance(value, dict):
        for key, below in schema.get("properties", {}).items():
            if key not in ("keyblock", "frames", "tracks"):  # the layout; results, which a run ignores
                yield from numeric_keys(below, value.get(key), f"{pointer}/{key}")
    if isinstance(value, list):
        for i in sorted({0, len(value) - 1} & set(range(len(value)))):
            places = schema.get("prefixItems", [])
            yield from numeric_keys(places[i] if i < len(places) else schema.get("items", {}), value[i], f"{pointer}/{i}")


def tried(value):
    """Values around the present one, and wrong ones."""
    number = re.match(r"[-+\d.eE]+", value) if isinstance(value, str) else None
    base = float(number[0]) if number else value if isinstance(value, (int, float)) else 1.0
    unit = value[number.end():] if number else ""
    near = [0.5 * base, 2 * base] if base else [1e-3, 1]
    return [f"{v:g}{unit}" for v in near] + ["0", "-1", "1e300", "1.5", '"word"', "null"]


def run(program, folder, case, pointer, value, count):
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 5))
    done = subprocess.run([program, "run", case, "--at", f"{pointer}={value}", "--set", "steps=2", "-o", folder / str(count),
                           "--no-pictures", "--threads", "1"], preexec_fn=limit, capture_output=True, text=True, errors="replace")
    reasons = [line for line in done.stderr.splitlines() if "error:" in line]
    if done.returncode not in ENDS:
        return "FAULT", f"exit code {done.returncode}: {done.stderr[-200:]}"
    if done.returncode == 5:
        return "FAULT", f"more than {SECONDS} s"
    if done.returncode in (3, 4) and not reasons:
        return "FAULT", f"exit code {done.returncode} without a reason"
    return ENDS[done.returncode], reasons[-1] if reasons else ""


VERDICTS = {"ran": "finished", "doubtful": "doubtful", "refused": "error", "no result": "failed"}


def swept(program, folder, case, pointer, values, count):
    """Rows (end, reason) of a sweep of a key; all are refused if the sweep is."""
    out = folder / f"sweep{count}"
    words = [json.loads(v) if v.startswith('"') else v for v in values]
    done = subprocess.run([program, "sweep", case, "--over", f"{pointer}={','.join(words)}", "--set", "steps=2", "--out", "displacement",
                           "--jobs", "1", "--time-limit", str(SECONDS), "-o", out], capture_output=True, text=True, errors="replace")
    reasons = [line for line in done.stderr.splitlines() if "error:" in line]
    if done.returncode == 2 and len(reasons) == 1:
        return [("error", reasons[0])] * len(values)
    if done.returncode not in (0, 1):
        return [("FAULT", f"exit code {done.returncode}: {done.stderr[-200:]}")] * len(values)
    with open(out / "table.csv", newline="", encoding="utf-8") as file:
        return [(row["verdict"], row["doubt"]) for row in csv.DictReader(file)]


def difference(end, reason, verdict, doubt):
    """What the row of a sweep has otherwise than the run, or nothing."""
    if end == "FAULT":
        return ""  # reported for the run
    if verdict != VERDICTS[end] or bool(doubt) != (end != "ran"):
        return f"{end} ({reason}), in the sweep {verdict} ({doubt})"
    said, known = (text.partition("error: ")[2] for text in (doubt, reason))
    if end == "refused" and said != known and "expected a whole number" not in said and "other than null" not in said:
        return f"refused: {known}, in the sweep: {said}"
    return ""


def is_apart(value):
    if value == "null":
        return 2
    try:
        return not float(value).is_integer()
    except (ValueError, OverflowError):
        return False


def differences(program, folder, rows, ends, jobs):
    """Rows of sweeps that differ from the runs. Fractions and null have sweeps of their own, which are refused as a whole."""
    groups = [(key, list(group)) for key, group in itertools.groupby(
        sorted(range(len(rows)), key=lambda i: (str(rows[i][0]), rows[i][1], is_apart(rows[i][2]), i)),
        key=lambda i: (rows[i][0], rows[i][1], is_apart(rows[i][2])))]
    with ThreadPoolExecutor(jobs) as pool:
        found = list(pool.map(lambda n: swept(program, folder, *groups[n][0][:2], [rows[i][2] for i in groups[n][1]], n),
                              range(len(groups))))
    for ((case, pointer, _), group), answers in zip(groups, found):
        if len(answers) != len(group):
            yield f"{case.stem}: {pointer}: {len(group)} values, {len(answers)} rows"
        for i, answer in zip(group, answers):
            if wrong := difference(*ends[i], *answer):
                yield f"{case.stem}: {pointer}={rows[i][2]}: {wrong}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--every", type=int, default=1, help="each N-th row")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--sweeps", action="store_true", help="compare with the rows of sweeps")
    asked = parser.parse_args()
    schema = json.loads(subprocess.run([asked.program, "formats", "--schema"], stdout=subprocess.PIPE, check=True).stdout)
    ends, faults = collections.Counter(), []
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(asked.jobs) as pool:
        folder, rows = Path(name), []
        for kind in KINDS:
            case = folder / f"{kind}.json"
            subprocess.run([asked.program, "new", kind, "--strict-json", "-o", case], check=True, capture_output=True)
            keys = list(numeric_keys(schema, json.loads(case.read_text(encoding="utf-8"))))
            rows += [(case, pointer, value) for pointer, present in keys for value in tried(present)]
        rows = rows[::asked.every]
        found = list(pool.map(lambda i: run(asked.program, folder, *rows[i], i), range(len(rows))))
        for (case, pointer, value), (end, reason) in zip(rows, found):
            ends[end] += 1
            if end == "FAULT":
                faults.append(f"{case.stem}: {pointer}={value}: {reason}")
        others = list(differences(asked.program, folder, rows, found, asked.jobs)) if asked.sweeps else []
    print(f"{len(rows)} runs:", ", ".join(f"{count} {end}" for end, count in sorted(ends.items())))
    if asked.sweeps:
        print(f"{len(others)} rows of sweeps differ")
    print(*faults, *others, sep="\n")
    return bool(faults or others)


if __name__ == "__main__":
    sys.exit(main())
