#!/usr/bin/env python3
"""Writes the verification manual, docs/verification: one page per case of legacy_cases, and an index.

usage: docs/make_verification.py PROGRAM [--from FILE] [--no-pictures]
       docs/make_verification.py --text
       docs/make_verification.py --check

The first form runs all cases (some minutes) and writes results.json, the pictures and the pages. --from takes the output
of `keyblock compare legacy_cases --all --json` from a file instead. --text writes the pages anew from the committed
results, after a change of a case README. --check writes nothing: it compares the committed pages with what --text would
write, and the results with the tables of the cases. One line per fault goes to standard output; the exit code is 1 if
there is any.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import json
import math
import posixpath
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import make_reference
import picture_size

ROOT = Path(__file__).resolve().parent.parent
CASES = ROOT / "legacy_cases"
MANUAL = ROOT / "docs" / "verification"
RESULTS = MANUAL / "results.json"
HEADINGS = ["Reference solution", "Model", "What it verifies", "Results"]
LARGEST_PICTURE, LARGEST_MANUAL = 60_000, 4_000_000  # bytes

# Topics, with the cases of each and the folder or the field that their picture shows.
TOPICS = {
    "Motion, elasticity and cutting of blocks": {
        "free_fall": "tumbling", "rigid_rotation": "row_1", "block_at_rest": "dynamic", "stack": "five_blocks",
        "settlement": "ten_soft_dynamic", "push_block": "ramp", "driven_point": "pendulum", "initial_stress": "column",
        "cantilever": "blocks_16x4", "circle_slope": ""},
    "Friction and strength of joints": {
        "sliding_block": "a30_p20", "sliding_threshold": "phi_29", "decelerating_block": "incline",
        "long_runout": "four_slabs", "runout": "steep_rounded", "newmark_pulse": "row_1", "newmark_sine": "row_1",
        "cohesive_joint": "c11240", "tensile_joint": "t15", "shear_box": "friction_residual"},
    "Toppling, rocking and impact": {
        "toppling_column": "a30_r110", "block_modes": "row_8_slide_topple", "tilting_stack": "n5",
        "brick_overhang": "n5_f103", "rocking_block": "row_1", "overturning": "above", "falling_column": "row_1",
        "domino": "tips", "restitution": "e_050", "two_body_impact": "row_1"},
    "Slopes, tunnels and masonry": {
        "goodman_bray": "falls", "plane_failure": "crack_slides", "two_block_slope": "wedge_p10",
        "strength_reduction": "two_blocks_steep", "roof_block": "falling", "bolt": "hanging",
        "staged_excavation": "roof_block", "masonry_arch": "quake_thin_falls", "voussoir_beam": "three_hinge"},
    "Elastic NMM bodies": {
        "patch_on_covers": "derived", "rigid_motion_on_covers": "derived", "beam_on_covers": "supported",
        "cook_membrane": "coarse", "plate_with_hole": "regular", "thick_cylinder": "lame", "sine_square": "derived",
        "sudden_load_on_covers": "damped", "sliding_block_on_covers": "a30_p20"},
    "Elastoplastic rock": {
        "single_element": "cyclic", "biaxial_strength": "phi_30_c_20_s3_100", "footing_collapse": "phi_30",
        "tunnel_in_yielding_rock": "psi_30", "cylinder_collapse": "pressure_180", "cook_membrane_plastic": "coarse",
        "yielding_pillar": "pressed_on_covers", "crack_closure": "plate"},
    "Cracks": {"stress_intensity": "edge_crack_05", "crack_growth": "first_kink"},
    "Replay of the Berkeley program": {"reference_traces": None},
}
OF_FOS = ("strength_reduction",)  # their picture is that of `keyblock fos`


def picture_command(case):
    """The command that draws the picture of a case, or an empty text."""
    folder = TOPICS[topic_of(case)][case]
    if folder is None:
        return ""
    name = f"legacy_cases/{case}/{folder}".rstrip("/")
    return f"keyblock fos {name} -o out" if case in OF_FOS else f"keyblock compare {name} --picture FILE"


def topic_of(case):
    return next(topic for topic, cases in TOPICS.items() if case in cases)


def all_cases():
    """Folders of legacy_cases with a README and expected values or traces below."""
    return sorted(f.name for f in CASES.iterdir() if (f / "README.md").is_file() and
                  (any(f.rglob("expected.csv")) or any(f.rglob("steps.csv"))))


# ----- results.json: what the program printed ------------------------------------------------------------------------


def printed(number, form="{:.9g}"):
    """A number as `keyblock compare` prints it."""
    return None if number is None else form.format(number)


def kept_value(case, rows):
    """One row of a table: the value as each profile computed it."""
    first = rows[0]
    missed = [row["profile"] for row in rows if row["judged"] and not row["holds"] and not row["listed_miss"]]
    return {"quantity": first["quantity"], "block": first["block"], "time": printed(first["time"], "{:.6g}"),
            "expected": printed(first["expected"]), "tolerance": printed(first["tolerance"], "{:.1e}"),
            "judged": [row["profile"] for row in rows if row["judged"]], "missed": missed,
            "listed": bool(first["listed_miss"]),
            "computed": {row["profile"]: printed(row["computed"]) for row in rows},
            "error": {row["profile"]: printed(None if row["computed"] is None else row["computed"] - row["expected"], "{:.2e}")
                      for row in rows}}


def strain(value):
    """The error in units of the tolerance."""
    if value["computed"] is None or math.isnan(value["computed"]):
        return math.inf
    error = abs(value["computed"] - value["expected"])
    return error / value["tolerance"] if error else 0.0


def kept_variant(run):
    judged = [value for value in run["values"] if value["judged"]]
    kept = {"name": run["variant"], "profile": run["profile"], "holds": run["holds"], "not_run": run["not_run"]}
    if judged and not run["not_run"]:
        worst = max(judged, key=strain)
        kept["worst"] = {"quantity": worst["quantity"], "block": worst["block"], "time": printed(worst["time"], "{:.6g}"),
                         "share": printed(strain(worst), "{:.2g}"), "tolerance": printed(worst["tolerance"], "{:.1e}"),
                         "error": printed(None if worst["computed"] is None else worst["computed"] - worst["expected"], "{:.2e}")}
    return kept


def kept_case(case):
    plain = [run for run in case["runs"] if not run["variant"]]
    rows = [[dict(run["values"][i], profile=run["profile"]) for run in plain if len(run["values"]) > i]
            for i in range(max(len(run["values"]) for run in plain))]
    return {"case": case["case"], "holds": case["holds"],
            "runs": [{"profile": run["profile"], "not_run": run["not_run"], "ended": run["reason"]} for run in plain],
            "values": [kept_value(case, row) for row in rows],
            "variants": [kept_variant(run) for run in case["runs"] if run["variant"]]}


def kept_results(program, report):
    version = make_reference.output_of(program, "--version").split("\n")[0].strip()
    return {"program": version, "cases": [kept_case(case) for case in report["cases"]],
            "traces": [{key: trace[key] for key in ("trace", "holds", "steps", "steps_in_trace")} |
                       {key: printed(trace[key], "{:.1e}") for key in ("polygon", "position", "rotation", "stress", "disp_ratio")}
                       for trace in report["traces"]]}


def results_text(results):
    """JSON with one value per line, so that changes are easy to read."""
    def lines(rows):
        return ",\n    ".join(json.dumps({k: v for k, v in row.items() if v not in (False, "", [])}, ensure_ascii=False,
                                         separators=(",", ":")) for row in rows)
    cases = ",\n".join(
        f'  {{"case": {json.dumps(c["case"])}, "holds": {json.dumps(c["holds"])},\n   "runs": {json.dumps(c["runs"], ensure_ascii=False)},\n'
        f'   "values": [\n    {lines(c["values"])}],\n   "variants": [\n    {lines(c["variants"])}]}}'
        for c in results["cases"])
    return (f'{{"program": {json.dumps(results["program"])},\n "cases": [\n{cases}],\n'
            f' "traces": [\n    {lines(results["traces"])}]}}\n')


def read_results():
    """results.json, with what results_text leaves out."""
    results = json.loads(RESULTS.read_text(encoding="utf-8"))
    for case in results["cases"]:
        case["values"] = [{"judged": [], "missed": [], "listed": False} | value for value in case["values"]]
        case["variants"] = [{"holds": False, "not_run": ""} | variant for variant in case["variants"]]
    results["traces"] = [{"holds": False} | trace for trace in results["traces"]]
    return results


def expected_rows(case):
    """The rows of the table of a case."""
    with open(CASES / case / "expected.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def result_faults(results):
    """Tables that have changed since the results were written."""
    tables = {f.parent.relative_to(CASES).as_posix() for f in CASES.rglob("expected.csv")}
    found = {c["case"]: c for c in results["cases"]}
    for name in sorted(tables ^ set(found)):
        yield f"legacy_cases/{name}: " + ("has no results" if name in tables else "has results but no table")
    for name in sorted(tables & set(found)):
        rows = [(r["quantity"], r["block"], printed(float(r["time"]), "{:.6g}"), printed(float(r["value"])),
                 printed(float(r["tolerance"]), "{:.1e}")) for r in expected_rows(name)]
        kept = [(v["quantity"], "" if v["block"] is None else str(v["block"]), v["time"], v["expected"], v["tolerance"])
                for v in found[name]["values"]]
        if rows != kept:
            yield f"legacy_cases/{name}/expected.csv: differs from docs/verification/results.json"
    traces = {f.parent.name for f in (CASES / "reference_traces").rglob("steps.csv")}
    for name in sorted(traces ^ {t["trace"].split("/")[-1] for t in results["traces"]}):
        yield f"legacy_cases/reference_traces/{name}: results and folders differ"


# ----- the Berkeley program ------------------------------------------------------------------------------------------


def berkeley():
    """{(case, quantity, block, time): (value, table, variant)} of inputs that the tables of the Berkeley program share."""
    found = {}

    def rows(name):
        with open(CASES / "berkeley_tables" / f"{name}.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def add(case, quantity, block, time, value, table, variant):
        if (CASES / case / "expected.csv").is_file():
            found[case, quantity, block, printed(float(time), "{:.6g}")] = (value, f"{table}.csv", variant)

    for r in rows("incline"):
        if r["variant"] == "dt1ms":
            add(f"sliding_block/a{int(r['angle_deg']):02}_p{int(r['phi_deg']):02}", "displacement", 2, r["t"], r["s_ntdda"], "incline",
                r["variant"])
    for r in rows("topple"):
        if r["variant"] == "dt1ms":
            add(f"toppling_column/a{r['angle_deg']}_r{int(r['ratio_pct']):03}", "rotation", 2, r["time"], r["rot_ntdda_rad"], "topple",
                r["variant"])
    for r in rows("rest"):
        if r["pfactor"] == "1":
            case = "block_at_rest/" + {"dyn": "dynamic", "static": "static"}[r["variant"]]
            add(case, "dy", 2, r["time"], r["final_dy"], "rest", f"{r['variant']}, pfactor 1")
            add(case, "syy", 2, r["time"], r["syy_final"], "rest", f"{r['variant']}, pfactor 1")
    for r in rows("stack"):
        if r["blocks"] == "5" and r["variant"] == "dyn_dt1ms":
            add("stack/five_blocks", "dy", 6, r["time"], r["top_dy"], "stack", r["variant"])
            add("stack/five_blocks", "syy", 2, r["time"], r["bottom_syy"], "stack", r["variant"])
    for r in rows("freefall"):
        if r["variant"] == "dt5ms":
            add("free_fall/released", "dy", 2, r["t"], r["dy_ntdda"], "freefall", r["variant"])
    return found


# ----- pages ---------------------------------------------------------------------------------------------------------


def owner_of(value):
    quantity = value["quantity"]
    if value["block"] is None:
        return quantity
    noun = ("support" if quantity.startswith("reaction_") else "point" if quantity in ("px", "py") or quantity.startswith("point_")
            else "tip" if quantity in ("K_I", "K_II", "J", "K_eq", "tip_x", "tip_y", "kink_deg", "crack_length") else "block")
    return f"{quantity} of {noun} {value['block']}"


def moved(text, case):
    """The text of a README with links that lead to the same files from the manual."""
    def target(match):
        link = match.group(2)
        if re.match(r"[a-z]+:|#", link):
            return match.group(0)
        path = posixpath.normpath(f"legacy_cases/{case}/{link}")
        page = re.fullmatch(r"legacy_cases/(\w+)/README\.md(#.*)?", path)
        if page and page[1] in all_cases():
            return f"{match.group(1)}{page[1]}.md{page[2] or ''})"
        return f"{match.group(1)}{posixpath.relpath(path, 'docs/verification')})"
    return re.sub(r"(\]\()([^()\s]+)\)", target, text)


def readme_of(case):
    """(title, text before the first heading, [(heading, text)]) of the README of a case."""
    text = (CASES / case / "README.md").read_text(encoding="utf-8")
    title, _, rest = text.partition("\n")
    parts = re.split(r"^## (.*)\n", rest, flags=re.M)
    return title.removeprefix("# ").strip(), parts[0].strip("\n"), list(zip(parts[1::2], (p.strip("\n") for p in parts[2::2])))


def verdict_of(value):
    if not value["judged"]:
        return "not judged"
    if value["missed"]:
        return "missed: " + ", ".join(value["missed"])
    if value["listed"]:
        return "listed miss: " + ", ".join(value["judged"])
    return "ok" if len(value["judged"]) == len(value["computed"]) else "ok: " + ", ".join(value["judged"]) + " only"


def shorter(text):
    """A long text with a sentence for each of its parts."""
    if len(text.split()) <= 30:
        return text
    return ". ".join(part[0].upper() + part[1:] for part in text.split("; "))


def case_tables(found, theirs):
    """The section of one folder of a case: its table, variants, sources."""
    name = found["case"]
    run = [r["profile"] for r in found["runs"] if not r["not_run"]]
    out = [f"### {name.partition('/')[2] or name}\n"]
    file = CASES / name / "case.json"
    about = json.loads(file.read_text(encoding="utf-8")).get("about", "") if file.is_file() else ""
    if about:
        out.append(make_reference.wrapped(make_reference.sentence(make_reference.plain(about[0].upper() + about[1:]))))
    notes = []
    for r in found["runs"]:
        if r["not_run"]:
            notes.append(f"- Not run by `{r['profile']}`: `{r['not_run']}`.")
        elif r["ended"]:
            notes.append(f"- The run of `{r['profile']}` ends early: `{r['ended']}`.")
    if notes:
        out.append("".join(make_reference.wrapped(note, later="  ") for note in notes))
    rows = expected_rows(name)
    sources = list(dict.fromkeys(row["source"] for row in rows))
    with_theirs = any((name, v["quantity"], v["block"], v["time"]) in theirs for v in found["values"])
    heads = (["Quantity", "Time", "Expected"] + [f"`{p}`" for p in run] + (["Berkeley program"] if with_theirs else []) +
             [f"Error, `{p}`" for p in run] + ["Tolerance", "Source", "Verdict"])
    out.append("| " + " | ".join(heads) + " |\n|" + "---|" * len(heads) + "\n" + "".join(
        "| " + " | ".join(
            [f"`{owner_of(value)}`", value["time"], value["expected"]] + [value["computed"].get(p) or "not reached" for p in run] +
            ([theirs.get((name, value["quantity"], value["block"], value["time"]), ("–",))[0]] if with_theirs else []) +
            [value["error"].get(p) or "–" for p in run] +
            [value["tolerance"], f"[{sources.index(row['source']) + 1}]", verdict_of(value)]) + " |\n"
        for value, row in zip(found["values"], rows)))
    out.append(variants_text(found["variants"]))
    out.append("Sources:\n\n" + "".join(
        make_reference.wrapped(f"{i}. {make_reference.sentence(make_reference.plain(shorter(text)))}", later="   ") for i, text in enumerate(sources, 1)))
    listed = list(dict.fromkeys(row["listed_miss"] for row in rows if row.get("listed_miss")))
    for text in listed:
        out.append("Listed miss:\n")
        out.append(make_reference.wrapped(make_reference.plain(make_reference.sentence(text[0].upper() + text[1:]))))
    return "\n".join(part for part in out if part)


def variants_text(variants):
    if not variants:
        return ""
    held = sum(v["holds"] for v in variants)
    lines = [f"{held} of {len(variants)} variants (other steps, contact laws or functions) are within their tolerances."]
    with_worst = [v for v in variants if "worst" in v]
    if with_worst:
        worst = max(with_worst, key=lambda v: float(v["worst"]["share"]))
        lines.append(f"Worst error relative to its tolerance: {worst['worst']['error']} of {worst['worst']['tolerance']}, variant"
                     f" `{worst['name']}`, `{owner_of(worst['worst'])}` at time {worst['worst']['time']}.")
    for v in variants:
        if not v["holds"]:
            lines.append(f"Missed by variant `{v['name']}`.")
    return make_reference.wrapped(" ".join(lines))


def traces_text(results):
    out = ["| Trace | Steps | Polygon | Position | Rotation | Stress | Verdict |\n|---|---|---|---|---|---|---|\n" + "".join(
               f"| `{t['trace'].split('/')[-1]}` | {t['steps']} of {t['steps_in_trace']} | {t['polygon']} | {t['position']} |"
               f" {t['rotation']} | {t['stress']} | {'ok' if t['holds'] else 'missed'} |\n" for t in results["traces"]),
           "Differences are relative, as the case page defines them.\n"]
    return "\n".join(out)


def case_page(case, results, theirs):
    title, before, sections = readme_of(case)
    out = [f"<!-- Generated by docs/make_verification.py from legacy_cases/{case}; edit that, not this page. -->\n", f"# {title}\n"]
    if before:
        out.append(moved(before, case) + "\n")
    if picture_command(case):
        out.append(f"![{title}]({case}.svg)\n")
        out.append(f"Picture: `{picture_command(case)}`.\n")
    for heading, text in sections:
        out.append(f"## {heading}\n\n{moved(text, case)}\n")
    out.append("## Computed values\n")
    out.append(make_reference.wrapped(
        f"Printed by {results['program']}. Values are in the units of the input, angles in radians, and times are multiples of the"
        f" step. The input is in `legacy_cases/{case}`. This command prints the tables below:"))
    out.append(f"```\nkeyblock compare --all legacy_cases/{case}\n```\n")
    found = [c for c in results["cases"] if c["case"].split("/")[0] == case]
    if any((c["case"], v["quantity"], v["block"], v["time"]) in theirs for c in found for v in c["values"]):
        out.append("Values of the Berkeley program, where its tables have the same input:"
                   " [tables](../../legacy_cases/berkeley_tables/README.md).\n")
    out += [case_tables(c, theirs) for c in found]
    if case == "reference_traces":
        out.append(traces_text(results))
    return "\n".join(out)


def index_rows():
    """{case: [physics, source, quantity, legacy, standard, verdict]} of legacy_cases/README.md."""
    rows = {}
    for line in (CASES / "README.md").read_text(encoding="utf-8").splitlines():
        found = re.match(r"\| \[(\w+)\]\(\1/README\.md\) \|(.*)\|$", line)
        if found:
            rows[found[1]] = [cell.strip() for cell in found[2].split(" | ")]
    return rows


def index_page(results):
    rows = index_rows()
    values = sum(len(c["values"]) for c in results["cases"])
    variants = sum(len(c["variants"]) for c in results["cases"])
    out = ["<!-- Generated by docs/make_verification.py from legacy_cases; edit that, not this page. -->\n", "# Verification manual\n",
           make_reference.wrapped(
               f"Each page compares computed values with a reference solution: {len(rows)} problems, {len(results['cases'])} inputs,"
               f" {values} expected values, {variants} further runs with other steps, contact laws or functions, and"
               f" {len(results['traces'])} traces of the Berkeley program. The numbers are those of {results['program']}."),
           make_reference.wrapped(
               "`keyblock compare legacy_cases/CASE` prints the table of a case, and with `--sources` the reasons of its tolerances."
               " [Verification cases](../../legacy_cases/README.md) explains errors, verdicts and files."
               " Further studies: [cost of accuracy](../../legacy_cases/fronts/README.md),"
               " [random stacks, slopes and cracks](../random_scenes.md), [old slopes](../old_slopes.md),"
               " [old manifold pairs](../old_manifold_pairs.md).")]
    for topic, cases in TOPICS.items():
        out.append(f"## {topic}\n")
        out.append("| Case | What it verifies | Reference | Error, `legacy` | Error, `standard` | Within tolerance |\n"
                   "|---|---|---|---|---|---|\n" + "".join(
                       f"| [{readme_of(case)[0]}]({case}.md) | {rows[case][0]} | {rows[case][1]} | {rows[case][3]} | {rows[case][4]} |"
                       f" {rows[case][5]} |\n" for case in cases))
    return "\n".join(out)


def pages(results):
    theirs = berkeley()
    made = {f"{case}.md": case_page(case, results, theirs) for case in all_cases()}
    made["README.md"] = index_page(results)
    return made


# ----- pictures ------------------------------------------------------------------------------------------------------


def draw(program):
    for cases in TOPICS.values():
        for case, folder in cases.items():
            if folder is None:
                continue
            file = MANUAL / f"{case}.svg"
            with tempfile.TemporaryDirectory() as out:
                made = [program, "fos", "-o", out] if case in OF_FOS else [program, "compare", "--picture", str(file), "--force"]
                subprocess.run([*made, str(CASES / case / folder)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               check=False)  # exit code 1: a miss
                if case in OF_FOS:
                    shutil.copy(Path(out) / "picture.svg", file)
            file.write_text(picture_size.smaller(file.read_text(encoding="utf-8"), LARGEST_PICTURE), encoding="utf-8")


def picture_faults():
    expected = {f"{case}.svg" for cases in TOPICS.values() for case, folder in cases.items() if folder is not None}
    there = {f.name: f.stat().st_size for f in MANUAL.glob("*.svg")}
    for name in sorted(expected ^ set(there)):
        yield f"docs/verification/{name}: " + ("is missing" if name in expected else "is of no case")
    for name, size in sorted(there.items()):
        if size > LARGEST_PICTURE:
            yield f"docs/verification/{name}: has {size} bytes, more than {LARGEST_PICTURE}"
    total = sum(f.stat().st_size for f in MANUAL.iterdir())
    if total > LARGEST_MANUAL:
        yield f"docs/verification: has {total} bytes, more than {LARGEST_MANUAL}"


# ----- main ----------------------------------------------------------------------------------------------------------


def topic_faults():
    sorted_in = [case for cases in TOPICS.values() for case in cases]
    for case in sorted(set(all_cases()) ^ set(sorted_in)):
        yield f"docs/make_verification.py: TOPICS and legacy_cases differ in {case}"
    for case in sorted(set(all_cases()) ^ set(index_rows())):
        yield f"legacy_cases/README.md: the table and the folders differ in {case}"


def check(results):
    faults = list(topic_faults()) + list(result_faults(results))
    if not faults:
        made = pages(results)
        there = {f.name for f in MANUAL.glob("*.md")}
        faults += [f"docs/verification/{name}: is of no case" for name in sorted(there - set(made))]
        for name, text in sorted(made.items()):
            path = MANUAL / name
            if not path.is_file() or path.read_text(encoding="utf-8") != text:
                faults.append(f"docs/verification/{name}: differs from its case; run docs/make_verification.py --text")
    faults += picture_faults()
    for fault in faults:
        print(fault)
    if any("results" in fault or "TOPICS" in fault for fault in faults):
        print("run `make verification`")
    return 1 if faults else 0


def main(arguments):
    program = None
    if arguments in (["--check"], ["--text"]):
        if arguments == ["--check"]:
            return check(read_results())
    else:
        options = [a for a in arguments if a == "--no-pictures"]
        rest = [a for a in arguments if a != "--no-pictures"]
        if not rest or rest[0].startswith("-") or len(rest) not in (1, 3) or (len(rest) == 3 and rest[1] != "--from"):
            sys.exit(__doc__[__doc__.index("usage:"):__doc__.index("The first form")].strip())
        program = str(Path(rest[0]).resolve())
        if len(rest) == 3:
            text = Path(rest[2]).read_text(encoding="utf-8")
        else:  # exit code 1: a value was missed, which the pages say
            text = subprocess.run([program, "compare", "--all", "--json", str(CASES)], stdout=subprocess.PIPE, text=True,
                                  check=False).stdout
        MANUAL.mkdir(exist_ok=True)
        RESULTS.write_text(results_text(kept_results(program, json.loads(text))), encoding="utf-8")
        if not options:
            draw(program)
    faults = list(topic_faults())
    if faults:
        sys.exit("\n".join(faults))
    made = pages(read_results())
    for file in MANUAL.glob("*.md"):
        if file.name not in made:
            file.unlink()
    for name, text in made.items():
        (MANUAL / name).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
