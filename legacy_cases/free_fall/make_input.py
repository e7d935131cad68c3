"""Writes the case free_fall/tumbling.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import G, Scene, analysis, material, rectangle, variant, write_case  # noqa: E402

SPEED, SPIN = 10.0, 2 * math.pi
SOURCE = 'closed form: ballistics and constant spin, v0 = (10, 10) m/s, omega = 2 pi rad/s (benchmark dda-02)'

scene = Scene()
scene.block(rectangle(-0.5, -0.25, 0.5, 0.25))
expected = []
for t in (0.5, 1.0, 2.0):
    expected += [('dx', 1, t, SPEED * t, 1e-9 * SPEED * t, 'asked for: 1e-9 relative', SOURCE),
                 ('dy', 1, t, SPEED * t - G * t * t / 2, 2e-8, 'asked for: 1e-9 of the way', SOURCE),
                 ('rotation', 1, t, SPIN * t, 1e-4 * t, 'asked for: 1e-4 rad a turn', SOURCE)]
expected.append(('area', 1, 2.0, 0.5, 0.5e-5, 'asked for: 1e-5; the true centrifugal stretch is 1.6e-6 of it',
                 'closed form: a rigid turn keeps the area'))
write_case(os.path.join(HERE, 'tumbling'), scene,
           analysis(1e-3, 2000, 0, [material(velocity=(SPEED, SPEED, SPIN))], displacement_ratio=0.1), expected,
           'a block thrown with a turn a second (benchmark dda-02)',
           variants=[variant('10 ms', time_step=0.01, steps=200), variant('rigid', basis='rigid')])
