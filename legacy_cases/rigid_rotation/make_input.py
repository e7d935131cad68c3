"""Writes the cases of rigid_rotation: a free square that turns slowly, in steps of various angles.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import Scene, analysis, material, rectangle, variant, write_case  # noqa: E402

SPIN = 0.1


def case(name, angle, steps, tolerance):
    scene = Scene()
    scene.block(rectangle(-0.5, -0.5, 0.5, 0.5))
    step = angle / SPIN
    end, swollen = step * steps, (1 + angle ** 2) ** steps
    expected = [('area', 1, end, 1, tolerance, 'asked for; the true centrifugal stretch is 6.5e-10',
                 'closed form: a rigid turn keeps the area'),
                ('rotation', 1, end, angle * steps, 1e-8 * angle * steps, 'the true change of inertia is 1e-9',
                 'closed form: omega t'),
                ('travel', 1, end, 0, 1e-9, 'rounding only', 'nothing moves the centroid'),
                ('area', 1, end, swollen, 1e-3 * swollen,
                 'diagnostic: the first-order rotation of the old programs swells the block',
                 'closed form: (1 + dtheta^2)^n, the area factor of a first-order rotation (benchmark dda-14)', 'legacy')]
    write_case(os.path.join(HERE, name), scene,
               analysis(step, steps, 0, [material(velocity=(0, 0, SPIN))], gravity=0.0, displacement_ratio=10), expected,
               'a free square turns by %g rad in %d steps of %g rad (benchmark dda-14)' % (angle * steps, steps, angle),
               slow=steps > 10000, variants=[variant('rigid', basis='rigid')])


case('row_1', 0.1, 63, 5e-9)
case('row_2', 0.05, 126, 5e-9)
case('row_3', 0.01, 628, 5e-9)
case('row_4', 0.001, 6283, 5e-9)
case('row_5', 0.0001, 62832, 5e-9)
case('row_6', 0.02, 31416, 1e-7)
