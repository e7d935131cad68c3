"""Writes the cases of biaxial_strength (pla-06).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import case_text, rectangle, write_case  # noqa: E402

STEPS = 8


def case(phi, c, s3, psi):
    strength = {'surface': 'mohr_coulomb', 'cohesion': c, 'friction_deg': phi, 'dilation_deg': psi}
    covers = {'mesh': {'side': 0.25, 'angle': 10, 'through_x': 0.0137, 'through_y': 0.0071},
              'displacements': [{'along': [(0, 0), (1, 0)], 'held': 'normal'}, {'along': [(0, 1), (0, 0)], 'held': 'normal'},
                                {'along': [(1, 1), (0, 1)], 'held': 'normal', 'normal': -4e-4}]}
    if s3:
        covers['tractions'] = [{'along': [(1, 0), (1, 1)], 'pressure': s3}]
    ratio = math.tan(math.radians(45 + phi / 2)) ** 2
    values = []
    for step in (STEPS // 2, STEPS):
        s1 = ratio * s3 * step / STEPS + 2 * c * math.sqrt(ratio)
        values.append(('reaction_y', 3, -s1, 0.005 * s1, 'asked for: 0.5 %', 'pla-06: s1 = N s3 + 2 c sqrt N (Coulomb 1776)', step))
    text = case_text(rectangle(0, 0, 1, 1), covers, 1e7, 0.25, [(0.6, 0.7)], plane_strain=True, steps=(STEPS, 1), strength=strength)
    folder = 'phi_%g_c_%g_s3_%g%s' % (phi, c, s3, '' if psi == phi else '_psi_%g' % psi)
    write_case(os.path.join(HERE, folder), text, values, 'a square pressed between smooth plates, phi %g, c %g, its sides under %g' % (phi, c, s3))


for phi, c, s3, psi in ((30, 0, 100, 30), (30, 20, 100, 30), (30, 20, 100, 0), (35, 5, 50, 35), (45, 10, 5, 45), (20, 10, 0, 20)):
    case(phi, c, s3, psi)
