"""Writes the cases of two_body_impact: two squares meet face to face in free space.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import Scene, analysis, material, rectangle, variant, write_case  # noqa: E402

GAP = 0.0123
SOURCE = "closed form: v1' = (P - m2 e (v1 - v2))/M, v2' = (P + m1 e (v1 - v2))/M (benchmark dda-13)"


def case(name, m1, m2, v1, v2, e):
    scene = Scene()
    scene.block(rectangle(0, 0, 1, 1), material=1)
    scene.block(rectangle(1 + GAP, 0, 2 + GAP, 1), material=2)
    momentum, size, mass = m1 * v1 + m2 * v2, m1 * abs(v1) + m2 * abs(v2), m1 + m2
    after = ((1, m1, (momentum - m2 * e * (v1 - v2)) / mass), (2, m2, (momentum + m1 * e * (v1 - v2)) / mass))
    expected = []
    for t in (0.1, 0.5):
        for block, m, v in after:
            expected += [('vx', block, t, v, 1e-10 * size / m, 'asked for: 1e-10 of the momentum', SOURCE),
                         ('vy', block, t, 0, 1e-10, 'rounding only', 'nothing acts across'),
                         ('rotation', block, t, 0, 1e-10, 'rounding only', 'a face to face impact turns nothing')]
    write_case(os.path.join(HERE, name), scene,
               analysis(1e-3, 500, 30, [material(m1, (v1, 0, 0)), material(m2, (v2, 0, 0))], gravity=0.0, displacement_ratio=0.1),
               expected, 'two squares meet face to face in free space: masses %g and %g kg, speeds %g and %g m/s, restitution %g '
               '(benchmark dda-13)' % (m1, m2, v1, v2, e), set={'standard': {'restitution': '%g' % e}},
               variants=[variant('10 ms', time_step=0.01, steps=50), variant('rigid', basis='rigid'),
                         variant('springs of 10 E', enforcement='penalty')])


case('row_1', 2500, 2500, 1, 0, 1)
case('row_2', 2500, 5000, 2, -1, 1)
case('row_3', 2500, 2.5e9, 1, 0, 1)
case('row_4', 2500, 5000, 2, -1, 0)
