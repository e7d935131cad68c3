"""Convergence of the tip displacement of Cook's membrane (1974) with the number of unknowns.

    python3 examples/figures/cook_membrane.py [FINEST_HALVINGS]

Figure: displacement of the middle of the right edge over unknowns, for three kinds of cover functions. Finite elements are
compared in this figure since Cook (1974); the limit is 23.966 (legacy_cases/cook_membrane).

- R. D. Cook: Improved two-dimensional finite element. J. Struct. Div. ASCE 100 (1974).
- J. C. Simo, M. S. Rifai: A class of mixed assumed strain methods. Int. J. Numer. Methods Eng. 29 (1990).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import sys

import keyblock as kb
import matplotlib.pyplot as plt

LIMIT = 23.966
COARSEST = {"constant": 8, "derived": 8, "quadratic": 16}  # side of the mesh, of a membrane of 48 by 60
case = kb.read("legacy_cases/cook_membrane/coarse")
halvings = int(sys.argv[1]) if len(sys.argv) > 1 else 2

figure, axes = plt.subplots(figsize=(7, 4))
for functions, side in COARSEST.items():
    sides = [side / 2**i for i in range(halvings + 1)]
    table = kb.sweep(case, {"functions": [functions], "mesh.side": sides}, out=["point1.dy", "/counts/unknowns"])
    unknowns, tip = table["/counts/unknowns"], table["point1.dy"]
    axes.semilogx(unknowns, tip, "o-", label=functions)
    print(functions, *(f"{n:g}: {100 * (u / LIMIT - 1):+.2f} %" for n, u in zip(unknowns, tip)), sep="  ")
axes.axhline(LIMIT, color="k", linewidth=0.8, label="limit")
axes.set(xlabel="unknowns", ylabel="displacement at (48, 52)", title="Cook's membrane")
axes.legend()
figure.savefig("cook_membrane.svg")
