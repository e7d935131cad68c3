"""Cases that the tests of the Python package share.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import signal
import tempfile
import threading
import unittest
from pathlib import Path

import keyblock as kb

ROOT = Path(__file__).resolve().parent.parent.parent
CASES = ROOT / "legacy_cases"
FRICTION = "/analysis/joint_materials/0/friction_angle_deg"
MATERIALS = {"block_materials": [{"name": "rock", "like": "sandstone"}],
             "joint_materials": [{"name": "joint", "friction_angle_deg": 30}]}
SI = {"length": "m", "mass": "kg", "time": "s"}


def slide():
    return kb.read(CASES / "sliding_block" / "a30_p20")


def endless():
    """A plan of a block at rest, whose run takes minutes."""
    return kb.Plan(slide().with_value(FRICTION, 40), settings={"steps": 10_000_000})


def stopped():
    """A context that stops what runs under it at once."""
    context = kb.Context()
    context.stop()
    return context


def box(left, bottom, right, top):
    return {"material": 1, "outer": [[left, bottom, 1], [right, bottom, 1], [right, top, 1], [left, top, 1]]}


def wall_of(bricks, courses, steps=3):
    """Content of a case file: courses of bricks on a fixed floor; every other course is set off by half a brick."""
    blocks = [box(-1, -1, bricks + 1, 0)]
    for course in range(courses):
        for i in range(bricks):
            left = i + (course % 2) * 0.5
            blocks.append(box(left, 0.5 * course, left + 1, 0.5 * course + 0.5))
    return {"keyblock": 2, "units": SI, "blocks": {"blocks": blocks, "fixed_points": [[-0.5, -0.5, 1], [bricks, -0.5, 1]]},
            "analysis": {"step_count": steps, "time_step": "2 ms", **MATERIALS}}


class Folder(unittest.TestCase):
    """Tests with a folder of their own, which is the current one."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="keyblock_python_")
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        self.folder = Path(folder.name)
        os.chdir(self.folder)

    def write(self, name, content):
        path = self.folder / name
        path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
        return path

    def wall(self, bricks, courses, steps=3):
        return kb.read(self.write("wall.json", wall_of(bricks, courses, steps)))

    def beam(self, side):
        """A clamped NMM beam under its weight: one linear solve."""
        return kb.read(self.write("beam.json", {
            "keyblock": 2, "units": SI,
            "blocks": {"blocks": [box(0, 0, 10, 1)], "measured_points": [[10, 0.5, 1]]},
            "covers": {"functions": "derived", "mesh": {"side": side}, "displacements": [{"along": [[0, 1], [0, 0]]}]},
            "analysis": {"velocity_carry_over": 0, "step_count": 1, "time_step": 1, **MATERIALS}}))


def press_ctrl_c(after):
    """Sends SIGINT to this process after some seconds."""
    timer = threading.Timer(after, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    return timer


def final_bytes(plan, threads):
    run = kb.Run(plan, threads=threads)
    run.go_on()
    return run.frame().vertices.tobytes()
