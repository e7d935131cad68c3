"""Where a rigid slab comes to rest that slides down a slope and over a kink or a rounded foot: a reference beside the program's steps.

The ground is a valley, so that the slab touches it with the two corners of its lower face alone, and free space is what all lines
of the profile leave: gaps are distances from lines. Between impacts Newton's and Euler's equations with Coulomb friction, by the
midpoint rule; where a corner reaches a line, Newton's law with restitution 0 and Coulomb's law for the impulse (Moreau 1988). In
both, every combination of open, sticking and sliding contacts is tried, and the one that fits is taken.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import itertools
import math

G = 9.81
CLOSED, STILL = 1e-9, 1e-9  # m, m/s


def solve(matrix, right):
    """Gaussian elimination with pivoting; None where the matrix is singular."""
    n = len(right)
    rows = [row[:] + [value] for row, value in zip(matrix, right)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(rows[r][i]))
        if abs(rows[pivot][i]) < 1e-12:
            return None
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for r in range(i + 1, n):
            factor = rows[r][i] / rows[i][i]
            rows[r] = [a - factor * b for a, b in zip(rows[r], rows[i])]
    values = [0.0] * n
    for i in reversed(range(n)):
        values[i] = (rows[i][n] - sum(rows[i][k] * values[k] for k in range(i + 1, n))) / rows[i][i]
    return values


class Slab:
    """Unit mass. `lines`: (point, angle, friction coefficient), from the slope to the level; angles fall below the horizontal.
    `state`: centroid, turn, and their velocities."""

    def __init__(self, lines, length, thickness, centre, turn):
        self.lines = [(point, (math.sin(a), math.cos(a)), (math.cos(a), -math.sin(a)), mu) for point, a, mu in lines]
        self.corners = ((-length / 2, -thickness / 2), (length / 2, -thickness / 2))
        self.inverse_mass = (1.0, 1.0, 12 / (length ** 2 + thickness ** 2))
        self.state = (*centre, turn, 0.0, 0.0, 0.0)

    def arm(self, state, corner):
        x, y = self.corners[corner]
        c, s = math.cos(state[2]), math.sin(state[2])
        return c * x - s * y, s * x + c * y

    def gap(self, state, contact):
        (x, y), normal, _, _ = self.lines[contact[1]]
        ax, ay = self.arm(state, contact[0])
        return (state[0] + ax - x) * normal[0] + (state[1] + ay - y) * normal[1]

    def rows(self, state, contact):
        """Of the velocities: those of the corner along normal and tangent; and the friction coefficient."""
        _, normal, tangent, mu = self.lines[contact[1]]
        ax, ay = self.arm(state, contact[0])
        return tuple((*d, ax * d[1] - ay * d[0]) for d in (normal, tangent)) + (mu,)

    def forces(self, contacts, free, tangential):
        """Forces (or impulses) at contacts and the accelerations (velocities) they leave of `free`. `tangential`: speed of each
        contact now, or None where the sign of what is left decides. `contacts`: (normal row, tangent row, friction, right side)."""
        m = self.inverse_mass
        dot = lambda a, b: sum(p * q for p, q in zip(a, b))
        for modes in itertools.product(('slide+', 'slide-', 'stick', 'open'), repeat=len(contacts)):
            columns, wanted, right = [], [], []
            for (n, t, mu, offset), mode, speed in zip(contacts, modes, tangential):
                if mode == 'open':
                    continue
                if speed is not None and (mode == 'stick' or (mode == 'slide+') != (speed > 0)):
                    break
                if mode == 'stick':
                    columns += [n, t]
                    wanted += [n, t]
                    right += [-offset[0] - dot(n, free), -offset[1] - dot(t, free)]
                else:
                    sign = 1 if mode == 'slide+' else -1
                    columns.append(tuple(a - sign * mu * b for a, b in zip(n, t)))
                    wanted.append(n)
                    right.append(-offset[0] - dot(n, free))
            else:
                found = solve([[sum(w[i] * m[i] * c[i] for i in range(3)) for c in columns] for w in wanted], right)
                if found is None:
                    continue
                left = tuple(f + m[i] * sum(c[i] * v for c, v in zip(columns, found)) for i, f in enumerate(free))
                if self.fits(contacts, modes, tangential, found, left):
                    return left
        raise ArithmeticError('no combination of contacts fits')

    @staticmethod
    def fits(contacts, modes, tangential, found, left):
        values = iter(found)
        for (n, t, mu, offset), mode, speed in zip(contacts, modes, tangential):
            normal = sum(a * b for a, b in zip(n, left)) + offset[0]
            along = sum(a * b for a, b in zip(t, left)) + offset[1]
            if mode == 'open':
                if normal < -1e-9:
                    return False
                continue
            pressure = next(values)
            if pressure < -1e-9:
                return False
            if mode == 'stick' and abs(next(values)) > mu * pressure + 1e-12:
                return False
            if speed is None and mode == 'slide+' and along < 0 or speed is None and mode == 'slide-' and along > 0:
                return False
        return True

    def all_contacts(self):
        return itertools.product(range(2), range(len(self.lines)))

    def closed(self, state):
        return [c for c in self.all_contacts() if self.gap(state, c) < CLOSED]

    def acceleration(self, state, closed):
        contacts, speeds = [], []
        for contact in closed:
            n, t, mu = self.rows(state, contact)
            ax, ay = self.arm(state, contact[0])
            turning = (-state[5] ** 2 * ax, -state[5] ** 2 * ay)
            along = sum(a * b for a, b in zip(t, state[3:]))
            contacts.append((n, t, mu, (n[0] * turning[0] + n[1] * turning[1], t[0] * turning[0] + t[1] * turning[1])))
            speeds.append(along if abs(along) > STILL else None)
        return self.forces(contacts, (0.0, -G, 0.0), speeds)

    def impact(self):
        contacts = [(*self.rows(self.state, contact), (0.0, 0.0)) for contact in self.closed(self.state)]
        velocity = self.forces(contacts, self.state[3:], [None] * len(contacts))
        self.state = (*self.state[:3], *velocity)

    def moved(self, dt):
        """By the midpoint rule, the contacts that close the step being those that close it now."""
        closed = [c for c in self.closed(self.state)
                  if sum(a * b for a, b in zip(self.rows(self.state, c)[0], self.state[3:])) < 1e-7]
        first = self.state[3:] + self.acceleration(self.state, closed)
        middle = tuple(s + dt / 2 * r for s, r in zip(self.state, first))
        rate = middle[3:] + self.acceleration(middle, closed)
        return tuple(s + dt * r for s, r in zip(self.state, rate))

    def set_down(self, state):
        """Removes what rounding and the rule leave of closed gaps: no contact drifts off its line."""
        for contact in self.all_contacts():
            gap = self.gap(state, contact)
            if -1e-6 < gap < 0:
                normal = self.lines[contact[1]][1]
                state = (state[0] - gap * normal[0], state[1] - gap * normal[1], *state[2:])
        return state

    def step(self, dt):
        """dt, or up to the first impact in it."""
        before = {c for c in self.all_contacts() if self.gap(self.state, c) >= CLOSED}
        reaches = lambda state: any(self.gap(state, c) < 0 for c in before)
        end = self.moved(dt)
        if not reaches(end):
            self.state = self.set_down(end)
            return dt
        low, high = 0.0, dt
        while high - low > 1e-13:
            middle = (low + high) / 2
            low, high = (low, middle) if reaches(self.moved(middle)) else (middle, high)
        self.state = self.set_down(self.moved(high))
        self.impact()
        return high


def run_out(lines, length, thickness, centre, turn, dt, longest=20.0):
    """Where the centroid comes to rest."""
    slab, time = Slab(lines, length, thickness, centre, turn), 0.0
    while time < longest:
        time += slab.step(dt)
        if time > 1 and max(abs(v) for v in slab.state[3:5]) < G * dt and slab.state[0] > -length:
            return slab.state[0]
    raise ArithmeticError('the slab does not come to rest')
