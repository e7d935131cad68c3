"""Timoshenko's cantilever under a force at its tip put on at once: modes, their shares of the deflection, and the swing of the tip.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import functools
import math

LENGTH, DEPTH, YOUNG, POISSON, DENSITY = 10.0, 1.0, 1e9, 0.3, 2500.0
SHEAR_FACTOR = 10 * (1 + POISSON) / (12 + 11 * POISSON)  # Cowper 1966
# Of the plane body: 80 x 8 quadrilaterals of second order, modes of bending (Hz).
PLANE_FREQUENCIES = (1.014947, 6.088759, 16.03801, 29.14489)


def product(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def exponential(a):
    """By its series, of a / 2^halvings, then squared."""
    size = max(sum(abs(x) for x in row) for row in a)
    halvings = max(0, math.ceil(math.log2(4 * size)))
    a = [[x / 2 ** halvings for x in row] for row in a]
    total = [[float(i == j) for j in range(4)] for i in range(4)]
    term = [row[:] for row in total]
    for k in range(1, 16):
        term = [[x / k for x in row] for row in product(term, a)]
        total = [[x + y for x, y in zip(*rows)] for rows in zip(total, term)]
    for _ in range(halvings):
        total = product(total, total)
    return total


def response(squared):
    """Determinant and deflection times it of a tip under a unit force at frequency sqrt(squared); state: w, slope, moment, shear."""
    inertia, share = DEPTH ** 3 / 12, squared * DENSITY
    shear = SHEAR_FACTOR * DEPTH * YOUNG / (2 * (1 + POISSON))
    field = [[0, 1, 0, 1 / shear], [0, 0, 1 / (YOUNG * inertia), 0], [0, -share * inertia, 0, -1], [-share * DEPTH, 0, 0, 0]]
    # Scaled by E so that all entries are of one size.
    scale = (1, 1, 1 / YOUNG, 1 / YOUNG)
    end = exponential([[LENGTH * x * scale[i] / scale[j] for j, x in enumerate(row)] for i, row in enumerate(field)])
    (a, b), (c, d) = end[2][2:], end[3][2:]
    return a * d - b * c, (end[0][3] * a - end[0][2] * b) / YOUNG


@functools.cache
def modes(count=8):
    """Circular frequency and share of the static deflection of each."""
    def determinant(omega):
        return response(omega * omega)[0]

    def root(low, high):
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (low, middle) if determinant(low) * determinant(middle) <= 0 else (middle, high)
        return low

    det, tip = response(0.0)
    static = tip / det
    found, omega = [], 0.5
    while len(found) < count:
        if determinant(omega) * determinant(omega + 0.5) < 0:
            at = root(omega, omega + 0.5)
            h = 1e-5 * at * at
            slope = (response(at * at + h)[0] - response(at * at - h)[0]) / (2 * h)
            found.append((at, -response(at * at)[1] / slope / at ** 2 / static))
        omega += 0.5
    return found


def swing(time, frequencies=PLANE_FREQUENCIES):
    """Deflection of the tip over the static one; with the given frequencies for the first modes."""
    total = sum(share for _, share in modes())
    return sum(share / total * (1 - math.cos((2 * math.pi * frequencies[i] if i < len(frequencies) else omega) * time))
               for i, (omega, share) in enumerate(modes()))


if __name__ == '__main__':
    print('frequency, Hz   share of the static deflection')
    for omega, share in modes()[:4]:
        print('%10.4f %14.4f' % (omega / (2 * math.pi), share))
    for name, frequencies in (('its own', ()), ("the plane body's", PLANE_FREQUENCIES)):
        for periods in (1, 5.05):
            times = [periods * i / 20000 for i in range(20001)]
            print('highest within %.2f s, with %s frequencies: %.4f' % (periods, name, max(swing(t, frequencies) for t in times)))
