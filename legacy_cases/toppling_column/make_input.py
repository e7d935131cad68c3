"""Writes the twelve columns of the Berkeley program's toppling table, and the falling ones on springs.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import PIVOT, SlopeScene, analysis, material, rk4, swing, variant, write_case  # noqa: E402

B = 1.0
VARIANTS = [variant('5 ms', time_step=0.005, steps=200), variant('rigid', basis='rigid'),
            variant('rigid, 5 ms', basis='rigid', time_step=0.005, steps=200)]


def turn(h, slope, t):
    p2, alpha = swing(B, h)
    first = slope - alpha
    return rk4(lambda _, y: [y[1], p2 * math.sin(y[0])], [first, 0.0], 0, t, 20000)[0] - first


def case(slope_deg, percent):
    slope = math.radians(slope_deg)
    h = B / (percent / 100 * math.tan(slope))
    scene = SlopeScene(slope_deg)
    scene.on_slope(6, 0, 6 + B, h)
    text = analysis(1e-3, 1000, 50, [material(2500.0)])
    name = 'a%d_r%03d' % (slope_deg, percent)
    if percent > 100:
        source = 'statics: b/h = %g tan a > tan a, friction 50 deg > slope' % (percent / 100)
        expected = [(quantity, 2, t, 0, tolerance, reason, source) for t in (0.5, 1.0) for quantity, tolerance, reason in
                    (('rotation', 1e-4, 'the elastic column leans; 1/240 of what the slowest falling column turns'),
                     ('travel', 1e-7, 'it stands'))]
        return write_case(os.path.join(HERE, name), scene, text, expected,
                          'a column of b/h = %g tan a on a slope a of %d degrees stands' % (percent / 100, slope_deg),
                          variants=VARIANTS)
    turns = [(t, turn(h, slope, t)) for t in (0.25, 0.5, 0.75, 1.0)]
    about = 'a column of b/h = %g tan a on a slope a of %d degrees falls' % (percent / 100, slope_deg)
    write_case(os.path.join(HERE, name), scene, text,
               [('rotation', 2, t, -v, 0.01 * v, 'asked for: 1 % with multipliers', PIVOT) for t, v in turns], about,
               variants=VARIANTS)
    write_case(os.path.join(HERE, 'springs_' + name), scene, text,
               [('rotation', 2, t, -v, 0.05 * v, 'asked for: 5 % with springs of up to 10 E', PIVOT) for t, v in turns],
               about + ', on springs of 10 E and 1 E', set={'standard': {'enforcement': 'penalty'}},
               variants=VARIANTS + [variant('springs of 1 E', contact_penalty='5e9')])


for degrees in (10, 20, 30):
    for ratio in (50, 90, 110, 200):
        case(degrees, ratio)
