"""Writes the cases of cantilever: a beam of bonded sub-blocks, clamped at one end and loaded at the other.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
import cover_files  # noqa: E402
from old_files import Scene, analysis_text, rock, write_case  # noqa: E402

LENGTH, DEPTH, LOAD, MODULUS, POISSON = 8.0, 1.0, 1e5, 2e10, 0.25
GLUE = 1e12  # cohesion and tensile strength, N/m2: the bond never fails


def exact_tip():
    """Timoshenko and Goodier, Theory of Elasticity, art. 21, plane stress, unit width, the clamped section held from warping at mid-depth."""
    inertia = DEPTH ** 3 / 12
    return LOAD * LENGTH ** 3 / (3 * MODULUS * inertia) + LOAD * (4 + 5 * POISSON) * DEPTH ** 2 * LENGTH / (24 * MODULUS * inertia)


def scene_of(columns, rows):
    scene = Scene()
    a, b = LENGTH / columns, DEPTH / rows
    for i in range(columns):
        for j in range(rows):
            scene.block([(i * a, j * b), ((i + 1) * a, j * b), ((i + 1) * a, (j + 1) * b), (i * a, (j + 1) * b)])
    scene.fixed_block([(-1, -1), (0, -1), (0, DEPTH + 1), (-1, DEPTH + 1)], 2)
    last = rows * (columns - 1)
    for j in range(rows):
        scene.load_at(LENGTH, (j + 0.5) * b, last + j + 1)
    scene.measured.append((LENGTH, DEPTH / 2, last + rows // 2))
    return scene


def case(columns, rows, share, penalty, listed_miss=''):
    scene = scene_of(columns, rows)
    tip = exact_tip()
    first = len(scene.fixed)
    curves = {first + j: [(0, 0, -LOAD / rows), (1e6, 0, -LOAD / rows)] for j in range(rows)}
    write_case(os.path.join(HERE, 'blocks_%dx%d' % (columns, rows)), scene,
               analysis_text(scene, 3, 1.0, [rock(2500, MODULUS, POISSON, weight=0.0), rock(2500, MODULUS * 1e3, 0.0, weight=0.0)],
                             [(45, GLUE, GLUE)], penalty=penalty, carry_over=0.0, curves=curves),
               [('point_dy', 1, 3.0, -tip, share * tip, 'asked for: %g %%' % (100 * share),
                 'Timoshenko and Goodier: tip of a cantilever under a shear load, plane stress, %.6f m' % tip, 'standard', listed_miss)],
               'a cantilever of %d x %d bonded sub-blocks' % (columns, rows), set={'standard': {'enforcement': 'penalty'}})


def on_covers():
    """The mass as one body on covers, two rows of triangles in its height, as wide as the sub-blocks of 16 x 4."""
    covers = {'functions': 'derived', 'mesh': {'side': 0.5, 'angle': 10, 'through_x': 0.0137, 'through_y': 0.0071},
              'displacements': [{'along': [(0, DEPTH), (0, 0)]}],
              'tractions': [{'along': [(LENGTH, 0), (LENGTH, DEPTH)], 'y': -LOAD / DEPTH}]}
    text = cover_files.case_text(cover_files.rectangle(0, 0, LENGTH, DEPTH), covers, MODULUS, POISSON, [(LENGTH, DEPTH / 2)])
    tip = 0.0103422763779
    reason = 'asked for: 5 % with 32 x 8 sub-blocks, 20 % with 16 x 4'
    cover_files.write_case(os.path.join(HERE, 'on_covers'), text,
                           [('point_dy', 1, -tip, 0.05 * tip, reason, 'clamped finite elements: 0.0103423 (Timoshenko and Goodier, free to warp: 0.010345)')],
                           'the same cantilever as one body on covers',
                           [(f, {'functions': f}, 0.05 * tip, reason) for f in ('linear', 'quadratic')])


if __name__ == '__main__':
    print(exact_tip())
    factor = float(sys.argv[1]) if len(sys.argv) > 1 else 1
    stiff = 'a block of one strain, glued all along its sides, does not bend: coarse masses bend in their springs alone'
    case(8, 2, 0.2, factor * MODULUS, stiff + ' (no figure is asked for 8 x 2: held against that of 16 x 4)')
    case(16, 4, 0.2, factor * MODULUS, stiff)
    case(32, 8, 0.05, factor * MODULUS)
    on_covers()
