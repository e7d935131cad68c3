"""Writes the cases of brick_overhang: bricks stacked to nearly the harmonic overhang, and a little beyond.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import Scene, analysis, rectangle, variant, write_case  # noqa: E402

STEP, HEIGHT = 2e-3, 0.25
SOURCE = 'statics: overhang f/2 sum 1/k; stable iff f < 1 (benchmark dda-20)'


def case(count, share):
    scene = Scene()
    table = scene.block(rectangle(-4, -1, 0, 0))
    scene.fixed += [(-3.5, -0.5, table), (-0.5, -0.5, table)]
    front = 0.0
    for level, k in enumerate(range(count, 0, -1)):
        front += share / (2 * k)
        top = scene.block(rectangle(front - 1, level * HEIGHT, front, (level + 1) * HEIGHT))
    if share < 1:
        end = 5.0
        expected = [('dy', top, end, 0, 1e-3, 'asked for: tip drop below 1 mm in 5 s', SOURCE),
                    ('rotation', top, end, 0, 1e-3, 'as the drop', SOURCE),
                    ('travel', top, end, 0, 2e-6, 'it stands', SOURCE)]
    else:
        end = 2.0
        expected = [('dy', top, end, -6.8, 0.65, 'verdict: it has come down, by much more than 1 mm',
                     SOURCE + '; the value is our own result, the weakest kind')]
    write_case(os.path.join(HERE, 'n%d_f%03d' % (count, round(100 * share))), scene,
               analysis(STEP, round(end / STEP), 45, penalty_factor=100), expected,
               '%d bricks that overhang by %g of the harmonic limit (benchmark dda-20)' % (count, share), slow=True,
               variants=[variant('springs of 100 E', enforcement='penalty'), variant('rigid', basis='rigid')])


for bricks in (3, 5, 10):
    case(bricks, 0.97)
    case(bricks, 1.03)
