"""Writes the cases of masonry_arch: voussoirs near their least thickness, and under a horizontal acceleration.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from limit_analysis import greatest_coefficient, joint_angles, least_thickness, voussoir  # noqa: E402
from old_files import Scene, analysis_text, rock, write_case  # noqa: E402

RADIUS, G = 5.0, 9.81


def springing(angle, outward, thickness):
    """A fixed block behind the joint at the angle; outward: +1 where the arch leaves it with growing angle."""
    inner, outer, depth = RADIUS * (1 - thickness / 2) - 0.3, RADIUS * (1 + thickness / 2) + 0.3, 0.6
    across, back = (math.cos(angle), math.sin(angle)), (outward * math.sin(angle), -outward * math.cos(angle))
    at = [(r * across[0] + d * back[0], r * across[1] + d * back[1]) for r, d in ((inner, 0), (inner, depth), (outer, depth), (outer, 0))]
    return at if outward > 0 else at[::-1]


def scene_of(count, half_angle, thickness):
    scene = Scene()
    angles = joint_angles(count, half_angle)
    for left, right in zip(angles, angles[1:]):
        scene.block([(RADIUS * x, RADIUS * y) for x, y in voussoir(left, right, thickness)])
    scene.fixed_block(springing(angles[0], -1, thickness))
    scene.fixed_block(springing(angles[-1], 1, thickness))
    return scene


def case(name, count, half_angle, thickness, coefficient, expected, about):
    steps = round(max(row[2] for row in expected) / 0.002)
    settings = {'body_acceleration.x': repr(coefficient * G)} if coefficient else {}
    write_case(os.path.join(HERE, name), scene_of(count, half_angle, thickness),
               analysis_text(scene_of(count, half_angle, thickness), steps, 0.002, [rock()], [(45, 0, 0)]), expected, about,
               set={'both': settings})


def pair(name, count, limit, what, time, case_at):
    """One case 5 % on the safe side of the limit and one 5 % beyond it."""
    reason = 'asked for: 5 %% of the limit; 5 %% %s: %s'
    source = 'limit analysis of these voussoirs (limit_analysis.py): %s %.6f' % (what, limit)
    blocks = sorted({(count + 1) // 4, (count + 1) // 2, count - (count + 1) // 4 + 1})
    stands = [('displacement', b, t, 0.0, 1e-3, reason % ('on the safe side', 'it stands, 1e-4 of its span for elastic strain'),
               source) for b in blocks for t in (0.5, 1.0)]
    falls = [('displacement', (count + 1) // 2, time, 1.0, 0.97,
              reason % ('beyond', 'it has left its place by 0.03 m and more and is on its way down'), source)]
    case_at(name + '_stands', -1, stands)
    case_at(name + '_falls', 1, falls)


def slim(count, half_angle):
    least = least_thickness(count, half_angle)

    def case_at(name, side, expected):
        case(name, count, half_angle, least * (1 - 0.05 * side), 0.0, expected,
             'a semicircle of %d voussoirs, %.2f of the least thickness' % (count, 1 - 0.05 * side))
    pair('slim', count, least, 'least thickness over mean radius', 1.0, case_at)


def quake(name, count, half_angle, thickness):
    greatest = greatest_coefficient(count, half_angle, thickness)

    def case_at(case_name, side, expected):
        case(case_name, count, half_angle, thickness, greatest * (1 + 0.05 * side), expected,
             'an arch of %d voussoirs at %.2f of the horizontal acceleration it can bear' % (count, 1 + 0.05 * side))
    pair(name, count, greatest, 'greatest horizontal coefficient', 1.5, case_at)


slim(15, 90.0)
quake('quake_thin', 15, 90.0, 0.15)
quake('quake_seven', 7, 78.75, 0.15)
quake('quake_thick', 15, 90.0, 0.2)
