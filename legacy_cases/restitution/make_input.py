"""Writes the cases of restitution: ten blocks at ten heights strike a floor, without weight.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import random
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import Scene, analysis, material, rectangle, variant, write_case  # noqa: E402

STIFF, SOFT = 5e10, 5e7  # springs of 10 E and of E/100, one a corner
SOURCE = 'closed form: Newton, rebound speed e times approach speed (benchmark dda-11)'


def steps_of(part, stiffness, end):
    """Step size and steps that reach `end`, the step at most the time of contact on two springs over `part`."""
    contact_time = math.pi * math.sqrt(2600 / (2 * stiffness))
    steps = math.ceil(end / (contact_time / part))
    return {'time_step': end / steps, 'steps': steps}


def falling_blocks(gaps, end, rebound, tolerance, reason, source):
    """The scene, and what is expected of it at `end`."""
    scene = Scene()
    floor = scene.block(rectangle(0, -1, 21, 0), material=2)
    scene.fixed += [(1, -0.5, floor), (20, -0.5, floor)]
    expected = []
    for i, gap in enumerate(gaps):
        block = scene.block(rectangle(1 + 2 * i, gap, 2 + 2 * i, 1 + gap))
        expected.append(('vy', block, end, rebound, tolerance, reason, source))
        expected.append(('rotation', block, end, 0, 1e-9, 'rounding only', 'a flat impact does not turn the block'))
    return scene, expected


def text_of(plain):
    return analysis(plain['time_step'], plain['steps'], 0, [material(velocity=(0, -1, 0)), material()], gravity=0.0)


def by_law(restitution, gaps):
    end = 0.02
    scene, expected = falling_blocks(gaps, end, restitution, 0.005 if restitution else 1e-9,
                                     'asked for: 0.5 %' if restitution else 'a plastic impact leaves no rebound; rounding only', SOURCE)
    variants = [variant('dt = Tc/%d' % part, **steps_of(part, STIFF, end)) for part in (200, 50, 10, 5)]
    variants += [variant('dt = 1 ms = 2 Tc', time_step=0.001, steps=20), variant('rigid', basis='rigid'),
                 variant('springs of 10 E', enforcement='penalty')]
    write_case(os.path.join(HERE, 'e_%03d' % round(100 * restitution)), scene, text_of(steps_of(20, STIFF, end)), expected,
               'ten blocks at ten heights strike a floor without weight; restitution %g (benchmark dda-11)' % restitution,
               slow=True, set={'standard': {'restitution': '%g' % restitution}}, variants=variants)


def by_springs(gaps):
    end = 0.04
    scene, expected = falling_blocks(gaps, end, 1, 0.02, 'asked for: 2 % at dt of Tc/20 and less',
                                     'closed form: an undamped spring gives all back (benchmark dda-11)')
    write_case(os.path.join(HERE, 'springs'), scene, text_of(steps_of(20, SOFT, end)), expected,
               'ten blocks at ten heights strike a floor of soft springs, Tc/20 (benchmark dda-11)', slow=True,
               set={'standard': {'enforcement': 'penalty', 'impact': 'springs', 'contact_penalty': '%g' % SOFT}},
               variants=[variant('dt = Tc/%d' % part, **steps_of(part, SOFT, end)) for part in (200, 50)] +
               [variant('rigid', basis='rigid')])


draw = random.Random(11)
heights = [2e-3 + 3e-3 * draw.random() for _ in range(10)]
for e in (0, 0.5, 0.8, 1):
    by_law(e, heights)
by_springs(heights)
