"""Writes the cases of crack_closure (pla-12).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import json
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import case_text, laid_out, rectangle, write_case  # noqa: E402

OPEN, INTACT, CLOSED, STRENGTH = 10e3, 30e3, 5e-4, 80  # MPa
CLOSURE = {'initial_modulus': OPEN, 'closure_strain': CLOSED}
YIELDS = {'surface': 'von_mises', 'yield_stress': STRENGTH}
SOURCE = 'pla-12: E1 up to the closure strain, then E2, up to the strength'


def elastic(strain):
    """Compression positive."""
    return OPEN * min(strain, CLOSED) + INTACT * max(strain - CLOSED, 0)


def pressed(strains):
    """Stress at each of the strains in turn: what flows stays behind."""
    flowed, stresses = 0, []
    at_strength = CLOSED + (STRENGTH - OPEN * CLOSED) / INTACT
    for strain in strains:
        flowed = max(flowed, strain - at_strength)
        stresses.append(elastic(strain - flowed))
    return stresses


def plate():
    corners = rectangle(0, 0, 1, 1)
    steps, part = 8, 5e-4
    covers = {'mesh': {'side': 0.25, 'angle': 10, 'through_x': 0.0137, 'through_y': 0.0071},
              'displacements': [{'along': [(0, 0), (1, 0)], 'held': 'normal'}, {'along': [(0, 1), (0, 0)], 'held': 'normal'},
                                {'along': [(1, 1), (0, 1)], 'held': 'normal', 'normal': -steps * part}]}
    text = case_text(corners, covers, INTACT, 0.25, [(0.6, 0.7)], steps=(steps, 1), strength=YIELDS)
    case = json.loads(text)
    case['analysis']['block_materials'][0]['crack_closure'] = CLOSURE
    text = '{\n' + ',\n'.join(' "%s": %s' % (key, laid_out(value, 1)) for key, value in case.items()) + '\n}\n'
    values = []
    for i in range(1, steps + 1):
        stretch = 1 - i * part
        nominal = min(elastic(-math.log(stretch)), STRENGTH) / stretch
        reason = '1e-4 of the strength: edges are held by springs, which give by 5e-5 of the strain'
        values.append(('reaction_y', 3, -nominal, 1e-4 * STRENGTH, reason, SOURCE, i))
    write_case(os.path.join(HERE, 'plate'), text, values, 'a plate with cracks that close, pressed along one axis onto its plateau')


def block():
    strains = [2.5e-4, 5e-4, 1e-3, 2e-3, 1e-3, 5e-4, 2.5e-4, 0, 1e-3, 2e-3, 3e-3, 4e-3, 3e-3, 1.5e-3, 1e-3, 1.5e-3, 4e-3, 5e-3]
    rows = [[t, 0, -e] for t, e in enumerate([0] + strains)]
    blocks = {'blocks': [{'outer': [[x, y, 1] for x, y in rectangle(0, 0, 1, 1)]}],
              'fixed_points': [[0.5, 0, 1], [0.5, 1, 1]]}
    material = {'density': 1, 'unit_weight': 0, 'youngs_modulus': INTACT, 'poissons_ratio': 0.25, 'crack_closure': CLOSURE,
                'strength': YIELDS}
    analysis = {'velocity_carry_over': 0, 'step_count': len(strains), 'time_step': 1, 'allowed_displacement_ratio': 0.1,
                'plane_strain': False, 'block_materials': [material], 'joint_materials': [{}],
                'fixed_point_motions': [[], rows]}
    folder = os.path.join(HERE, 'block')
    os.makedirs(folder, exist_ok=True)
    parts = [('keyblock', 1), ('blocks', blocks), ('analysis', analysis)]
    with open(os.path.join(folder, 'block.json'), 'w') as file:
        file.write('{\n' + ',\n'.join(' "%s": %s' % (key, laid_out(value, 1)) for key, value in parts) + '\n}\n')
    with open(os.path.join(folder, 'expected.csv'), 'w', newline='') as file:
        rows = csv.writer(file, lineterminator='\n')
        rows.writerow(['quantity', 'block', 'time', 'value', 'tolerance', 'tolerance_reason', 'source', 'judged'])
        for i, stress in enumerate(pressed(strains)):
            rows.writerow(['syy', 1, i + 1, repr(float(-stress)), '%.6g' % (1e-6 * STRENGTH), '1e-6 of the strength', SOURCE, 'standard'])
    with open(os.path.join(folder, 'case.json'), 'w') as file:
        file.write(json.dumps({'about': 'a block with cracks that close, driven to and fro along one axis, static',
                               'legacy': 'not run: rock stays linear elastic under the rules of the old programs'}, indent=1) + '\n')


plate()
block()
