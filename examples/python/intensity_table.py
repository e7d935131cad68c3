"""Table of the stress intensity factors of verification cases.

    python3 examples/python/intensity_table.py [NUMBER_OF_CASES]

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import keyblock as kb
import pandas as pd

# %%
cases = kb.cases("stress_intensity")[:int(sys.argv[1]) if len(sys.argv) > 1 else None]
table = pd.DataFrame([dict(case=p.name, **t.asdict()) for p in cases for t in kb.stress_intensity(p)])
print(table[["case", "x", "y", "k1", "k2", "spread", "doubt"]].to_string())
