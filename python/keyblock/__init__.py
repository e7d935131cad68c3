"""Keyblock in Python: discontinuous deformation analysis (DDA) and the numerical manifold method (NMM).

    import keyblock as kb

    run = kb.Run(kb.read("slope.json"))
    for step in run:                 # Ctrl-C is heard inside steps too
        print(step.number, step.time)
    run.frame().displacement         # NumPy view, one row per block

Numbers of blocks, materials and cracks count from 1, as in case files and tables. Rows of columns count from 0.
Quantities have the units of the case (`Case.units`).

This module wraps the C++ library (`include/keyblock/keyblock.hpp`). Some functions start the program `keyblock`
instead: `sweep` of a case with named results, `compare`, `element`, `fit`, `joints`, `convert` and `new`.
SPDX-License-Identifier: GPL-3.0-or-later
"""
from ._keyblock import Error, InputError, Outcome, SettingError, Step, Stopped, Tip, Trial, Warning
from ._keyblock import version as _version
from ._cases import Case, Context, Plan, read
from ._cite import cite
from ._frames import Frame, plot
from ._pool import Failed, Pool
from ._program import ProgramError, cases, compare, convert, element, fit, joints, new, program
from ._records import Results, record, resume
from ._runs import Run, Strength, Tips, factor_of_safety, stress_intensity
from ._sweeps import Distribution, Table, choice, grid, lognormal, normal, random, sweep, triangular, uniform

__version__ = _version()

__all__ = [
    "Case", "Context", "Distribution", "Error", "Failed", "Frame", "InputError", "Outcome", "Plan", "Pool", "ProgramError",
    "Results", "Run", "SettingError", "Step", "Stopped", "Strength", "Table", "Tip", "Tips", "Trial", "Warning", "cases",
    "choice", "cite", "compare", "convert", "element", "factor_of_safety", "fit", "grid", "joints", "lognormal", "new",
    "normal", "plot", "program", "random", "read", "record", "resume", "stress_intensity", "sweep", "triangular", "uniform",
]
