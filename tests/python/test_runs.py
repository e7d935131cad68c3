"""Cases, runs and frames in Python.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import ast
import gc
import pickle
import re
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import keyblock as kb  # noqa: E402
from support import CASES, FRICTION, ROOT, Folder, endless, final_bytes, slide, stopped  # noqa: E402


def resident_kib():
    with open("/proc/self/status", encoding="ascii") as file:
        return int(next(line for line in file if line.startswith("VmRSS")).split()[1])


class Cases(Folder):
    def test_a_value_is_read_and_changed_and_the_case_stays(self):
        base = slide()
        other = base.with_value(FRICTION, np.float64(12.5))
        self.assertEqual((base.get(FRICTION), other.get(FRICTION)), (20, 12.5))
        self.assertEqual(base.get("/analysis/joint_materials/*/friction_angle_deg"), [20])
        self.assertEqual(other.with_value("/analysis/joint_materials/*/friction_angle_deg", 3).get(FRICTION), 3)
        self.assertEqual(base.with_value("/analysis/joint_materials/0/cohesion", 5).get("/analysis/joint_materials/0/cohesion"), 5)
        self.assertEqual(pickle.loads(pickle.dumps(other)).json(), other.json())
        self.assertEqual(kb.Plan(other).profile, kb.Plan(base).profile)
        for pointer in ("/analysis/no_such_thing", "no pointer", "/analysis/*/nothing"):
            with self.assertRaises(kb.SettingError):
                base.get(pointer)
        with self.assertRaises(kb.InputError):
            base.with_value(FRICTION, "steep")
        with self.assertRaises(kb.InputError):
            base.with_value("/analysis/no_such_thing", 1)

    def test_a_case_has_a_dialect_and_a_profile(self):
        own = kb.read(kb.new("block", "block.json"))
        self.assertEqual([(c.dialect, c.profile) for c in (slide(), own)], [("ddaml", "legacy"), ("", "standard")])
        self.assertEqual(kb.Plan(slide()).profile, slide().profile)
        self.assertEqual(own.with_value("/analysis/dialect", "shi").dialect, "shi")

    def test_a_list_of_files_is_read_as_the_files(self):
        files = [CASES / "sliding_block" / "a30_p20" / f"a30_p20.{ending}" for ending in ("geo", "ana")]
        self.assertEqual(kb.read(files).files, kb.read(*files).files)

    def test_a_name_stands_for_an_index(self):
        path = self.wall(2, 1).files[0]
        case = kb.read(path)
        self.assertEqual(case.get("/analysis/joint_materials/joint/friction_angle_deg"), 30)
        self.assertEqual(case.with_value("/analysis/joint_materials/joint/friction_angle_deg", "25 deg").get(FRICTION), "25 deg")

    def test_errors_keep_their_place(self):
        path = self.write("bad.json", '{"keyblock": 2,\n "blocks": 7}')
        with self.assertRaises(kb.InputError) as caught:
            kb.read(path)
        self.assertEqual((caught.exception.file, caught.exception.line), (str(path), 2))
        self.assertGreater(caught.exception.column, 0)
        self.assertIn("expected", str(caught.exception))
        self.assertIsInstance(caught.exception, kb.Error)
        with self.assertRaisesRegex(kb.SettingError, 'one of legacy, draft, standard, reference, found "legasy"'):
            kb.Plan(slide(), profile="legasy")
        with self.assertRaises(kb.SettingError):
            kb.Plan(slide(), settings={"no_setting": 1})

    def test_a_case_is_written_and_an_existing_file_is_an_error(self):
        slide().write("slide.json")
        self.assertEqual(kb.read("slide.json").get(FRICTION), 20)
        with self.assertRaises(kb.Error):
            slide().write("slide.json")

    def test_warnings_have_code_and_place(self):
        warnings = kb.Plan(slide()).warnings
        self.assertTrue(all(w.code and w.sentence for w in warnings))
        self.assertTrue(all(f"[{w.code}]" in str(w) for w in warnings))

    def test_settings_are_text_numbers_or_bools(self):
        plan = kb.Plan(self.wall(2, 1), "legacy", {"time_step": "3 ms", "steps": 7, "quirk.stale_contact_list": False})
        self.assertEqual((plan.settings["steps"], plan.settings["quirk.stale_contact_list"]), ("7", "off"))
        self.assertAlmostEqual(float(plan.settings["time_step"]), 0.003)
        self.assertEqual(plan.steps, 7)


class Runs(Folder):
    def test_a_block_slides_as_theory_has_it(self):
        for friction in (0, 10, 20):
            run = kb.Run(slide().with_value(FRICTION, friction), "standard", {"basis": "rigid", "enforcement": "lagrange"})
            outcome = run.go_on()
            self.assertEqual(outcome.end, "finished", outcome.reason)
            slope, phi = np.radians(30), np.radians(friction)
            expected = 0.5 * 9.81 * (np.sin(slope) - np.cos(slope) * np.tan(phi)) * outcome.time ** 2
            self.assertAlmostEqual(np.hypot(*run.frame().displacement[1]) / expected, 1, delta=1e-6)

    def test_iteration_makes_steps_and_a_callback_leaves_the_run_able_to_go_on(self):
        plan = kb.Plan(slide())
        run = kb.Run(plan)
        self.assertEqual([next(run).number for _ in range(3)], [1, 2, 3])
        self.assertEqual(run.go_on(lambda r: r.last.number == 7).end, "running")
        self.assertEqual((run.outcome.steps, run.outcome.time), (7, run.last.time))
        self.assertTrue(np.isnan([run.outcome.displacement, run.outcome.speed]).all(), "known at the end alone")
        self.assertEqual(run.frame().step, 7)
        self.assertEqual(run.go_on().steps, plan.steps)
        self.assertFalse(run.advance())
        self.assertEqual(run.frame().vertices.tobytes(), final_bytes(plan, 1))

    def test_an_error_of_a_callback_passes_through(self):
        run = kb.Run(slide())
        with self.assertRaises(ZeroDivisionError):
            run.go_on(lambda r: 1 / 0)
        self.assertEqual(run.last.number, 1)

    def test_a_time_limit_stops_a_run(self):
        with kb.Context(time_limit=0.3) as context:
            run = kb.Run(endless(), context=context)
            began = time.monotonic()
            self.assertEqual(run.go_on().end, "stopped")
            self.assertLess(time.monotonic() - began, 5)
            self.assertTrue(context.timed_out)
        run = kb.Run(slide())
        run.stop()
        self.assertEqual((run.go_on().end, run.context.timed_out), ("stopped", False))

    def test_a_time_limit_leaves_no_thread(self):
        def watches():
            for _ in range(100):  # a thread ends a moment after its context
                if not (found := [t for t in threading.enumerate() if "_watch" in t.name]):
                    break
                time.sleep(0.01)
            return found
        context = kb.Context(time_limit=1000)
        self.assertEqual(kb.Run(slide(), context=context).go_on().end, "finished")
        self.assertTrue([t for t in threading.enumerate() if "_watch" in t.name])
        del context
        gc.collect()
        self.assertEqual(watches(), [])
        with kb.Context(time_limit=1000, progress=True) as kept:
            pass
        self.assertEqual(watches(), [])
        self.assertFalse(kept.is_stopped)

    def test_a_time_limit_is_a_finite_number(self):
        for wrong in (-1, float("nan"), float("inf")):
            with self.assertRaisesRegex(ValueError, "time_limit: expected"):
                kb.Context(time_limit=wrong)

    def test_threads_beside_a_context_are_refused(self):
        with self.assertRaisesRegex(ValueError, "threads: expected none beside a context"):
            kb.Run(slide(), threads=2, context=kb.Context())

    def test_a_load_is_a_function_of_time(self):
        still, pushed = kb.Run(slide(), "standard"), kb.Run(slide(), "standard", load=lambda t: (0.0, -9.81 * (t < 2)))
        still.go_on(), pushed.go_on()
        self.assertAlmostEqual(pushed.frame().displacement[1, 0] / still.frame().displacement[1, 0], 2, delta=1e-3)
        self.assertGreater(pushed.load_seconds, 0)

    def test_a_load_covers_the_whole_run(self):
        times = []
        run = kb.Run(slide(), settings={"time_step": 1e-4, "steps": 10}, load=lambda t: (0.5, times.append(t) or 0.0))
        outcome = run.go_on()
        self.assertEqual(len(times), 11)
        self.assertAlmostEqual(outcome.time, times[-1], delta=1e-15)
        self.assertNotIn("acceleration_held_after_table", [w.code for w in outcome.warnings])

    def test_a_load_covers_stages_of_other_steps(self):
        stages = [{"steps": 2}, {"steps": 3, "set": {"time_step": "4 ms"}}]
        times = []
        run = kb.Run(self.wall(1, 1).with_value("/stages", stages), load=lambda t: (0.5, times.append(t) or 0.0))
        outcome = run.go_on()
        np.testing.assert_allclose(times, [0, 0.002, 0.004, 0.008, 0.012, 0.016], rtol=1e-12)
        self.assertAlmostEqual(outcome.time, times[-1], delta=1e-12)
        self.assertNotIn("acceleration_held_after_table", [w.code for w in outcome.warnings])

    def test_an_epoch_begins_where_a_stage_excavates(self):
        brick = [[1, 0], [2, 0], [2, 0.5], [1, 0.5]]
        stages = [{"steps": 2}, {"steps": 1, "excavations": [{"outline": brick}]}]
        run = kb.Run(self.wall(2, 1).with_value("/stages", stages))
        frames = [run.frame()]
        while run.advance():
            frames.append(run.frame())
        self.assertEqual([(frame.epoch, len(frame.number)) for frame in frames], [(0, 3)] * 3 + [(1, 2)])
        self.assertEqual(pickle.loads(pickle.dumps(frames[-1])).epoch, 1)

    def test_a_load_is_two_finite_numbers_of_a_case(self):
        for wrong in (3.0, (1.0,), (0.0, float("nan")), None, "ab"):
            with self.assertRaisesRegex(ValueError, r"load: expected an acceleration \(ax, ay\) .* at time 0, found"):
                kb.Run(slide(), settings={"steps": 2}, load=lambda t: wrong)
        with self.assertRaisesRegex(ValueError, "load: expected a case, found a Plan"):
            kb.Run(kb.Plan(slide()), load=lambda t: (0, 0))

    def test_a_load_replaces_no_table_of_accelerations(self):
        shaken = self.wall(1, 1).with_value("/analysis/body_acceleration", [[0, 1, 0], [1, 1, 0]])
        table = Path(tempfile.mkdtemp()) / "shaking.csv"
        table.write_text("time,ax,ay\n0,1,0\n1,1,0\n")
        for case, settings in ((shaken, {}), (slide(), {"body_acceleration_file": table})):
            with self.assertRaisesRegex(ValueError, "load: expected a case without a table of accelerations"):
                kb.Run(case, settings=settings, load=lambda t: (0, 0))

    def test_200_runs_in_one_process_keep_memory_flat(self):
        plan = kb.Plan(slide())

        def some(count):
            for _ in range(count):
                run = kb.Run(plan)
                run.go_on(lambda r: r.last.number == 20)
                run.frame().displacement
        some(50)
        gc.collect()
        before = resident_kib()
        some(200)
        gc.collect()
        growth = resident_kib() - before
        print(f"200 runs: {growth} KiB more", file=sys.stderr)
        self.assertLess(growth, 4096)


class Frames(Folder):
    def test_views_share_memory_and_outlive_the_run(self):
        run = kb.Run(slide())
        run.go_on()
        frame = run.frame()
        self.assertTrue(np.shares_memory(frame.stress, frame.column("blocks", "stress")))
        self.assertFalse(frame.stress.flags.writeable)
        self.assertFalse(frame.stress.flags.owndata)
        stress = frame.stress
        before = stress.copy()
        del run, frame
        gc.collect()
        np.testing.assert_array_equal(stress, before)

    def test_columns_fit_together(self):
        run = kb.Run(slide())
        run.go_on()
        frame = run.frame()
        self.assertEqual(frame.vertices.shape, (frame.loop_corners.sum(), 2))
        self.assertEqual(frame.displacement.shape, (2, 2))
        self.assertEqual(frame.column("cracks", "ends").shape, (0, 4))
        for part in frame.parts():
            for name in frame.names(part):
                self.assertEqual(len(frame.column(part, name)), frame._frame.rows(part), (part, name))
        self.assertEqual([len(b) for b in frame.polygons()], [1, 1])
        self.assertEqual(frame.index_of(2), 1)
        with self.assertRaises(KeyError):
            frame.index_of(3)
        with self.assertRaises(kb.SettingError):
            frame.column("blocks", "colour")

    def test_corners_have_displacement(self):
        run = kb.Run(slide())
        run.go_on()
        frame = run.frame("corners")
        self.assertEqual(frame.column("corners", "displacement").shape, frame.vertices.shape)
        with self.assertRaises(ValueError):
            run.frame("all")

    def test_a_part_is_a_data_frame_with_units(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("pandas is not installed")
        run = kb.Run(self.wall(2, 2))
        run.go_on()
        table = run.frame().part("contacts")
        units = table.attrs["units"]
        self.assertEqual(list(units), list(table.columns))
        self.assertEqual((units["normal_force"], units["place_x"], units["block"]), ("N/m", "m", ""))
        self.assertEqual(run.frame().part("blocks").attrs["units"]["stress_xx"], "Pa")
        self.assertEqual(table.attrs["step"], 3)

    def test_pictures_have_every_block(self):
        run = kb.Run(self.wall(3, 2))
        run.go_on()
        frame = run.frame()
        self.assertEqual(frame._repr_svg_().count("<path"), 7)
        self.assertIn("<title>block 7", frame.svg(frame.stress[:, 1]))
        for colour in ([7.0], np.ones(8), "stress"):
            with self.assertRaisesRegex(ValueError, "colour: expected a number for each of 7 blocks"):
                frame.svg(colour)
        try:
            import matplotlib
        except ImportError:
            self.skipTest("matplotlib is not installed")
        matplotlib.use("agg")
        axes = kb.plot(frame, colour="rotation", cmap="viridis")
        self.assertEqual(len(axes.collections[-1].get_paths()), 7)
        import matplotlib.pyplot as plt
        other = kb.plot(frame)
        self.assertNotEqual(other.figure, axes.figure)
        self.assertIs(kb.plot(frame, ax=axes), axes)
        plt.close("all")

    def test_a_mesh_has_every_block(self):
        try:
            import meshio  # noqa: F401
        except ImportError:
            self.skipTest("meshio is not installed")
        run = kb.Run(kb.new("block", "block.json"))
        mesh = run.frame().to_meshio()
        self.assertEqual([(c.type, len(c.data)) for c in mesh.cells], [("triangle", 1), ("quad", 1)])
        self.assertEqual([list(n) for n in mesh.cell_data["block"]], [[1], [2]])
        mesh.write("block.vtu")

    def test_a_grid_for_pyvista_has_every_block(self):
        """A stand-in of PyVista keeps what it is given; VTK, if it is installed, reads the cells."""
        pyvista = SimpleNamespace(UnstructuredGrid=lambda *given: SimpleNamespace(given=given, cell_data={}))
        run = kb.Run(kb.new("block", "block.json"))
        run.go_on()
        with mock.patch.dict(sys.modules, pyvista=pyvista):
            grid = run.frame().to_pyvista()
        cells, kinds, points = grid.given
        self.assertEqual((list(cells), list(kinds), points.shape), ([3, 0, 1, 2, 4, 3, 4, 5, 6], [7, 7], (7, 3)))
        self.assertEqual(points[:, :2].tolist(), run.frame().vertices.tolist())
        self.assertEqual(list(grid.cell_data), ["block", "material", "displacement", "stress"])
        self.assertEqual(grid.cell_data["displacement"].tolist(), run.frame().displacement.tolist())
        try:
            import vtk
            from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
        except ImportError:
            self.skipTest("VTK is not installed")
        places, polygons, read = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkUnstructuredGrid()
        places.SetData(numpy_to_vtk(points))
        polygons.ImportLegacyFormat(numpy_to_vtkIdTypeArray(cells.astype(np.int64)))
        read.SetPoints(places)
        read.SetCells(int(kinds[0]), polygons)
        self.assertEqual([read.GetCell(i).GetNumberOfPoints() for i in range(read.GetNumberOfCells())], [3, 4])

    def test_a_frame_of_4901_blocks_is_cheap(self):
        run = kb.Run(kb.Plan(self.wall(70, 70), settings={"start": "sudden"}))
        run.frame()
        times = []
        for _ in range(20):
            began = time.process_time()
            run.frame()
            times.append(time.process_time() - began)
        began = time.process_time()
        frame = run.frame()
        made = time.process_time()
        frame.vertices, frame.displacement, frame.stress
        print(f"4,901 blocks: frame {1e3 * min(times):.2f} ms, three views {1e3 * (time.process_time() - made):.3f} ms "
              "of processor time", file=sys.stderr)
        self.assertLess(min(times), 0.01)  # machines of tests are busy

    def test_contacts_are_those_of_their_step_whenever_they_are_asked_for(self):
        plan = kb.Plan(self.wall(4, 3))
        early, late = kb.Run(plan), kb.Run(plan)
        for _ in range(2):
            early.advance()
            late.advance()
        at_once, held = early.frame(), late.frame()
        expected = [at_once.column("contacts", name).tobytes() for name in at_once.names("contacts")]
        late.advance()
        del late
        self.assertEqual([held.column("contacts", name).tobytes() for name in held.names("contacts")], expected)
        self.assertGreater(len(held.contact_gap), 0)

    def test_histories_are_those_of_the_table(self):
        follow = ["top=point:0.5,0.25", "block:2"]
        run = kb.Run(self.wall(2, 2), history=follow)
        run.go_on()
        self.assertEqual(run.histories()[0], "top")
        kb.record(run.plan.case, "out", history=follow, pictures=False)
        table = kb.Results("out").table("histories")
        top = run.history("top")
        kept = table[(table["name"] == "top") & (table["quantity"] == "velocity_y")]
        self.assertEqual(list(top["velocity_y"]), list(kept["value"]))
        self.assertEqual(list(top["time"]), list(kept["time"]))
        self.assertEqual((top.attrs["units"]["velocity_y"], top.attrs["units"]["time"]), ("m/s", "s"))
        with self.assertRaises(kb.SettingError):
            run.history("crest")
        with self.assertRaisesRegex(kb.InputError, 'found "a" for two: block 2 and block 1'):
            kb.Run(self.wall(2, 2), history=["a=block:2", "a=block:1"])
        one = kb.Run(self.wall(2, 2), history="block:2")
        one.go_on()
        self.assertEqual(one.histories(), ["2"])
        self.assertIn("histories", kb.record(one.plan.case, "one", history="block:2", pictures=False).tables())
        twice = kb.Run(self.wall(2, 2), history=["block:2", "block:2"])
        twice.go_on()
        self.assertEqual((twice.histories(), len(twice.history("2")["time"])), (["2"], 4))


class Stubs(unittest.TestCase):
    def test_stubs_name_all_that_the_module_has(self):
        text = (Path(__file__).resolve().parents[2] / "python/keyblock/_keyblock.pyi").read_text(encoding="utf-8")
        tree = ast.parse(text)
        named = {n.name: n for n in tree.body if isinstance(n, (ast.ClassDef, ast.FunctionDef))}
        module = kb._keyblock
        self.assertEqual(set(named), {n for n in dir(module) if not n.startswith("_")})
        for name, node in named.items():
            if isinstance(node, ast.ClassDef) and not issubclass(getattr(module, name), Exception):
                members = {m.name for m in node.body if isinstance(m, ast.FunctionDef)} - {"__init__"}
                self.assertEqual(members, {n for n in vars(getattr(module, name)) if not n.startswith("_")}, name)

    def test_lines_of_the_package_are_short(self):
        for file in (ROOT / "python/keyblock").glob("*.py*"):
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                self.assertLessEqual(len(line), 128, f"{file.name}:{number}")

    def test_all_that_the_package_exports_is_documented(self):
        page = (ROOT / "docs/python.md").read_text(encoding="utf-8")
        for name in kb.__all__:
            exported = getattr(kb, name)
            self.assertTrue(exported.__doc__, name)
            self.assertTrue(re.search(rf"\b{name}\b", page), name)
            for member, value in vars(exported).items() if isinstance(exported, type) else ():
                if not member.startswith("_"):
                    self.assertRegex(value.__doc__ or "", r"\w.*\.", f"{name}.{member}")
        self.assertTrue((Path(kb.__file__).parent / "py.typed").exists())


class Values(Folder):
    def test_what_runs_and_studies_return_passes_through_a_pool(self):
        case = slide()

        def work(_):
            run = kb.Run(case, settings={"steps": 20})
            outcome = run.go_on()
            return (outcome, run.last, run.frame("corners"), kb.factor_of_safety(case, within=0.1),
                    kb.stress_intensity(CASES / "stress_intensity" / "edge_crack_05", settings={"ledger": "off"}))
        with kb.Pool(jobs=1) as pool:
            (outcome, step, frame, strength, tips), = pool.map(work, [1])
        here = work(1)
        for found, other in ((outcome, here[0]), (step, here[1]), (strength.trials[0], here[3].trials[0]),
                             (tips[0], here[4][0]), (tips.warnings[0], here[4].warnings[0])):
            for name in (n for n in vars(type(other)) if not n.startswith("_") and n not in ("asdict", "warnings", "doubts")):
                self.assertEqual(getattr(found, name), getattr(other, name), name)
        self.assertEqual([str(w) for w in outcome.warnings], [str(w) for w in here[0].warnings])
        for found, other in ((frame, here[2]), (strength.falling, here[3].falling), (pickle.loads(pickle.dumps(frame)), frame)):
            self.assertEqual((found.step, found.time, found.units), (other.step, other.time, other.units))
            for part in other.parts():
                self.assertEqual(found.names(part), other.names(part))
                for name in other.names(part):
                    np.testing.assert_array_equal(found.column(part, name), other.column(part, name))
                    self.assertEqual(found.unit(part, name), other.unit(part, name))
        self.assertEqual((repr(frame), frame.svg()), (repr(here[2]), here[2].svg()))
        with self.assertRaises(ValueError):
            frame.displacement[0, 0] = 1
        with self.assertRaises(kb.SettingError):
            frame.column("blocks", "colour")

    def test_parts_without_rows_have_their_columns(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("pandas is not installed")
        kb.new("block", "block.json")
        run = kb.Run("block.json")
        before = run.frame()
        run = kb.Run("block.json", load=lambda t: (0, 30.0))  # the block leaves the slope
        run.go_on()
        contacts = run.frame().part("contacts")
        self.assertEqual((len(contacts), contacts["normal_force"].sum()), (0, 0))
        self.assertEqual(list(contacts), list(before.part("contacts")))
        cracked = kb.Run(CASES / "stress_intensity" / "edge_crack_05")
        cracked.go_on()
        kb.new("tunnel", "tunnel.json")
        frames = [before, cracked.frame("corners"), kb.Run("tunnel.json").frame()]
        names = {part: {} for part in ("contacts", "points", "cracks", "tips")}  # by the presence of rows
        for frame in frames:
            for part, found in names.items():
                found[frame._frame.rows(part) > 0] = frame.names(part)
        for part, found in names.items():
            self.assertEqual(found[False], found[True], part)
            self.assertGreater(len(found[True]), 3, part)

    def test_quantities_of_a_history_have_equal_times(self):
        kb.new("block", "block.json")
        run = kb.Run("block.json", load=lambda t: (0, 30.0), history=["contact:1,2"])  # the block leaves the slope
        run.go_on()
        name, = run.histories()
        for table in (run.history(name), without_pandas(lambda: run.history(name))):
            times, gap = np.asarray(table["time"]), np.asarray(table["least_gap"])
            self.assertEqual((len(times), len(gap), np.isnan(gap[-1])), (101, 101, True))
            self.assertTrue(0 < np.isfinite(gap).sum() < 101)
            self.assertEqual(np.isfinite(np.asarray(table["closed_contacts"])).sum(), 101)


def without_pandas(call):
    with mock.patch.dict("sys.modules", {"pandas": None}):
        return call()


class Studies(unittest.TestCase):
    def test_a_factor_of_safety_has_the_states_on_both_sides(self):
        steep = slide().with_value(FRICTION, 40)
        found = kb.factor_of_safety(steep)
        stands, falls = (np.hypot(*f.displacement[1]) for f in (found.standing, found.falling))
        self.assertLess(stands, 1e-3)
        self.assertGreater(falls, 2 * stands)
        self.assertEqual(kb.factor_of_safety(steep, context=stopped()).standing, None)
        self.assertEqual((found.falling.units, len(found.falling.contact_gap)), (steep.units, 0))

    def test_stress_intensity_is_that_of_the_closed_form(self):
        tip, = kb.stress_intensity(CASES / "stress_intensity" / "edge_crack_05")
        self.assertAlmostEqual(tip.k1, 3.5327, delta=0.001)  # as keyblock sif prints it
        self.assertEqual(tip.asdict()["k1"], tip.k1)

    def test_stress_intensity_passes_its_warnings_on(self):
        case = CASES / "stress_intensity" / "edge_crack_05"
        self.assertEqual(kb.stress_intensity(case).warnings, [])
        found = kb.stress_intensity(case, settings={"ledger": "off"})
        self.assertEqual(([w.code for w in found.warnings], len(found)), (["setting_without_effect"], 1))


if __name__ == "__main__":
    unittest.main()
