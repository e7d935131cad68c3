"""Writes the cases of plane_failure: a wedge of rock on a plane with cohesion, with and without tension crack.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from old_files import Scene, analysis_text, reduced, rock, write_case  # noqa: E402

G = 9.81


def case(name, height, face, plane, cohesion, phi, crack, share, time=1.0):
    """Toe at (0, 0), face of angle `face`, plane rising to the right, crack of depth `crack` from the level top."""
    face, plane, friction = (math.radians(v) for v in (face, plane, phi))
    x_crest, x_back = height / math.tan(face), (height - crack) / math.tan(plane)
    block = [(0, 0), (x_back, height - crack)] + ([(x_back, height)] if crack else []) + [(x_crest, height)]
    scene = Scene()
    scene.block(block, joints=[1] + [2] * (len(block) - 1))
    run = x_back + 1
    scene.fixed_block([(-2, -2 * math.tan(plane)), (x_back + 1, -2 * math.tan(plane) - 1), (run, run * math.tan(plane))])
    area = height / 2 * (height - crack) / math.tan(plane) + crack * x_back / 2 - height * x_crest / 2
    weight, length = 26e3 * area, (height - crack) / math.sin(plane)
    sine, cosine = math.sin(plane), math.cos(plane)
    safety = (cohesion * length + weight * cosine * math.tan(friction)) / (weight * sine)
    factor = share * safety
    a = G * (sine - cosine * math.tan(friction) / factor) if share > 1 else 0.0
    source = 'Hoek and Bray 1977: F = (c A + W cos p tan phi)/(W sin p) = %.5f; reduced by %.2f of it' % (safety, share)
    expected = [('displacement', 1, t, a * t * t / 2, 0.01 * a * t * t / 2 if a else 1e-3,
                 'asked for: 2 % of the factor of safety, that is, whether it moves; the bond is lost at the first slip, after '
                 'which only friction acts', source) for t in (time / 2, time)]
    write_case(os.path.join(HERE, name), scene,
               analysis_text(scene, round(time / 0.002), 0.002, [rock(26e3 / G, weight=26e3)],
                             [(phi, cohesion, 0), (0, 0, 0)]), expected,
               'rock on a plane at %.2f of its factor of safety %.4f' % (share, safety), set=reduced(1 / factor))
    return weight, length, safety


def critical_depth(height, face, plane):
    return height * (1 - math.sqrt(math.tan(math.radians(plane)) / math.tan(math.radians(face))))


ROWS = {'no_crack': (10, 70, 35, 20e3, 30, 0),
        'crack': (10, 70, 35, 10e3, 30, critical_depth(10, 70, 35)),
        'high_slope': (60, 50, 35, 98.1e3, 35, critical_depth(60, 50, 35))}
for row, data in ROWS.items():
    case(row + '_stands', *data, 0.98)
    print(row, case(row + '_slides', *data, 1.02))
