"""Writes the cases of settlement: stacks under their own weight, contacts of finite stiffness.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from old_files import Scene, analysis_text, rock, write_case  # noqa: E402

G = 9.81


def settlements(count, h, w, modulus, rho, p):
    """Of the centroids, from the lowest block up: two contacts of stiffness p an interface, uniform stress in each block."""
    below, values = 0.0, []
    for k in range(count):
        below += (count - k) * rho * G * h * w / (2 * p)
        shortening = rho * G * h * (count - k - 0.5) * h / modulus
        lower_half = rho * G * h * (count - k - 0.5) * h / (2 * modulus)
        values.append(below + lower_half)
        below += shortening
    return values, below


def case(name, count, h, w, modulus, rho, p, carry_over, multipliers):
    scene = Scene()
    scene.fixed_block([(-2, -1), (w + 2, -1), (w + 2, 0), (-2, 0)], 2)
    for k in range(count):
        scene.block([(0, k * h), (w, k * h), (w, (k + 1) * h), (0, (k + 1) * h)], 1)
    values, top = settlements(count, h, w, modulus, rho, p)
    source = 'closed form: rho g (N h)^2/(2E) + sum of W_k/(2p), %.6g m for the top' % top
    expected = []
    for k, value in enumerate(values):
        for time in (0.05, 0.4):
            if k in (0, count // 2, count - 1):
                expected.append(('dy', k + 2, time, -value, 0.01 * value, 'asked for: 1 %', source))
    materials = [rock(rho, modulus, 0.0), rock(rho, modulus * 1e3, 0.0)]
    case = {'set': {'standard': {'enforcement': 'penalty'}}}
    if multipliers:
        case['variants'] = [{'name': 'multipliers', 'profile': 'standard', 'set': {'enforcement': 'lagrange'}}]
    write_case(os.path.join(HERE, name), scene,
               analysis_text(scene, 400, 0.001, materials, [(30, 0, 0)], penalty=p, carry_over=carry_over), expected,
               'settlement of a stack of %d under its own weight' % count, **case)


ROWS = {'ten_soft': (10, 1, 1, 1e9, 2500, 1e10, False), 'ten_stiff': (10, 1, 1, 1e9, 2500, 1e12, True),
        'five_tall': (5, 2, 1, 5e9, 2700, 5e10, False)}
for row, (*data, multipliers) in ROWS.items():
    case(row + '_dynamic', *data, 1.0, multipliers)
    case(row + '_static', *data, 0.0, multipliers)
