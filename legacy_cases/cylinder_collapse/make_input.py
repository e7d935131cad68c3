"""Writes the cases of cylinder_collapse (pla-07).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import arc, case_text, write_case  # noqa: E402

A, B = 100, 200
inner = arc(A, 90, 0, 48)
corners = arc(B, 0, 90, 48) + inner
SIDE = 9
MESH = {'kind': 'unstructured', 'placement': 'aligned', 'side': SIDE}
SYMMETRY = [{'along': [(A, 0), (B, 0)], 'held': 'normal'}, {'along': [(0, A), (0, B)], 'held': 'normal'}]
HILL = 'Hill 1950; de Souza Neto et al. 2008'


def write(folder, covers, steps, values, about, surface):
    strength = {'surface': 'von_mises', 'yield_stress': 0.24} if surface == 'von_mises' else {'surface': 'tresca', 'cohesion': 0.12}
    text = case_text(corners, covers, 210, 0.3, [(B, 0)], plane_strain=True, steps=(steps, 1), strength=strength)
    write_case(os.path.join(HERE, folder), text, values, about)


for surface, limit in (('von_mises', 0.192090581416), ('tresca', 0.166355323334)):
    covers = {'mesh': MESH, 'displacements': SYMMETRY + [{'along': inner, 'held': 'normal', 'normal': -0.8}]}
    write('limit_' + surface, covers, 16,
          [('reaction_x', 3, limit * A, 0.003 * limit * A, 'asked for: 0.3 %', '%.9g, %s' % (limit, HILL), 16),
           ('yielded_fraction', '', 1, 1e-9, 'all of the rock flows at the limit', HILL, 16)],
          'thick cylinder opened to its limit pressure, ' + surface, surface)
for share, u, c in ((0.14, 0.0872421680105, 120.538801428), (0.18, 0.153301462796, 159.785289360)):
    covers = {'mesh': MESH, 'displacements': SYMMETRY, 'tractions': [{'along': inner, 'pressure': share}]}
    write('pressure_%g' % (1000 * share), covers, 8,
          [('point_dx', 1, u, 0.015 * u, '1.5 %: the formula takes the stress across the plane of an incompressible cylinder', '%.9g, %s' % (u, HILL), 8),
           ('yielded_fraction', '', (c * c - A * A) / (B * B - A * A), 0.4 * SIDE * c / (B * B - A * A), 'the front to a fifth of a side of the mesh',
            'plastic radius c = %.6g of p = 2 sigma_y/sqrt(3) (ln(c/a) + (1 - c^2/b^2)/2), %s' % (c, HILL), 8)],
          'thick cylinder under internal pressure %g, von Mises' % share, 'von_mises')
