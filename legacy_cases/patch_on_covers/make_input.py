"""Writes the case of patch_on_covers: a linear field, exact on every mesh (nmm-01).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import case_text, free_mesh, rectangle, write_case  # noqa: E402

corners = rectangle(0, 0, 0.24, 0.12)
points = [(0.01, 0.01), (0.13, 0.07), (0.24, 0.12)]
SOURCE = 'Hooke, plane stress: E 1e6, nu 0.25, strains 1e-3, 1e-3, gamma 1e-3 (patch test of MacNeal and Harder 1985)'


def case(functions, share):
    covers = {'functions': functions, 'mesh': free_mesh(0.04),
              'displacements': [{'along': corners + corners[:1], 'x': '1e-3*(x + y/2)', 'y': '1e-3*(y + x/2)'}]}
    values = []
    for i, (x, y) in enumerate(points):
        for quantity, value in [('point_dx', 1e-3 * (x + y / 2)), ('point_dy', 1e-3 * (y + x / 2)),
                                ('point_sxx', 4000 / 3), ('point_syy', 4000 / 3), ('point_sxy', 400)]:
            size = 3e-4 if quantity.startswith('point_d') else 4000 / 3
            values.append((quantity, i + 1, value, share * size, 'asked for: %g of the largest; the functions hold the field' % share, SOURCE))
    write_case(os.path.join(HERE, functions), case_text(corners, covers, 1e6, 0.25, points), values,
               'patch test on a mesh turned against the body: a linear field, %s functions' % functions)


for name in ('constant', 'derived', 'linear'):
    case(name, 1e-12)
case('quadratic', 1e-11)
