"""Writes the cases of rigid_motion_on_covers: a quarter turn in 90 steps of a degree, with a shift (nmm-02).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import case_text, rectangle, write_case  # noqa: E402

CENTRE = (0.12, 0.06)
CORNERS = rectangle(0, 0, 0.24, 0.12)
DT = 0.1
SHIFT = (0.001, -0.002)  # of a step
# The trapezoidal rule turns a rigid body by 2 atan(w dt/2) a step.
SPIN = 2 * math.tan(math.radians(0.5))


def moved(point, step):
    c, s = math.cos(math.radians(step)), math.sin(math.radians(step))
    x, y = point[0] - CENTRE[0], point[1] - CENTRE[1]
    return CENTRE[0] + c * x - s * y + SHIFT[0] * step, CENTRE[1] + s * x + c * y + SHIFT[1] * step


def write(folder, functions, mesh, about):
    measured = [(0.24, 0), (0, 0.12), (0.1, 0.05)]
    covers = {'functions': functions, 'mesh': mesh}
    text = case_text(CORNERS, covers, 1e6, 0.25, measured, density=1000, steps=(90, DT), velocity=[r / DT for r in SHIFT + (SPIN,)],
                     settings={'start': 'sudden', 'force_weight': '0.5'})
    source = 'rigid motion'
    values = []
    for step in (45, 90):
        time = round(step * DT, 9)
        for i, point in enumerate(measured):
            values += [(quantity, i + 1, value, 1e-6, 'swells by rho w^2 r^2 / E, 5e-7 at the corners, and turns slower for it', source, time)
                       for quantity, value in zip(('px', 'py'), moved(point, step))]
        values += [(quantity, 3, 0, 1, 'asked for: 1e-6 of E', source, time)
                   for quantity in ('point_sxx', 'point_syy', 'point_sxy')]
        values.append(('total_area', '', 0.24 * 0.12, 1e-6 * 0.24 * 0.12, 'swells by rho w^2 r^2 / E, 5e-7 at the corners', source, time))
    write_case(os.path.join(HERE, folder), text, values, about)


turned = {'side': 0.04, 'angle': 10, 'through_x': 0.0137, 'through_y': 0.0071}
# A row of nodes a hundred-millionth of the side below the upper edge, a column as near to the right one.
slivers = {'side': 0.04, 'through_x': 0.24 - 4e-10, 'through_y': 0.12 - 4e-10}
for functions in ('constant', 'derived'):
    write(functions, functions, turned, 'quarter turn of a plate, %s functions' % functions)
write('slivers', 'derived', slivers, 'quarter turn of a plate with elements cut to 1e-8 of their size')
