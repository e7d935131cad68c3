"""Writes the cases of footing_collapse (pla-08).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import about_edge_of_footing, case_text, write_case  # noqa: E402

WIDTH = DEPTH = 5.0
corners = [(0, -DEPTH), (WIDTH, -DEPTH), (WIDTH, 0), (1, 0), (0, 0)]


def bearing_factor(phi):
    """Prandtl 1920."""
    if phi == 0:
        return 2 + math.pi
    tangent = math.tan(math.radians(phi))
    return (math.exp(math.pi * tangent) * math.tan(math.radians(45 + phi / 2)) ** 2 - 1) / tangent


def case(folder, phi, mesh, settlement, steps, share, reason, slow=False):
    covers = {'mesh': mesh,
              'displacements': [{'along': [(0, -DEPTH), (WIDTH, -DEPTH)]},
                                {'along': [(0, -DEPTH), (0, 0)], 'held': 'normal'},
                                {'along': [(WIDTH, -DEPTH), (WIDTH, 0)], 'held': 'normal'},
                                {'along': [(0, 0), (1, 0)], 'held': 'y', 'y': -settlement}]}
    strength = {'surface': 'mohr_coulomb', 'cohesion': 10, 'friction_deg': phi, 'dilation_deg': phi}
    text = case_text(corners, covers, 1e7, 0.48 if phi == 0 else 0.3, [(0.5, 0)], plane_strain=True, steps=(steps, 1), strength=strength)
    load = 10 * bearing_factor(phi)
    # What is left of the load's growth in the last step, over that of the settlement, shows the plateau.
    values = [('reaction_y', 4, -load, share * load, reason, 'c Nc = %.6g on the half width 1: Prandtl 1920' % load, steps),
              ('reaction_y', 4, -load, share * load, 'the same an eighth of the settlement before: a plateau', 'the same', steps - steps // 8)]
    write_case(os.path.join(HERE, folder), text, values, 'footing on weightless soil, friction %g degrees, flow associated' % phi, slow=slow)


def graded(side, refined):
    return {'kind': 'unstructured', 'placement': 'aligned', 'side': side, 'refined': refined}


for phi, settlement, steps, share, fine in ((0, 6e-5, 16, 0.01, 0.01), (10, 1.2e-4, 16, 0.015, 0.01), (20, 2e-4, 24, 0.02, 0.01), (30, 2e-4, 24, 0.03, 0.015)):
    case('phi_%d' % phi, phi, graded(0.3, [(1, 0, 0.35 * 0.1)]), settlement, steps, share, '1,682 unknowns; half of it at 4,360 (case fine)')
    case('phi_%d_fine' % phi, phi, graded(0.2, about_edge_of_footing()), settlement, steps, fine, 'asked for: %g %%' % (100 * fine), slow=True)


def turned(side):
    """A regular mesh that the outline and the edge of the footing cut anyhow."""
    return {'side': side, 'angle': 10, 'through_x': 0.0137, 'through_y': 0.0071}


case('phi_0_cut', 0, turned(0.25), 6e-5, 16, 0.025, '1,106 unknowns; a quarter of it at 4,054 (case cut_fine)')
for phi, settlement, steps in ((0, 6e-5, 16), (10, 1.2e-4, 16), (20, 2e-4, 24)):
    case('phi_%d_cut_fine' % phi, phi, turned(0.125), settlement, steps, 0.01, 'asked for: 1 %', slow=True)
# With rows halved about the edge and where the soil is sheared: 4,174 unknowns.
case('phi_30_cut_fine', 30, dict(turned(0.14), refined=about_edge_of_footing()), 2e-4, 24, 0.015, 'asked for: 1.5 %', slow=True)
