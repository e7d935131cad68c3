"""Writes the cases of single_element (pla-01 to pla-05).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import json
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import laid_out, rectangle  # noqa: E402

E, NU = 1000, 0.25
# In place of the E of a benchmark where strains would be larger than a step of statics moves a block by; stress that returns does not depend on it.
STIFF = 3000
LAME = STIFF * NU / ((1 + NU) * (1 - 2 * NU))
SHEAR = STIFF / (2 * (1 + NU))
APART, ROW = 1.5, 9  # from block to block, and how many lie beside each other
ASKED = '1e-9 of the largest stress of the case, of which the file of the benchmark has 12 digits'


def coulomb(cohesion, friction, dilation):
    return {'surface': 'mohr_coulomb', 'cohesion': cohesion, 'friction_deg': friction, 'dilation_deg': dilation}


class Case:
    """Unit squares beside each other that do not touch, each one point of rock, in steps of 1."""

    def __init__(self, steps, plane_strain=True):
        self.steps, self.plane_strain = steps, plane_strain
        self.blocks, self.materials, self.fixed, self.motions, self.loads, self.forces, self.values = [], [], [], [], [], [], []

    def add(self, strength, young=E, nu=NU, initial=None):
        """A square; `initial`: stress (xx, yy, zz). Returns its number."""
        number = len(self.blocks) + 1
        self.left, self.low = APART * (len(self.blocks) % ROW), APART * (len(self.blocks) // ROW)
        corners = rectangle(self.left, self.low, self.left + 1, self.low + 1)
        self.blocks.append({'material': number, 'outer': [[x, y, number] for x, y in corners]})
        material = {'density': 1, 'unit_weight': 0, 'youngs_modulus': young, 'poissons_ratio': nu, 'strength': strength}
        if initial is not None:
            material['initial_stress'] = [initial[0], initial[1], 0]
            material['initial_stress_zz'] = initial[2]
        self.materials.append(material)
        return number

    def hold(self, x, y, rows=None):
        """A point of the last square is held, or moved by rows of (time, x, y)."""
        self.fixed.append([self.left + x, self.low + y, len(self.blocks)])
        self.motions.append(rows or [])

    def push(self, x, y, fx, fy):
        self.loads.append([self.left + x, self.low + y, len(self.blocks)])
        self.forces.append([[0, fx, fy], [self.steps, fx, fy]])

    def drive_axis(self, strains):
        """yy follows the strains, what is across is free."""
        self.hold(0.5, 0)
        self.hold(0.5, 1, [[0, 0, 0]] + [[t + 1, 0, e] for t, e in enumerate(strains)])

    def drive_all(self, strains):
        """All strains in the plane follow those given, (xx, yy, angle of shear), without a turn."""
        self.hold(0, 0)
        self.hold(1, 0, [[0, 0, 0]] + [[t + 1, e[0], e[2] / 2] for t, e in enumerate(strains)])
        self.hold(0, 1, [[0, 0, 0]] + [[t + 1, e[2] / 2, e[1]] for t, e in enumerate(strains)])

    def expect(self, quantity, value, time, source, largest=None):
        self.values.append((quantity, len(self.blocks), time, value, source, largest))

    def write(self, name, about, tolerance=1e-9, reason=ASKED):
        blocks = {'blocks': self.blocks, 'fixed_points': self.fixed}
        if self.loads:
            blocks['loading_points'] = self.loads
        analysis = {'velocity_carry_over': 0, 'step_count': self.steps, 'time_step': 1, 'allowed_displacement_ratio': 0.1,
                    'plane_strain': self.plane_strain, 'block_materials': self.materials, 'joint_materials': [{}] * len(self.blocks),
                    'fixed_point_motions': self.motions}
        if self.loads:
            analysis['point_loads'] = self.forces
        folder = os.path.join(HERE, name)
        os.makedirs(folder, exist_ok=True)
        parts = [('keyblock', 1), ('blocks', blocks), ('analysis', analysis)]
        with open(os.path.join(folder, name + '.json'), 'w') as file:
            file.write('{\n' + ',\n'.join(' "%s": %s' % (key, laid_out(value, 1)) for key, value in parts) + '\n}\n')
        with open(os.path.join(folder, 'expected.csv'), 'w', newline='') as file:
            rows = csv.writer(file, lineterminator='\n')
            rows.writerow(['quantity', 'block', 'time', 'value', 'tolerance', 'tolerance_reason', 'source', 'judged'])
            greatest = max(abs(v[3]) for v in self.values)
            for quantity, block, time, value, source, largest in self.values:
                rows.writerow([quantity, block, time, repr(float(value)), '%.6g' % (tolerance * (largest or greatest)), reason, source, 'standard'])
        with open(os.path.join(folder, 'case.json'), 'w') as file:
            file.write(json.dumps({'about': about, 'legacy': 'not run: rock stays linear elastic under the rules of the old programs'}, indent=1) + '\n')


def uniaxial_strength():
    case = Case(2, plane_strain=False)
    for cohesion, friction, ucs, uts in ((10, 0, 20.0, 20.0), (10, 30, 34.6410161514, 11.5470053838),
                                         (5, 45, 24.1421356237, 4.14213562373), (2, 20, 5.71259202697, 2.80083015284)):
        for way, strength in ((-1, ucs), (1, uts)):
            case.add(coulomb(cohesion, friction, 0), young=STIFF)
            case.drive_axis([way * 40 / STIFF, way * 60 / STIFF])
            for time in (1, 2):
                case.expect('syy', way * strength, time, 'pla-01: %s, c %g, φ %g' % ('UCS' if way < 0 else 'UTS', cohesion, friction))
    case.write('uniaxial_strength', 'squares of rock with both sides free, pressed and pulled to their strength, static')


def cyclic():
    case = Case(6)
    case.add(coulomb(2, 30, 0))
    case.drive_axis([-0.004, -0.010, -0.006, 0, 0.004, -0.004])
    for time, (yy, zz) in enumerate(((-4.26666666667, -1.06666666667), (-6.92820323028, -1.73205080757), (-2.66153656361, -0.665384140902),
                                     (2.30940107676, 0.57735026919), (2.30940107676, 0.57735026919), (-6.22393225657, -1.55598306414)), 1):
        for quantity, value in (('sxx', 0), ('syy', yy), ('szz', zz)):
            case.expect(quantity, value, time, 'pla-02 A: sides free')
    case.add(coulomb(2, 30, 0), initial=(-5, -5, -5))
    case.drive_axis([-0.010, -0.030, -0.020, -0.030, -0.030, -0.030])
    case.push(0, 0.5, 5, 0)
    case.push(1, 0.5, -5, 0)
    for time, (yy, zz) in enumerate(((-15.6666666667, -7.66666666667), (-21.9282032303, -9.23205080757),
                                     (-11.2615365636, -6.5653841409), (-21.9282032303, -9.23205080757)), 1):
        for quantity, value in (('sxx', -5), ('syy', yy), ('szz', zz)):
            case.expect(quantity, value, time, 'pla-02 B: sides under a pressure of 5')
    case.write('cyclic', 'squares of rock driven to and fro along one axis at a constant stress on their sides, plane strain, static', 1e-8,
               '1e-8 of the largest stress: statics leaves up to 5e-9 of it out of balance at the free sides; asked for: 1e-4')


def oedometer():
    case = Case(5)
    for name, nu, dilation, strains, stresses in (
            ('A', 0.1, 0, (-0.005, -0.01, -0.02, -0.01, 0),
             ((-0.568181818182, -5.11363636364), (-1.13636363636, -10.2272727273), (-3.61435935394, -17.7712812921),
              (-2.47799571758, -7.54400856484), (-0.989743318611, 1.97948663722))),
            ('B', 0.25, 30, (0.002, 0.005, -0.005, -0.02, 0),
             ((0.8, 2.4), (1.60557405349, 2.84459242792), (-2.39442594651, -9.15540757208), (-8.39442594651, -27.1554075721),
              (-0.39442594651, -3.15540757208)))):
        case.add(coulomb(2, 30, dilation), nu=nu)
        case.drive_all([(0, e, 0) for e in strains])
        for time, (side, axial) in enumerate(stresses, 1):
            for quantity, value in (('sxx', side), ('syy', axial), ('szz', side)):
                case.expect(quantity, value, time, 'pla-03 %s' % name)
    case.write('oedometer', 'squares of rock driven to and fro along one axis without strain across it, static')


def way_to(trial, is_inside):
    """Strains (xx, yy) in the plane and an initial stress that a surface bears, from which they lead to a trial stress (xx, yy, zz)."""
    for k in range(0, 400):
        for sign in (1, -1):
            trace = sign * k / STIFF
            for part in range(-100, 101):
                xx = trace / 2 + 2 / STIFF * part
                yy = trace - xx
                initial = (trial[0] - LAME * trace - 2 * SHEAR * xx, trial[1] - LAME * trace - 2 * SHEAR * yy, trial[2] - LAME * trace)
                if is_inside(sorted(initial, reverse=True)):
                    return (xx, yy), initial
    raise ValueError(trial)


TRIALS = ((-1, -5, -30), (5, -5, -20), (10, 9.9, -20), (2, -30, -30.5), (20, 18, 15), (3, 1, -2), (0, 0, -10), (-10, -20, -60))
# By dilation angle, of c 2 and φ 30.
COULOMB = {
    30: ((-7.69059892324, -7.69059892324, -30.0), (-4.35726558991, -7.33931639748, -20.0), (-4.35726558991, -4.35726558991, -20.0),
         (-8.19888583295, -31.5248607291, -31.5248607291), (3.46410161514, 3.46410161514, 3.46410161514), (1.64273441009, 0.660683602523, -2.0),
         (-1.02393225657, -1.02393225657, -10.0), (-17.6905989232, -21.9226497308, -60.0)),
    10: ((-6.64716152143, -6.64716152143, -26.8696877946), (-3.05629621279, -6.03834702035, -16.0970918686), (-1.17457265912, -1.17457265912, -10.4519212076),
         (-7.22712078027, -28.6095655711, -28.6095655711), (3.46410161514, 3.46410161514, 3.46410161514), (1.83143921409, 0.84938840652, -1.43388558801),
         (-0.796155541721, -0.796155541721, -9.31666985544), (-16.6213513322, -20.8534021398, -56.7922572268)),
    0: ((-5.81435935394, -5.81435935394, -24.3712812921), (-2.01794919243, -5.0, -12.9820508076), (1.36564064606, 1.36564064606, -2.83128129211),
        (-6.37765621992, -26.06117189, -26.06117189), (3.46410161514, 3.46410161514, 3.46410161514), (1.98205080757, 1.0, -0.982050807569),
        (-0.614359353945, -0.614359353945, -8.77128129211), (-15.7679491924, -20.0, -54.2320508076))}
MISES = ((-7.95904902896, -9.4284857457, -18.6124652253), (-1.31363287635, -5.90194755376, -12.7844195699), (3.31668048581, 3.28329164376, -6.69997212957),
         (-12.8339341775, -22.755520518, -22.9105453045), (20.0, 18.0, 15.0), (3.0, 1.0, -2.0), (0.0, 0.0, -10.0),
         (-25.6356421953, -27.8178210976, -36.5465367071))
# Of the principal stresses those that are xx, yy and zz.
PLACES = (0, 2, 1), (2, 0, 1), (1, 0, 2)


def returned(case, strength, trial, landed, places, is_inside, source):
    strains, initial = way_to([trial[i] for i in places], is_inside)
    case.add(strength, young=STIFF, initial=initial)
    case.drive_all([(strains[0], strains[1], 0)])
    for quantity, i in zip(('sxx', 'syy', 'szz'), places):
        case.expect(quantity, landed[i], 1, source, largest=max(abs(t) for t in trial))


def return_vectors():
    reason = '1e-9 of the largest trial stress, of which the file of the benchmark has 12 digits'
    case = Case(1)
    for dilation, landings in COULOMB.items():
        for trial, landed in zip(TRIALS, landings):
            for places in PLACES:
                returned(case, coulomb(2, 30, dilation), trial, landed, places,
                         lambda s: 3 * s[0] - s[2] < 0.9 * 4 * math.sqrt(3), 'pla-04: trial %s, ψ %g' % (trial, dilation))
    case.write('return_mohr_coulomb', 'trial stresses that return to the planes, edges and apex of Mohr and Coulomb, each in three directions, static', reason=reason)
    case = Case(1)
    for trial, landed in zip(TRIALS, MISES):
        for places in PLACES:
            returned(case, {'surface': 'von_mises', 'yield_stress': 10}, trial, landed, places,
                     lambda s: math.sqrt(((s[0] - s[1]) ** 2 + (s[1] - s[2]) ** 2 + (s[2] - s[0]) ** 2) / 2) < 9, 'pla-05: trial %s' % (trial,))
    case.write('return_von_mises', 'trial stresses that return to the cylinder of von Mises, each in three directions, static', reason=reason)


def cones():
    """Under shear without change of volume √J2 is the constant k; pulled alike on all sides rock stands at k/(3 α)."""
    case = Case(1)
    for friction, constants in ((10, ((0.0709436251553, 1.20702387468), (0.0631801740507, 1.07493771736), (0.0575940042887, 0.979895488325))),
                                (20, ((0.148583083744, 1.2246860025), (0.118171293618, 0.974018882531), (0.111846965088, 0.921891033044))),
                                (30, ((0.230940107676, 1.2), (0.164957219768, 0.857142857143), (0.160128153805, 0.832050294338))),
                                (40, ((0.314874977757, 1.12576015788), (0.203752531988, 0.728468435991), (0.200875760253, 0.71818322684)))):
        for matching, (slope, strength) in zip(('compression', 'extension', 'plane_strain'), constants):
            law = {'surface': 'drucker_prager', 'matching': matching, 'cohesion': 1, 'friction_deg': friction, 'dilation_deg': 0}
            source = 'pla-05: %s cone of φ %g, ' % (matching, friction)
            case.add(law)
            case.drive_all([(0, 0, 0.01)])
            case.expect('sxy', strength, 1, source + 'k')
            case.add(law)
            case.drive_all([(0.02, 0.02, 0)])
            for quantity in ('sxx', 'syy', 'szz'):
                case.expect(quantity, strength / (3 * slope), 1, source + 'k / (3 α)')
    case.write('cones', 'rock of Drucker and Prager sheared, and pulled on all sides, static')


uniaxial_strength()
cyclic()
oedometer()
return_vectors()
cones()
