"""Writes the cases of newmark_sine: a sine of acceleration on a block on a slope.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
from ddaml_case import G, SlopeScene, analysis, variant, write_case  # noqa: E402

ROWS_A_PERIOD = 200  # of the table: linear between rows, 8e-5 less than the sine on average
ORACLE_STEP = 2e-5
SOURCE = ("equation of motion of a rigid block with Coulomb friction both ways, midpoint steps of 2e-5 s: "
          "s'' = g (sin a - mu cos a) + a(t) (cos a + mu sin a) down-slope (benchmark dda-08)")


def slides(slope, friction, acceleration, times):
    """Down-slope displacement at the given times."""
    c, s, mu = math.cos(math.radians(slope)), math.sin(math.radians(slope)), math.tan(math.radians(friction))
    way = speed = 0.0
    wanted = {round(t / ORACLE_STEP): t for t in times}
    found = {}
    for i in range(max(wanted)):
        a = acceleration((i + 0.5) * ORACLE_STEP)
        drive, hold = G * s + a * c, mu * max(0.0, G * c - a * s)
        if speed == 0.0:
            after = 0.0 if abs(drive) <= hold else (drive - math.copysign(hold, drive)) * ORACLE_STEP
        else:
            after = speed + (drive - math.copysign(hold, speed)) * ORACLE_STEP
            if after * speed < 0:
                after = 0.0
        way += (speed + after) / 2 * ORACLE_STEP
        speed = after
        if i + 1 in wanted:
            found[wanted[i + 1]] = way
    return found


def case(name, slope, friction, amplitude, frequency, end):
    def acceleration(t):
        return amplitude * G * math.sin(2 * math.pi * frequency * t)

    scene = SlopeScene(slope)
    scene.on_slope(5, 0, 6, 1)
    found = slides(slope, friction, acceleration, [0.5 * k for k in range(1, 2 * end + 1)])
    of_cycle = found[1.0] / frequency if slope else found[0.5]
    expected = [('displacement', 2, t, s, min(0.02 * of_cycle * max(1, t * frequency), 0.09 * s), 'asked for: 2 % a cycle; at most 9 % of the value', SOURCE)
                for t, s in sorted(found.items())]
    step = 1 / (ROWS_A_PERIOD * frequency)
    write_case(os.path.join(HERE, name), scene, analysis(1e-3, 1000 * end, friction), expected,
               'a sine of %g g at %g Hz on a block on a slope of %g degrees, friction %g degrees (benchmark dda-08)'
               % (amplitude, frequency, slope, friction), slow=True,
               motion=[(k * step, acceleration(k * step), 0) for k in range(round(end / step) + 1)],
               variants=[variant('5 ms', time_step=0.005, steps=200 * end), variant('rigid', basis='rigid'),
                         variant('springs of 10 E', enforcement='penalty')])


case('row_1', 20, 30, 0.5, 1, 5)
case('row_2', 20, 30, 0.5, 2, 5)
case('row_3', 10, 15, 0.3, 1, 4)
case('row_4', 0, 10, 0.3, 1, 4)
case('row_5', 28, 32, 0.25, 3, 4)
