"""Ctrl-C while the library computes.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import itertools
import json
import sys
import threading
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import keyblock as kb  # noqa: E402
from support import FRICTION, ROOT, Folder, endless, press_ctrl_c, slide, wall_of  # noqa: E402

AFTER = 0.5  # seconds
AT_MOST = 1.0  # seconds from the signal to the exception, which the page promises


class Interrupts(Folder):
    def tearDown(self):
        while kb._keyblock.left_behind():  # a process that ends before them ends with 130
            time.sleep(0.1)

    def interrupted(self, work):
        """Seconds from the signal to KeyboardInterrupt."""
        timer = press_ctrl_c(AFTER)
        began = time.monotonic()
        try:
            work()
        except KeyboardInterrupt:
            return time.monotonic() - began - AFTER
        finally:
            timer.join()
        self.fail("no KeyboardInterrupt")

    def heard(self, name, work):
        seconds = self.interrupted(work)
        print(f"{name}: heard after {seconds:.2f} s", file=sys.stderr)
        self.assertLess(seconds, AT_MOST)

    def test_small_steps_in_a_loop(self):
        run = kb.Run(endless())
        self.heard("loop", lambda: [None for _ in run])
        self.assertLess(run.last.number, 10_000_000)

    def test_a_large_step_of_few_unknowns(self):
        case = self.wall(18, 18).with_value("/analysis/velocity_carry_over", 0)  # 1,944 unknowns, and a step of many seconds
        for name, steps in (("static step in a loop", lambda run: [None for _ in run]), ("static step", kb.Run.advance)):
            run = kb.Run(case)
            self.heard(name, lambda: steps(run))

    def test_reading_and_changing_a_large_case(self):
        text = json.dumps(wall_of(100, 100))
        case = kb.read(self.write("wall.json", text))
        for name, change in (("with_value", lambda: case.with_value(FRICTION, 21)), ("get", lambda: case.get(FRICTION))):
            self.heard(name, lambda: [change() for _ in itertools.repeat(0)])
            longest = self.longest_pause_beside(change)
            self.assertLess(longest, 0.3, name)

    def longest_pause_beside(self, work):
        """Longest time that another thread of Python stands still."""
        pauses, is_done = [], threading.Event()

        def tick():
            last = time.monotonic()
            while not is_done.wait(0.01):
                pauses.append(time.monotonic() - last)
                last = time.monotonic()
        thread = threading.Thread(target=tick)
        thread.start()
        work()
        is_done.set()
        thread.join()
        return max(pauses)

    def test_small_steps_to_the_end(self):
        run = kb.Run(endless())
        self.heard("go_on", run.go_on)
        self.assertEqual(run.go_on().end, "stopped")
        self.assertEqual(kb.Run(slide()).go_on().end, "finished")  # other runs go on

    def test_looks_at_a_run_of_another_thread(self):
        run = kb.Run(endless())
        thread = threading.Thread(target=run.go_on)
        thread.start()
        for name, look in (("outcome", lambda: run.outcome), ("frame", run.frame), ("repr", lambda: repr(run))):
            began = time.monotonic()
            look()  # waits for a step, not for the run
            self.assertLess(time.monotonic() - began, AT_MOST)
            self.heard(f"looks at {name}", lambda: [look() for _ in itertools.repeat(0)])
        self.assertTrue(thread.is_alive())  # the other thread goes on
        run.stop()
        thread.join()
        self.assertEqual(run.outcome.end, "stopped")

    def test_steps_of_4901_blocks(self):
        run = kb.Run(kb.Plan(self.wall(70, 70, 1000), settings={"start": "sudden"}))
        self.heard("large step", lambda: [None for _ in run])

    def test_the_initial_state(self):
        plan = kb.Plan(self.wall(70, 70))
        self.heard("initial state", lambda: kb.Run(plan))

    def test_a_factor_of_safety(self):
        case = self.wall(30, 30)
        self.heard("factor of safety", lambda: kb.factor_of_safety(case))

    def test_a_recorded_run_which_is_resumed(self):
        kb.new("slope", "slope.json")
        self.heard("record", lambda: kb.record("slope.json", "out", settings={"steps": 20000}))
        steps = []

        def some(step):
            steps.append(step.number)
            if len(steps) == 3:
                raise ZeroDivisionError
        with self.assertRaises(ZeroDivisionError):
            kb.resume("out", on_step=some)
        self.assertGreater(steps[0], 1)

    def test_cutting(self):
        spec = {"slope": {"height": 40, "angle": 60, "toe": 20, "crest": 40, "base": 10}, "seed": 2,
                "sets": [{"dip": 35, "spacing": 0.3, "trace": 500, "scatter": 0.1},
                         {"dip": 118, "spacing": 0.3, "trace": 500, "scatter": 0.1}],
                "fixed": [[-20, -9.9, 80, -9.9]]}
        drawing = kb.joints(spec, "fine.json")
        case = kb.read(drawing, ROOT / "docs/bench.json")

        def cut():
            while True:  # a fast machine cuts it within the time before the signal
                kb.Plan(case)
        self.heard("cutting", cut)

    def test_a_linear_solve(self):
        case = self.beam("0.015 m")  # 106,000 unknowns

        def solve():
            while True:
                kb.Run(kb.Plan(case)).go_on()
        self.heard("linear solve", solve)


if __name__ == "__main__":
    unittest.main()
