"""Writes the cases of falling_column: columns released beyond their balance.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import Scene, analysis, leaning, rectangle, rk4, swing, until, variant, write_case  # noqa: E402

STEP = 0.005  # of the coarser run; times are multiples of it


def case(name, b, h, tilt):
    p2, alpha = swing(b, h)

    def rate(_, y):
        return [y[1], -p2 * math.sin(alpha - y[0])]

    end, (_, last) = until(rate, [tilt, 0.0], lambda y: y[0] - math.pi / 2)
    source = ("theta'' = -p^2 sin(alpha - theta), p^2 = 3g/(4R), fourth-order Runge-Kutta: 90 degrees at %.5f s, %.5f rad/s "
              '(benchmark dda-18 A)' % (end, last))
    expected = []
    for share in (0.5, 0.75, 0.98, 0.995):
        t = round(share * end / STEP) * STEP
        theta, spin = rk4(rate, [tilt, 0.0], 0, t, 4000)
        expected += [('rotation', 2, t, tilt - theta, 0.01 * t * spin, 'asked for: 1 % in time', source),
                     ('spin', 2, t, -spin, 0.01 * spin, 'asked for: 1 %', source)]
    scene = Scene()
    floor = scene.block(rectangle(-5, -1, 15, 0))
    scene.fixed += [(-4, -0.5, floor), (14, -0.5, floor)]
    scene.block(leaning(b, h, tilt))
    steps = math.ceil(end / STEP)
    write_case(os.path.join(HERE, name), scene, analysis(1e-3, 5 * steps, 89), expected,
               'a column %g m x %g m released beyond its balance falls (benchmark dda-18 A)' % (b, h),
               variants=[variant('5 ms', time_step=STEP, steps=steps), variant('rigid', basis='rigid')])


case('row_1', 0.5, 2.0, 0.3)
case('row_2', 1.0, 10.0, 0.15)
