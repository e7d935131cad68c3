"""Stops a run by a criterion of its own, and draws a film: one picture per 20 steps.

    python3 examples/python/own_criterion.py [CASE]

The run ends when block 2 has moved by half a length unit, or when the fastest block is slower than the fastest one was 49 steps
before. The script writes block.json and the folder film into the current folder; a notebook writes them into the repository.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys
from pathlib import Path

import keyblock as kb
import numpy as np

case = kb.read(sys.argv[1]) if len(sys.argv) > 1 else kb.read(kb.new("block", "block.json", force=True))
run, film, pictures, speeds = kb.Run(case), Path("film"), [], []
film.mkdir(exist_ok=True)


# %%
def until(r):
    f = r.frame()
    speeds.append(np.hypot(*f.velocity.T).max())
    if f.step % 20 == 0:
        pictures.append(film / f"{f.step:06}.svg")
        pictures[-1].write_text(f.svg(), encoding="utf-8")
    return np.hypot(*f.displacement[f.index_of(2)]) > 0.5 or len(speeds) > 50 and speeds[-1] < speeds[-50]


# %%
run.go_on(until)
print(f"step {run.last.number}, time {run.last.time:.3g}: {len(pictures)} pictures in {film}")
