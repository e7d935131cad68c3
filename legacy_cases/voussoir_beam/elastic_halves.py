"""How far an elastic voussoir beam sags: half of it by finite elements between walls that only push.

Plane stress, Poisson's ratio 0, four-node quadrilaterals with the Green-Lagrange strain (large displacements, total Lagrangian
formulation: Bathe 1996, chapter 6); nodes on the wall, the seat and the plane of symmetry press or are free, by an active set.
Needs NumPy and SciPy, as no case does. Prints crown sag and thrust for three meshes, and the modulus below which none stands.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve

GAUSS = 1 / np.sqrt(3)
SEAT = 0.02  # length of the seat over the depth


def mesh(span, depth, rows):
    """Square elements and one narrow column on the seat; x from the plane of symmetry, y from the lower face."""
    columns = round(span / 2 / (depth / rows))
    x = np.concatenate([[-span / 2 - SEAT * depth], np.linspace(-span / 2, 0, columns + 1)])
    y = np.linspace(0, depth, rows + 1)
    nodes = np.array([(a, b) for a in x for b in y])
    corner = np.arange(len(x) * len(y)).reshape(len(x), len(y))
    elements = np.stack([corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]], -1).reshape(-1, 4)
    return nodes, elements, corner


def integration_points(nodes, elements):
    """Of every point of the rule: shape functions, their gradients in every element, and weights."""
    for a in (-GAUSS, GAUSS):
        for b in (-GAUSS, GAUSS):
            shape = np.array([(1 - a) * (1 - b), (1 + a) * (1 - b), (1 + a) * (1 + b), (1 - a) * (1 + b)]) / 4
            slope = np.array([[b - 1, 1 - b, 1 + b, -1 - b], [a - 1, -1 - a, 1 + a, 1 - a]]) / 4
            jacobian = np.einsum('ka,eai->eki', slope, nodes[elements])
            yield shape, np.einsum('eik,ka->eia', np.linalg.inv(jacobian), slope), np.linalg.det(jacobian)


def internal_forces(points, elements, moduli, u):
    """Forces and tangent stiffness of every element at the nodal displacements u."""
    count = len(elements)
    force, tangent = np.zeros((count, 8)), np.zeros((count, 8, 8))
    for _, gradient, weight in points:
        f = np.einsum('eai,eka->eik', u.reshape(-1, 2)[elements], gradient) + np.eye(2)  # deformation gradient
        green = (np.einsum('eki,ekj->eij', f, f) - np.eye(2)) / 2
        stress = np.stack([green[:, 0, 0], green[:, 1, 1], 2 * green[:, 0, 1]], -1) * moduli
        b = np.zeros((count, 3, 8))
        for i in range(2):
            b[:, 0, i::2] = f[:, i, 0, None] * gradient[:, 0]
            b[:, 1, i::2] = f[:, i, 1, None] * gradient[:, 1]
            b[:, 2, i::2] = f[:, i, 0, None] * gradient[:, 1] + f[:, i, 1, None] * gradient[:, 0]
        force += weight[:, None] * np.einsum('eva,ev->ea', b, stress)
        tangent += weight[:, None, None] * np.einsum('eva,v,evb->eab', b, moduli, b)
        tensor = np.stack([stress[:, 0], stress[:, 2], stress[:, 2], stress[:, 1]], -1).reshape(-1, 2, 2)
        geometric = weight[:, None, None] * np.einsum('eia,eij,ejb->eab', gradient, tensor, gradient)
        tangent[:, 0::2, 0::2] += geometric
        tangent[:, 1::2, 1::2] += geometric
    return force, tangent


def sag(span, depth, modulus, unit_weight, rows, most=60):
    """Sag of the upper crown corner and thrust, or None where Newton finds no equilibrium from the straight beam."""
    nodes, elements, corner = mesh(span, depth, rows)
    points = list(integration_points(nodes, elements))
    moduli = modulus * np.array([1, 1, 0.5])
    load, u = np.zeros(nodes.size), np.zeros(nodes.size)
    for shape, _, weight in points:
        np.add.at(load, 2 * elements + 1, -unit_weight * weight[:, None] * shape)
    unknowns = np.stack([2 * elements, 2 * elements + 1], -1).reshape(-1, 8)
    at = np.repeat(unknowns, 8, 1).ravel(), np.tile(unknowns, (1, 8)).ravel()
    wall, seat = 2 * corner[0], 2 * corner[:2, 0] + 1
    sides = {**{d: 1 for d in wall}, **{d: 1 for d in seat}, **{d: -1 for d in 2 * corner[-1]}}  # sign of the free side
    pressed = {2 * corner[0, 0], 2 * corner[1, 0] + 1, 2 * corner[-1, -1]}
    for passes in range(most):
        force, tangent = internal_forces(points, elements, moduli, u)
        internal = np.zeros(nodes.size)
        np.add.at(internal, unknowns, force)
        residual = load - internal
        if passes:
            now = {d for d, side in sides.items()
                   if (-side * residual[d] >= -1e-9 if d in pressed else side * u[d] < -1e-13)}
            settled, pressed = now == pressed, now
        matrix = sparse.csr_matrix((tangent.ravel(), at), shape=(nodes.size, nodes.size))
        held = np.array(sorted(pressed))
        free = np.setdiff1d(np.arange(nodes.size), held)
        change = np.zeros(nodes.size)
        change[held] = -u[held]
        change[free] = spsolve(matrix[free][:, free].tocsc(), residual[free] - matrix[free][:, held] @ change[held])
        largest = abs(change).max()
        u += change * min(1, 0.1 * depth / largest)
        if passes and settled and largest < 1e-12 * span:
            return -u[2 * corner[-1, -1] + 1], -sum(residual[d] for d in wall if d in pressed)
    return None


if __name__ == '__main__':
    for beam in ((10, 0.5, 5e9), (10, 1, 5e9), (20, 1, 1e10), (7, 0.25, 2e9), (7, 0.25, 1.8e9), (7, 0.25, 1.5e9),
                 (7, 0.25, 0.5e9)):
        for rows in (8, 16, 32):
            print('span %g m, depth %g m, E %g Pa, %d rows:' % (*beam, rows), 'sag %.5f m, thrust %.0f N' % found
                  if (found := sag(*beam, 25e3, rows)) else 'no equilibrium')
