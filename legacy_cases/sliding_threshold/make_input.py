"""Writes the cases of sliding_threshold: friction angles about the slope angle.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import G, SlopeScene, analysis, variant, write_case  # noqa: E402

SLOPE = 30.0
REASON = 'from the compatible start the contact does not ring: 1e-6 relative and 1e-7 m'


def case(friction):
    scene = SlopeScene(SLOPE)
    scene.on_slope(1, 0, 2, 1)
    a, slides = math.radians(SLOPE), friction < SLOPE
    acceleration = G * (math.sin(a) - math.cos(a) * math.tan(math.radians(friction))) if slides else 0.0
    source = ('closed form: g/2 (sin a - cos a tan phi) t^2 with a = 30 deg, phi = %g deg, g = 9.81 m/s^2' % friction
              if slides else 'statics: phi >= a, nothing slides')
    expected = []
    for t in (1.0, 5.0, 10.0):
        s = acceleration * t * t / 2
        expected.append(('displacement' if slides else 'travel', 2, t, s, 1e-6 * s + 1e-7, REASON, source))
    if not slides:
        expected.append(('speed', 2, 10.0, 0, 1e-9, 'no growth: 1e-8 m would take 10 s more', source))
    expected.append(('rotation', 2, 10.0, 0, 1e-5,
                     'the elastic block shears under its weight, rho g sin(a) h/4G = 1.6e-6 rad, and its bottom stays flat',
                     'a block flat on a plane cannot rotate'))
    coarse = {'time_step': 0.01, 'steps': 1000}
    write_case(os.path.join(HERE, 'phi_' + ('%g' % friction).replace('.', '_')), scene, analysis(1e-3, 10000, friction), expected,
               'a block on a slope of 30 degrees with a friction angle of %g degrees, 10 s (benchmark dda-04)' % friction,
               slow=True, set={'legacy': {**{k: str(v) for k, v in coarse.items()}, 'contact_penalty': '5e9'}},
               variants=[variant('10 ms', **coarse), variant('10 ms, rigid', basis='rigid', **coarse),
                         variant('10 ms, springs of 10 E', enforcement='penalty', **coarse)])


for angle in (29, 29.9, 29.99, 30, 30.01, 30.1, 31):
    case(angle)
