"""Writes the cases of two_block_slope: an upper block pushes a lower one through a vertical joint.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from old_files import Scene, analysis_text, area_and_centroid, reduced, rock, write_case  # noqa: E402

G = 9.81
HEEL = 0.1  # m cut off the lower block's heel, so that it does not stand in the kink
CHAMFER = 0.5  # m of the upper block's base cut off at the kink, so that it can slide on without entering the lower plane


STRAIN = 'elastic strain of the blocks'
RIGID = {'name': 'rigid blocks', 'profile': 'standard', 'set': {'basis': 'rigid'}, 'tolerance': 1e-6,
         'reason': 'exact but for the geometry that the file rounds'}


def tangent(degrees):
    return math.tan(math.radians(degrees))


def factor_of_safety(w1, psi1, phi1, w2, psi2, phi2, phi12):
    """F with Q1 = Q2, the force between the blocks from the equilibrium of either, all friction tangents divided by F."""
    def gap(factor):
        p1, p2, d = (math.atan(tangent(p) / factor) for p in (phi1, phi2, phi12))
        s1, s2 = math.radians(psi1), math.radians(psi2)
        return w1 * math.sin(s1 - p1) / math.cos(s1 - p1 - d) - w2 * math.sin(p2 - s2) / math.cos(p2 - s2 + d)
    low, high = 1.0, 2.0  # gap < 0: holds
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if gap(middle) < 0 else (low, middle)
    return low


def acceleration(w1, psi1, mu1, w2, psi2, mu2, mu12):
    """Accelerations of both blocks down their planes, the joint between them closed and every joint sliding."""
    s1, c1, s2, c2 = (f(math.radians(p)) for p in (psi1, psi2) for f in (math.sin, math.cos))
    ratio = c1 / c2  # a2 / a1

    def residual(a, n1, q):
        m1, m2 = w1 / G, w2 / G
        x1 = n1 * s1 - mu1 * n1 * c1 - q - m1 * a * c1
        y1 = n1 * c1 + mu1 * n1 * s1 + mu12 * q - w1 + m1 * a * s1
        n2 = (w2 + mu12 * q - m2 * a * ratio * s2) / (c2 + mu2 * s2)
        x2 = n2 * s2 - mu2 * n2 * c2 + q - m2 * a * ratio * c2
        return [x1, y1, x2]

    zero = residual(0, 0, 0)
    columns = [[r - z for r, z in zip(residual(*unit), zero)] for unit in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    a = determinant([[-z for z in zero], columns[1], columns[2]]) / determinant(columns)
    return (a, a * ratio) if a > 0 else (0.0, 0.0)


def determinant(m):
    return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))


def scene_of(psi1, psi2, d, h, length, toe):
    """Upper block over the plane psi1 left of the kink (0, 0), lower block right of it; joint 3 between them."""
    t1, t2 = tangent(psi1), tangent(psi2)
    scene = Scene()
    scene.block([(-CHAMFER, CHAMFER * t1), (0, CHAMFER * t1 + 0.3), (0, h), (-d, d * t1)], 1, [1, 3, 1, 1])
    scene.block([(0, HEEL), (HEEL, -HEEL * t2), (length, -length * t2), (length, toe), (0, h)], 2, [2, 2, 2, 2, 3])
    left, right = d + 2, length + 10
    scene.fixed_block([(-left, left * t1), (-left, -6), (right, -6), (right, -right * t2), (0, 0)], 3, [1, 1, 1, 2, 1])
    return scene


def weighing(weight, scene, block):
    unit = weight * 1e3 / area_and_centroid(scene.blocks[block - 1][1])[0]
    return rock(density=unit / G, weight=unit)


def case(name, data, shape, share, time=1.0):
    w1, psi1, phi1, w2, psi2, phi2, phi12 = data
    safety = factor_of_safety(*data)
    factor = share * safety
    scene = scene_of(psi1, psi2, *shape)
    a = acceleration(w1, psi1, tangent(phi1) / factor, w2, psi2, tangent(phi2) / factor, tangent(phi12) / factor)
    source = 'limit equilibrium: factor of safety %.5f; reduced by %.2f of it: %s' % (
        safety, share, 'two sliding blocks, a = %.5g and %.5g' % a if a[0] else 'at rest')
    expected = []
    for block in (1, 2):
        if a[0]:
            expected += [('displacement', block, t, a[block - 1] * t * t / 2, 2e-3 * a[block - 1] * t * t / 2 + 1e-4,
                          STRAIN + '; 2 % of the factor of safety, as asked for, would be the whole displacement', source)
                         for t in (time / 2, time)]
        else:
            expected += [('displacement', block, time, 0.0, 1e-4, STRAIN, source), ('speed', block, time, 0.0, 1e-6, 'at rest', source)]
    steps = round(time / 0.002)
    write_case(os.path.join(HERE, name), scene,
               analysis_text(scene, steps, 0.002, [weighing(w1, scene, 1), weighing(w2, scene, 2), rock()],
                             [(phi1, 0, 0), (phi2, 0, 0), (phi12, 0, 0)], penalty=5e9), expected,
               'two blocks at %.2f of their factor of safety %.4f' % (share, safety), set=reduced(1 / factor),
               variants=[RIGID])


def wedge_pair(phi, time=0.8):
    """The wedge pair of berkeley_tables/wedge2.csv: a trapezium on 45 degrees pushes a block on the level."""
    scene = Scene()
    scene.block([(9, 1), (10, 1), (10, 3), (7, 3)])
    scene.block([(10, HEEL), (10 + HEEL, 0), (12, 0), (12, 3), (10, 3)])
    scene.fixed_block([(0, 10), (0, -2), (30, -2), (30, 0), (10, 0)])
    a = acceleration(4 * 2.5 * G, 45, tangent(phi), (6 - HEEL ** 2 / 2) * 2.5 * G, 0, tangent(phi), tangent(phi))
    expected = [('dx', block, t, a[1] * t * t / 2, 1e-4 * a[1] * t * t / 2 + 1e-5, STRAIN,
                 'two sliding blocks, horizontal acceleration %.6g of both' % a[1]) for block in (1, 2) for t in (time / 2, time)]
    write_case(os.path.join(HERE, 'wedge_p%02d' % phi), scene,
               analysis_text(scene, 800, 0.001, [rock(2500)], [(phi, 0, 0)], penalty=5e9), expected,
               'a trapezium on 45 degrees pushes a block on the level, friction %d degrees everywhere' % phi, variants=[RIGID])


ROWS = {'smooth_joint': ((1000, 50, 30, 1500, 10, 30, 0), (6, 8, 9, 4)),
        'rough_joint': ((1000, 50, 30, 1500, 10, 30, 20), (6, 8, 9, 4)),
        'steep': ((600, 60, 35, 1000, 5, 25, 30), (4, 7, 9, 4))}
for row, (data, shape) in ROWS.items():
    case(row + '_stands', data, shape, 0.98)
    case(row + '_slides', data, shape, 1.02)
for angle in (0, 5, 10, 15):
    wedge_pair(angle)
