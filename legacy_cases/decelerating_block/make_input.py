"""Writes the cases of decelerating_block: a block thrown down a gentle slope, and along a floor.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import G, SlopeScene, analysis, material, turned, variant, write_case  # noqa: E402


def case(name, slope, tan_friction, speed, times, about, source):
    a = math.radians(slope)
    deceleration = G * (math.cos(a) * tan_friction - math.sin(a))
    stop, way = speed / deceleration, speed ** 2 / (2 * deceleration)
    scene = SlopeScene(slope, material=2)
    scene.on_slope(1, 0, 2, 1)
    expected = []
    for t in times:
        s = speed * t - deceleration * t * t / 2 if t < stop else way
        expected.append(('displacement', 2, t, s, 0.01 * s, 'asked for: 1 %', source))
        if t > stop:
            expected.append(('speed', 2, t, 0, 1e-3, 'asked for: 1e-3 m/s after the stop', source))
    vx, vy = turned(slope, [(speed, 0)])[0]
    steps = round(times[-1] * 1000)
    write_case(os.path.join(HERE, name), scene,
               analysis(1e-3, steps, math.degrees(math.atan(tan_friction)), [material(velocity=(vx, vy, 0)), material()]),
               expected, about,
               variants=[variant('10 ms', time_step=0.01, steps=steps // 10), variant('rigid', basis='rigid'),
                         variant('springs of 10 E', enforcement='penalty')])


case('incline', 15, math.tan(math.radians(30)), 3.0, (0.5, 1.0, 1.2, 2.0),
     'a block thrown down a slope flatter than its friction angle stops (benchmark dda-05 A)',
     'closed form: v0 t - d t^2/2, d = g (cos a tan phi - sin a), a = 15 deg, phi = 30 deg, v0 = 3 m/s; '
     'stops at 1.02326 s, 1.53489 m')
case('flat', 0, 0.3, 5.0, (0.5, 1.0, 1.5, 1.8, 3.0), 'a block thrown along a floor stops (benchmark dda-05 B)',
     'closed form: v0 t - mu g t^2/2, mu = 0.3, v0 = 5 m/s; stops at 1.69895 s, 4.24737 m')
