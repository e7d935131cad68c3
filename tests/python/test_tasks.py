"""Five tasks of a notebook, each in at most as many lines as a reader would expect.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import contextlib
import io
import shutil
import sys
import textwrap
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from support import CASES, ROOT, Folder  # noqa: E402

IMPORTS = "import keyblock as kb, numpy as np, pandas as pd, matplotlib.pyplot as plt\n"

SWEEP = """
    base = kb.read("block.json")
    angle = "/analysis/joint_materials/0/friction_angle_deg"
    def slide(deg: float) -> float:
        run = kb.Run(base.with_value(angle, deg), threads=1)
        run.go_on()
        return float(np.hypot(*run.frame().displacement[1]))
    with kb.Pool(jobs=2, time_limit=60) as pool:
        rows = list(pool.map(slide, range(10, 30, 8)))
    plt.plot(range(10, 30, 8), [np.nan if isinstance(r, kb.Failed) else r for r in rows])
"""
OLD_FILE = """
    old = kb.read("a30_p20.geo", "a30_p20.ana")
    print(*old.warnings, sep="\\n")
    run = kb.Run(old, profile="legacy")
    frames = [run.frame()]
    for step in run:
        if step.number % 50 == 0:
            frames.append(run.frame())
    axes = kb.plot(frames[-1], colour=frames[-1].stress[:, 1])
    print(run.outcome.end, run.outcome.sentences)
"""
SAFETY = """
    slope = kb.read("quarry.dxf", "bench.json", layers="quarry_layers.csv")
    with kb.Context(threads=2, time_limit=120, progress=True) as c:
        s = kb.factor_of_safety(slope, "joints", context=c)
    print(s.stands, s.falls, s.notes)
    axes = kb.plot(s.falling or s.standing)
"""
INTENSITY = """
    table = pd.DataFrame([dict(case=p.stem, **t.asdict())
                          for p in kb.cases("stress_intensity")
                          for t in kb.stress_intensity(kb.read(p))])
    print(table[["case", "x", "y", "k1", "k2", "spread", "doubt"]])
"""
OWN_STOP = """
    run = kb.Run(kb.read("slope.json"), settings={"time_step": "2 ms", "ledger": True})
    def until(r: kb.Run) -> bool:
        moved = r.frame().displacement[r.index_of(12)]
        kinetic = r.history("kinetic")
        return np.hypot(*moved) > 1 or len(kinetic) > 50 and kinetic[-1] > kinetic[-50]
    run.record("out/slope", every=20).go_on(until)
    again = kb.resume("out/slope")
"""


class Tasks(Folder):
    def done(self, task, lines):
        """Runs a task, which may not have more lines than these, and returns its names."""
        text = textwrap.dedent(task).strip()
        self.assertLessEqual(len(text.splitlines()), lines)
        names = {"__name__": "task"}
        with contextlib.redirect_stdout(io.StringIO()):
            exec(IMPORTS + text, names)  # noqa: S102
        names["plt"].close("all")
        return names

    def setUp(self):
        super().setUp()
        try:
            import matplotlib
            import pandas  # noqa: F401
        except ImportError as missing:
            self.skipTest(str(missing))
        matplotlib.use("Agg")

    def test_a_sweep_in_child_processes(self):
        import keyblock as kb
        kb.new("block", "block.json")
        rows = self.done(SWEEP, 9)["rows"]
        self.assertEqual(len(rows), 3)
        self.assertGreater(rows[0], rows[1])  # less friction, a longer way

    def test_an_old_file_read_and_drawn(self):
        for ending in ("geo", "ana"):
            shutil.copy(CASES / f"sliding_block/a30_p20/a30_p20.{ending}", ".")
        names = self.done(OLD_FILE, 9)
        self.assertEqual(names["run"].outcome.end, "finished")
        self.assertGreater(len(names["frames"]), 2)

    def test_the_factor_of_safety_of_a_drawing(self):
        for name in ("quarry.dxf", "bench.json", "quarry_layers.csv"):
            shutil.copy(ROOT / "docs" / name, ".")
        found = self.done(SAFETY, 5)["s"]
        self.assertLess(found.stands, found.falls)
        self.assertLess(found.falls, 1.01 * found.stands + 0.01)

    def test_a_table_of_stress_intensity(self):
        for case in ("centre_crack", "edge_crack_05"):
            shutil.copytree(CASES / "stress_intensity" / case, Path("stress_intensity") / case)
        table = self.done(INTENSITY, 4)["table"]
        self.assertEqual(sorted(set(table["case"])), ["centre_crack", "edge_crack_05"])
        self.assertTrue((table["k1"] > 0).all())

    def test_an_own_criterion_and_a_run_that_goes_on(self):
        import keyblock as kb
        kb.new("slope", "slope.json")
        again = self.done(OWN_STOP, 7)["again"]
        self.assertEqual(again.end, "finished")
        self.assertTrue(Path("out/slope/run.json").exists())


if __name__ == "__main__":
    unittest.main()
