"""Runs in several threads of one process: each gives the bytes of one alone.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys
import threading
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import keyblock as kb  # noqa: E402
from support import Folder, endless, final_bytes, slide  # noqa: E402


class Threads(Folder):
    def test_runs_on_several_threads_give_the_bytes_of_one_alone(self):
        plan = kb.Plan(self.wall(30, 25), settings={"start": "sudden"})
        self.assertGreater(plan.blocks, 700)
        alone = final_bytes(plan, 1)
        found = {}
        threads = [threading.Thread(target=lambda n=n: found.update({n: final_bytes(plan, n)})) for n in (1, 2, 3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([found[n] == alone for n in (1, 2, 3)], [True] * 3)

    def test_a_second_thread_may_not_step_the_run(self):
        run = kb.Run(endless())
        thread = threading.Thread(target=run.go_on)
        thread.start()
        while not run.last.number:
            time.sleep(0.01)
        for step in (run.advance, run.go_on, lambda: next(run), lambda: run.go_on(lambda r: True)):
            with self.assertRaisesRegex(kb.Error, "another thread steps this run"):
                step()
        run.stop()
        thread.join()
        self.assertFalse(run.advance())

    def test_stop_of_one_run_leaves_the_other(self):
        plan = kb.Plan(slide())
        first, second = kb.Run(plan), kb.Run(plan)
        next(first), next(second)
        first.stop()
        self.assertEqual(first.go_on().end, "stopped")
        self.assertEqual(second.go_on().end, "finished")

    def test_one_of_three_runs_at_once_is_stopped_and_the_others_stay_whole(self):
        plan = kb.Plan(slide(), settings={"steps": 1500})
        alone = final_bytes(plan, 1)
        runs = [kb.Run(plan, threads=1), kb.Run(endless(), threads=2), kb.Run(plan, threads=3)]
        started = threading.Barrier(4)
        ends = {}

        def work(run):
            next(run)
            started.wait()  # all three are at work
            ends[run] = run.go_on().end
        threads = [threading.Thread(target=work, args=(run,)) for run in runs]
        for thread in threads:
            thread.start()
        started.wait()
        runs[1].stop()
        for thread in threads:
            thread.join()
        self.assertEqual([ends[run] for run in runs], ["finished", "stopped", "finished"])
        self.assertEqual([run.frame().vertices.tobytes() == alone for run in (runs[0], runs[2])], [True, True])

    def test_three_recorded_runs_at_once_leave_the_files_of_one_alone(self):
        plan = kb.Plan(slide(), settings={"steps": 200})

        def work(folder, until=None):
            kb.Run(plan).record(folder, pictures=False).go_on(until)
        work("alone")
        threads = [threading.Thread(target=work, args=arguments) for arguments in
                   (("first",), ("stopped", lambda r: r.last.number == 50), ("third",))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        files = {f: {p.relative_to(f): p.read_bytes() for p in Path(f).rglob("*") if p.is_file() and p.name != "run.json"}
                 for f in ("alone", "first", "third")}
        self.assertGreater(len(files["alone"]), 5)
        self.assertEqual([files[f] == files["alone"] for f in ("first", "third")], [True, True])
        self.assertEqual([kb.Results(f).run["outcome"]["steps"] for f in ("first", "stopped", "third")], [200, 50, 200])


if __name__ == "__main__":
    unittest.main()
