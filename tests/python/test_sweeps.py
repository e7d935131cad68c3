"""Jobs in child processes, and sweeps of them.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import csv
import hashlib
import json
import math
import os
import pickle
import shutil
import signal
import statistics
import subprocess
import sys
import threading
import time
import unittest
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import keyblock as kb  # noqa: E402
from support import FRICTION, ROOT, SI, Folder, endless, press_ctrl_c, slide  # noqa: E402


def way(friction):
    run = kb.Run(slide().with_value(FRICTION, friction))
    run.go_on()
    return float(np.hypot(*run.frame().displacement[1]))


def troubled(item):
    if item == "crash":
        os.kill(os.getpid(), signal.SIGSEGV)
    if item == "killed":
        os.kill(os.getpid(), signal.SIGKILL)
    if item == "nameless":
        os.kill(os.getpid(), signal.SIGRTMIN + 6)
    if item == "slow":
        time.sleep(60)
    if item == "error":
        raise ValueError("no such thing")
    if item == "large":
        return bytes(1 << 30)
    return item


class Cost:
    def __init__(self, factor):
        self.factor = factor

    def of(self, run):
        return self.factor


class Pools(Folder):
    def test_results_come_in_order_and_a_job_in_trouble_is_one_result(self):
        items = [1, "crash", 2, "slow", "error", "killed", 3]
        with kb.Pool(jobs=3, time_limit=1.5) as pool:
            found = list(pool.map(troubled, items))
        self.assertEqual([r for r in found if not isinstance(r, kb.Failed)], [1, 2, 3])
        self.assertEqual([(f.reason, f.signal) for f in found if isinstance(f, kb.Failed)],
                         [("signal", signal.SIGSEGV), ("time_limit", signal.SIGKILL), ("error", 0), ("signal", signal.SIGKILL)])
        self.assertEqual(found[4].message, "ValueError: no such thing")
        self.assertTrue(math.isnan(float(found[1])))

    def test_pools_of_two_threads_do_not_wait_for_each_other(self):
        fork, ends, delays = os.fork, {}, iter((0.6, 0.1))

        def slow_fork():  # the second child is made while the first pipe is open, unless starts take turns
            time.sleep(next(delays))
            return fork()

        def wait(seconds):
            with kb.Pool(jobs=1) as pool:
                list(pool.map(time.sleep, [seconds]))
            ends[seconds] = time.monotonic()
        with mock.patch("os.fork", slow_fork):
            threads = [threading.Thread(target=wait, args=(seconds,)) for seconds in (0, 3)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
        self.assertGreater(ends[3] - ends[0], 1.5)

    def test_a_signal_without_a_name_is_one_result(self):
        with kb.Pool(jobs=1) as pool:
            failed, other = pool.map(troubled, ["nameless", 1])
        self.assertEqual((failed.reason, failed.message, other), ("signal", f"signal {failed.signal}", 1))

    def test_a_job_beyond_its_memory_is_one_result(self):
        with kb.Pool(jobs=1, memory_limit=1500) as pool:
            failed, other = pool.map(troubled, ["large", 1])
        self.assertEqual((failed.reason, other), ("memory_limit", 1))
        row, = kb.sweep(slide(), {"steps": [2]}, out=lambda run: len(bytes(3 << 30)), memory_limit=1500)
        self.assertEqual((row["verdict"], row["doubt"]), ("memory_limit", "MemoryError"))

    def test_jobs_go_on_behind_the_thread_that_began_them(self):
        pool, first = kb.Pool(jobs=2), []
        results = pool.unordered(lambda i: time.sleep(0.1 + i) or i, [0, 1])
        thread = threading.Thread(target=lambda: first.append(next(results)))
        thread.start()
        thread.join()
        self.assertEqual([*first, *results], [(0, 0), (1, 1)])

    def test_the_limit_of_a_context_holds_in_children(self):
        plan = endless()
        with kb.Context(time_limit=1) as context, kb.Pool(jobs=1, time_limit=20) as pool:
            found, = pool.map(lambda i: (kb.Run(plan, context=context).go_on().end, context.timed_out), [1])
            self.assertEqual(found, ("stopped", True))

    def test_numbers_of_jobs_and_limits_are_checked(self):
        nan, infinite = math.nan, math.inf
        for wrong in ({"jobs": -1}, {"jobs": 1.5}, {"time_limit": -1}, {"time_limit": nan}, {"time_limit": infinite},
                      {"memory_limit": -1}):
            for call in (kb.Pool, lambda **o: kb.sweep(slide(), {FRICTION: [20]}, **o)):
                with self.assertRaisesRegex(ValueError, f"{next(iter(wrong))}: expected"):
                    call(**wrong)
        self.assertEqual(kb.Pool(0).jobs, os.cpu_count())
        self.assertEqual(kb.sweep(slide(), {"steps": [2]}, jobs=0, out="time")[0]["verdict"], "finished")

    def test_children_compute_what_the_caller_computes_also_behind_its_runs(self):
        kb.Run(kb.Plan(self.wall(30, 25), settings={"start": "sudden"}), threads=2).go_on()  # threads of loops exist now
        with kb.Pool(jobs=2) as pool:
            self.assertEqual(list(pool.map(lambda f: way(f), [10, 20])), [way(10), way(20)])

    def test_ctrl_c_ends_the_children(self):
        plan = endless()
        pids = self.folder / "pids"

        def job(i):
            with open(pids, "a") as file:
                file.write(f"{os.getpid()}\n")
            kb.Run(plan).go_on()
        timer = press_ctrl_c(0.5)
        began = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            with kb.Pool(jobs=2) as pool:
                list(pool.map(job, range(4)))
        timer.join()
        self.assertLess(time.monotonic() - began, 2.5)
        for pid in pids.read_text().split():
            self.assertFalse(os.path.exists(f"/proc/{pid}"))

    def test_children_end_with_a_killed_parent(self):
        for call in ("work()", "threading.Thread(target=work).start()"):
            with self.subTest(call):
                self.ends_with_parent(call)

    def ends_with_parent(self, call):
        script = ("import keyblock as kb, threading, time, os\n"
                  "def job(i):\n    print(os.getpid(), flush=True)\n    time.sleep(60)\n"
                  f"def work():\n    list(kb.Pool(jobs=1).map(job, [1]))\n{call}\n")
        parent = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
        pid = int(parent.stdout.readline())
        parent.kill()
        parent.wait()
        parent.stdout.close()
        for _ in range(50):
            if not os.path.exists(f"/proc/{pid}") or " Z " in Path(f"/proc/{pid}/stat").read_text():
                return
            time.sleep(0.05)
        self.fail("the child goes on")


class Sweeps(Folder):
    def test_warnings_of_a_row_are_in_its_table(self):
        case = kb.read(kb.new("block", self.folder / "block.json"))
        over = {"time_step": ["10 ms", "1 s"], "steps": [10]}  # the block passes the end of its base within a step
        by_program = kb.sweep(case, over)
        self.assertEqual(by_program["warnings"][0], "")
        self.assertIn("step_passes_blocks", by_program["warnings"][1].split())
        self.assertEqual(list(kb.sweep(case, over, out=lambda run: 0)["warnings"]), list(by_program["warnings"]))

    def test_a_grid_is_a_table_in_order(self):
        table = kb.sweep(slide(), {FRICTION: [10, 20], "time_step": [0.001, 0.0005]})
        self.assertEqual(table.columns, [FRICTION, "time_step", "verdict", "doubt", "warnings", "displacement", "job"])
        self.assertEqual(len(table.seconds), 4)
        self.assertEqual(list(table[FRICTION]), [10, 10, 20, 20])
        self.assertAlmostEqual(table[0]["displacement"], way(10), delta=1e-5)  # of a corner, and of the centroid
        self.assertEqual(set(table["verdict"]), {"finished"})
        table.write("table.csv")
        self.assertEqual((self.folder / "table.csv").read_text().count("\n"), 5)

    def test_a_data_frame_is_its_rows(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("pandas is not installed")
        rows = [{FRICTION: 20.0, "steps": 3}, {FRICTION: 40.0, "steps": 4}]
        tables = [kb.sweep(slide(), over) for over in (rows, pandas.DataFrame(rows))]
        self.assertEqual([list(row.values()) for row in tables[0]], [list(row.values()) for row in tables[1]])
        self.assertEqual(list(tables[1]["steps"]), [3, 4])

    def test_trouble_of_one_row_stays_there(self):
        def out(run):
            return {"x": troubled("crash") if run.plan.case.get(FRICTION) == 15 else 1.0}
        table = kb.sweep(slide(), {FRICTION: [10, 15, "steep", 20]}, out=out)
        self.assertEqual([r["verdict"] for r in table], ["finished", "signal", "error", "finished"])
        self.assertEqual(table[1]["doubt"], "SIGSEGV")
        self.assertIn("InputError", table[2]["doubt"])
        self.assertEqual([r["x"] for r in table[::3]], [1.0, 1.0])

    def test_factors_of_safety_and_points_are_outputs(self):
        table = kb.sweep(slide(), {FRICTION: [20]}, out=["fos", "speed", "steps", "blocks", "point1.dx", "displacement"])
        self.assertAlmostEqual(table[0]["point1.dx"], math.cos(math.radians(30)) * table[0]["displacement"], delta=1e-3)
        self.assertAlmostEqual(table[0]["fos"], math.tan(math.radians(20)) / math.tan(math.radians(30)), delta=0.01)
        self.assertEqual((table[0]["steps"], table[0]["blocks"]), (1000, 2))
        with self.assertRaises(kb.Error):
            kb.sweep(slide(), {FRICTION: [20]}, out="colour")
        with self.assertRaises(ValueError):
            kb.sweep(slide, {}, out="colour")

    def test_values_are_a_list(self):
        for values in ("10:25:5", 10):
            with self.assertRaisesRegex(ValueError, "expected a list of values for a"):
                kb.grid({"a": values})

    def test_an_output_that_is_refused_leaves_the_others(self):
        row, = kb.sweep(lambda angle: slide().with_value(FRICTION, angle), {"angle": [20]},
                        out=["fos", "fos_rock", "displacement"], settings={"steps": 10})
        self.assertEqual((row["verdict"], math.isnan(row["fos_rock"])), ("error", True))
        self.assertIn("strength", row["doubt"])
        self.assertGreater(row["fos"], 0)
        self.assertGreater(row["displacement"], 0)

    def test_a_search_without_a_bracket_is_no_finished_row(self):
        stable = SimpleNamespace(factor=64.0, verdict="stands", why="")
        undecided = SimpleNamespace(factor=128.0, verdict="undecided", why="forces do not settle")
        for end, trials, doubt in (("stands", [stable], "F = 64: stands"),
                                   ("undecided", [stable, undecided], "F = 128: undecided: forces do not settle")):
            found = SimpleNamespace(end=end, stands=64.0, trials=trials, warnings=[])
            with mock.patch("keyblock._sweeps.factor_of_safety", lambda *_, **__: found):
                for out in (["fos"], ["fos", "steps"], ["steps", "fos"]):
                    row = kb._sweeps._row(slide(), {"steps": 2}, out, None, None, ())
                    self.assertEqual((row["verdict"], row["fos"], row["doubt"]), (end, 64, doubt))

    def test_a_search_without_a_bracket_has_the_same_reason_by_program_and_by_function(self):
        values = {FRICTION: [89.9]}
        by_program, = kb.sweep(slide(), values, out=["fos"])
        by_function, = kb.sweep(lambda: slide(), values, out=["fos"])
        self.assertEqual((by_program["verdict"], by_program["doubt"]), ("stands", "F = 16: stands"))
        self.assertEqual(by_program["doubt"], by_function["doubt"])

    def test_a_function_has_the_histories(self):
        row, = kb.sweep(slide(), {"steps": [2]}, out=lambda run: len(run.history("top")["time"]),
                        history=["top=block:2"])
        self.assertEqual((row["verdict"], row["out"]), ("finished", 3), row)

    def test_measured_points_count_from_1(self):
        for name in ("point0.dx", "point00.dx", "point².dx"):
            with self.assertRaisesRegex(ValueError, "number of a measured point"):
                kb.sweep(slide(), {FRICTION: [20]}, out=name)

    def test_rows_of_different_keys_are_one_table(self):
        table = kb.sweep(slide(), [{FRICTION: 10, "steps": 2}, {"steps": 3}, {FRICTION: 20, "time_step": "1 ms"}], out="time")
        self.assertEqual(table.columns, [FRICTION, "steps", "time_step", "verdict", "doubt", "warnings", "time", "job"])
        even = kb.sweep(slide(), [{FRICTION: 10, "steps": 2}, {FRICTION: 20, "steps": 3}], out="point1.dx")
        mixed = kb.sweep(slide(), [{FRICTION: 10, "steps": 2}, {"steps": 3}], out="point1.dx")
        np.testing.assert_array_equal(mixed["point1.dx"], even["point1.dx"])  # the case has 20 degrees
        by_function = kb.sweep(slide(), [{FRICTION: 10, "steps": 2}, {"steps": 3}], out=lambda run: run.last.number)
        self.assertEqual(list(by_function["out"]), [2, 3])
        np.testing.assert_array_equal(table[FRICTION], [10, math.nan, 20])
        self.assertIn("1 ms", repr(table))
        table.write("table.csv")
        rows = list(csv.reader((self.folder / "table.csv").read_text().splitlines()))
        self.assertEqual([row[:3] for row in rows[1:]], [["10", "2", ""], ["", "3", ""], ["20", "", "1 ms"]])
        kb.Table([{"a": 1}, {"b": 2.5}]).write("free.csv")
        self.assertEqual((self.folder / "free.csv").read_text(), "a,b\n1,\n,2.5\n")
        with self.assertRaises(KeyError):
            kb.Table([{"a": 1}])["b"]

    def test_no_column_hides_another(self):
        for case in (slide(), lambda steps: slide()):
            with self.assertRaisesRegex(ValueError, "found steps"):
                kb.sweep(case, {"steps": [2]}, out=["time", "steps"])
        for name in ("seconds", "verdict"):
            with self.assertRaisesRegex(ValueError, name):
                kb.sweep(lambda **values: slide(), {name: [2]}, out="steps")
        row, = kb.sweep(slide(), {"steps": [2]}, out=lambda run: {"steps": 7})
        self.assertEqual((row["steps"], row["verdict"]), (2, "error"))

    def test_a_function_makes_the_cases(self):
        table = kb.sweep(lambda angle: slide().with_value(FRICTION, angle), {"angle": [10, 20]})
        self.assertEqual(table.columns, ["angle", "verdict", "doubt", "warnings", "displacement"])
        np.testing.assert_allclose(table["displacement"], [way(10), way(20)], atol=1e-5)

    def test_a_sweep_refuses_files_that_changed_since_they_were_read(self):
        path = kb.new("block", "block.json")
        case, text = kb.read(path), path.read_text()
        pickled = pickle.dumps(case)
        for change in (lambda: path.write_text(text.replace("20 deg", "5 deg")), path.unlink):
            change()
            self.assertEqual(case.get(FRICTION), "20 deg")
            for call in (lambda: kb.sweep(case, {"steps": [2]}), lambda: pickle.loads(pickled)):
                with self.assertRaisesRegex(kb.Error, "block.json has changed since the case was read"):
                    call()
        path.write_text(text)
        self.assertEqual(kb.sweep(case, {"steps": [2]})[0]["verdict"], "finished")
        self.assertEqual(pickle.loads(pickled).json(), case.json())

    def test_the_folder_has_what_its_command_names(self):
        case = kb.read(kb.new("block", "block.json"))
        kb.sweep(case, {"steps": [2, 3]}, folder="out")
        kept = (self.folder / "out/design.json").read_bytes()
        with self.assertRaisesRegex(kb.Error, "has 1 run that this sweep lacks"):
            kb.sweep(case, {"steps": [2]}, folder="out")
        self.assertEqual((self.folder / "out/design.json").read_bytes(), kept)
        with self.assertRaisesRegex(kb.Error, "colour"):
            kb.sweep(case, {"steps": [2]}, out="colour", folder="refused")
        self.assertEqual(os.listdir("refused"), [])
        table = (self.folder / "out/table.csv").read_bytes()
        origin = json.loads((self.folder / "out/sweep.json").read_text())
        for file in origin["inputs"]:
            self.assertEqual(hashlib.sha256(Path(file["file"]).read_bytes()).hexdigest(), file["sha256"])
        command = [word for word in origin["made_by"]["command"] if word != "--resume"]
        command[command.index("-o") + 1] = "again"
        subprocess.run(command, check=True, capture_output=True)
        self.assertEqual((self.folder / "again/table.csv").read_bytes(), table)
        self.write("file", "")
        with self.assertRaisesRegex(kb.Error, "cannot write .*file: File exists"):
            kb.sweep(case, {"steps": [2]}, folder="file")

    def test_a_failed_row_has_the_bytes_of_the_command(self):
        for case in (kb.new("block", "block.json"), ROOT / "legacy_cases/sliding_block/a30_p20"):
            kb.sweep(case, {"time_step": ["1 ms"]}, out="fos_rock").write("python.csv")
            subprocess.run([kb.program(), "sweep", case, "--over", "time_step=1 ms", "--out", "fos_rock", "-o", "command",
                            "--force"], capture_output=True)
            self.assertEqual((self.folder / "python.csv").read_text(), (self.folder / "command/table.csv").read_text())
            self.assertNotIn(str(self.folder), (self.folder / "python.csv").read_text())

    def test_a_second_call_computes_missing_rows_alone(self):
        count = self.folder / "count"

        def counted(run):
            with open(count, "a") as file:
                file.write("x")
            return run.frame().displacement[1, 0]
        over = {FRICTION: [10, 15, 20]}
        first = kb.sweep(slide(), over, out=counted, folder="rows")
        lines = (self.folder / "rows/journal.jsonl").read_text().splitlines(True)
        self.write("rows/journal.jsonl", "".join(lines[:-1]) + lines[-1][:5])  # a kill cut the last row
        second = kb.sweep(slide(), over, out=counted, folder="rows")
        third = kb.sweep(slide(), over, out=counted, folder="rows")
        self.assertEqual((self.folder / "count").read_text(), "xxxx")
        self.assertEqual([list(t["out"]) for t in (second, third)], [list(first["out"])] * 2)
        with self.assertRaises(kb.Error):
            kb.sweep(slide(), over, out=lambda run: 1, settings={"steps": 3}, folder="rows")

    def test_a_longer_time_limit_computes_late_rows_anew(self):
        path = self.folder / "count"

        def counted(run):
            with open(path, "a") as file:
                file.write("x")
            time.sleep(60 if len(path.read_text()) == 1 else 0)
            return 1
        for limit, verdict, count in ((1, "time_limit", 1), (1, "time_limit", 1), (30, "finished", 2),
                                      (40, "finished", 2)):
            row, = kb.sweep(slide(), {"steps": [2]}, out=counted, folder="rows", time_limit=limit)
            self.assertEqual((row["verdict"], len((self.folder / "count").read_text())), (verdict, count))

    def test_rows_of_another_function_are_refused(self):
        def times(factor):
            return lambda run: factor * run.last.time
        few, over = {"steps": 2}, {FRICTION: [10]}
        kb.sweep(slide(), over, out=times(1), settings=few, folder="rows")
        kb.sweep(slide(), over, out=times(1), settings=few, folder="rows")
        for other in (times(2), lambda run: run.last.time, lambda run: run.last.dt):
            with self.assertRaisesRegex(kb.Error, "another sweep"):
                kb.sweep(slide(), over, out=other, settings=few, folder="rows")
        kb.sweep(lambda angle: slide(), {"angle": [10]}, settings=few, folder="cases")
        with self.assertRaisesRegex(kb.Error, "another sweep"):
            kb.sweep(lambda angle: slide().with_value(FRICTION, angle), {"angle": [10]}, settings=few, folder="cases")
        with self.assertRaisesRegex(ValueError, "function of Python"):
            kb.sweep(slide(), over, out=print, settings=few, folder="other")

    def test_settings_of_a_folder_and_files_that_settings_name_identify_a_case(self):
        shutil.copytree(ROOT / "legacy_cases/newmark_sine/row_1", "row_1")
        few = {"settings": {"steps": 20}, "folder": "rows", "out": lambda run: run.outcome.displacement}
        motion, described = self.folder / "row_1/motion.csv", self.folder / "row_1/case.json"
        over = {"time_step": [0.005]}
        texts = {path: path.read_text() for path in (motion, described)}
        kb.sweep("row_1", over, **few)
        for path, other in ((motion, texts[motion].replace(",0", ",1")), (described, '{"set": {}}')):
            path.write_text(other)
            with self.assertRaisesRegex(kb.Error, "another sweep"):
                kb.sweep("row_1", over, **few)
            path.write_text(texts[path])
        kb.sweep("row_1", over, **few)
        named, found = {"body_acceleration_file": ["acc.csv"]}, []
        for acceleration in (5, -5, 5):
            self.write("acc.csv", f"time,ax,ay\n0,{acceleration},0\n20,{acceleration},0\n")
            few["folder"] = "named"
            found.append(kb.sweep(slide(), named, **few)["out"][0])
            with (self.assertRaisesRegex(kb.Error, "another sweep") if acceleration < 0 else contextlib.nullcontext()):
                kb.sweep(slide(), {"time_step": [0.001]}, **{**few, "folder": "common", "settings": {
                    "steps": 2, "body_acceleration_file": "acc.csv"}})
        self.assertEqual(found[0], found[2])
        self.assertNotEqual(found[0], found[1])

    def test_enclosed_values_and_objects_of_methods_identify_a_function_by_their_content(self):
        def enclosing(value):
            return lambda run: value
        plain = SimpleNamespace
        for first, same, other in ((Path("a"), Path("a"), Path("b")), (plain(k=1), plain(k=1), plain(k=2)),
                                   (Fraction(1), Fraction(1), Fraction(2)), (np.arange(3), np.arange(3), np.arange(4)),
                                   (Cost(1).of, Cost(1).of, Cost(2).of), (slide(), slide(), slide().with_value(FRICTION, 5))):
            marks = [json.dumps(kb._sweeps._identity("out", enclosing(value))) for value in (first, same, other)]
            self.assertEqual(marks[0], marks[1])
            self.assertNotEqual(marks[0], marks[2])
        marks = [kb._sweeps._identity("out", Cost(k).of) for k in (1, 1, 2)]
        self.assertEqual(marks[0], marks[1])
        self.assertNotEqual(marks[0], marks[2])
        with self.assertRaisesRegex(ValueError, "out: expected a function whose enclosed values can be pickled"):
            kb.sweep(slide(), {"steps": [2]}, out=enclosing(threading.Lock()), folder="rows")

    def test_functions_that_differ_in_a_name_or_a_nested_constant_have_different_marks(self):
        pairs = [(lambda run: run.last.time, lambda run: run.last.dt), (lambda run: 1, lambda run: 2),
                 (lambda run: [i + 1 for i in run], lambda run: [i + 2 for i in run]),
                 (lambda run, a=1: a, lambda run, a=2: a), (lambda run: run in {"a", "b"}, lambda run: run in {"a", "c"})]
        for first, second in pairs:
            self.assertNotEqual(kb._sweeps._mark(first, ()), kb._sweeps._mark(second, ()))

    def test_rows_of_another_build_are_refused(self):
        def call():
            return kb.sweep(slide(), {FRICTION: [10]}, out=lambda run: 1, settings={"steps": 2}, folder="rows")
        call()
        path = self.folder / "rows/journal.jsonl"
        path.write_text(path.read_text().replace(kb._keyblock.build(), "0" * 40))
        with self.assertRaisesRegex(kb.Error, "expected rows of the library"):
            call()

    def test_a_journal_that_was_cut_goes_on_and_another_text_is_one_error(self):
        def call():
            return kb.sweep(slide(), {FRICTION: [10, 20]}, out=lambda run: 1, settings={"steps": 2}, folder="rows")
        call()
        path = self.folder / "rows/journal.jsonl"
        whole = path.read_bytes()
        heading = whole.index(b"\n")
        for cut in (0, 1, 12, heading, heading + 1, heading + 2, len(whole) - 1):
            path.write_bytes(whole[:cut])
            self.assertEqual(list(call()["out"]), [1, 1], cut)
            self.assertEqual(sorted(json.loads(line)[0] for line in path.read_text().splitlines()[1:]),
                             sorted(json.loads(line)[0] for line in whole.decode().splitlines()[1:]))
        for wrong in (b"[1, 2]\n", b"notes", b"\n", b"null\n", whole + b"garbage\n", whole + b"[1]\n", whole + b"\xff\n"):
            path.write_bytes(wrong)
            with self.assertRaisesRegex(kb.Error, "journal.jsonl:[14]: error: expected"):
                call()
            self.assertEqual(path.read_bytes(), wrong)

    def test_outputs_of_any_type_of_number_are_kept_and_others_are_failed_rows(self):
        def out(run):
            third = np.float32(1 / 3)
            kinds = {10: {"a": {"b": [third, Fraction(1, 2)]}}, 15: {"a": np.longdouble(2)}, 20: {"a": 1j}, 25: {"a": third}}
            return kinds[run.plan.case.get(FRICTION)]
        over, few = {FRICTION: [10, 15, 20, 25]}, {"steps": 2}
        third = float(np.float32(1 / 3))
        for _ in range(2):
            table = kb.sweep(slide(), over, out=out, settings=few, folder="rows")
            self.assertEqual([table[i]["a"] for i in (0, 1, 3)], [{"b": [third, 0.5]}, 2.0, third])
            self.assertEqual((table[2]["verdict"], math.isnan(table[2]["a"])), ("error", True))
            self.assertIn("complex", table[2]["doubt"])
        in_memory = kb.sweep(slide(), over, out=out, settings=few)
        with self.assertRaisesRegex(TypeError, "found complex"):
            in_memory.write("none.csv")
        self.assertFalse(Path("none.csv").exists())

    def test_shards_together_are_the_whole_table(self):
        over = {FRICTION: [10, 15, 20, 25, 5]}
        for out in ("displacement", lambda run: run.outcome.displacement):
            folder = "names" if isinstance(out, str) else "functions"
            shards = [kb.sweep(slide(), over, out=out, folder=folder, shard=f"{k}/2") for k in (1, 2)]
            self.assertEqual(sorted(v for t in shards for v in t[FRICTION]), [5, 10, 15, 20, 25])
            kb.sweep(slide(), over, out=out, folder=folder).write("merged.csv")
            kb.sweep(slide(), over, out=out).write("whole.csv")
            self.assertEqual((self.folder / "merged.csv").read_text(), (self.folder / "whole.csv").read_text())
        with self.assertRaises(ValueError):
            kb.sweep(slide(), over, out=lambda run: 1, shard="3/2")

    def test_the_table_has_the_bytes_of_the_command(self):
        rows = kb.random({FRICTION: kb.normal(20, 3, low=0, high=45), "steps": kb.choice(20, 40)}, 4, seed=3)
        table = kb.sweep(slide(), rows, out=["displacement", "speed", "state", "point1.dy"], profile="standard")
        table.write("python.csv")
        case = ROOT / "legacy_cases/sliding_block/a30_p20"
        subprocess.run([kb.program(), "sweep", case, "--over", f"{FRICTION}=normal(20,3,0,45)", "--over", "steps=20,40",
                        "--random", "4", "--seed", "3", "--out", "displacement,speed,state,point1.dy", "--profile", "standard",
                        "-o", "command"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.assertEqual((self.folder / "python.csv").read_text(), (self.folder / "command/table.csv").read_text())

    def test_a_sweep_of_the_command_goes_on_here_and_the_reverse(self):
        case, journal = ROOT / "legacy_cases/sliding_block/a30_p20", self.folder / "both/journal.jsonl"

        def command(values):
            subprocess.run([kb.program(), "sweep", case, "--over", f"{FRICTION}={values}", "--profile", "standard",
                            "--resume", "-o", "both"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

        def here(values):
            table = kb.sweep(case, {FRICTION: values}, out="displacement", profile="standard", folder="both")
            table.write("python.csv")
            self.assertEqual((self.folder / "python.csv").read_text(), (self.folder / "both/table.csv").read_text())
        lines = []
        for go_on, values, count in ((command, "10,20", 3), (here, np.array([10.0, 20.0, 25.0]), 4),
                                     (command, "10,20,25,30", 5), (here, [10, 20, 25, 30], 5)):
            go_on(values)
            found = journal.read_text().splitlines()
            self.assertEqual((found[:len(lines)], len(found)), (lines, count))
            lines = found

    def test_dask_gives_the_same_table(self):
        try:
            from distributed import Client
        except ImportError:
            self.skipTest("distributed is not installed")
        over = {FRICTION: [10, 15, 20, 25]}
        outs = ("displacement", lambda run: run.outcome.displacement)
        with Client(n_workers=2, threads_per_worker=1, dashboard_address=None, processes=True) as client:
            for out in outs:
                kb.sweep(slide(), over, out=out, client=client).write("dask.csv")
                kb.sweep(slide(), over, out=out).write("here.csv")
                self.assertEqual((self.folder / "dask.csv").read_text(), (self.folder / "here.csv").read_text())

    def test_joints_are_drawn_for_each_row(self):
        spec = {"slope": {"height": 6, "angle": 60, "toe": 3, "crest": 6, "base": 2}, "fixed": [[-3, -1.9, 12, -1.9]],
                "sets": [{"dip": dip, "spacing": 2, "trace": 100, "scatter": 0.2, "joint": 1} for dip in (35, 118)]}
        case = kb.read(self.write("face.json", {"keyblock": 2, "units": SI, "analysis": {
            "step_count": 2, "time_step": "1 ms", "block_materials": [{"like": "limestone"}],
            "joint_materials": [{"friction_angle_deg": 40}]}}))
        over = {"joints:/seed": [1, 2], "joints:/sets/0/dip": [30, 35]}
        table = kb.sweep(case, over, out="blocks", joints=spec, folder="dict")
        same = kb.sweep(case, over, out="blocks", joints=self.write("joints.json", spec), folder="path")
        self.assertEqual(list(table), list(same))
        self.assertGreater(len(set(table["blocks"])), 1)
        self.assertEqual(table.units["joints:/sets/0/dip"], "deg")
        with self.assertRaisesRegex(ValueError, "joints: expected a case and outputs by name"):
            kb.sweep(case, over, out=lambda run: 1, joints=spec)

    def test_units_of_columns_are_those_of_the_case(self):
        table = kb.sweep(slide().with_value("/units", SI), {FRICTION: [10, 20]}, out=["displacement", "fos"], settings={"steps": 2})
        self.assertEqual(table.units, {FRICTION: "deg", "displacement": "m"})
        self.assertEqual(table.pandas().attrs["units"], table.units)

    def test_a_sweep_without_keys_is_refused(self):
        for over in ({}, [], [{}], {FRICTION: []}):
            with self.assertRaisesRegex(ValueError, "over: expected at least one row with a key"):
                kb.sweep(slide(), over)
        with self.assertRaisesRegex(ValueError, "time_limit: expected at least 1 s"):
            kb.sweep(slide(), {FRICTION: [10]}, time_limit=0.5)
        with self.assertRaisesRegex(ValueError, f"over: expected finite numbers, found nan for {FRICTION}"):
            kb.sweep(slide(), {FRICTION: [10, float("nan")]})

    def test_random_rows_are_stratified_and_depend_on_the_seed_alone(self):
        over = {"a": kb.uniform(2, 4), "b": kb.normal(30, 2), "c": kb.lognormal(5, 1), "d": kb.choice("x", "y"),
                "e": kb.normal(0, 1, low=0), "f": kb.triangular(0, 1, 4)}
        rows = kb.random(over, 200, seed=7)
        self.assertEqual(rows, kb.random(over, 200, seed=7))
        self.assertNotEqual(rows, kb.random(over, 200, seed=8))
        self.assertEqual(sorted(int((r["a"] - 2) * 100) for r in rows), list(range(200)))  # one in each part
        self.assertAlmostEqual(statistics.mean(r["b"] for r in rows), 30, delta=0.02)
        self.assertAlmostEqual(statistics.stdev(r["b"] for r in rows), 2, delta=0.1)
        self.assertAlmostEqual(statistics.mean(r["c"] for r in rows), 5, delta=0.02)
        self.assertAlmostEqual(statistics.stdev(r["c"] for r in rows), 1, delta=0.1)
        self.assertEqual(sum(r["d"] == "x" for r in rows), 100)
        self.assertGreaterEqual(min(r["e"] for r in rows), 0)
        self.assertAlmostEqual(statistics.mean(r["f"] for r in rows), 5 / 3, delta=0.02)

    def test_a_truncated_normal_distribution_is_that_of_the_inverse_within_its_bounds(self):
        law = statistics.NormalDist(20, 3)
        for low, high in ((17, 24), (None, 15), (22, None), (26, 29)):
            below, above = 0 if low is None else law.cdf(low), 1 if high is None else law.cdf(high)
            values = sorted(r["a"] for r in kb.random({"a": kb.normal(20, 3, low, high)}, 400, seed=3))
            self.assertTrue(all((low is None or low <= v) and (high is None or v <= high) for v in values))
            shares = [400 * (law.cdf(v) - below) / (above - below) for v in values]
            self.assertEqual([int(s) for s in shares], list(range(400)))  # one in each part

    def test_numbers_of_distributions_are_checked(self):
        for call in (lambda: kb.normal(20, 0), lambda: kb.normal(20, -1), lambda: kb.normal(20, math.nan),
                     lambda: kb.normal(20, 3, low=30, high=10), lambda: kb.normal(20, 3, low=math.nan, high=10),
                     lambda: kb.lognormal(-1, 1), lambda: kb.lognormal(0, 1), lambda: kb.lognormal(1, 0),
                     lambda: kb.uniform(4, 2), lambda: kb.uniform(2, 2), lambda: kb.uniform(math.nan, 2),
                     lambda: kb.uniform(1, math.inf), lambda: kb.triangular(4, 2, 1), lambda: kb.triangular(1, 1, 1),
                     lambda: kb.triangular(1, math.nan, 2), lambda: kb.normal(math.inf, 1), lambda: kb.choice(),
                     lambda: kb.random({"angle": []}, 3), lambda: kb.random({"a": kb.choice(1)}, -1),
                     lambda: kb.random({"a": kb.choice(1)}, 1, seed=-1), lambda: kb.random({"a": kb.choice(1)}, 1.5)):
            with self.assertRaisesRegex(ValueError, "^(deviation|low|mean|mode|uniform|normal|choice|count|seed|over): expected"):
                call()


if __name__ == "__main__":
    unittest.main()
