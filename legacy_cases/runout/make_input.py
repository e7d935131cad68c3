"""Writes the cases of runout: a block slides down a slope and out on a level, over a kink or a rounded foot.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from old_files import Scene, analysis_text, rock, write_case  # noqa: E402
from rigid_slab import run_out  # noqa: E402

G, DEPTH = 9.81, 3.0


def foot_profile(alpha, facets, radius):
    """Corners from the slope to the level: the kink at (0, 0), or a circle of the radius in so many facets."""
    if facets == 0:
        return [(0.0, 0.0)]
    reach = radius * math.tan(alpha / 2)
    angles = [alpha - alpha * i / facets for i in range(facets + 1)]
    return [(reach - radius * math.sin(a), radius - radius * math.cos(a)) for a in angles]


def case(name, height, alpha_deg, phi1, phi2, facets, time, length=0.5, thickness=0.1):
    alpha = math.radians(alpha_deg)
    mu1, mu2 = math.tan(math.radians(phi1)), math.tan(math.radians(phi2))
    slope = height / math.sin(alpha)
    a = G * (math.sin(alpha) - math.cos(alpha) * mu1)
    speed, t_foot = math.sqrt(2 * a * slope), math.sqrt(2 * slope / a)
    profile = foot_profile(alpha, facets, 10.0)
    reach = profile[-1][0]  # of the rounded foot, from the kink, along slope and level; no friction on it
    smooth = reach + (2 * a * (slope - reach) + 2 * G * reach * math.sin(alpha)) / (2 * G * mu2)
    least = (speed * max(0.0, math.cos(alpha) - mu2 * math.sin(alpha))) ** 2 / (2 * G * mu2)

    def on_slope(s, n):
        return (s * math.cos(alpha) + n * math.sin(alpha), -s * math.sin(alpha) + n * math.cos(alpha))

    back = -slope - length / 2  # the centroid travels the whole slope to the kink
    scene = Scene()
    scene.block([on_slope(back, 0), on_slope(back + length, 0), on_slope(back + length, thickness), on_slope(back, thickness)], 1)
    top, end = on_slope(-slope - 2, 0), (smooth + 30, 0.0)
    scene.fixed_block([top, (top[0], -DEPTH), (end[0], -DEPTH), end] + profile[::-1], 2,
                      [2, 2, 2, 2] + [3] * (len(profile) - 1) + [1])
    step = 0.005
    before = step * math.floor((math.sqrt(2 * (slope - reach - length) / a)) / step)
    source = 'energy: foot speed %.4f m/s after %.5f s' % (speed, t_foot)
    expected = [('speed', 1, before, a * before, 0.01 * a * before, 'asked for: 1 %', source)]
    lines = [(profile[0], alpha, mu1)] + [(p, math.atan2(p[1] - q[1], q[0] - p[0]), 0.0) for p, q in zip(profile, profile[1:])]
    rest = run_out(lines + [(profile[-1], 0.0, mu2)], length, thickness, on_slope(-slope, thickness / 2), -alpha, 1e-3)
    expected.append(('cx', 1, time, rest, 0.01 * rest, 'first order in the step: impacts end a step',
                     'rigid slab on two corners (rigid_slab.py), at rest at %.4f m; %s; mass point: %.4f m without loss%s' % (
                         rest, source, smooth, '' if facets else ', %.4f m where the kink takes the speed into the level '
                         'and friction its share' % least)))
    expected.append(('speed', 1, time, 0.0, 1e-3, 'it has stopped', 'friction of the level'))
    write_case(os.path.join(HERE, name), scene,
               analysis_text(scene, round(time / step), step, [rock(), rock()], [(phi1, 0, 0), (phi2, 0, 0), (0, 0, 0)], ratio=0.002),
               expected, 'a slab slides down %g m at %g degrees and out on the level' % (height, alpha_deg),
               variants=[{'name': '1 ms', 'profile': 'standard', 'set': {'time_step': '0.001', 'steps': str(round(time / 0.001))},
                          'tolerance': 0.005 * rest, 'reason': 'half: the step is a fifth'}])


case('gentle_kink', 20, 30, 15, 15, 0, 12.0)
case('steep_kink', 10, 45, 25, 30, 0, 5.0)
case('gentle_rounded', 20, 30, 15, 15, 24, 12.0)
case('steep_rounded', 10, 45, 25, 30, 24, 6.0)
