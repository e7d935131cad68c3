"""Writes the cases of voussoir_beam: two halves that hold each other between fixed abutments, as one block each or elastic.

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


UNIT_WEIGHT = 25e3
GLUE = 1e12  # cohesion and tensile strength, N/m2: the bond never fails
DAMPING = '10'  # of mass, 1/s: the sag is that at rest


def half_beam(span, depth, columns, rows):
    """The left half between its abutment and the plane of symmetry, as triangles glued together: rectangles in rows and columns,
    each cut along both diagonals. Joints: 1 smooth walls and seat, 2 glue."""
    scene, seat = Scene(), 0.02 * depth
    end, a, b = span / 2 + seat, span / 2 / columns, depth / rows
    for i in range(columns):
        for j in range(rows):
            left, right = (-end if i == 0 else i * a - span / 2), (i + 1) * a - span / 2
            corners = [(left, j * b), (right, j * b), (right, (j + 1) * b), (left, (j + 1) * b)]
            outer = [1 if j == 0 else 2, 1 if i + 1 == columns else 2, 2, 1 if i == 0 else 2]
            for k in range(4):
                last = scene.block([corners[k], corners[(k + 1) % 4], ((left + right) / 2, (j + 0.5) * b)], 1, [outer[k], 2, 2])
    scene.fixed_block([(-end - 1, -depth), (-end, -depth), (-end, 2 * depth), (-end - 1, 2 * depth)], 2)
    scene.fixed_block([(-end, -depth), (-span / 2, -depth), (-span / 2, 0), (-end, 0)], 2)
    scene.fixed_block([(0, -8 * depth), (1, -8 * depth), (1, 2 * depth), (0, 2 * depth)], 2)
    scene.measured.append((0.0, depth, last - 1))
    return scene


def elastic(name, span, depth, modulus, columns, rows, expected, about, steps, step, **case):
    scene = half_beam(span, depth, columns, rows)
    rocks = [rock(UNIT_WEIGHT / 9.81, e, 0.0, weight=UNIT_WEIGHT) for e in (modulus, 1e3 * modulus)]
    write_case(os.path.join(HERE, name), scene,
               analysis_text(scene, steps, step, rocks, [(0, 0, 0), (45, GLUE, GLUE)], penalty=100 * modulus), expected, about,
               set={'standard': {'enforcement': 'penalty', 'mass_damping': DAMPING}},
               legacy='not run: its open-close passes go round in the glue', **case)


def sags(name, span, depth, modulus, columns, rows, sag, scheme):
    source = 'finite elements, large displacements (elastic_halves.py): sag of the crown %.5f m; scheme of the benchmark %s' % (sag, scheme)
    elastic(name, span, depth, modulus, columns, rows,
            [('point_dy', 1, 1.0, -sag, 0.2 * sag, 'asked for: 20 % of the sag; constant strain in a block is too stiff', source)],
            'sag of an elastic voussoir beam, span %g m, depth %g m' % (span, depth), 20, 0.05, slow=True)


three_hinge()
sags('elastic_slender', 10.0, 0.5, 5e9, 28, 3, 0.01714, '0.02322 m')
sags('elastic_stout', 10.0, 1.0, 5e9, 20, 5, 0.00455, '0.00577 m')
elastic('low_stands', 7.0, 0.25, 2e9, 24, 2,
        [('point_dy', 1, 2.0, -0.05732 / 2, 0.0286, 'verdict: it stands, between no sag and that of finite elements',
          'finite elements (elastic_halves.py): it stands down to E = 1.8e9 Pa, sag 0.05732 m; scheme of the benchmark: it falls')],
        'a low elastic voussoir beam that just stands', 40, 0.05)
elastic('low_snaps', 7.0, 0.25, 0.5e9, 12, 2,
        [('point_dy', 1, 0.8, -(0.25 + 0.5 * 9.81 * 0.8 ** 2) / 2, (0.5 * 9.81 * 0.8 ** 2 - 0.25) / 2,
          'verdict: below its depth, and not beyond free fall',
          'finite elements (elastic_halves.py): no equilibrium; scheme of the benchmark: it falls')],
        'a low elastic voussoir beam that snaps through', 40, 0.02)
