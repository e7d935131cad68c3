"""Writes the files of a case (block file, Shi's analysis file, expected.csv, case.json) for the make_input.py of the cases.

Layouts: formats/shi/dda_blocks.hpp and formats/shi/dda_analysis.hpp. Python 3, standard library only.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import json
import math
import os


def number(value):
    return repr(round(value, 12) + 0.0) if isinstance(value, float) else str(value)


def line(*values):
    return ' '.join(number(v) for v in values) + '\n'


def area_and_centroid(polygon):
    area = x = y = 0.0
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
        cross = x0 * y1 - x1 * y0
        area += cross / 2
        x += (x0 + x1) * cross / 6
        y += (y0 + y1) * cross / 6
    return area, (x / area, y / area)


class Scene:
    """Blocks and points, numbered from 1 in the order they are added."""

    def __init__(self):
        self.blocks, self.fixed, self.loading, self.measured = [], [], [], []

    def block(self, polygon, material=1, joints=1):
        """Corners counter-clockwise; `joints` is one joint material or one an edge, edge i from corner i to i + 1."""
        polygon = [(float(x), float(y)) for x, y in polygon]
        assert area_and_centroid(polygon)[0] > 0, 'corners must run counter-clockwise'
        if isinstance(joints, int):
            joints = [joints] * len(polygon)
        self.blocks.append((material, polygon, joints))
        return len(self.blocks)

    def fixed_block(self, polygon, material=1, joints=1):
        """A block held by two points, half way from its centroid to two of its corners."""
        block = self.block(polygon, material, joints)
        polygon = self.blocks[-1][1]
        centre = area_and_centroid(polygon)[1]
        for corner in (polygon[0], polygon[len(polygon) // 2]):
            self.fixed.append(((corner[0] + centre[0]) / 2, (corner[1] + centre[1]) / 2, block))
        return block

    def load_at(self, x, y, block):
        self.loading.append((x, y, block))

    def text(self):
        slots, ranges, vertices = 0, '', ''
        for material, polygon, joints in self.blocks:
            ranges += line(material, slots + 1, slots + len(polygon))
            slots += len(polygon) + 4
            arriving = joints[-1:] + joints[:-1]
            for joint, (x, y) in zip(arriving + arriving[:1], polygon + polygon[:1]):
                vertices += line(joint, x, y)
            area, (x, y) = area_and_centroid(polygon)
            radius = max(math.hypot(px - x, py - y) for px, py in polygon)
            vertices += line(0, radius, area) + line(0, area * x, area * y) + line(0, x, y)
        head = line(len(self.blocks), 0, slots) + line(len(self.fixed), len(self.loading), len(self.measured))
        points = ''.join(line(kind, float(x), float(y), block) for kind, points in
                         ((0, self.fixed), (2, self.loading), (1, self.measured)) for x, y, block in points)
        return head + ranges + vertices + points


def rock(density=2600.0, youngs_modulus=5e9, poissons_ratio=0.25, weight=None, velocity=(0.0, 0.0, 0.0), gravity=9.81):
    """A block material: mass and weight per area, E, nu, no stress, start velocity."""
    weight = density * gravity if weight is None else weight
    return (density, weight, youngs_modulus, poissons_ratio) + (0.0,) * 6 + tuple(velocity)


def analysis_text(scene, steps, time_step, rocks, joints, penalty=5e10, carry_over=1.0, curves=None, ratio=0.01):
    """Shi's analysis file. `joints`: (friction angle, cohesion, tensile strength). `curves`: {point: rows (t, x, y)}, points
    counted from 0, fixed ones first."""
    curves = curves or {}
    counts = [len(curves.get(i, ())) for i in range(len(scene.fixed) + len(scene.loading))]
    text = line(carry_over) + line(steps) + line(len(rocks), len(joints)) + line(ratio) + line(time_step) + line(penalty)
    text += line(*counts)
    for i in sorted(curves):
        text += ''.join(line(*map(float, row)) for row in curves[i])
    for r in rocks:
        text += line(*r[:4]) + line(*r[4:7]) + line(*r[7:10]) + line(*r[10:])
    for joint in joints:
        text += line(*map(float, joint))
    return text


CONSTANT = {'step_control': 'constant', 'penalty_control': 'constant'}


def write_case(folder, scene, analysis, expected, about, **case):
    """Writes a case folder. `expected`: (quantity, block, time, value, tolerance, reason, source[, judged[, listed miss]])."""
    os.makedirs(folder, exist_ok=True)
    name = os.path.join(folder, os.path.basename(os.path.normpath(folder)))
    with open(name + '.blk', 'w') as file:
        file.write(scene.text())
    with open(name + '.ana', 'w') as file:
        file.write(analysis)
    columns = ['quantity', 'block', 'time', 'value', 'tolerance', 'tolerance_reason', 'source', 'judged']
    if any(len(row) > len(columns) for row in expected):
        columns.append('listed_miss')
    with open(os.path.join(folder, 'expected.csv'), 'w', newline='') as file:
        table = csv.writer(file, lineterminator='\n')
        table.writerow(columns)
        for row in expected:
            row = ['%.10g' % (v + 0.0) if isinstance(v, float) else v for v in row]
            if len(row) < 8:
                row.append('standard')
            table.writerow(row + [''] * (len(columns) - len(row)))
    overrides = case.pop('set', {})
    overrides['both'] = {**CONSTANT, **overrides.get('both', {})}
    with open(os.path.join(folder, 'case.json'), 'w') as file:
        json.dump({'about': about, 'set': overrides, **case}, file, indent=1, ensure_ascii=False)
        file.write('\n')


def reduced(strength_factor):
    """Strength of all joints times a factor, in both profiles."""
    return {'both': {'joint_strength_factor': repr(strength_factor)}}
