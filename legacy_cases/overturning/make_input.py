"""Writes the cases of overturning: a block on a floor under a constant horizontal acceleration.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import G, SlopeScene, analysis, rk4, swing, until, variant, write_case  # noqa: E402

B, H = 0.5, 2.0
P2, ALPHA = swing(B, H)
UPLIFT = G * B / H


def rate_under(acceleration):
    return lambda t, y: [y[1], -P2 * (math.sin(ALPHA - y[0]) - acceleration / G * math.cos(ALPHA - y[0]))]


def case(name, acceleration, end, expected, about):
    scene = SlopeScene(0)
    scene.on_slope(6, 0, 6 + B, H)
    write_case(os.path.join(HERE, name), scene, analysis(1e-3, round(1000 * end), 60), expected, about,
               set={'both': {'body_acceleration.x': '%.9g' % acceleration}},
               variants=[variant('10 ms', time_step=0.01, steps=round(100 * end)), variant('rigid', basis='rigid')])


def falling(name, acceleration):
    rate = rate_under(acceleration)
    balance = until(rate, [0.0, 0.0], lambda y: ALPHA - y[0])[0]
    source = ("theta'' = -p^2 (sin(alpha - theta) - a/g cos(alpha - theta)), fourth-order Runge-Kutta: theta = alpha at %.6f s "
              '(benchmark dda-17)' % balance)
    expected = []
    for t in (round(balance / 2, 2), round(balance, 2)):
        theta, spin = rk4(rate, [0.0, 0.0], 0, t, 20000)
        expected.append(('rotation', 2, t, -theta, 0.02 * t * spin, 'asked for: 2 % in time', source))
    case(name, acceleration, round(balance, 2), expected,
         'a block 0.5 m x 2 m under a horizontal acceleration of %g m/s^2 overturns (benchmark dda-17)' % acceleration)


falling('row_1', 2.943)
falling('row_2', 2.5506)
SOURCE = 'statics: uplift iff a > g b/h = %.4f m/s^2 (benchmark dda-17)' % UPLIFT
case('below', 0.99 * UPLIFT, 1.0, [('rotation', 2, 1.0, 0, 1e-4, 'the elastic block leans', SOURCE),
                                   ('travel', 2, 1.0, 0, 1e-7, 'it stands', SOURCE)],
     'the same block at 0.99 of the acceleration that lifts it (benchmark dda-17)')
lifted = rk4(rate_under(1.01 * UPLIFT), [0.0, 0.0], 0, 1.0, 20000)[0]
case('above', 1.01 * UPLIFT, 1.0, [('rotation', 2, 1.0, -lifted, 0.05 * lifted, 'verdict: it lifts; the limit is within 1 %', SOURCE)],
     'the same block at 1.01 of the acceleration that lifts it (benchmark dda-17)')
