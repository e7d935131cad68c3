"""Whether an arch of voussoirs stands: is there a line of thrust that presses on every joint and slides on none?

The force on the left springing (two components and a moment) is unknown; equilibrium gives those on all other joints. Pressure at
both corners and friction are linear in the three unknowns: a linear programme (Heyman 1969; Livesley 1978).
SPDX-License-Identifier: GPL-3.0-or-later
"""
import math

from old_files import area_and_centroid

FRICTION = 1.0  # 45 degrees: a friction coefficient of 10 gives the same limits, no joint slides


def joint_angles(count, half_angle):
    """From the left springing to the right one, radians from the x axis."""
    return [math.radians(90 + half_angle - 2 * half_angle * i / count) for i in range(count + 1)]


def voussoir(left, right, thickness):
    """Corners counter-clockwise, straight edges, mean radius 1."""
    inner, outer = 1 - thickness / 2, 1 + thickness / 2
    return [(r * math.cos(a), r * math.sin(a)) for r, a in ((inner, left), (inner, right), (outer, right), (outer, left))]


def conditions(count, half_angle, thickness, coefficient):
    """Rows (g, h) of g · x >= h, x = force (fx, fy, moment about the centre) on the left springing; weight 1 per area."""
    inner, outer = 1 - thickness / 2, 1 + thickness / 2
    angles, load, rows = joint_angles(count, half_angle), [0.0, 0.0, 0.0], []
    for k, angle in enumerate(angles):
        cosine, sine = math.cos(angle), math.sin(angle)
        normal, shear = (sine, -cosine, 0), (cosine, sine, 0)
        for g in ([-(inner * n) for n in normal[:2]] + [-1], [outer * n for n in normal[:2]] + [1],
                  [FRICTION * n - s for n, s in zip(normal, shear)], [FRICTION * n + s for n, s in zip(normal, shear)]):
            rows.append((g, -sum(a * b for a, b in zip(g, load))))
        if k < count:
            area, (x, y) = area_and_centroid(voussoir(angle, angles[k + 1], thickness))
            for i, part in enumerate((coefficient * area, -area, -area * x - coefficient * area * y)):
                load[i] += part
    return rows


def is_feasible(rows):
    """Farkas: no x meets g · x >= h if some y >= 0 has sum of y g = 0 and sum of y h > 0. Simplex on that, Bland's rule."""
    table = [[s * g[i] for g, _ in rows] + [0.0] for i in range(3) for s in (1, -1)] + [[1.0] * (len(rows) + 1)]
    table = [row[:-1] + [float(i == j) for j in range(7)] + row[-1:] for i, row in enumerate(table)]
    cost, basis = [-h for _, h in rows] + [0.0] * 8, [len(rows) + i for i in range(7)]
    while True:
        entering = next((j for j, c in enumerate(cost[:-1]) if c < -1e-12), None)
        if entering is None:
            return cost[-1] < 1e-9
        ratios = [(row[-1] / row[entering], basis[i], i) for i, row in enumerate(table) if row[entering] > 1e-12]
        _, _, leaving = min(ratios)
        pivot = [v / table[leaving][entering] for v in table[leaving]]
        table = [pivot if i == leaving else [a - row[entering] * b for a, b in zip(row, pivot)]
                 for i, row in enumerate(table)]
        cost = [a - cost[entering] * b for a, b in zip(cost, pivot)]
        basis[leaving] = entering


def threshold(low, high, is_low):
    for _ in range(30):
        middle = (low + high) / 2
        low, high = (middle, high) if is_low(middle) else (low, middle)
    return (low + high) / 2


def least_thickness(count, half_angle):
    return threshold(0.02, 0.5, lambda t: not is_feasible(conditions(count, half_angle, t, 0.0)))


def greatest_coefficient(count, half_angle, thickness):
    return threshold(0.0, 2.0, lambda k: is_feasible(conditions(count, half_angle, thickness, k)))
