"""Writes the cases of sudden_load_on_covers: the clamped beam of nmm-04 under a load put on at once (nmm-06).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

from timoshenko import swing

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import case_text, rectangle, write_case  # noqa: E402

STATIC = 4.0238e-6  # quadrilaterals of second order, 200 x 20
FREQUENCY = 1.0149
OMEGA = 2 * math.pi * FREQUENCY
CORNERS = rectangle(0, 0, 10, 1)


def text(rows, steps, settings, functions='derived'):
    side = 1.3 / rows
    covers = {'functions': functions, 'mesh': {'side': side, 'shape': 'old', 'through_x': 0.3 * side, 'through_y': 0.4 * side},
              'displacements': [{'along': [(0, 1), (0, 0)]}], 'tractions': [{'along': [(10, 0), (10, 1)], 'y': 1}]}
    return case_text(CORNERS, covers, 1e9, 0.3, [(10, 0.5)], density=2500, steps=steps, settings={'start': 'sudden', **settings})


def case(folder, case_text, values, about, variants=()):
    write_case(os.path.join(HERE, folder), case_text, values, about, variants)


def undamped():
    dt = 0.005
    source = ("Timoshenko's beam under the load put on at once, a sum over its modes (timoshenko.py), with the frequencies of quadrilaterals of "
              "second order (80 x 8); benchmark nmm-06: twice the static deflection in the first mode, 1.948 times at the tip")
    top = 'asked for: 1 % of the overshoot'
    values = []
    for time, why, share in ((0.12, top, 0.02), (0.25, top, 0.02), (0.48, top, 0.0195), (0.74, top, 0.02), (1.47, top, 0.0195),
                             (5.175, 'asked for: 0.2 % of the frequency, 0.010 s of the fifth swing at the greatest speed', 0.064)):
        values.append(('point_dy', 1, STATIC * swing(time), share * STATIC, why, source, time))
    case('undamped', text(3, (1050, dt), {'force_weight': '0.5'}), values, 'swings to twice the static deflection in its first mode')


def to_rest():
    """Ω = ω dt = 1: of the first mode each step leaves 1/(1 + Ω²/2) with the velocity set to 0, its root with it carried over."""
    dt = round(1 / OMEGA, 4)
    source = 'static deflection by quadrilaterals of second order, 200 x 20: 4.0238e-6; first mode left: (1 + (w dt)^2/2)^-n'
    why = 'asked for: 0.1 % of the static deflection, and what theory leaves of the first mode after these steps'
    left = lambda n: (1 + (OMEGA * dt) ** 2 / 2) ** -n
    values = [('point_dy', 1, STATIC * (1 - 0.9694 * left(n)), tolerance * STATIC, reason, source, round(n * dt, 9))
              for n, tolerance, reason in ((2, 0.01, 'the share of the first mode, by theory; of the others a hundredth is left'),
                                           (5, 0.005, 'the share of the first mode, by theory'), (18, 0.001, 'asked for: 0.1 %'))]
    case('static_steps', text(4.3, (18, dt), {'velocity_carry_over': '0'}), values, 'each step from rest: 18 steps of w dt = 1 leave 1/1000')
    values = [('point_dy', 1, STATIC, 0.001 * STATIC, 'asked for: 0.1 % of the static deflection', source, round(60 * dt, 9))]
    case('dynamic_steps', text(4.3, (60, dt), {'force_weight': '1'}), values, 'velocity carried over, weights 1/2 and 1: the rule itself damps')
    values = [('point_dy', 1, STATIC, 0.001 * STATIC, 'asked for: 0.1 % of the static deflection', source, 6.0)]
    case('damped', text(4.3, (300, 0.02), {'force_weight': '0.5', 'stiffness_damping': '%.6g' % (2 * 0.5 / OMEGA)}), values,
         'stiffness damping of half the critical in the first mode')


undamped()
to_rest()
