"""Writes the cases of thick_cylinder: Lame's ring (nmm-07), and the same almost incompressible (nmm-11).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import arc, case_text, free_mesh, write_case  # noqa: E402

outer, inner = arc(2, 0, 90), arc(1, 90, 0)
DIAGONAL = math.sqrt(0.5)
SOURCE = 'Lame: u = (1 + nu)/E A ((1 - 2 nu) r + b^2/r), hoop stress A (1 + b^2/r^2), A = 1/3'


def u(r, nu):
    return (1 + nu) / 1000 / 3 * ((1 - 2 * nu) * r + 4 / r)


def case(folder, nu, about, functions, side, tolerance, reason, variants, hoop=None, slow=False):
    covers = {'functions': functions, 'mesh': free_mesh(side),
              'displacements': [{'along': [(1, 0), (2, 0)], 'held': 'normal'}, {'along': [(0, 2), (0, 1)], 'held': 'normal'}],
              'tractions': [{'along': inner, 'pressure': 1}]}
    points = [(DIAGONAL, DIAGONAL), (0, 1.5)]
    text = case_text(outer + inner, covers, 1000, nu, points, plane_strain=True)
    values = [('point_dx', 1, DIAGONAL * u(1, nu), tolerance * u(1, nu), reason, SOURCE),
              ('point_dy', 2, u(1.5, nu), tolerance * u(1, nu), reason, SOURCE)]
    if hoop:
        # Nothing widens across the plane, and sxx + syy = 2/3 wherever one looks.
        values.append(('point_szz', 2, nu * 2 / 3, 0.02 * nu * 2 / 3, 'asked for: 2 % of the stress in the middle of the wall', 'plane strain: szz = nu (sxx + syy), Timoshenko and Goodier ch. 2'))
        values.append(('point_sxx', 2, (1 + 4 / 2.25) / 3, hoop, 'asked for: 2 % of the stress in the middle of the wall', SOURCE))
    write_case(os.path.join(HERE, folder), text, values, about, variants, slow)


FINE = 'asked for: 0.1 %'
share = u(1, 0.3) / 100
case('lame', 0.3, 'thick cylinder under inner pressure, every basis', 'derived', 0.125, 1e-3, FINE, [], hoop=0.02)
case('every_basis', 0.3, 'thick cylinder: displacement, every basis', 'derived', 0.0625, 1e-3, FINE,
     [('constant, side 0.035', {'functions': 'constant', 'mesh.side': 0.035}, 0.1 * share, FINE),
      ('linear, side 0.25', {'functions': 'linear', 'mesh.side': 0.25}, 0.1 * share, FINE),
      ('quadratic, side 0.25', {'functions': 'quadratic', 'mesh.side': 0.25}, 0.1 * share, FINE)])
case('nearly_incompressible', 0.499, 'thick cylinder, nu 0.499: displacement does not lock', 'quadratic', 0.25, 0.05, 'asked for: 5 %',
     [('linear, side 0.125', {'functions': 'linear', 'mesh.side': 0.125}, 5 * u(1, 0.499) / 100, 'asked for: 5 %'),
      ('derived, side 0.125', {'functions': 'derived', 'mesh.side': 0.125}, 5 * u(1, 0.499) / 100, 'asked for: 5 %')])
