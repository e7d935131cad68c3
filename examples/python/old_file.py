"""Reads an old file of Shi's format, runs it by Shi's rules, and draws the end.

    python3 examples/python/old_file.py [FILE…]

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import keyblock as kb

folder = "legacy_cases/sliding_block/a30_p20/"
old = kb.read(*sys.argv[1:] or [folder + "a30_p20.geo", folder + "a30_p20.ana"])
print(*old.warnings, sep="\n")
# %%
run = kb.Run(old, profile="legacy")
frames = [run.frame()] + [run.frame() for step in run if step.number % 50 == 0]  # Ctrl-C takes effect inside steps
# %%
kb.plot(frames[-1], colour=frames[-1].stress[:, 1], label="vertical stress").figure.savefig("old_file.svg")
print(run.outcome.end, *run.outcome.sentences, sep="\n")
