"""Writes the cases of strength_reduction: slopes of rock that yields (pla-09), and blocks on joints, with their factors of safety.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
import cover_files  # noqa: E402
import old_files  # noqa: E402
from old_files import Scene, analysis_text, area_and_centroid, rock  # noqa: E402

G = 9.81
HEEL, CHAMFER = 0.1, 0.5  # as in two_block_slope


def tangent(degrees):
    return math.tan(math.radians(degrees))


def slope(name, corners, held, strength, gamma, mesh, search, value, tolerance, reason, source, about, poisson=0.3, slow=False):
    """A slope of height 10 under its weight, which comes on in four parts; E is 1e5."""
    text = json.loads(cover_files.case_text(corners, {'mesh': mesh, 'displacements': held}, 1e5, poisson, [corners[-1]], plane_strain=True,
                                            density=gamma / G, steps=(4, 1), strength=strength))
    text['analysis']['block_materials'][0]['unit_weight'] = gamma
    folder = os.path.join(HERE, name)
    cover_files.write_case(folder, cover_files.laid_out(text, 0) + '\n', [('factor_of_safety', '', value, tolerance, reason, source, 0)], about, slow=slow)
    with_search(folder, dict(search, what='rock'))


def with_search(folder, search):
    path = os.path.join(folder, 'case.json')
    with open(path) as file:
        case = json.load(file)
    case.pop('set', None)  # of steps in time
    case['reduce_strength'] = {key: search[key] for key in ('what', 'from', 'to', 'to_within') if key in search}
    with open(path, 'w') as file:
        file.write('{\n' + ',\n'.join(' %s: %s' % (json.dumps(k), json.dumps(v)) for k, v in case.items()) + '\n}\n')


def rollers(right, height, toe=0.0):
    held = [{'along': [[0, -toe], [right, -toe]]}, {'along': [[right, -toe], [right, height]], 'held': 'normal'}]
    return held + ([{'along': [[0, -toe], [0, 0]], 'held': 'normal'}] if toe else [])


def mesh(side):
    return {'kind': 'unstructured', 'placement': 'aligned', 'side': side}


def coulomb(cohesion, phi, psi):
    return {'surface': 'mohr_coulomb', 'cohesion': cohesion, 'friction_deg': phi, 'dilation_deg': psi}


GRIFFITHS = 'finite elements 1.4, Bishop 1.38 (Griffiths & Lane 1999, example 1); log-spiral 1.368 (Chen 1975)'
TWO_TO_ONE = [(0, 0), (32, 0), (32, 10), (20, 10)]


def rock_slopes():
    for name, psi in (('two_to_one', 20), ('two_to_one_psi_0', 0)):
        slope(name, TWO_TO_ONE, rollers(32, 10), coulomb(10, 20, psi), 20, mesh(1.0), {}, 1.39, 0.03, 'band asked for: 1.36 to 1.42', GRIFFITHS,
              'slope 2:1, friction 20 degrees, c = 0.05 gamma H, dilation %d degrees (pla-09 A)' % psi)
    slope('forty_five', [(0, 0), (25, 0), (25, 10), (10, 10)], rollers(25, 10), coulomb(12.38, 20, 20), 20, mesh(1.0), {'from': 0.7}, 1.01, 0.02,
          'band asked for: 0.99 to 1.03', 'limit analysis 1.00 (Dawson, Roth & Drescher 1999); log-spiral 1.0002 (Chen 1975)',
          'slope of 45 degrees, friction 20 degrees, c = 12.38 (pla-09 B)')
    slope('acads', TWO_TO_ONE, rollers(32, 10), coulomb(3, 19.6, 19.6), 20, mesh(0.8), {'from': 0.7}, 0.995, 0.025, 'band asked for: 0.97 to 1.02',
          'referee value 1.00 (Donald & Giam 1989); log-spiral 0.9845 (Chen 1975)', 'slope 2:1, friction 19.6 degrees, c = 3 (pla-09 C)', slow=True)
    # Undrained: c so that gamma H / c is 3.83 at F = 1. The rigorous bracket is 3.772 to 3.786.
    slope('vertical_cut', [(0, -10), (30, -10), (30, 10), (10, 10), (10, 0), (0, 0)], rollers(30, 10, 10),
          {'surface': 'tresca', 'cohesion': 200 / 3.83173}, 20, mesh(1.0), {'from': 0.7}, 1.0, 0.03, '3 % are asked for',
          'upper bound of limit analysis gamma H / c = 3.8317 (Chen 1975)', 'vertical cut of 10 in clay, undrained (pla-09 D)', poisson=0.49, slow=True)


def joints(name, scene, rocks, strengths, value, tolerance, reason, source, about, **search):
    folder = os.path.join(HERE, name)
    old_files.write_case(folder, scene, analysis_text(scene, 1, 0.001, rocks, strengths, penalty=5e10, carry_over=0.0),
                         [('factor_of_safety', '', 0, value, tolerance, reason, source, 'standard')], about,
                         legacy='not run: strength is reduced in statics of profile standard')
    with_search(folder, dict({'to_within': 1e-3 * value, 'what': 'joints'}, **search))


LIMIT = 'half the bracket, and the elastic strain of the blocks'


def block_on_plane():
    scene = Scene()
    slope_of = lambda x: -x * tangent(30)  # noqa: E731
    along, across = (math.cos(math.radians(30)), -math.sin(math.radians(30))), (math.sin(math.radians(30)), math.cos(math.radians(30)))
    base = [(2 + s * along[0] + h * across[0], slope_of(2) + s * along[1] + h * across[1]) for s, h in ((0, 0), (1, 0), (1, 1), (0, 1))]
    scene.block(base)
    scene.fixed_block([(-1, slope_of(-1) - 3), (12, slope_of(12) - 1), (12, slope_of(12)), (-1, slope_of(-1))])
    joints('block_on_plane', scene, [rock()], [(40, 0, 0)], tangent(40) / tangent(30), 1e-3 * tangent(40) / tangent(30), '0.1 % are asked for',
           'tan 40 / tan 30', 'a block on a plane of 30 degrees, friction 40 degrees', to_within=3e-4)


def plane_failure():
    """Hoek & Bray 1977, as case no_crack of plane_failure."""
    height, face, plane, cohesion, phi = 10.0, math.radians(70), math.radians(35), 20e3, 30
    scene = Scene()
    x_back, x_crest = height / math.tan(plane), height / math.tan(face)
    scene.block([(0, 0), (x_back, height), (x_crest, height)], joints=[1, 2, 2])
    run = x_back + 1
    scene.fixed_block([(-2, -2 * math.tan(plane)), (run, -2 * math.tan(plane) - 1), (run, run * math.tan(plane))])
    weight = height / 2 * (x_back - x_crest) * 2600 * G
    value = (cohesion * height / math.sin(plane) + weight * math.cos(plane) * tangent(phi)) / (weight * math.sin(plane))
    joints('plane_failure', scene, [rock()], [(phi, cohesion, 0), (phi, 0, 0)], value, 2e-3 * value, LIMIT,
           'F = (c A + W cos p tan phi) / (W sin p) (Hoek & Bray 1977)', 'a wedge of rock on a plane of 35 degrees with cohesion')


def two_blocks(name, w1, psi1, phi1, w2, psi2, phi2, phi12, depth, height, length, toe):
    """As two_block_slope has them."""
    def gap(factor):
        p1, p2, d = (math.atan(tangent(p) / factor) for p in (phi1, phi2, phi12))
        s1, s2 = math.radians(psi1), math.radians(psi2)
        return w1 * math.sin(s1 - p1) / math.cos(s1 - p1 - d) - w2 * math.sin(p2 - s2) / math.cos(p2 - s2 + d)
    low, high = 1.0, 2.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if gap(middle) < 0 else (low, middle)
    t1, t2 = tangent(psi1), tangent(psi2)
    scene = Scene()
    scene.block([(-CHAMFER, CHAMFER * t1), (0, CHAMFER * t1 + 0.3), (0, height), (-depth, depth * t1)], 1, [1, 3, 1, 1])
    scene.block([(0, HEEL), (HEEL, -HEEL * t2), (length, -length * t2), (length, toe), (0, height)], 2, [2, 2, 2, 2, 3])
    left, right = depth + 2, length + 10
    scene.fixed_block([(-left, left * t1), (-left, -6), (right, -6), (right, -right * t2), (0, 0)], 3, [1, 1, 1, 2, 1])
    rocks = [rock(density=w * 1e3 / area_and_centroid(scene.blocks[i][1])[0] / G) for i, w in enumerate((w1, w2))] + [rock()]
    joints(name, scene, rocks, [(phi1, 0, 0), (phi2, 0, 0), (phi12, 0, 0)], low, 2e-3 * low, LIMIT,
           'limit equilibrium of both blocks (Kovari & Fritz 1978; Goodman 1989)', 'an upper block pushes a lower one')


rock_slopes()
block_on_plane()
plane_failure()
two_blocks('two_blocks_smooth', 1000, 50, 30, 1500, 10, 30, 0, 6, 8, 9, 4)
two_blocks('two_blocks_rough', 1000, 50, 30, 1500, 10, 30, 20, 6, 8, 9, 4)
two_blocks('two_blocks_steep', 600, 60, 35, 1000, 5, 25, 30, 4, 7, 9, 4)
