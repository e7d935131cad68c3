"""Writes the cases of roof_block: a falling block, a prism between walls and a wedge in a roof.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from old_files import Scene, analysis_text, area_and_centroid, rock, write_case  # noqa: E402

G, RHO = 9.81, 2600.0
TOLERANCE = 1e-3  # of the expected displacement: rigid equations, elastic strains of 1e-5 and less


def falling():
    scene = Scene()
    scene.block([(-1.2, 0), (1.2, 0), (1, 1), (-1, 1)])
    scene.fixed_block([(1.2, 0), (3, 0), (3, 1), (1, 1)])
    scene.fixed_block([(-3, 0), (-1.2, 0), (-1, 1), (-3, 1)])
    times = (0.5, 1.0)
    expected = [('dy', 1, t, -G * t * t / 2, 1e-6 * t * t, 'round-off of the file; asked for: 0.5 %', 'free fall, g t^2/2')
                for t in times]
    expected += [('rotation', 1, 1.0, 0, 1e-9, 'no force turns it', 'symmetry')]
    write_case(os.path.join(HERE, 'falling'), scene,
               analysis_text(scene, 200, 0.005, [rock()], [(35, 0, 0)]), expected,
               'a roof block whose joints diverge downward falls freely')


def prism(name, share, time):
    """Walls pressed by `share` of the thrust that holds the prism: the left one movable, the right one fixed."""
    mu, mass = math.tan(math.radians(30)), RHO
    thrust = share * mass * G / (2 * mu)
    scene = Scene()
    scene.block([(-0.5, 5), (0.5, 5), (0.5, 6), (-0.5, 6)], joints=1)
    wall = scene.block([(-2.5, 0), (-0.5, 0), (-0.5, 7), (-2.5, 7)], joints=[2, 1, 2, 2])
    scene.fixed_block([(0.5, 0), (2.5, 0), (2.5, 7), (0.5, 7)])
    scene.fixed_block([(-4, -1), (1, -1), (1, 0), (-4, 0)], joints=2)
    scene.fixed.append((-1.5, -0.5, 4))  # a third point, so that the file fits no other format
    scene.load_at(-2.25, 5.5, wall)
    curves = {len(scene.fixed): [(0, thrust, 0), (10, thrust, 0)]}
    a = max(0.0, G - 2 * thrust * mu / mass)
    source = 'a = g - 2 H tan(phi)/m, phi 30 deg, H = %.2f H_crit, H_crit = m g/(2 tan(phi)) = %.1f N' % (
        share, mass * G / (2 * mu))
    expected = [('dy', 1, t, -a * t * t / 2, TOLERANCE * a * t * t / 2 + 1e-6 if a else 1e-5,
                 'elastic strain of prism and wall; asked for: 2 % of the thrust and of the acceleration', source)
                for t in (time / 2, time)]
    write_case(os.path.join(HERE, name), scene,
               analysis_text(scene, round(time / 0.002), 0.002, [rock()], [(30, 0, 0), (0, 0, 0)], curves=curves),
               expected, 'a prism between two walls pressed by %.2f of the thrust that holds it' % share)


def wedge(name, share, time):
    """Wedge, base 2 m, height 1.5 m, between two blocks pressed inward by dead loads on frictionless ledges."""
    phi, psi = math.radians(45), math.atan(1 / 1.5)
    area = 0.5 * 2 * 1.5
    weight = RHO * G * area
    critical = weight / (2 * math.tan(phi - psi))
    thrust = share * critical
    top = 1.2
    x_top = 1 - top / 1.5
    scene = Scene()
    scene.block([(-1, 0), (1, 0), (0, 1.5)], joints=1)
    below = 0.3  # the faces go on below the wedge, so that its corners do not stand on theirs
    x_low = 1 + below / 1.5
    right = [(x_low, -below), (4, -below), (4, top), (x_top, top)]
    left = [(-4, -below), (-x_low, -below), (-x_top, top), (-4, top)]
    scene.block(left, joints=[2, 1, 2, 2])
    scene.block(right, joints=[2, 2, 2, 1])
    scene.fixed_block([(-6, -1), (-1.5, -1), (-1.5, -below), (-6, -below)], joints=2)
    scene.fixed_block([(1.5, -1), (6, -1), (6, -below), (1.5, -below)], joints=2)
    scene.load_at(-3.9, 0.7, 2)
    scene.load_at(3.9, 0.7, 3)
    first = len(scene.fixed)
    curves = {first: [(0, thrust, 0), (10, thrust, 0)], first + 1: [(0, -thrust, 0), (10, -thrust, 0)]}
    a, source = wedge_acceleration(weight, thrust, phi, psi, area_and_centroid(right)[0] * RHO)
    source = 'H = %.2f H_crit, H_crit = W/(2 tan(phi - psi)) = %.1f N; %s' % (share, critical, source)
    expected = [('dy', 1, t, -a * t * t / 2, 0.005 * a * t * t / 2 + 1e-4 if a else 1e-4,
                 'the sides shorten by 2e-5 under the thrust; 2 % of the thrust, as asked for, would be 100 % of this fall', source) for t in (time / 2, time)]
    write_case(os.path.join(HERE, name), scene,
               analysis_text(scene, round(time / 0.002), 0.002, [rock()], [(45, 0, 0), (0, 0, 0)], curves=curves),
               expected, 'a roof wedge under %.2f of the side thrust that holds it' % share)


def wedge_acceleration(weight, thrust, phi, psi, side_mass):
    """Wedge down by a, sides inward by a tan(psi), S = N tan(phi) on both joints: three equations, two unknowns a side."""
    c, s, t = math.cos(psi), math.sin(psi), math.tan(phi)
    up, across = t * c - s, c + t * s  # of N = 1, on the wedge and on a side
    # (W - 2 up N) / m = a;  (H - across N) / M = a tan(psi)
    mass, tp = weight / G, math.tan(psi)
    n = (thrust / side_mass - tp * weight / mass) / (across / side_mass - 2 * tp * up / mass)
    a = (weight - 2 * up * n) / mass
    return (a, 'sliding on both joints, a = (W - 2 N (tan phi cos psi - sin psi))/m, sides follow by a tan psi') if a > 0 \
        else (0.0, 'statics')


falling()
prism('prism_held', 1.02, 1.0)
prism('prism_slides', 0.98, 1.0)
prism('prism_half_thrust', 0.5, 0.5)
wedge('wedge_held', 1.02, 1.0)
wedge('wedge_slides', 0.98, 0.5)
