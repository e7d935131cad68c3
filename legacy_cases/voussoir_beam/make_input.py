"""Writes the cases of voussoir_beam: two blocks that hold each other between fixed abutments.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from old_files import Scene, analysis_text, rock, write_case  # noqa: E402


SEAT = 0.1  # m of a block that lies on its ledge


def three_hinge():
    """Clear span 10 m, depth 1 m, 25 kN/m3: hinges at the lower corners in the abutments and the upper corners at mid-span."""
    half, depth, unit_weight = 5.0, 1.0, 25e3
    end = half + SEAT
    weight = unit_weight * depth * end
    thrust = weight * (half - end / 2) / depth
    scene = Scene()
    scene.block([(-end, 0), (0, 0), (0, depth), (-end, depth)], joints=[2, 1, 2, 2])
    scene.block([(0, 0), (end, 0), (end, depth), (0, depth)], joints=[2, 2, 2, 1])
    for wall, ledge in (((-end - 2, -end), (-end, -half)), ((end, end + 2), (half, end))):
        scene.fixed_block([(wall[0], -1), (wall[1], -1), (wall[1], 2), (wall[0], 2)], joints=2)
        scene.fixed_block([(ledge[0], -1), (ledge[1], -1), (ledge[1], 0), (ledge[0], 0)], joints=2)
    stress = thrust / depth  # mean stress over the block: thrust times length over area
    source = 'three-hinge arch, moments of a half about its crown: H = %.0f N (gamma t s^2/(8 t) = %.0f N without the seats); mean stress xx = -H/t' % (
        thrust, unit_weight * depth * (2 * half) ** 2 / (8 * depth))
    expected = [('sxx', block, t, -stress, 0.02 * stress, 'asked for: 2 %', source) for block in (1, 2) for t in (0.1, 1.0)]
    write_case(os.path.join(HERE, 'three_hinge'), scene,
               analysis_text(scene, 500, 0.002, [rock(unit_weight / 9.81, weight=unit_weight)], [(45, 0, 0), (0, 0, 0)]), expected,
               'thrust of two blocks that bridge 10 m')


three_hinge()
