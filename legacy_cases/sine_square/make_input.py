"""Writes the case of sine_square: a field made up with its body force (nmm-10).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import case_text, free_mesh, rectangle, write_case  # noqa: E402

corners = rectangle(0, 0, 1, 1)
S, C = 'sin(_pi*x)*sin(_pi*y)', 'cos(_pi*x)*cos(_pi*y)'
MU, LAMBDA = 1 / 2.6, 0.3 / (1.3 * 0.4)
force = '_pi^2*(%r*%s + %r*(%s - %s))' % (2 * MU, S, LAMBDA + MU, S, C)
covers = {'functions': 'derived', 'mesh': free_mesh(1 / 32),
          'displacements': [{'along': corners + corners[:1], 'x': S, 'y': S}], 'body_force': {'x': force, 'y': force}}
points = [(0.5, 0.5), (0.25, 0.25), (0.7, 0.5)]
import math  # noqa: E402
source = 'made up: both components sin(pi x) sin(pi y), the body force that belongs to it; E 1, nu 0.3, plane strain'
values = [('point_dx', i + 1, math.sin(math.pi * x) * math.sin(math.pi * y), 1e-4,
           'second order: the mean error is 1e-5 on a mesh of 1/32, at a point up to ten times that', source) for i, (x, y) in enumerate(points)]
text = case_text(corners, covers, 1, 0.3, points, plane_strain=True)
write_case(os.path.join(HERE, 'derived'), text, values, 'a field made up with its body force, every basis',
           [('constant, 1/64', {'functions': 'constant', 'mesh.side': 1 / 64}, 2e-3, 'first order: the mean error is 4e-4 on a mesh of 1/64'),
            ('linear, 1/16', {'functions': 'linear', 'mesh.side': 1 / 16}, 5e-4, 'second order: the mean error is 8e-5 on a mesh of 1/16'),
            ('quadratic, 1/16', {'functions': 'quadratic', 'mesh.side': 1 / 16}, 3e-5, 'third order: the mean error is 5e-6 on a mesh of 1/16')])
