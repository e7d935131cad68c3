"""Writes the cases of newmark_pulse: a rectangular pulse of acceleration on a block on a floor.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import G, SlopeScene, analysis, variant, write_case  # noqa: E402


def case(name, pulse, slip, length):
    scene = SlopeScene(0)
    scene.on_slope(5, 0, 6, 1)
    speed = pulse * G * length
    end = speed / (slip * G)
    last = speed ** 2 / (2 * G * slip) * (1 - slip / pulse)
    total = math.ceil((end + 0.3) * 10) / 10
    source = ('closed form, Newmark 1965: A = %g g for %g s, yield N = %g g; d = V^2/(2 g N) (1 - N/A), V = A g t0 '
              '(benchmark dda-07)' % (pulse, length, slip))
    expected = []
    for t in (length, length + round((end - length) / 2, 2), total):
        if t >= end:
            s = last
        else:
            s = (pulse - slip) * G * length * (t - length / 2) - slip * G * (t - length) ** 2 / 2
        expected.append(('dx', 2, t, s, 0.01 * s, 'asked for: 1 %', source))
    expected.append(('vx', 2, total, 0, 1e-3, 'it stops', source))
    steps = round(total * 1000)
    write_case(os.path.join(HERE, name), scene, analysis(1e-3, steps, math.degrees(math.atan(slip))), expected,
               'a pulse of %g g for %g s on a block that slides at %g g (benchmark dda-07)' % (pulse, length, slip),
               motion=[(0, pulse * G, 0), (length - 1e-6, pulse * G, 0), (length + 1e-6, 0, 0), (total, 0, 0)],
               variants=[variant('10 ms', time_step=0.01, steps=steps // 10), variant('rigid', basis='rigid'),
                         variant('springs of 10 E', enforcement='penalty')])


case('row_1', 0.5, 0.2, 0.5)
case('row_2', 0.4, 0.1, 0.3)
case('row_3', 0.3, 0.25, 1.0)
