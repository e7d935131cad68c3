#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures every case and writes the last three columns of the table in README.md; the others are written by hand.

    legacy_cases/index.py build/keyblock             reruns the cases and rewrites the table
    legacy_cases/index.py build/keyblock --check     reruns them; exit code 1 if the table would change
    legacy_cases/index.py --from FILE                takes the output of `keyblock compare --all --json` instead

Fails if a case has no row, or a row no case."""
import argparse
import json
import pathlib
import subprocess
import sys
from collections import defaultdict

FOLDER = pathlib.Path(__file__).resolve().parent
HEADER = "| case | physics | source | quantity | legacy | standard | verdict |"


def values_of(run, profile):
    """What a profile is held against: for each quantity, block and time the values judged for it, else any."""
    rows = defaultdict(list)
    for value in run["values"]:
        rows[value["quantity"], value["block"], value["time"]].append(value)
    kept = []
    for same in rows.values():
        judged = [value for value in same if value["judged"]]
        if judged or profile == "legacy":
            kept += judged or same
    return kept


class Measured:
    """The main runs of one case in one profile; variants count in `variants` alone."""

    def __init__(self, cases, profile):
        self.worst, self.held, self.asked, self.listed, self.ended, self.left_out = None, 0, 0, 0, 0, 0
        self.runs, self.variants, self.variants_held = 0, 0, 0
        for case in cases:
            for run in case["runs"]:
                if run["profile"] == profile:
                    self.add(run, profile)

    def add(self, run, profile):
        if run["variant"]:
            self.variants += 1
            self.variants_held += run["holds"]
            return
        if run["not_run"]:
            self.left_out += 1
            return
        self.runs += 1
        values = values_of(run, profile)
        self.ended += any(value["computed"] is None for value in values)
        greatest = defaultdict(float)
        for value in values:
            key = value["quantity"], value["block"]
            greatest[key] = max(greatest[key], abs(value["expected"]))
        for value in values:
            self.asked += 1
            self.listed += bool(value["listed_miss"])
            if value["computed"] is None:
                continue
            error = abs(value["computed"] - value["expected"])
            self.held += error <= value["tolerance"]
            size = greatest[value["quantity"], value["block"]]
            if size > 0 and not value["tolerance_reason"].startswith("verdict: "):
                self.worst = max(self.worst or 0, error / size)

    def error(self):
        if not self.runs:
            return "not run"
        parts = [] if self.worst is None else [percent(self.worst)]
        if self.ended:
            parts.append(f"{self.ended} of {self.runs} runs end early")
        return ", ".join(parts) or "–"

    def verdict(self):
        text = f"{self.held} of {self.asked}"
        if self.variants:
            text += f", variants {self.variants_held} of {self.variants}"
        return text + (f", listed misses {self.listed}" if self.listed else "")


def percent(ratio):
    value = 100 * ratio
    if value < 1e-6:
        return "< 1e-6 %"
    if value > 1000:
        return "> 1000 %"
    return (f"{value:.0f} %" if value >= 10 else f"{value:.2g} %").replace("e-0", "e-")


def columns(cases):
    legacy, standard = (Measured(cases, profile) for profile in ("legacy", "standard"))
    verdict = f"standard {standard.verdict()}"
    if legacy.runs:
        verdict += f"; legacy {legacy.verdict()}"
    return legacy.error(), standard.error(), verdict


def columns_of_traces(traces):
    worst = {name: max(trace[name] for trace in traces) for name in ("position", "stress")}
    return (f"position {worst['position']:.0e}, stress {worst['stress']:.0e}".replace("e-0", "e-"), "not meant",
            f"legacy {sum(trace['holds'] for trace in traces)} of {len(traces)} runs")


def rewritten(page, report):
    families = defaultdict(list)
    for case in report["cases"]:
        families[case["case"].split("/")[0]].append(case)
    measured = {name: columns(cases) for name, cases in families.items()}
    measured["reference_traces"] = columns_of_traces(report["traces"])
    lines, rows, within = [], [], False
    for line in page.splitlines():
        within = line == HEADER or within and line.startswith("|")
        if not within or not line.startswith("| ["):
            lines.append(line)
            continue
        cells = [cell.strip() for cell in line.strip("|").split(" | ")]
        name = cells[0][1:].split("]")[0]
        rows.append(name)
        lines.append("| " + " | ".join(cells[:4] + list(measured.get(name, ["?"] * 3))) + " |")
    missing = sorted(set(measured) - set(rows)), sorted(set(rows) - set(measured))
    if any(missing):
        sys.exit(f"{FOLDER / 'README.md'}: cases without a row: {missing[0]}; rows without a case: {missing[1]}")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?")
    parser.add_argument("--from", dest="report", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    if arguments.report:
        text = arguments.report.read_text(encoding="utf-8")
    elif arguments.program:
        text = subprocess.run([arguments.program, "compare", "--all", "--json", str(FOLDER)], stdout=subprocess.PIPE,
                              text=True, check=False).stdout  # exit code 1: a value was missed, which the table says
    else:
        parser.error("expected the program, or --from FILE")
    file = FOLDER / "README.md"
    before = file.read_text(encoding="utf-8")
    after = rewritten(before, json.loads(text))
    if arguments.check:
        return 0 if after == before else 1
    file.write_text(after, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
