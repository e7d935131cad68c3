"""Writes the cases of tilting_stack: bricks on a plate that tilts through the limit of the stack.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import G, SlopeScene, analysis, rk4, swing, variant, write_case  # noqa: E402

B, H = 1.0, 0.5
RATE = 0.5  # degrees a second
MARGIN = 0.5  # degrees before and after the limit
STEP, ROWS = 2e-3, 50


def case(count):
    limit = math.degrees(math.atan(B / (count * H)))
    first, end = limit - MARGIN, 2 * MARGIN / RATE
    p2, alpha = swing(B, count * H)

    def tilt(t):
        return math.radians(first + RATE * t)

    turn = rk4(lambda t, y: [y[1], p2 * math.sin(tilt(t) - alpha + y[0])], [0.0, 0.0], end / 2, end, 20000)[0]
    source = ('statics: the whole stack topples at tan(alpha) = b/(n h), %.4f deg; then a rigid block about its toe, '
              'fourth-order Runge-Kutta (benchmark dda-35)' % limit)
    scene = SlopeScene(0)
    for level in range(count):
        scene.on_slope(6, level * H, 6 + B, (level + 1) * H)
    expected = []
    for brick in (2, count + 1):
        expected += [('travel', brick, end / 2 - 0.1, 0, 1e-5, 'it stands below the limit: only the elastic lean grows', source),
                     ('rotation', brick, end / 2 - 0.1, 0, 1e-4, 'the elastic lean', source),
                     ('rotation', brick, end, -turn, 0.09 * turn,
                      'verdict: within 0.5 degrees of the limit the stack, bottom brick too, topples', source)]
    write_case(os.path.join(HERE, 'n%d' % count), scene, analysis(STEP, round(end / STEP), 40), expected,
               '%d bricks on a plate that tilts by 0.5 degrees a second through the limit of %.2f degrees (benchmark dda-35)'
               % (count, limit), slow=True, set={'both': {'gravity.x': '0', 'gravity.y': '0'}},
               motion=[(end * k / ROWS, G * math.sin(tilt(end * k / ROWS)), -G * math.cos(tilt(end * k / ROWS)))
                       for k in range(ROWS + 1)],
               variants=[variant('rigid', basis='rigid'), variant('springs of 10 E', enforcement='penalty')])


for bricks in (3, 4, 5, 8):
    case(bricks)
