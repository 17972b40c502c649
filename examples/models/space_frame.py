"""A frame in space by numpy, as files for a study: what a program of your own does with its matrices.

    python3 space_frame.py [FOLDER]

writes portal.M.mtx, portal.K.mtx and portal.dofs.csv: four columns with two floors of beams. Units t, kN, m, s; z points up. The masses
are at the nodes, the rotations have none. Needs numpy and scipy.
"""

import sys
from pathlib import Path

import numpy as np

from matrix_market import write_dofs, write_matrices

E, G, A, I, J = 3.0e7, 1.25e7, 0.09, 6.75e-4, 1.1e-3
PLAN = [(0.0, 0.0), (5.0, 0.0), (5.5, 4.0), (0.0, 4.0)]
HEIGHT, FLOORS, MASS = 3.0, 2, 8.0


def beam(a, b):
    """Stiffness (12 x 12) of a beam from a to b: x, y, z, rx, ry, rz of each end."""
    axis = b - a
    L = np.linalg.norm(axis)
    x = axis / L
    side = np.cross([0.0, 0.0, 1.0] if abs(x[2]) < 0.9 else [0.0, 1.0, 0.0], x)
    y = side / np.linalg.norm(side)
    k = np.zeros((12, 12))
    for i, stiffness in ((0, E * A / L), (3, G * J / L)):
        k[np.ix_([i, i + 6], [i, i + 6])] += stiffness * np.array([[1, -1], [-1, 1]])
    bending = E * I / L**3 * np.array([[12, 6 * L, -12, 6 * L], [6 * L, 4 * L**2, -6 * L, 2 * L**2],
                                       [-12, -6 * L, 12, -6 * L], [6 * L, 2 * L**2, -6 * L, 4 * L**2]])
    for at, sign in (([1, 5, 7, 11], 1), ([2, 4, 8, 10], -1)):
        s = np.array([1, sign, 1, sign])
        k[np.ix_(at, at)] += bending * np.outer(s, s)
    turn = np.kron(np.eye(4), np.array([x, y, np.cross(x, y)]))
    return turn.T @ k @ turn


def frame():
    """M, K and dofs without the nodes on the ground. Node 10 f + c is on floor f at column c."""
    places = {10 * f + c: np.array([X, Y, HEIGHT * f]) for f in range(FLOORS + 1) for c, (X, Y) in enumerate(PLAN, 1)}
    beams = [(10 * f + c, 10 * f + c + 10) for f in range(FLOORS) for c in range(1, 5)]
    beams += [(10 * f + c, 10 * f + c % 4 + 1) for f in range(1, FLOORS + 1) for c in range(1, 5)]
    nodes = sorted(places)
    K = np.zeros((6 * len(nodes), 6 * len(nodes)))
    for a, b in beams:
        at = [6 * nodes.index(n) + i for n in (a, b) for i in range(6)]
        K[np.ix_(at, at)] += beam(places[a], places[b])
    free = [n for n in nodes if n > 10]
    kept = slice(6 * (len(nodes) - len(free)), None)
    K = (K + K.T)[kept, kept] / 2
    M = np.diag(np.tile([MASS] * 3 + [0.0] * 3, len(free)))
    return M, K, [(n, d, *places[n].tolist()) for n in free for d in ("x", "y", "z", "rx", "ry", "rz")]


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    folder.mkdir(parents=True, exist_ok=True)
    M, K, dofs = frame()
    write_matrices(folder / "portal", M=M, K=K)
    write_dofs(folder / "portal.dofs.csv", dofs)


if __name__ == "__main__":
    main()
