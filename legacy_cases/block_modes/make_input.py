"""Writes the cases of block_modes: a block on a slope stands, slides, topples, or slides and topples.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import G, PIVOT, SlopeScene, analysis, rk4, swing, variant, write_case  # noqa: E402

TOPPLE_SLIDING = ('two ordinary differential equations of a rigid block whose toe slides with friction, fourth-order '
                  'Runge-Kutta (benchmark dda-15)')
ROWS = ((1, 2, 20, 30, 'stable'), (1, 2, 30, 40, 'topple'), (1, 4, 20, 40, 'topple'), (1, 2, 30, 20, 'slide'),
        (1, 4, 30, 20, 'topple'), (1, 1, 30, 20, 'slide'), (1, 3, 25, 30, 'topple'), (1, 4, 30, 16, 'slide_topple'))


def about_toe(b, h, slope, end, steps=4000):
    """How far the block has turned about a toe that holds, and the greatest tan phi that holding it took."""
    p2, alpha = swing(b, h)
    radius = math.hypot(b, h) / 2
    state, most = [slope - alpha, 0.0], 0.0
    for _ in range(steps):
        theta, rate = state  # theta: from the vertical to the line from toe to centroid, down-slope positive
        change = p2 * math.sin(theta)
        ax = radius * (math.cos(theta) * change - math.sin(theta) * rate ** 2)
        ay = -radius * (math.sin(theta) * change + math.cos(theta) * rate ** 2)
        tangential = ax * math.cos(slope) - (G + ay) * math.sin(slope)
        normal = ax * math.sin(slope) + (G + ay) * math.cos(slope)
        most = max(most, abs(tangential) / normal)
        state = rk4(lambda t, y: [y[1], p2 * math.sin(y[0])], state, 0, end / steps, 1)
    return state[0] - (slope - alpha), most


def with_sliding_toe(b, h, slope, mu, end):
    """Rotation, and displacement of the centroid, of a block whose toe slides down-slope.

    s is the way of the toe, psi the turn; (ox, oy) leads from toe to centroid along and out of the slope. With N the normal
    force per mass and k the square of the radius of inertia: N = g cos a + oy'', k psi'' = N (ox + mu oy),
    s'' = g sin a - mu N - ox''.
    """
    k = (b * b + h * h) / 12

    def arm(psi):
        return (-b / 2 * math.cos(psi) + h / 2 * math.sin(psi), b / 2 * math.sin(psi) + h / 2 * math.cos(psi))

    def rate(_, y):
        ox, oy = arm(y[2])
        lever = ox + mu * oy
        turn = lever * (G * math.cos(slope) - oy * y[3] ** 2) / (k + ox * lever)
        normal = G * math.cos(slope) - ox * turn - oy * y[3] ** 2
        return [y[1], G * math.sin(slope) - mu * normal - oy * turn + ox * y[3] ** 2, y[3], turn]

    s, speed, psi, _ = rk4(rate, [0.0] * 4, 0, end, 4000)
    assert speed > 0, 'the toe does not slide'
    ox, oy = arm(psi)
    return psi, math.hypot(s + ox + b / 2, oy - h / 2)


def standing(slope, mu, b, h):
    source = 'statics: b/h > tan a and phi > a'
    return [('rotation', 2, 1.0, 0, 1e-4, 'the elastic block leans under its weight', source),
            ('travel', 2, 1.0, 0, 1e-7, 'it stands', source)]


def sliding(slope, mu, b, h):
    acceleration = G * (math.sin(slope) - math.cos(slope) * mu)
    source = 'closed form: g/2 (sin a - cos a tan phi) t^2, b/h >= tan phi (benchmark dda-15)'
    return [('displacement', 2, t, acceleration * t * t / 2, 0.01 * acceleration * t * t / 2, 'asked for (dda-03): 1 %', source)
            for t in (0.5, 1.0)] + [('rotation', 2, 1.0, 0, 1e-4, 'it slides flat: only the elastic lean', source)]


def turning(motion, source):
    expected = []
    for t in (0.1, 0.25, 0.5):
        turn, way = motion(t)
        expected += [('rotation', 2, t, -turn, 0.03 * turn, 'asked for: 3 % of the angular acceleration', source),
                     ('displacement', 2, t, way, 0.03 * way, 'as the rotation', source)]
    return expected


def toppling(slope, mu, b, h):
    def motion(t):
        turn, needed = about_toe(b, h, slope, t)
        assert needed <= mu, 'the toe slides'
        return turn, 2 * math.hypot(b, h) / 2 * math.sin(turn / 2)
    return turning(motion, PIVOT + ' (benchmark dda-15)')


def toppling_and_sliding(slope, mu, b, h):
    return turning(lambda t: with_sliding_toe(b, h, slope, mu, t), TOPPLE_SLIDING)


EXPECTED = {'stable': standing, 'slide': sliding, 'topple': toppling, 'slide_topple': toppling_and_sliding}

for number, (width, height, slope_deg, friction_deg, mode) in enumerate(ROWS, 1):
    scene = SlopeScene(slope_deg)
    scene.on_slope(6, 0, 6 + width, height)
    steps = 1000 if mode in ('stable', 'slide') else 500
    rows = EXPECTED[mode](math.radians(slope_deg), math.tan(math.radians(friction_deg)), width, height)
    write_case(os.path.join(HERE, 'row_%d_%s' % (number, mode)), scene, analysis(1e-3, steps, friction_deg), rows,
               'a block %g m x %g m on a slope of %g degrees with friction %g degrees: %s (benchmark dda-15)'
               % (width, height, slope_deg, friction_deg, mode.replace('_', ' and ')),
               variants=[variant('5 ms', time_step=0.005, steps=steps // 5), variant('rigid', basis='rigid')])
