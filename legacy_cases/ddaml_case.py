"""Writes the files of a case (block file, DDAML analysis, expected.csv, case.json) for the make_input.py of the cases, and
integrates the equations of motion that their expected values come from.

Layouts: formats/shi/dda_blocks.hpp and formats/berkeley/ddaml_analysis.hpp. Python 3, standard library only.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import csv
import json
import math
import os
import re

from old_files import Scene

G = 9.81
PIVOT = ("ordinary differential equation of a rigid block turning about its toe, (b^2+h^2)/3 theta'' = "
         "g/2 sqrt(b^2+h^2) sin theta, fourth-order Runge-Kutta")


def rectangle(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def turned(slope_deg, points):
    """From (s, n), down the slope and out of it, to (x, y)."""
    c, s = math.cos(math.radians(slope_deg)), math.sin(math.radians(slope_deg))
    return [(u * c + n * s, -u * s + n * c) for u, n in points]


class SlopeScene(Scene):
    """Block 1 is the ground, held: s from 0 to `length`, n from -`depth` to 0, turned by the slope."""

    def __init__(self, slope_deg, length=20.0, depth=2.0, material=1):
        super().__init__()
        self.slope_deg = slope_deg
        ground = self.block(turned(slope_deg, rectangle(0, -depth, length, 0)), material)
        for x, y in turned(slope_deg, rectangle(1, -0.75 * depth, length - 1, -0.25 * depth)):
            self.fixed.append((x, y, ground))

    def on_slope(self, s0, n0, s1, n1, material=1):
        return self.block(turned(self.slope_deg, rectangle(s0, n0, s1, n1)), material)


def leaning(b, h, tilt):
    """A rectangle on its lower right corner, in the origin, turned clockwise by `tilt`."""
    c, s = math.cos(tilt), math.sin(tilt)
    return [(u * c + v * s, -u * s + v * c) for u, v in rectangle(-b, 0, 0, h)]


def material(density=2600.0, velocity=(0.0, 0.0, 0.0), youngs_modulus=5e9):
    return density, youngs_modulus, tuple(velocity)


def analysis(time_step, steps, friction_deg, materials=None, gravity=G, penalty_factor=10, displacement_ratio=0.01):
    """DDAML: dynamic, constant step, plane stress, one joint material without cohesion."""
    def tag(name, text):
        return '<%s> %s </%s>\n' % (name, text, name)

    text = ('<?xml version="1.0" standalone="no"?>\n<!DOCTYPE DDA SYSTEM "analysis.dtd">\n'
            '<Berkeley:DDA xmlns:Berkeley="http://www.tsoft.com/~bdoolin/dda">\n<!-- analysis -->\n'
            '<Analysis type="dynamic">\n<Analysistype type="dynamic"/>\n<Rotation type="linear"/>\n'
            '<Gravity flag="no"></Gravity>\n<Gravaccel value="%r"/>\n<Autotimestep flag="no"/>\n'
            '<Autopenalty flag="no" pfactor="%g"/>\n<Planestrain flag="no"/>\n<Numtimesteps timesteps="%d"/>\n'
            '<Maxtimestep maxtimestep="%r"/>\n<Maxdisplacement maxdisplacement="%g"/>\n<Saveinterval step="%d"/>\n'
            % (gravity, penalty_factor, steps, time_step, displacement_ratio, max(1, steps // 100)))
    for density, youngs_modulus, velocity in materials or [material()]:
        text += '<Blockmaterial type="1">\n' + tag('Unitmass', '%.15g' % density)
        text += tag('Unitweight', '%.15g' % (density * gravity)) + tag('Youngsmod', '%.15g' % youngs_modulus)
        text += tag('Poissonratio', '0.25') + tag('Damping', '0') + tag('Istress', '0 0 0')
        text += tag('Ivelocity', '%.17g %.17g %.17g' % velocity) + tag('Istrain', '0 0 0') + '</Blockmaterial>\n'
    text += '<Jointproperties type="1">\n' + tag('Friction', '%.17g' % friction_deg) + tag('Cohesion', '0')
    return text + tag('Tensile', '0') + '</Jointproperties>\n</Analysis>\n</Berkeley:DDA>\n'


def variant(name, profile='standard', **settings):
    return {'name': name, 'profile': profile, 'set': {key: str(value) for key, value in settings.items()}}


def case_text(case):
    """One line a variant."""
    text = json.dumps(case, indent=1, ensure_ascii=False)
    text = re.sub(r'\{[^{}]*\}', lambda m: re.sub(r'\s*\n\s*', '', m.group()), text)
    return re.sub(r'\{\n\s*"name".*?\n\s*\}(?=,?\n)', lambda m: re.sub(r'\s*\n\s*', ' ', m.group()), text, flags=re.S) + '\n'


def write_case(folder, scene, analysis_text, expected, about, motion=None, **case):
    """Writes a case folder. `expected`: (quantity, block, time, value, tolerance, reason, source[, judged]), judged in
    `standard` unless it says otherwise. `motion`: rows (t, ax, ay) of a body acceleration."""
    os.makedirs(folder, exist_ok=True)
    name = os.path.join(folder, os.path.basename(os.path.normpath(folder)))
    with open(name + '.blk', 'w') as file:
        file.write(scene.text())
    with open(name + '.ana', 'w') as file:
        file.write(analysis_text)
    columns = ['quantity', 'block', 'time', 'value', 'tolerance', 'tolerance_reason', 'source', 'judged']
    with open(os.path.join(folder, 'expected.csv'), 'w', newline='') as file:
        table = csv.writer(file, lineterminator='\n')
        table.writerow(columns)
        for quantity, block, time, value, tolerance, *words in expected:
            words += ['standard'] * (3 - len(words))
            table.writerow([quantity, block, '%.15g' % time, '%.15g' % value, '%.4g' % tolerance] + words)
    if motion:
        with open(os.path.join(folder, 'motion.csv'), 'w') as file:
            file.write('time,ax,ay\n' + ''.join('%.9g,%.12g,%.12g\n' % row for row in motion))
        settings = case.setdefault('set', {})
        settings['both'] = {**settings.get('both', {}), 'body_acceleration_file': 'motion.csv'}
    with open(os.path.join(folder, 'case.json'), 'w') as file:
        file.write(case_text({'about': about, **case}))


def rk4(rate, y, start, end, steps):
    """Fourth-order Runge-Kutta rule for y' = rate(t, y)."""
    h, t = (end - start) / steps, start
    for _ in range(steps):
        k1 = rate(t, y)
        k2 = rate(t + h / 2, [a + h / 2 * b for a, b in zip(y, k1)])
        k3 = rate(t + h / 2, [a + h / 2 * b for a, b in zip(y, k2)])
        k4 = rate(t + h, [a + h * b for a, b in zip(y, k3)])
        y = [a + h / 6 * (b + 2 * c + 2 * d + e) for a, b, c, d, e in zip(y, k1, k2, k3, k4)]
        t += h
    return y


def until(rate, y, event, step=1e-4):
    """Time and state at which `event(y)` first changes its sign, by bisection of one step."""
    t, sign = 0.0, event(y)
    while True:
        after = rk4(rate, y, t, t + step, 4)
        if event(after) * sign <= 0:
            break
        y, t = after, t + step
    low, high = 0.0, step
    for _ in range(60):
        middle = (low + high) / 2
        if event(rk4(rate, y, t, t + middle, 4)) * sign > 0:
            low = middle
        else:
            high = middle
    return t + high, rk4(rate, y, t, t + high, 4)


def swing(b, h):
    """p^2 = 3g/(4R) and alpha of a rigid block b x h on a corner: theta'' = -p^2 sin(alpha - theta)."""
    return 3 * G / (2 * math.hypot(b, h)), math.atan(b / h)
