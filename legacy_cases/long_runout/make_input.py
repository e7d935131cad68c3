"""Writes the cases of long_runout: 250 m down a slope of one block, of one block with vertices in line, of four blocks.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import G, Scene, analysis, rectangle, turned, variant, write_case  # noqa: E402

SLOPE, FRICTION, DEPTH = 30.0, 15.0, 5.0
JOINTS = [0, 40, 130, 220, 300]
SOURCE = ('closed form: g/2 (sin a - cos a tan phi) t^2 with a = 30 deg, phi = 15 deg: 25 m at 4.36138 s, '
          '250 m at 13.7919 s (benchmark dda-10)')


def held(scene, polygon, first, last):
    block = scene.block(turned(SLOPE, polygon))
    for x, y in turned(SLOPE, [(first + 1, -DEPTH / 2), (last - 1, -DEPTH / 2)]):
        scene.fixed.append((x, y, block))


def case(name, slabs, about):
    scene = Scene()
    for polygon, first, last in slabs:
        held(scene, polygon, first, last)
    block = scene.block(turned(SLOPE, rectangle(1, 0, 3, 2)))
    a = math.radians(SLOPE)
    acceleration = G * (math.sin(a) - math.cos(a) * math.tan(math.radians(FRICTION)))
    expected = [('displacement', block, t, acceleration * t * t / 2, 0.01 * acceleration * t * t / 2,
                 'asked for: 1 % beyond 25 m', SOURCE) for t in (4.4, 13.8)]
    variants = [variant('1 ms', time_step=0.001, steps=13800), variant('100 ms', time_step=0.1, steps=138),
                variant('rigid', basis='rigid')]
    variants += [variant('springs of %s N/m' % p, enforcement='penalty', contact_penalty=p)
                 for p in ('1e6', '1e8', '1e10', '1e12')]
    write_case(os.path.join(HERE, name), scene, analysis(0.01, 1380, FRICTION, displacement_ratio=0.1), expected, about,
               slow=True, variants=variants)


one = rectangle(0, -DEPTH, 300, 0)
case('one_slope', [(one, 0, 300)], 'a block of 2 m slides 250 m down a slope (benchmark dda-10)')
case('four_edges', [(one[:3] + [(s, 0) for s in JOINTS[3:0:-1]] + one[3:], 0, 300)],
     'the same slope with four edges in one line: the block crosses three vertices of the base (benchmark dda-10)')
case('four_slabs', [(rectangle(s0, -DEPTH, s1, 0), s0, s1) for s0, s1 in zip(JOINTS, JOINTS[1:])],
     'the same slope of four slabs: the block crosses three joints of the base (benchmark dda-10)')
