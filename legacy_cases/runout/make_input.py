"""Writes the cases of runout: a block slides down a slope and out on a level, over a kink or a rounded foot.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from old_files import Scene, analysis_text, rock, write_case  # noqa: E402

G, DEPTH = 9.81, 3.0


def strip(scene, start, end, joint):
    """A fixed block below the line from start to end (left to right), its other edges square to it."""
    length = math.dist(start, end)
    nx, ny = -(end[1] - start[1]) / length * DEPTH, (end[0] - start[0]) / length * DEPTH
    scene.fixed_block([(start[0] - nx, start[1] - ny), (end[0] - nx, end[1] - ny), end, start], 2, joint)


def foot_profile(alpha, facets, radius):
    """Corners from the slope to the level: the kink at (0, 0), or a circle of the radius in so many facets."""
    if facets == 0:
        return [(0.0, 0.0)]
    reach = radius * math.tan(alpha / 2)
    angles = [alpha - alpha * i / facets for i in range(facets + 1)]
    return [(reach - radius * math.sin(a), radius - radius * math.cos(a)) for a in angles]


def case(name, height, alpha_deg, phi1, phi2, facets, time, side=0.5):
    alpha = math.radians(alpha_deg)
    mu1, mu2 = math.tan(math.radians(phi1)), math.tan(math.radians(phi2))
    slope = height / math.sin(alpha)
    a = G * (math.sin(alpha) - math.cos(alpha) * mu1)
    speed, t_foot = math.sqrt(2 * a * slope), math.sqrt(2 * slope / a)
    smooth = speed ** 2 / (2 * G * mu2)
    least = (speed * max(0.0, math.cos(alpha) - mu2 * math.sin(alpha))) ** 2 / (2 * G * mu2)
    profile = foot_profile(alpha, facets, 10.0)
    radius_reach = -profile[0][0]
    down = (math.cos(alpha), -math.sin(alpha))
    out = (math.sin(alpha), math.cos(alpha))
    scene = Scene()

    def on_slope(s, n):
        return (s * down[0] + n * out[0], s * down[1] + n * out[1])

    back = -slope - side / 2  # the centroid travels the whole slope to the kink
    scene.block([on_slope(back, 0), on_slope(back + side, 0), on_slope(back + side, side), on_slope(back, side)], 1)
    strip(scene, on_slope(-slope - 2, 0), profile[0], 1)
    for p, q in zip(profile, profile[1:]):
        strip(scene, p, q, 2)
    scene.fixed_block([(profile[-1][0], -DEPTH), (smooth + 30, -DEPTH), (smooth + 30, 0), profile[-1]], 2, 2)
    step = 0.005
    before = step * math.floor((t_foot - radius_reach / speed / math.cos(alpha) - 1.5 * side / speed) / step)
    start_x = on_slope(back + side / 2, side / 2)[0]
    source = 'energy: foot speed %.4f m/s after %.5f s; runs on between %.4f m (plastic kink with friction) and %.4f m (smooth)' % (
        speed, t_foot, least, smooth)
    expected = [('speed', 1, before, a * before, 0.01 * a * before, 'asked for: 1 %', source)]
    if facets:
        expected.append(('cx', 1, time, smooth, 0.03 * smooth, 'asked for: 3 % for a rounded foot', source))
    else:
        expected.append(('cx', 1, time, (smooth + least) / 2, (smooth - least) / 2, 'between both bounds of the kink', source))
    expected.append(('speed', 1, time, 0.0, 1e-3, 'at rest', 'it has stopped'))
    write_case(os.path.join(HERE, name), scene,
               analysis_text(scene, round(time / step), step, [rock(), rock()], [(phi1, 0, 0), (phi2, 0, 0)], ratio=0.005), expected,
               'a block slides down %g m at %g degrees and out on the level' % (height, alpha_deg))


case('gentle_kink', 20, 30, 15, 15, 0, 12.0)
case('steep_kink', 10, 45, 25, 30, 0, 5.0)
case('gentle_rounded', 20, 30, 15, 15, 12, 12.0)
case('steep_rounded', 10, 45, 25, 30, 12, 6.0)
