"""The program behind the Python package: its outputs, and runs in Python with the same results.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import hashlib
import json
import math
import os
import pickle
import resource
import shutil
import signal
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import keyblock as kb  # noqa: E402
from support import CASES, FRICTION, ROOT, Folder, slide, stopped  # noqa: E402


def column(table, name):
    return list(table[name])


class Program(Folder):
    def test_a_run_in_python_ends_as_that_of_the_program(self):
        kb.new("block", "block.json")
        for case in (kb.read("block.json"), kb.read("block.json").with_value(FRICTION, 10), slide().with_value(FRICTION, 10)):
            run = kb.Run(case)
            run.go_on()
            written = run.record("out", force=True)
            with self.assertRaisesRegex(kb.Error, "has ended"):
                written.results
            written.go_on()
            results = written.results
            points = results.table("points")
            (dx, dy), = run.frame().point_displacement[-1:] if len(run.frame().point) else [(None, None)]
            self.assertEqual((column(points, "dx")[-1], column(points, "dy")[-1]), (dx, dy), case)
            self.assertEqual((results.end, results.doubts), ("finished", []))
            self.assertEqual(results.run["profile"], run.plan.profile)

    def test_tables_of_a_run_without_a_record_are_read(self):
        kb.new("block", "block.json")
        steps = kb.record("block.json", "out").table("history")
        Path("out/run.json").unlink()
        killed = kb.Results("out")
        self.assertEqual((killed.end, killed.doubts), ("unfinished", []))
        self.assertEqual(column(killed.table("history"), "time"), column(steps, "time"))
        Path("empty").mkdir()
        with self.assertRaisesRegex(kb.Error, "expected the results of a run, found none"):
            kb.Results("empty")

    def test_joints_overwrite_a_drawing_on_request(self):
        spec = ROOT / "docs" / "slope.json"
        kb.joints(spec, "slope.geo", seed=1)
        with self.assertRaisesRegex(kb.Error, "force=True"):
            kb.joints(spec, "slope.geo", seed=2)
        kb.joints(spec, "slope.geo", seed=2, force=True)

    def test_record_leaves_the_files_of_keyblock_run(self):
        kb.new("block", "block.json")
        steps = []
        results = kb.record("block.json", "first", every=20, history=["block:2"], on_step=lambda s: steps.append(s.number))
        self.assertEqual(steps, list(range(1, 101)))
        subprocess.run([kb.program(), "run", "block.json", "-o", "second", "--record-every", "20", "--history", "block:2"],
                       check=True, capture_output=True)
        names = {str(p.relative_to("first")) for p in Path("first").rglob("*") if p.is_file()}
        self.assertEqual(names, {str(p.relative_to("second")) for p in Path("second").rglob("*") if p.is_file()})
        for name in names - {"run.json"}:  # which holds times
            self.assertEqual((Path("first") / name).read_bytes(), (Path("second") / name).read_bytes(), name)
        other = kb.Results("second").run
        for record in (results.run, other):
            made = record.pop("made_by")
            self.assertEqual((made["commit"], made["compiler"]), (kb._keyblock.commit(), kb._keyblock.compiler()))
            self.assertRegex(made["build"], "^[0-9a-f]{40}$")
            self.assertIsNone(made["seed"])
            for name, checksum in record["output_sha256"].items():
                self.assertEqual(hashlib.sha256((Path("first") / name).read_bytes()).hexdigest(), checksum, name)
            self.assertLess({"history.csv", "fields.pvd", "frames/00000100.vtu"}, set(record["output_sha256"]))
            del record["seconds"]
        self.assertEqual(made["command"][1:3], ["run", "block.json"])
        self.assertEqual(results.run, other)
        self.assertIn("histories", results.tables())
        with self.assertRaises(kb.SettingError):
            kb.record("block.json", "first")

    def test_times_between_frames_and_checkpoints_are_checked(self):
        for wrong in ({"every": -1}, {"checkpoint_every": -1}, {"checkpoint_every": float("nan")}):
            with self.assertRaisesRegex(ValueError, f"{next(iter(wrong))}: expected"):
                kb.record(slide(), "out", **wrong)
        self.assertFalse(Path("out").exists())

    def test_an_error_of_a_callback_passes_through_and_the_run_is_resumed(self):
        kb.new("slope", "slope.json")

        def end_at_100(step):
            if step.number == 100:
                raise ZeroDivisionError
        with self.assertRaises(ZeroDivisionError):
            kb.record("slope.json", "parts", on_step=end_at_100)
        self.assertEqual(kb.Results("parts").end, "stopped")
        steps = []
        self.assertEqual(kb.resume("parts", on_step=lambda s: steps.append(s.number)).end, "finished")
        self.assertEqual((steps[0], steps[-1]), (101, 300))
        whole = kb.record("slope.json", "whole")
        self.assertEqual((Path("parts") / "points.csv").read_bytes(), (whole.folder / "points.csv").read_bytes())
        with self.assertRaises(kb.Error):
            kb.resume("whole")

    def test_a_recorded_run_ends_at_a_condition_and_is_resumed(self):
        kb.new("slope", "slope.json")
        run, seen = kb.Run("slope.json", settings={"steps": 60}, history=["block:12"]), []

        def until(r):
            seen.append(np.hypot(*r.frame().displacement[r.index_of(12)]))
            kinetic = r.history("kinetic")
            self.assertEqual(len(kinetic), r.last.number + 1)
            return len(kinetic) > 40 and kinetic[-1] > 0
        outcome = run.record("parts", every=20).go_on(until)
        self.assertEqual((outcome.end, outcome.steps, outcome.reason), ("stopped", 40, "until is true"))
        self.assertEqual(kb.Results("parts").run["outcome"]["ended_early"], "until is true")
        seen.clear()
        again = kb.resume("parts", until=lambda r: until(r) and r.last.number > 49
                          and f"step {r.last.number} of {r.plan.steps}")
        self.assertEqual((again.end, again.run["outcome"]["ended_early"], len(seen)), ("stopped", "step 50 of 60", 10))
        self.assertEqual(kb.resume("parts").end, "finished")
        whole = run.record("whole", every=20)
        numbers = [step.number for step in whole]
        self.assertEqual((numbers, whole.results.end), (list(range(1, 61)), "finished"))
        self.same_files("parts", "whole")
        ledger = whole.results.table("ledger")
        self.assertEqual(list(whole.history("kinetic")), column(ledger, "kinetic"))
        self.assertEqual(list(whole.history("ledger")), [n for n in ledger if n != "step"])
        without = kb.Run("slope.json", settings={"ledger": "off"})
        self.assertEqual((whole.histories(), without.histories()), (["12"], []))
        with self.assertRaises(kb.SettingError):
            without.history("kinetic")
        moved = whole.history("12")
        self.assertEqual(seen[-1], np.hypot(*(np.asarray(moved[f"displacement_{axis}"])[40] for axis in "xy")))

    def test_an_error_of_a_callback_leaves_the_context_of_the_caller(self):
        kb.new("block", "block.json")
        context = kb.Context()

        def fail(_):
            raise ZeroDivisionError
        for name in ("on_step", "until"):
            with self.assertRaises(ZeroDivisionError):
                kb.record("block.json", name, context=context, **{name: fail})
            self.assertFalse(context.is_stopped)
            self.assertEqual(kb.resume(name, context=context).end, "finished")

    def test_the_case_of_a_resumed_run_has_its_files(self):
        kb.new("block", "block.json")
        case = kb.read("block.json").with_value(FRICTION, 10)
        kb.record(case, "out", "reference", {"steps": 20}, until=lambda r: r.last.number == 5, pictures=False)
        runs = []
        os.mkdir("elsewhere")
        os.chdir("elsewhere")
        self.assertEqual(kb.resume("../out", until=runs.append).end, "finished")
        plan = runs[0].plan
        planned = kb.Plan(case, "reference", {"steps": 20})
        self.assertEqual((plan.profile, plan.steps, plan.settings), (planned.profile, planned.steps, planned.settings))
        again = pickle.loads(pickle.dumps(plan.case))
        self.assertEqual((again.json(), again.get(FRICTION), plan.case._read), (case.json(), 10, case._read))
        self.assertEqual(kb.sweep(plan.case, {"steps": [2]})[0]["verdict"], "finished")
        (self.folder / "out/run.json").unlink()
        with self.assertRaisesRegex(kb.Error, "expected a case whose files are known"):
            pickle.dumps(kb._cases.Case(plan.case._case))

    def test_record_takes_a_condition_and_its_reason(self):
        kb.new("block", "block.json")
        steps, options = [], {"on_step": lambda s: steps.append(s.number), "pictures": False}
        results = kb.record("block.json", "out", until=lambda r: r.last.number == 30 and "enough", **options)
        self.assertEqual((results.end, results.run["outcome"]["ended_early"], steps), ("stopped", "enough", list(range(1, 31))))
        with self.assertRaises(ZeroDivisionError):
            kb.record("block.json", "out", force=True, until=lambda r: 1 / 0)
        self.assertEqual(kb.Results("out").run["outcome"]["steps"], 1)
        self.assertNotIn("ended_early", kb.Results("out").run["outcome"])
        self.assertEqual(kb.resume("out").end, "finished")
        self.assertEqual(kb.record("block.json", "out", force=True, until=lambda r: r.last.number == 1000).end, "finished")
        self.assertEqual(kb.record("block.json", "out", force=True, until=lambda r: True, context=stopped()).end, "stopped")

    def same_files(self, first, second):
        names = {str(p.relative_to(first)) for p in Path(first).rglob("*") if p.is_file()}
        self.assertEqual(names, {str(p.relative_to(second)) for p in Path(second).rglob("*") if p.is_file()})
        for name in names - {"run.json"}:  # which holds times
            self.assertEqual((Path(first) / name).read_bytes(), (Path(second) / name).read_bytes(), name)

    def test_batch_and_sweep_that_cannot_write_end_with_one_error_and_are_resumed(self):
        def no_large_files():  # as a full disk
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192))
        Path("cases").mkdir()
        for name in ("a", "b"):
            kb.new("block", f"cases/{name}.json")
        for command in (["batch", "cases", "--run", "--profile", "standard"],
                        ["sweep", "cases/a.json", "--over", f"{FRICTION}=10,20", "--out", "displacement"]):
            with self.subTest(command[0]):
                call = [kb.program(), *command, "--jobs", "2", "-o", command[0]]
                done = subprocess.run(call, preexec_fn=no_large_files, capture_output=True, text=True)
                errors = [line for line in done.stderr.splitlines() if "error:" in line]
                self.assertEqual((done.returncode, len(errors)), (4, 1), done.stderr)
                self.assertIn("cannot write", errors[0])
                self.assertIn("File too large", errors[0])
                done = subprocess.run([*call, "--resume"], capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("0 jobs done before, 2 to do" if command[0] == "batch" else "", done.stderr)

    def test_tables_have_plain_names_and_units(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("pandas is not installed")
        kb.new("block", "block.json")
        table = kb.record("block.json", "out", pictures=False).table("history")
        self.assertEqual(list(table.columns), ["step", "time", "x1", "y1", "dx1", "dy1"])
        self.assertEqual(table.attrs["units"]["dx1"], "m")
        self.assertEqual(len(table), 101)

    def test_a_run_that_is_stopped_before_its_first_step_has_results_and_is_resumed(self):
        kb.new("slope", "slope.json")
        context, options = kb.Context(), {"settings": {"steps": 5}, "pictures": False}
        kb.record("slope.json", "out", **options)  # whose run.json must not answer
        context.stop()
        results = kb.record("slope.json", "out", force=True, context=context, **options)
        self.assertEqual((results.end, results.doubts, Path("out/run.json").exists()), ("stopped", [], False))
        self.assertIn("stopped", repr(results))
        self.assertEqual(kb.resume("out", context=context).end, "stopped")
        self.assertEqual(kb.resume("out").run["outcome"]["steps"], 5)

    def test_a_recorded_run_of_a_changed_case_is_resumed_with_its_value(self):
        def end_at_2(step):
            if step.number == 2:
                raise ZeroDivisionError
        few = {"settings": {"steps": 5}, "pictures": False}
        with self.assertRaises(ZeroDivisionError):
            kb.record(slide().with_value(FRICTION, 10), "parts", on_step=end_at_2, **few)
        resumed = kb.resume("parts")
        self.assertEqual((resumed.end, resumed.run["values"]), ("finished", {FRICTION: 10}))
        kb.record(slide().with_value(FRICTION, 10), "whole", **few)
        self.assertEqual(Path("parts/points.csv").read_bytes(), Path("whole/points.csv").read_bytes())

    def test_each_column_of_a_table_has_one_type(self):
        self.write("run.json", {"outcome": {"end": "finished"}})
        self.write("mixed.csv", "name,unit,count,force [N],mark\n1,m,1,2,3\ntop,,2,,1_0\n")
        table = kb.Results(self.folder).table("mixed")
        self.assertEqual([list(table[c]) for c in ("name", "unit", "count", "mark")],
                         [["1", "top"], ["m", ""], [1, 2], ["3", "1_0"]])
        self.assertTrue(table["force"][0] == 2.0 and math.isnan(table["force"][1]))
        kb.new("block", "block.json")
        found = kb.record("block.json", "out", history=["block:2"], pictures=False).table("histories")
        self.assertEqual({type(v) for c in ("what", "name", "quantity", "unit") for v in found[c]}, {str})
        self.assertEqual({float(v).is_integer() for v in found["step"]}, {True})

    def test_a_drawing_is_read_with_its_layers(self):
        quarry = kb.read(ROOT / "docs/quarry.dxf", ROOT / "docs/bench.json", layers=ROOT / "docs/quarry_layers.csv")
        self.assertGreater(kb.Plan(quarry).blocks, 30)
        with self.assertRaises(kb.InputError):
            kb.read(ROOT / "docs/quarry.dxf", ROOT / "docs/bench.json", layers="nothing.csv")

    def test_units_and_distances_of_drawings_are_refused_as_by_the_program(self):
        files = [ROOT / "docs/quarry.dxf", ROOT / "docs/bench.json"]
        layers = {"layers": ROOT / "docs/quarry_layers.csv"}
        for name, wrong in (("unit", "furlong"), ("unit", "MM"), ("join", -1.0), ("join", float("nan"))):
            with self.subTest(name, wrong=wrong):
                with self.assertRaises(kb.SettingError) as caught:
                    kb.read(*files, **layers, **{name: wrong})
                told = subprocess.run([kb.program(), "check", *files, f"--{name}={wrong}"], capture_output=True, text=True)
                self.assertEqual(told.returncode, 2)
                said = str(caught.exception).rpartition("found")[0].partition("expected")[2]
                self.assertTrue(said and said in told.stderr, str(caught.exception))
        self.assertGreater(kb.Plan(kb.read(*files, **layers, unit="mm", join=1.0)).blocks, 30)

    def test_joints_depend_on_the_seed(self):
        texts = [kb.joints(str(ROOT / "docs/slope.json"), f"{i}.geo", seed=seed).read_text() for i, seed in enumerate((1, 1, 2))]
        self.assertEqual(texts[0], texts[1])
        self.assertNotEqual(texts[0], texts[2])

    def test_a_citation_names_the_build_and_the_origin_of_results(self):
        kb.new("block", "block.json")
        cited = kb.cite(kb.record("block.json", "out", settings={"steps": 2}))
        changed = kb.read("block.json").with_value("/analysis/joint_materials/0/friction_angle_deg", 12)
        self.assertIn("% value /analysis/joint_materials/0/friction_angle_deg=12\n",
                      kb.cite(kb.record(changed, "changed", settings={"steps": 2})))
        self.assertNotIn("% value", cited)
        self.assertIn(f"commit {kb._keyblock.commit()}, {kb._keyblock.compiler()}, build {kb._keyblock.build()}", kb.cite())
        self.assertTrue(cited.startswith(kb.cite()))
        checksum = hashlib.sha256(Path("block.json").read_bytes()).hexdigest()
        self.assertRegex(cited, f"% input {checksum} .*block.json\n")
        self.assertRegex(cited, "% output [0-9a-f]{64} history.csv\n")
        self.assertNotIn("frames/", cited)

    def test_other_commands_answer(self):
        report = kb.compare(CASES / "sliding_block" / "a30_p20")
        self.assertTrue(report)
        kb.new("block", "block.json")
        end, curve = kb.element("block.json", "uniaxial", to=[-0.001], material=1)
        self.assertEqual(end["end"]["strain"][1], -0.001)
        self.assertEqual(len(curve), end["points"])
        folder = CASES / "sliding_block" / "a30_p20"
        old = [folder / f"a30_p20.{ending}" for ending in ("geo", "ana")]
        drawing = kb.read(ROOT / "docs/quarry.dxf", ROOT / "docs/bench.json", layers=ROOT / "docs/quarry_layers.csv")
        for case in (folder, kb.read(folder), kb.read(*old), kb.read(*reversed(old)), drawing, ROOT / "docs/bench.json"):
            self.assertEqual(kb.element(case, "uniaxial", to=[-0.001])[0]["end"]["strain"][1], -0.001)
            self.assertEqual(kb.element(case, "uniaxial", to=-0.001)[0]["end"]["strain"][1], -0.001)
        self.write("curve.csv", "strain,stress\n" + "".join(f"{-e / 1e4},{-e * 1e-4 * 20e9}\n" for e in range(1, 11)))
        self.assertTrue(kb.fit("curve.csv"))
        self.assertTrue(kb.convert("block.json", output="block.dxf"))
        self.assertEqual(len(kb.cases("sliding_block", CASES)), 21)

    def test_cases_are_those_of_a_batch(self):
        shutil.copytree(CASES / "block_at_rest" / "static", "archive/old/with_case/static")
        shutil.copytree(CASES / "sliding_block" / "a30_p25", "archive/old/bare", ignore=shutil.ignore_patterns("case.json", "*.csv"))
        kb.new("block", "archive/own/block.json")
        bare = tuple(Path(f"archive/old/bare/a30_p25.{ending}") for ending in ("geo", "ana"))
        expected = [bare, Path("archive/old/with_case/static"), Path("archive/own/block.json")]
        self.assertEqual(kb.cases("archive"), expected)
        self.assertEqual(kb.cases("old", "archive"), expected[:2])
        self.assertEqual([kb.read(case).profile for case in expected], ["legacy", "legacy", "standard"])
        subprocess.run([kb.program(), "batch", "archive", "--check", "-o", "out"], check=True, capture_output=True)
        with open("out/catalogue.csv", newline="", encoding="utf-8") as rows:
            self.assertEqual(len([row for row in csv.DictReader(rows) if row["outcome"] in ("ok", "warnings")]), 3)

    def test_messages_name_what_exists_and_arguments_of_python(self):
        with self.assertRaisesRegex(kb.Error, "one of slope, arch, beam, tunnel, block, found"):
            kb.new("foo", "foo.json")
        case = kb.new("block", "block.json")
        with self.assertRaisesRegex(kb.Error, "out: expected displacement, .*found nothing") as caught:
            kb.sweep(case, {"steps": [2]}, out="nothing")
        self.assertNotIn("--", str(caught.exception))
        said = kb._words.in_arguments
        self.assertEqual(said("expected --over or --design, found a--b; --time-limit: 3"),
                         "expected over= or over=, found a--b; time_limit: 3")
        self.assertEqual(said("--history: expected 3"), "history: expected 3")
        self.assertEqual(said("a exists; give another name, or --force to overwrite it"),
                         "a exists; give another name, or force=True to overwrite it")
        self.assertEqual(said("a lacks b; give another folder, or --force to replace it", ["force"]),
                         "a lacks b; give another folder")
        self.assertEqual(said("(`keyblock run --settings` lists them); --join 0.003 closes it"),
                         "(`keyblock run --settings` lists them); join=0.003 closes it")
        self.assertEqual(said("try --set slivers=glue"), 'try settings={"slivers": "glue"}')

    def test_messages_of_the_library_name_arguments_of_python_too(self):
        kb.new("block", "block.json")
        with self.assertRaisesRegex(kb.SettingError, "^history: expected"):
            kb.Run("block.json", history=["blok:1"])
        with self.assertRaisesRegex(kb.InputError, "^history=block:7: error: ") as caught:
            kb.Run("block.json", history=["block:7"])
        self.assertEqual(caught.exception.file, "history=block:7")
        Path("a --force").mkdir()
        wrong = Path("a --force/c.json")
        wrong.write_text('{"keyblock": 2,\n "blocks": 7}')
        with self.assertRaisesRegex(kb.InputError, "^a --force/c.json:2:12: error: ") as caught:
            kb.read(wrong)
        self.assertEqual(caught.exception.file, str(wrong))
        with self.assertRaisesRegex(kb.Error, "block.json exists; give another name$"):
            kb.read("block.json").write("block.json")
        kb.record("block.json", "out", settings={"steps": 2}, pictures=False)
        with self.assertRaisesRegex(kb.Error, "out.* or force=True to overwrite"):
            kb.record("block.json", "out")
        with self.assertRaisesRegex(kb.SettingError, "found none; begin a new run there$"):
            kb.resume(self.folder)

    def test_wrong_arguments_are_named_before_anything_is_written(self):
        kb.new("block", "block.json")
        with self.assertRaisesRegex(TypeError, "^on_step: expected a function, found 5$"):
            kb.record("block.json", "out", on_step=5)
        with self.assertRaisesRegex(TypeError, "^history: expected a text, .*, found 3$"):
            kb.record("block.json", "out", history=[3])
        with self.assertRaisesRegex(TypeError, "^history: expected a text, .*, found 3$"):
            kb.Run("block.json", history=3)
        with self.assertRaisesRegex(kb.SettingError, "^contacts: expected automatic, .* found \"some\"$"):
            kb.record("block.json", "out", contacts="some")
        with self.assertRaisesRegex(kb.SettingError, "^folder: expected the name of a folder, found an empty one$"):
            kb.record("block.json", "")
        with self.assertRaisesRegex(kb.SettingError, "^folder: expected the name of a folder, found an empty one$"):
            kb.resume("")
        with self.assertRaisesRegex(kb.InputError, '^"": error: expected the name of a file or a folder'):
            kb.read("")
        self.assertFalse(Path("out").exists())

    def test_names_and_texts_are_utf8_whatever_the_locale(self):
        script = ("import keyblock as kb, os, sys\n"
                  "case = kb.read(kb.new('block', 'block.json'))\n"
                  "name = '/analysis/joint_materials/0/name'\n"
                  "table = kb.sweep(case, {name: ['\\u00e9', '\\u00b5']}, settings={'steps': 2})\n"
                  "assert list(table[name]) == ['\\u00e9', '\\u00b5'], table[name]\n"
                  "path = os.fsdecode(b'\\xff.json')\n"
                  "for call in (lambda: kb.read(path), lambda: kb.element(path, 'uniaxial', to=[1])):\n"
                  "    try:\n        call()\n    except kb.Error as error:\n"
                  "        assert path in str(error) and getattr(error, 'file', path) == path, ascii(str(error))\n"
                  "    else:\n        raise SystemExit('no error')\n"
                  "os.rename('block.json', path)\n"
                  "assert kb.Run(path, settings={'steps': 2}).go_on().end == 'finished'\n")
        for locale in ({"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}, {"LC_ALL": "C.UTF-8"}):
            done = subprocess.run([sys.executable, "-c", script], env={**os.environ, **locale}, capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            os.remove(b"\xff.json")

    def test_a_program_that_does_not_start_is_an_error_of_the_package(self):
        with mock.patch.dict("os.environ", {"KEYBLOCK_PROGRAM": "/nope"}):
            with self.assertRaisesRegex(kb.ProgramError, "the program /nope does not start: No such file") as caught:
                kb.new("block", "block.json")
        self.assertEqual(caught.exception.code, 127)

    def test_a_sweep_says_why_it_refuses_a_folder(self):
        case = kb.read(kb.new("block", "block.json"))
        kb.sweep(case, {"steps": [2, 3]}, folder="out")
        with self.assertRaisesRegex(kb.Error, "has 1 run that this sweep lacks; give another folder$"):
            kb.sweep(case, {"steps": [2]}, folder="out")
        with self.assertRaisesRegex(kb.Error, "a sweep of another case, output or limit"):
            kb.sweep(case, {"steps": [2]}, folder="out", out="speed")

    def test_a_factor_of_safety_names_the_profile_of_the_command(self):
        old = [CASES / "sliding_block" / "a30_p20" / f"a30_p20.{ending}" for ending in ("geo", "ana")]
        for profile in (None, "reference"):
            found = kb.factor_of_safety(kb.read(old), "joints", within=0.1, profile=profile)
            told = subprocess.run([kb.program(), "fos", *old, "--to-within", "0.1", "--json", *kb._program._options(profile=profile)],
                                  capture_output=True, text=True)
            told = json.loads(told.stdout)
            self.assertEqual((found.profile, found.stands), (told["profile"], told["bracket"]["stands"]))
            self.assertEqual(found.profile, profile or "standard")
            self.assertIn(found.profile, repr(found))
            self.assertTrue(found.why_profile)
            self.assertEqual(found.unknowns, told["unknowns"])
            self.assertEqual((found.settings["motion"], told["settings"]["motion"]), ("static", "static"))
            self.assertEqual(found.settings.keys(), told["settings"].keys())
        crack = kb.stress_intensity(kb.cases("stress_intensity", CASES)[0])
        self.assertEqual((crack.profile, bool(crack.why_profile)), ("standard", True))
        self.assertGreater(crack.unknowns, 100)
        self.assertEqual(crack.settings["motion"], "static")


if __name__ == "__main__":
    unittest.main()
