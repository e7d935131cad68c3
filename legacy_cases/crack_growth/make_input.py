"""Writes the cases of crack_growth: paths and loads of cracks that grow (fra-06, 14, 19), and a disc that splits (fra-10).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import arc, case_text, free_mesh, laid_out, rectangle, write_case  # noqa: E402


def write(name, corners, cracks, side, covers, growth, steps, values, about, young, poisson, toughness, contact='ignored', joint=None, tip=None):
    """`values` as those of write_case."""
    mesh = free_mesh(side)
    if tip:
        mesh['tip_side'] = tip
    parts = {'contact': contact, 'mesh': mesh, 'growth': growth}
    if cracks:
        parts['cracks'] = [{'along': a} for a in cracks]
    parts.update(covers)
    text = case_text(corners, parts, young, poisson, [], plane_strain=True, steps=(steps, 1)).replace(',\n  "measured_points": []', '')
    text = text.replace('"poissons_ratio": %s' % json.dumps(poisson), '"poissons_ratio": %s, "toughness": %s' % (json.dumps(poisson), json.dumps(toughness)))
    if joint:
        text = text.replace('   {}\n', '   %s\n' % json.dumps(joint))
    write_case(os.path.join(HERE, name), text, values, about)


def cantilever(name, tilt, increment, steps, values, about):
    """Double cantilever of fra-06 in inches and pounds, opened by 197 on each arm."""
    end = [3.94, 0.3 * math.tan(math.radians(tilt))]
    cracks = [[[0, 0], [3.64, 0], end]] if tilt else [[[0, 0], end]]
    young = 3e7
    write(name, [(0, -1.97), (11.8, -1.97), (11.8, 1.97), (0, 1.97), (0, 0)], cracks, 0.4,
          {'tractions': [{'along': [[0, 0], [0, 1.97]], 'y': 100}, {'along': [[0, -1.97], [0, 0]], 'y': -100}],
           'springs': [[11.8, -1.97, 1, 0, young], [11.8, -1.97, 0, 1, young], [11.8, 1.97, 1, 0, young]]},
          {'increment': increment}, steps, values, about, young, 0.3, {'mode_1': 1000})


def loads_of_a_cantilever():
    """Load over length: K = P (3.46 a + 2.38 h) / h^1.5 reaches the toughness 10."""
    young, steps = 1e5, 6
    values = []
    for k in range(steps):
        a = 2 + 0.4 * k
        values.append(('load_factor', '', 10 / (3.46 * a + 2.38), 0.015 * 10 / (3.46 * a + 2.38), '1.5 %: the formula is fitted to 0.5 %, K is found to 0.6 %',
                       'Kanninen 1973; Tada, Paris & Irwin 1973', k + 1))
    write('cantilever_loads', [(0, -1), (14, -1), (14, 1), (0, 1), (0, 0)], [[[0, 0], [2, 0]]], 0.2,
          {'tractions': [{'along': [[0, 0], [0, 1]], 'y': 1}, {'along': [[0, -1], [0, 0]], 'y': -1}],
           'springs': [[14, -1, 1, 0, young], [14, -1, 0, 1, young], [14, 1, 1, 0, young]]},
          {'increment': 0.4}, steps, values, 'load of a double cantilever over the length of its crack', young, 0.3, {'mode_1': 10}, tip=0.00625)


def kink(mode_1, mode_2):
    return math.degrees(2 * math.atan((mode_1 - math.hypot(mode_1, math.sqrt(8) * mode_2)) / (4 * mode_2)))


def first_kinks():
    """An inclined crack in tension, of which both tips kink by the hoop stress."""
    c, s, young = math.cos(math.radians(30)), math.sin(math.radians(30)), 1e5
    exact = kink(0.752427563926, 0.433737607479)
    write('first_kink', rectangle(-20, -20, 20, 20), [[[-c, -s], [c, s]]], 4,
          {'tractions': [{'along': [[-20, 20], [20, 20]], 'y': 1}, {'along': [[-20, -20], [20, -20]], 'y': -1}],
           'springs': [[20, -20, 1, 0, young], [20, -20, 0, 1, young], [20, 20, 1, 0, young]]},
          {'increment': 0.1}, 1, [('kink_deg', t, exact, 2, 'asked for: 2 degrees', 'Erdogan & Sih 1963', 1) for t in (1, 2)],
          'first kink of a crack at 30 degrees in tension (fra-14)', young, 0.3, {'mode_1': 1})


def wing_crack():
    """A closed flaw in compression that rubs: both tips slide, and wings start at 70.53 degrees."""
    c, young = math.sqrt(0.5), 1e4
    write('wing_crack', rectangle(-20, -20, 20, 20), [[[-c, -c], [c, c]]], 4,
          {'tractions': [{'along': [[-20, 20], [20, 20]], 'y': -1}, {'along': [[-20, -20], [20, -20]], 'y': 1}],
           'springs': [[20, -20, 1, 0, young], [20, -20, 0, 1, young], [20, 20, 1, 0, young]]},
          {'increment': 0.2}, 1, [('kink_deg', t, 70.5288, 2, 'asked for: 2 degrees', 'Horii & Nemat-Nasser 1985, with K_I = 0', 1) for t in (1, 2)],
          'wings of a closed crack in compression, friction 0.3 (fra-19)', young, 0.3, {'mode_1': 1}, contact='felt',
          joint={'friction_angle_deg': math.degrees(math.atan(0.3))}, tip=1 / 320)


def split_disc():
    """A whole disc: the load at which it cracks, and a crack that parts it."""
    half, young = 5, 1e5
    right = arc(1, -90 + half, 90 - half, 90)
    left = [(-x, -y) for x, y in right]
    corners = right + [(0.0, 1.0)] + left + [(0.0, -1.0)]
    top, bottom = [right[-1], (0.0, 1.0), left[0]], [left[-1], (0.0, -1.0), right[0]]
    length = sum(math.dist(a, b) for a, b in zip(top, top[1:]))
    strength, radius = 1.0, 0.1
    write('split_disc', corners, [], 0.05,
          {'tractions': [{'along': [list(p) for p in top], 'y': -1 / length}, {'along': [list(p) for p in bottom], 'y': 1 / length}],
           'springs': [[0, 1, 1, 0, young], [0, -1, 1, 0, young], [0, -1, 0, 1, young]]},
          {'increment': 0.2}, 2, [('load_factor', '', math.pi, 0.05 * math.pi, 'asked for: 5 % of the load of the Brazilian test', 'Hondros 1959: P = pi D t ft / 2', 1)],
          'Brazilian disc that cracks along its diameter (fra-10)', young, 0.2, {'mode_1': round(strength * math.sqrt(math.pi * radius), 9), 'tensile_strength': strength})


def cantilever_in_time():
    """Arms driven apart slowly; the tip follows the opening as at rest: with K = P (3.46 a + 2.38 h)/h^1.5 and G = P^2/2 dC/da the opening under
    which the tip stands at a is 2 K (3.46 a + 2.38 h)^2/(10.38 h^1.5 E')."""
    young, poisson, tough, steps, dt = 1e5, 0.3, 10, 130, 0.02
    values = []
    for step in (130,):
        opening = 2e-3 * step * dt
        a = (math.sqrt(opening * 10.38 * young / (1 - poisson ** 2) / (2 * tough)) - 2.38) / 3.46
        values.append(('crack_length', 1, a, 0.4, 'an increment: a tip goes on by 0.4 at once', 'Kanninen 1973; G = P^2/2 dC/da', step * dt))
    mesh = free_mesh(0.5)
    mesh['tip_side'] = 0.03
    case = {'keyblock': 1,
            'blocks': {'blocks': [{'outer': [[x, y, 1] for x, y in rectangle(0, -1, 8, 1)]}], 'fixed_points': [[0.05, 0.5, 1], [0.05, -0.5, 1]]},
            'covers': {'mesh': mesh, 'cracks': [{'along': [[0, 0], [2, 0]]}], 'growth': {'increment': 0.4}},
            'analysis': {'step_count': steps, 'time_step': dt, 'velocity_carry_over': 1, 'allowed_displacement_ratio': 0.1, 'plane_strain': True, 'gravity': 0,
                         'fixed_point_motions': [[[0, 0, 0], [10, 0, 0.01]], [[0, 0, 0], [10, 0, -0.01]]], 'joint_materials': [{}],
                         'block_materials': [{'density': 1, 'unit_weight': 0, 'youngs_modulus': young, 'poissons_ratio': poisson, 'toughness': {'mode_1': tough}}]}}
    write_case(os.path.join(HERE, 'cantilever_in_time'), json.dumps(case, indent=1) + '\n', values, 'double cantilever driven apart in time', slow=True)


def spalling_pillar():
    """A pillar with a flaw near its side, pressed by 0.00384 of its height 2: wings part a slab, and both stand."""
    young, poisson, height, pressed = 1e4, 0.2, 2, 0.00384
    half, angle, at = 0.1, math.radians(60), (0.8, 1)
    flaw = [[at[0] + k * half * math.cos(angle), at[1] + k * half * math.sin(angle)] for k in (-1, 1)]
    stress = -young / (1 - poisson ** 2) * pressed / height
    mesh = free_mesh(0.2)
    along = 'between the ends of the flaw: wings turn to the direction of the load'
    case = {'keyblock': 1,
            'blocks': {'blocks': [{'outer': [[x, y, 1] for x, y in rectangle(0, 0, 1, height)]}],
                       'measured_points': [[0.5, 1, 1], [0.95, 2, 1]]},
            'covers': {'contact': 'felt', 'mesh': mesh, 'cracks': [{'along': flaw}], 'growth': {'increment': 0.08, 'loads': 'given'},
                       'displacements': [{'along': [[0, 0], [1, 0]], 'held': 'y', 'y': 0}, {'along': [[0, height], [1, height]], 'held': 'y', 'y': -pressed}],
                       'springs': [[0, 0, 1, 0, young]]},
            'analysis': {'step_count': 26, 'time_step': 1, 'velocity_carry_over': 0, 'allowed_displacement_ratio': 0.1, 'plane_strain': True, 'gravity': 0,
                         'joint_materials': [{'friction_angle_deg': math.degrees(math.atan(0.3))}],
                         'block_materials': [{'density': 1, 'unit_weight': 0, 'youngs_modulus': young, 'poissons_ratio': poisson, 'toughness': {'mode_1': 1}}]}}
    write_case(os.path.join(HERE, 'spalling_pillar'), json.dumps(case, indent=1) + '\n',
               [('tip_x', tip, at[0], half * math.cos(angle), along, 'Horii & Nemat-Nasser 1985', 8) for tip in (1, 2)] +
               [('point_syy', 1, stress, 0.05 * abs(stress), '5 %: wings along the load take none of it', "Hooke's law of a column in plane strain", 26),
                ('point_dx', 2, 0, 0.02, 'a hundredth of the height: the slab stands', 'equilibrium', 26)],
               'pillar from whose side wings of a closed flaw part a slab: both stand', slow=True)


def energy_set_free(tough, modulus, half, radius):
    """What both tips of a crack along the middle of a disc set free beyond twice their surfaces on the way to the rim, if
    the load stays: the integral of G - G_c, G = K_I^2/E' (Griffith 1921; Irwin 1957), G/G_c = a N_I^2 over that at the
    start, N_I by Atkinson, Smelser & Sanchez 1982, table 1, whose last G is kept from there on. Plates that stand still
    set free less: their load falls as the crack grows."""
    factor = [(0.3, 1.135551), (0.4, 1.243134), (0.5, 1.387239), (0.6, 1.578258)]
    over = [a * n ** 2 / (half / radius * factor[0][1] ** 2) - 1 for a, n in factor]
    area = sum((b[0] - a[0]) * (p + q) / 2 for a, b, p, q in zip(factor, factor[1:], over, over[1:]))
    return 2 * radius * (area + (1 - factor[-1][0]) * over[-1]) * tough ** 2 / modulus


def half_disc_falls(after, gravity, flat, corners, kinetic=0):
    """How far a point 0.4 from the middle of the cut has gone, of half a disc that is rigid: it stands beside its
    mirror image without friction and leans out, first about the outer end of its flat, then on its rim, while the lower
    end of the cut stays where it is or rises along the plane of symmetry. By its energy, (w M w)/2 + V = V0 + `kinetic`
    for the angle and its rate w, all over its mass."""
    half = [(0, corners[0][1])] + corners + [(0, corners[-1][1])]
    area = centroid = polar = 0
    for (x, y), (u, v) in zip(half, half[1:] + half[:1]):
        c = x * v - u * y
        area, centroid, polar = area + c / 2, centroid + c * (x + u) / 6, polar + c * (x * x + x * u + u * u + y * y + y * v + v * v) / 12
    centroid /= area
    inertia = polar / area - centroid ** 2
    sine, cosine = math.sin(flat), math.cos(flat)

    def middle(t):  # of the disc
        return (sine - sine * math.cos(t) + cosine * math.sin(t), sine * math.sin(t) + cosine * math.cos(t)) if t < flat else (cosine * math.sin(t), 1)

    def place(t):
        return middle(t)[0] + centroid * math.cos(t), middle(t)[1] - centroid * math.sin(t)
    time, root, part = 0, 0, 1e-3  # the angle is the square of `root`: at rest its rate goes as the root of the angle
    while time < after:
        t = (root + part / 2) ** 2
        low, high = place(t - 1e-8), place(t + 1e-8)
        mass = ((high[0] - low[0]) ** 2 + (high[1] - low[1]) ** 2) / 4e-16 + inertia
        rate = math.sqrt(2 * (kinetic + gravity * (place(0)[1] - place(t)[1])) / mass)
        time, root = time + 2 * (root + part / 2) * part / rate, root + part
    t = root ** 2
    return middle(t)[0] + 0.4 * math.cos(t) - 0.4, middle(t)[1] - 0.4 * math.sin(t) - cosine


def disc_falls_apart():
    """A disc with a crack along its middle, pressed between two plates until it splits; the upper plate is then taken
    away. With K_I = sigma sqrt(pi a) N_I, sigma = P/(pi R) and K_I = 0.35085 P for a/R = 0.3 (as in
    stress_intensity/cracked_disc_03_0) the mean of both tips is K_Ic where P + W/2 = K_Ic/0.35085: the weight W, borne
    below, is W/2 at both ends and a rest that is antisymmetric about the middle, which adds to one tip what it takes
    from the other. The mean stress of the plate above, held along its upper side, is -P over its width."""
    young, poisson, tough, gravity, flat, half, width, high, dt, steps = 8e4, 0.2, 20, 10, 4, 0.3, 0.4, 0.15, 1.5e-3, 330
    right = arc(1, -90 + flat, 90 - flat, 24)
    corners = right + [(-x, -y) for x, y in right]
    top = right[-1][1]
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1])) / 2
    load = tough / 0.3508548903219572 - gravity * area / 2
    down = [[0, 0, 0], [0.03, 0, -0.000425], [0.12, 0, -0.002975], [0.14, 0, -0.002975], [0.24, 0, 0.3], [0.54, 0, 1.2]]
    mesh = {'side': 0.3, 'through_x': 0, 'through_y': 0, 'tip_side': 0.006, 'materials': [[1]]}
    plates = [rectangle(-3, -top - high, 3, -top), rectangle(-width / 2, top, width / 2, top + high)]
    case = {'keyblock': 1,
            'blocks': {'blocks': [{'material': 2, 'outer': [[x, y, 1] for x, y in plate]} for plate in plates] +
                       [{'material': 1, 'outer': [[x, y, 1] for x, y in corners]}],
                       'fixed_points': [[-2.9, -top - high, 1], [2.9, -top - high, 1], [-0.18, top + high, 2], [0.18, top + high, 2]],
                       'measured_points': [[0.4, 0, 3], [-0.4, 0, 3]]},
            'covers': {'mesh': mesh, 'cracks': [{'along': [[0, -half], [0, half]]}], 'growth': {'increment': 0.35}},
            'analysis': {'step_count': steps, 'time_step': dt, 'velocity_carry_over': 1, 'allowed_displacement_ratio': 0.1, 'plane_strain': True, 'gravity': gravity,
                         'fixed_point_motions': [[], [], down, down], 'joint_materials': [{'friction_angle_deg': 0}],
                         'block_materials': [{'density': 1, 'unit_weight': 0, 'youngs_modulus': young, 'poissons_ratio': poisson, 'toughness': {'mode_1': tough}},
                                             {'density': 0.01, 'unit_weight': 0, 'youngs_modulus': 10 * young, 'poissons_ratio': poisson}]},
            'run': {'set': {'stiffness_damping.1': '1e-3'}}}
    end, split = steps * dt, 0.096
    rest = half_disc_falls(end - split, gravity, math.radians(flat), right)
    pushed = half_disc_falls(end - split, gravity, math.radians(flat), right,
                             energy_set_free(tough, young / (1 - poisson ** 2), half, 1) / area)
    (x, more_x), (y, more_y) = (((b + a) / 2, abs(b - a) / 2) for a, b in zip(rest, pushed))
    share = '9 %: waves of the load 5 %, K with sides of a/50 at the tip 3 % low'
    even = 'a hundredth of what a half does'
    fall = 'halves set out with none to all of the energy that the crack sets free'
    rigid = 'fall of a rigid half beside its mirror image from when the tips went on (0.096, this program), by its energy; Griffith 1921'
    write_case(os.path.join(HERE, 'disc_falls_apart'), json.dumps(case, indent=1) + '\n',
               [('syy', 2, -load / width, 0.09 * load / width, share, 'Atkinson, Smelser & Sanchez 1982; mean stress of the plate by equilibrium, one step before the tips go on (0.096, this program)', 63 * dt)] +
               [('tip_x', tip, 0, 0.035, 'a tenth of an increment: along the loaded diameter', 'symmetry', 68 * dt) for tip in (1, 2)] +
               [('centre_of_mass_x', '', 0, 0.005, even, 'symmetry', end), ('momentum_x', '', 0, 0.01, even, 'symmetry: nothing pushes sideways', end)] +
               [('point_dx', point, sign * x, more_x, fall, rigid, end) for point, sign in ((1, 1), (2, -1))] +
               [('point_dy', point, y, more_y, fall, rigid, end) for point in (1, 2)],
               'disc that splits between two plates: both halves fall apart', slow=True)


def three_holes():
    """A notched beam of PMMA with three holes above each other (inches, pounds), bent at three points. The crack turns to the load and ends in the
    middle hole: its last place, an increment before the hole at most, is held against the middle of that hole."""
    young, radius, notch, steps, increment = 4.5e5, 0.25, 4, 28, 0.15
    holes = [[[6 + x, y + z, 1] for x, z in reversed(arc(radius, 0, 360, 32)[:-1])] for y in (2.75, 4.75, 6.75)]
    text = case_text([(0, 0), (1, 0), (notch, 0), (19, 0), (20, 0), (20, 8), (10.05, 8), (9.95, 8), (0, 8)],
                     {'contact': 'ignored', 'mesh': free_mesh(0.5), 'growth': {'increment': increment}, 'cracks': [{'along': [[notch, 0], [notch, 1]]}],
                      'tractions': [{'along': [[10.05, 8], [9.95, 8]], 'y': -10}],
                      'springs': [[1, 0, 0, 1, 1e3 * young], [19, 0, 0, 1, 1e3 * young], [1, 0, 1, 0, 1e3 * young]]},
                     young, 0.35, [], plane_strain=True, steps=(steps, 1)).replace(',\n  "measured_points": []', '')
    text = text.replace('"poissons_ratio": 0.35', '"poissons_ratio": 0.35, "toughness": {"mode_1": 1000}')
    text = text.replace('[9.95, 8, 1], [0, 8, 1]]', '[9.95, 8, 1], [0, 8, 1]],\n    "holes": %s' % laid_out(holes, 3))
    last = 27  # before the increment that reaches the hole, by this program
    near = 'radius of the hole and an increment'
    source = 'end: Bittencourt, Wawrzynek, Ingraffea & Sousa 1996; Ingraffea & Grigoriu 1990'
    write_case(os.path.join(HERE, 'three_holes'), text,
               [('tip_x', 1, 6, radius + increment, near, source, last), ('tip_y', 1, 4.75, radius + increment, near, source, last),
                ('K_II', 1, 0, 50, 'asked for: K_II/K_I <= 0.05 behind each step', 'Cotterell & Rice 1980', last)],
               'crack of a beam with three holes, which ends in the middle one (fra-16)', slow=True)


def roof_with_bridge():
    """A tunnel in mapped joints of three sets. Two of its roof's joints would part a wedge of 23 m2, but one ends half a metre before the other: the
    bridge breaks under the weight of the wedge, which then falls freely, the only block that block theory lets out."""
    right, low, top, dt, steps, gravity, tough = 15, -12, 12, 1e-3, 700, 9.81, 1e6
    side, base = right - 1, low + 1  # within the frame, which alone is held
    joints = [[-right, low, right, low], [right, low, right, top], [right, top, -right, top], [-right, top, -right, low],
              [-5, -6, 5, -6], [5, -6, 5, 0], [5, 0, -5, 0], [-5, 0, -5, -6], [-side, base, side, base], [side, base, side, top], [-side, base, -side, top],
              [-4, 0, 4, 12], [4, 0, 0.3, 5.55], [-side, 9, side, 9], [-side, -3, -5, -3], [5, -3, side, -3], [-side, -6, -5, -6], [5, -6, side, -6]]
    rock = {'density': 2600, 'youngs_modulus': 2e10, 'poissons_ratio': 0.25}
    case = {'keyblock': 2, 'units': {'length': 'm', 'mass': 'kg', 'time': 's'},
            'drawing': {'edge_node_ratio': 0.001, 'boundary_count': 8, 'joints': [j + [1] for j in joints], 'hole_points': [[0, -3]],
                        'material_lines': [[7, 2, 7.1, 2, 2]],
                        'fixed_lines': [[-right - 1, low + 0.5, right + 1, low + 0.5]],
                        'measured_points': [[0, 0.1], [0, 3], [6, 1], [-6, 1], [0, 10], [-5.5, -4.5], [5.5, -4.5]]},
            'covers': {'mesh': {'side': 1.2, 'tip_side': 0.06, 'materials': [[2]]}, 'growth': {'increment': 0.25}},
            'analysis': {'step_count': steps, 'time_step': dt, 'block_materials': [rock, dict(rock, toughness={'mode_1': tough})],
                         'joint_materials': [{'friction_angle_deg': 35}]},
            'run': {'set': {'stiffness_damping.2': '1e-4'}}}
    fall = gravity * (steps * dt) ** 2 / 2
    late = '3 %: until its bridge breaks, after 14 ms (this program), the wedge comes down, but not freely'
    values = [('point_dy', point, -fall, 0.03 * fall, late, 'free fall', steps * dt) for point in (1, 2)]
    values += [('point_d' + axis, point, 0, 1e-3, 'asked for: every other block moves by less than 1 mm', 'Goodman & Shi 1985: not removable', steps * dt)
               for point in (3, 4, 5, 6, 7) for axis in 'xy']
    write_case(os.path.join(HERE, 'roof_with_bridge'), json.dumps(case, indent=1) + '\n', values,
               'tunnel in mapped joints: a bridge of rock in the roof breaks, and the wedge falls (dda-36)', slow=True)


if __name__ == '__main__':
    three_holes()
    roof_with_bridge()
    disc_falls_apart()
    spalling_pillar()
    cantilever_in_time()
    PATH = 'independent reckoning with singular functions, corrected steps of 0.15 in.; Cotterell & Rice 1980: unstable for T > 0'
    cantilever('cantilever_tilted', 5.71, 0.15, 13, [('tip_y', 1, 1.10, 0.165, 'asked for: 15 % of the deviation', PATH, 13), ('tip_x', 1, 5.16, 0.18, 'asked for: 15 % of the way', PATH, 13),
                                                    ('K_II', 1, 0, 50, 'asked for: K_II/K_I <= 0.05 behind each step', PATH, 13)],
               'double cantilever whose crack begins tilted: it turns to that side (fra-06)')
    cantilever('cantilever_straight', 0, 0.3, 7, [('tip_y', 1, 0, 0.15, 'asked for: half an increment', 'symmetry', 7), ('K_II', 1, 0, 10, 'asked for: 0.01 of K_I', 'symmetry', 7)],
               'double cantilever with a straight crack (fra-06)')
    loads_of_a_cantilever()
    first_kinks()
    wing_crack()
    split_disc()
