"""Writes the cases of domino: a standing domino with a little less and a little more spin than tips it.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import Scene, analysis, material, rectangle, rk4, swing, variant, write_case  # noqa: E402

B, H = 0.1, 1.0
P2, ALPHA = swing(B, H)
CRITICAL = math.sqrt(2 * P2 * (1 - math.cos(ALPHA)))


def case(name, share, end, expected):
    spin = share * CRITICAL
    scene = Scene()
    floor = scene.block(rectangle(-5, -1, 5, 0), material=2)
    scene.fixed += [(-4, -0.5, floor), (4, -0.5, floor)]
    scene.block(rectangle(-B, 0, 0, H))
    about_corner = (spin * H / 2, spin * B / 2, -spin)
    write_case(os.path.join(HERE, name), scene,
               analysis(1e-3, round(1000 * end), 60, [material(velocity=about_corner), material()]), expected,
               'a standing domino with %g of the spin that tips it (benchmark dda-18 B)' % share,
               variants=[variant('5 ms', time_step=0.005, steps=round(200 * end)), variant('rigid', basis='rigid')])


case('returns', 0.99, 2.0, [
    ('rotation', 2, 2.0, 0, ALPHA, 'verdict: within the balance angle of %.4f rad; it rocks on' % ALPHA,
     'energy: omega0 < sqrt(2 p^2 (1 - cos alpha)) = %.6f rad/s returns (benchmark dda-18 B)' % CRITICAL)])
theta = rk4(lambda t, y: [y[1], -P2 * math.sin(ALPHA - y[0])], [0.0, 1.01 * CRITICAL], 0, 1.2, 20000)[0]
case('tips', 1.01, 1.2, [
    ('rotation', 2, 1.2, -theta, 0.09 * theta, 'verdict: beyond the balance angle of %.4f rad' % ALPHA,
     "theta'' = -p^2 sin(alpha - theta), fourth-order Runge-Kutta; tips if omega0 > %.6f rad/s (benchmark dda-18 B)" % CRITICAL)])
