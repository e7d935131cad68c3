"""Writes the cases of plate_with_hole: Kirsch's stress at the edge of a hole (nmm-08).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import arc, case_text, free_mesh, write_case  # noqa: E402

hole = arc(1, 90, 0)
corners = [(5, 0), (5, 5), (0, 5)] + hole
# Kirsch's stresses, tension 1 along x: with q = 1/r^2 and c = cos 2t = (x^2 - y^2) q, s = sin 2t = 2 x y q.
Q, C, S = '(1/(x^2+y^2))', '((x^2-y^2)/(x^2+y^2))', '(2*x*y/(x^2+y^2))'
C4, S4 = '(%s^2-%s^2)' % (C, S), '(2*%s*%s)' % (S, C)
XX = '(1 - %s*(1.5*%s + %s) + 1.5*%s^2*%s)' % (Q, C, C4, Q, C4)
YY = '(-%s*(0.5*%s - %s) - 1.5*%s^2*%s)' % (Q, C, C4, Q, C4)
XY = '(-%s*(0.5*%s + %s) + 1.5*%s^2*%s)' % (Q, S, S4, Q, S4)
TRACTION = {'x': '%s*nx + %s*ny' % (XX, XY), 'y': '%s*nx + %s*ny' % (XY, YY)}
SOURCE = 'Kirsch 1898: hoop stress 3 at the end of the hole\'s diameter across the tension'


def case(folder, functions, mesh, about, tolerance, reason, variants=(), slow=False):
    covers = {'functions': functions, 'mesh': mesh,
              'displacements': [{'along': [(1, 0), (5, 0)], 'held': 'normal'}, {'along': [(0, 5), (0, 1)], 'held': 'normal'}],
              'tractions': [{'along': [(5, 0), (5, 5), (0, 5)], **TRACTION}]}
    text = case_text(corners, covers, 1, 0.3, [(0, 1)])
    write_case(os.path.join(HERE, folder), text, [('point_sxx', 1, 3, tolerance, reason, SOURCE)], about, variants, slow)


FINE = 'asked for: 0.3 %'
refined = {'kind': 'unstructured', 'side': 1, 'refined': [[0, 1, 0.05], [1, 0, 0.15], [0.7071, 0.7071, 0.15]], 'placement': 'free'}
case('refined', 'quadratic', refined, 'plate with a hole: unstructured mesh, refined where the stress is read', 0.009, FINE)
case('regular', 'quadratic', free_mesh(0.125), 'plate with a hole: regular mesh, 8 triangles along the radius', 0.009, FINE,
     [('linear, side 0.0625', {'functions': 'linear', 'mesh.side': 0.0625}, 0.009, FINE),
      ('derived, side 0.0625', {'functions': 'derived', 'mesh.side': 0.0625}, 0.06, 'raw stress at a point of the boundary, second order, no recovery: 2 %'),
      ('constant, side 0.0625', {'functions': 'constant', 'mesh.side': 0.0625}, 0.15, 'raw stress of first order converges unevenly: 5 %')], slow=True)
