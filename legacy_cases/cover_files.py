"""Case files of bodies on covers, for the make_input.py of their cases.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import json
import math
import os


def rectangle(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def arc(radius, start, end, chords=64):
    """Corners on a circle about the origin, both ends included; angles in degrees, the axes met exactly."""
    points = []
    for i in range(chords + 1):
        angle = math.radians(start + (end - start) * i / chords)
        x, y = radius * math.cos(angle), radius * math.sin(angle)
        points.append((0.0 if abs(x) < 1e-12 else x, 0.0 if abs(y) < 1e-12 else y))
    return points


def about_tunnel(finer=False):
    """A mesh about a quarter of a hole of radius 1, graded to far beyond where rock flows: rings of radius, side, parts of a quarter. The elastic
    ring counts as much as the wall: what it gives is what flow about the hole grows from."""
    rings = ((1, 0.05, 24), (1.5, 0.08, 24), (2.2, 0.13, 24), (3.5, 0.22, 18), (6, 0.4, 16), (11, 0.8, 12)) if finer else (
        (1, 0.07, 12), (1.5, 0.1, 12), (2.2, 0.18, 12), (3.5, 0.3, 12), (6, 0.55, 12), (11, 1.1, 8))
    return {'kind': 'unstructured', 'placement': 'aligned', 'side': 4,
            'refined': [(radius * x, radius * y, side) for radius, side, parts in rings for x, y in arc(1, 0, 90, parts)]}


def about_edge_of_footing():
    """Where a mesh is refined about the edge at (1, 0) of a footing, and where the soil is sheared below and beside it."""
    return [(1, 0, 0.012)] + [(x, y, 0.05) for x in (0.5, 0.9, 1.3, 1.7, 2.1) for y in (-0.2, -0.55)]


def case_text(corners, covers, young, poisson, measured, plane_strain=False, density=1, steps=(1, 1), settings=None, velocity=None, strength=None):
    """One body of one weightless material, `steps` (count, size) of load; in time where `settings` are those of the run. `velocity`: that of the
    start, of the centroid, and the rate of rotation. `strength`: of rock that may yield."""
    blocks = {'blocks': [{'outer': [[x, y, 1] for x, y in corners]}],
              'measured_points': [[x, y, 1] for x, y in measured]}
    analysis = {'step_count': steps[0], 'time_step': steps[1], 'allowed_displacement_ratio': 0.1 if velocity is None else 1, 'plane_strain': plane_strain,
                'block_materials': [{'density': density, 'unit_weight': 0, 'youngs_modulus': young, 'poissons_ratio': poisson}],
                'joint_materials': [{}]}
    if strength:
        analysis['block_materials'][0]['strength'] = strength
    if velocity:
        analysis['block_materials'][0]['initial_velocity'] = list(velocity)
    parts = [('keyblock', 1), ('blocks', blocks), ('covers', covers), ('analysis', analysis)]
    if settings is not None:
        analysis['velocity_carry_over'] = 1
        parts.append(('run', {'set': settings}))
    return '{\n' + ',\n'.join(' "%s": %s' % (key, laid_out(value, 1)) for key, value in parts) + '\n}\n'


def laid_out(value, depth):
    """Objects and lists of objects or rows by lines, else on one line; long rows of numbers are broken."""
    pad = ' ' * depth
    if isinstance(value, dict) and depth < 3:
        return '{\n' + ',\n'.join('%s %s: %s' % (pad, json.dumps(k), laid_out(v, depth + 1)) for k, v in value.items()) + '\n' + pad + '}'
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return '[\n' + ',\n'.join(pad + ' ' + laid_out(v, depth + 1) for v in value) + '\n' + pad + ']'
    if isinstance(value, dict):
        return '{' + ', '.join('%s: %s' % (json.dumps(k), laid_out(v, depth + 1)) for k, v in value.items()) + '}'
    text = json.dumps(value)
    if len(text) < 110 or not isinstance(value, list):
        return text
    lines, line = [], ''
    for row in value:
        part = json.dumps(row)
        if line and len(line) + len(part) > 100:
            lines.append(line)
            line = ''
        line += (', ' if line else '') + part
    lines.append(line)
    return '[' + (',\n' + pad + '  ').join(lines) + ']'


def write_case(folder, text, values, about, variants=(), slow=False, missed=None):
    """`values`: quantity, point, value, tolerance, reason of it, source, and the time where it is not 1. `variants`: name, settings,
    tolerance, reason. `missed`: of values by their index, why they are known to be missed."""
    os.makedirs(folder, exist_ok=True)
    name = os.path.basename(folder)
    with open(os.path.join(folder, name + '.json'), 'w') as file:
        file.write(text)
    with open(os.path.join(folder, 'expected.csv'), 'w', newline='') as file:
        rows = csv.writer(file, lineterminator='\n')
        rows.writerow(['quantity', 'block', 'time', 'value', 'tolerance', 'tolerance_reason', 'source', 'judged'] + (['listed_miss'] if missed else []))
        for i, (quantity, point, value, tolerance, reason, source, *time) in enumerate(values):
            rows.writerow([quantity, point, *(time or [1]), repr(float(value)), '%.6g' % tolerance, reason, source, 'standard'] +
                          ([missed.get(i, '')] if missed else []))
    case = {'about': about, 'legacy': 'not run: bodies on covers are run by profile standard'}
    if slow:
        case['slow'] = True
    if variants:
        case['variants'] = [{'name': n, 'profile': 'standard', 'set': s, 'tolerance': t, 'reason': r} for n, s, t, r in variants]
    with open(os.path.join(folder, 'case.json'), 'w') as file:
        file.write(json.dumps(case, indent=1) + '\n')


# Turned and shifted against every body here, so that nothing is aligned.
def free_mesh(side):
    return {'side': side, 'angle': 10, 'through_x': 0.0137, 'through_y': 0.0071}
