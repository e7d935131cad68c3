"""Writes the cases of beam_on_covers: exact data (nmm-03), clamped (nmm-04), on two supports (nmm-05).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from cover_files import case_text, free_mesh, rectangle, write_case  # noqa: E402


def exact_data():
    """Timoshenko and Goodier: the displacement of the solution at the root, parabolic shear at the tip."""
    corners = rectangle(0, -6, 48, 6)
    k = 1000 / (6 * 3e7 * 144)
    ux = '-%r*y*((288 - 3*x)*x + 2.3*(y^2 - 36))' % k
    uy = '%r*(0.9*y^2*(48 - x) + 198*x + (144 - x)*x^2)' % k
    covers = {'functions': 'derived', 'mesh': free_mesh(1.5), 'displacements': [{'along': [(0, 6), (0, -6)], 'x': ux, 'y': uy}],
              'tractions': [{'along': [(48, -6), (48, 6)], 'y': '1000/288*(36 - y^2)'}]}
    text = case_text(corners, covers, 3e7, 0.3, [(48, 0)])
    tip = 0.0089
    source = 'Timoshenko and Goodier: tip 0.0089'
    values = [('point_dy', 1, tip, 1e-3 * tip, 'asked for: 0.1 %', source)]
    share = tip / 100
    write_case(os.path.join(HERE, 'exact_data'), text, values, 'cantilever with exact data at both ends, every basis',
               [('constant, side 0.307', {'functions': 'constant', 'mesh.side': 0.307}, 0.1 * share, 'asked for: 0.1 %'),
                ('linear, side 6', {'functions': 'linear', 'mesh.side': 6}, 0.15 * share, 'second order, two triangles across the height: 0.1 %'),
                ('quadratic, side 6', {'functions': 'quadratic', 'mesh.side': 6}, 1e-8 * share, 'the basis holds the field, a cubic: round-off')])


def clamped():
    """Rows 1.3 times as wide as high along the beam, none on its faces, as a free mesh of the old cutter."""
    corners = rectangle(0, 0, 10, 1)

    def mesh(rows):
        side = 1.3 / rows
        return {'side': side, 'shape': 'old', 'through_x': 0.3 * side, 'through_y': 0.4 * side}

    def case(folder, functions, rows, about, slow=False):
        covers = {'functions': functions, 'mesh': mesh(rows), 'displacements': [{'along': [(0, 1), (0, 0)]}],
                  'tractions': [{'along': [(10, 0), (10, 1)], 'y': 1}]}
        text = case_text(corners, covers, 1000, 0.3, [(10, 0.5)])
        source = 'quadrilaterals of second order, 200 x 20: 4.0238; Bernoulli 4, Timoshenko and Goodier 4.0275 (free to warp)'
        values = [('point_dy', 1, 4.0238, 0.0040238, 'asked for: 0.1 %', source)]
        write_case(os.path.join(HERE, folder), text, values, about, slow=slow)

    case('clamped_derived', 'derived', 4.3, 'clamped cantilever, derived functions, 4.3 rows')
    case('clamped_linear', 'linear', 3, 'clamped cantilever, linear functions, 3 rows')
    case('clamped_quadratic', 'quadratic', 2.2, 'clamped cantilever, quadratic functions, 2.2 rows')
    case('clamped_constant', 'constant', 47.8, 'clamped cantilever, constant functions, 47.8 rows', slow=True)


def supported():
    """Half of the beam; supported by parabolic shear on its end, for a point support sinks in without limit as the mesh is refined."""
    corners = rectangle(0, 0, 5, 1)
    covers = {'functions': 'derived', 'mesh': free_mesh(0.125), 'displacements': [{'along': [(5, 0), (5, 1)], 'held': 'normal'}],
              'tractions': [{'along': [(0, 1), (0, 0)], 'y': '3*y*(1 - y)'}], 'forces': [[5, 1, 0, -0.5]],
              'springs': [[0, 0.5, 0, 1, 1000]]}
    text = case_text(corners, covers, 1000, 0.3, [(5, 0.5), (0, 0.5)])
    d = 0.25 * (1 + 2.85 / 100 - 0.84 / 1000)
    source = 'Seewald\'s correction of P L^3/(48 E I), middle plane (Timoshenko and Goodier, Theory of Elasticity)'
    values = [('point_dy', 1, -d, 5e-3 * d, 'asked for: 0.5 %; the force at a point makes the value drift with the mesh', source),
              ('point_dy', 2, 0, 1e-9, 'the loads balance: the spring that only places the beam carries nothing but round-off', source)]
    share = d / 100
    why = 'asked for: 0.5 %'
    write_case(os.path.join(HERE, 'supported'), text, values, 'beam on two supports, force on top of its middle, every basis',
               [('constant, side 0.03125', {'functions': 'constant', 'mesh.side': 0.03125}, 0.5 * share, why),
                ('linear, side 0.25', {'functions': 'linear', 'mesh.side': 0.25}, 0.5 * share, why),
                ('quadratic, side 0.25', {'functions': 'quadratic', 'mesh.side': 0.25}, 0.5 * share, why)])


exact_data()
clamped()
supported()
