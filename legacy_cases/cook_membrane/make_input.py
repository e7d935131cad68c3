"""Writes the cases of cook_membrane (nmm-09).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import case_text, free_mesh, write_case  # noqa: E402

corners = [(0, 0), (48, 44), (48, 60), (0, 44)]
SOURCE = '23.966: limit of three orders of covers and of quadrilaterals of second order to 64 x 64 (23.9628); Cook 1974, Simo and Rifai 1990'


def case(folder, side, about, tolerance, variants, slow=False):
    covers = {'functions': 'derived', 'mesh': free_mesh(side), 'displacements': [{'along': [(0, 44), (0, 0)]}],
              'tractions': [{'along': [(48, 44), (48, 60)], 'y': '1/16'}]}
    text = case_text(corners, covers, 1, 1 / 3, [(48, 52)])
    values = [('point_dy', 1, 23.966, tolerance * 23.966, 'asked for: %g %%' % (100 * tolerance), SOURCE)]
    write_case(os.path.join(HERE, folder), text, values, about, variants, slow)


share = 23.966 / 100
case('coarse', 1.85, 'Cook\'s membrane, every basis at a few thousand unknowns', 1e-3,
     [('constant, side 1', {'functions': 'constant', 'mesh.side': 1}, 0.5 * share, 'first order: 0.1 % takes 14,500 unknowns (case fine), here are 3,700'),
      ('linear, side 2.7', {'functions': 'linear', 'mesh.side': 2.7}, 0.1 * share, 'asked for: 0.1 %'),
      ('quadratic, side 3.9', {'functions': 'quadratic', 'mesh.side': 3.9}, 0.1 * share, 'asked for: 0.1 %')])
case('fine', 0.5, 'Cook\'s membrane, finest meshes', 3e-4,
     [('constant, side 0.45', {'functions': 'constant', 'mesh.side': 0.45}, 0.1 * share, 'asked for: 0.1 %'),
      ('linear, side 1', {'functions': 'linear', 'mesh.side': 1}, 0.03 * share, 'a mesh of half the side leaves half the error: 0.02 %'),
      ('quadratic, side 2', {'functions': 'quadratic', 'mesh.side': 2}, 0.03 * share, 'the same')], slow=True)
