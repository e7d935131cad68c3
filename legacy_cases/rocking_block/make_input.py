"""Writes the cases of rocking_block: a block released at a tilt rocks over to its other corner.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import Scene, analysis, leaning, rectangle, rk4, swing, until, variant, write_case  # noqa: E402

STEP = 0.002  # of the coarser run; times are multiples of it
SOURCE = ("Housner 1963: theta'' = -p^2 sin(alpha - theta), p^2 = 3g/(4R), fourth-order Runge-Kutta; angular velocity times "
          '1 - 1.5 sin(alpha)^2 at the impact (benchmark dda-16)')
QUARTER = 'asked for: quarter period within 1 %'
REBOUND = 'angular velocity after the impact within 1 %; the benchmark asks for 10 %'


def case(name, b, h, tilt):
    p2, alpha = swing(b, h)

    def rate(_, y):
        return [y[1], -p2 * math.sin(alpha - y[0])]

    quarter, state = until(rate, [tilt, 0.0], lambda y: y[0])
    before = -state[1]
    after = (1 - 1.5 * math.sin(alpha) ** 2) * before
    back, _ = until(rate, [0.0, after], lambda y: y[1])

    def rounded(t):
        return round(t / STEP) * STEP

    half, full = rounded(quarter / 2), rounded(quarter)
    expected = [('rotation', 2, half, tilt - rk4(rate, [tilt, 0.0], 0, half, 2000)[0], 0.005 * quarter * before, QUARTER, SOURCE)]
    turned = (tilt - rk4(rate, [tilt, 0.0], 0, full, 2000)[0] if full <= quarter
              else tilt + rk4(rate, [0.0, after], 0, full - quarter, 2000)[0])
    expected.append(('rotation', 2, full, turned, 0.01 * quarter * before, QUARTER, SOURCE))
    for share in (0.5, 1.0):
        t = rounded(quarter + share * back)
        theta, speed = rk4(rate, [0.0, after], 0, t - quarter, 2000)
        more = rk4(rate, [0.0, 1.01 * after], 0, t - quarter, 2000)[0]
        expected.append(('rotation', 2, t, tilt + theta, min(more - theta, 0.009 * (tilt + theta)), REBOUND, SOURCE))
        if share < 1:
            expected.append(('spin', 2, t, speed, 0.009 * speed, REBOUND, SOURCE))
    scene = Scene()
    floor = scene.block(rectangle(-5, -1, 5, 0))
    scene.fixed += [(-4, -0.5, floor), (4, -0.5, floor)]
    scene.block(leaning(b, h, tilt))
    steps = math.ceil((quarter + back) / STEP)
    write_case(os.path.join(HERE, name), scene, analysis(STEP / 2, 2 * steps, 50), expected,
               'a block %g m x %g m rocks from a tilt of %g rad (benchmark dda-16)' % (b, h, tilt),
               variants=[variant('2 ms', time_step=STEP, steps=steps), variant('rigid', basis='rigid')])


case('row_1', 0.5, 2.0, 0.05)
case('row_2', 1.0, 4.0, 0.1)
case('row_3', 0.2, 0.6, 0.1)
