"""Models of the studies of reductions: a bar, and two frames of which one strikes the other between its floors.

    python3 pounding.py [FOLDER]

writes bar.M.mtx, bar.K.mtx, bar.dofs.csv and the same of `towers`. The bar has length, mass and wave speed 1; its nodes 1 to 61 have
lumped masses. The frames have units t, kN, m, s and beams with bending; node a2_10 is in column 2 of frame a, 10 elements above the
ground. Frame a has floors at 3.2, 6.4 and 9.6 m. The roof of frame b is at 8 m, at a2_10. Rotations have no mass. Needs numpy and scipy.
"""

import sys
from pathlib import Path

import numpy as np

from matrix_market import write_dofs, write_matrices

ELEMENTS = 60
E = 3.0e7
COLUMN = (0.09, 6.75e-4)   # A, I
BEAM = (0.12, 1.6e-3)
STOREYS, PARTS, DENSITY = 3, 4, 2.5
FRAMES = {"a": {"x": (0.0, 6.0), "height": 3.2, "mass": 20.0}, "b": {"x": (6.1, 11.1), "height": 8 / 3, "mass": 32.0}}


def bar(n):
    """M, K and dofs of a free bar of n elements."""
    m = np.full(n + 1, 1 / n)
    m[[0, -1]] /= 2
    K = n * (np.diag(np.r_[1, np.full(n - 1, 2.0), 1]) - np.eye(n + 1, k=1) - np.eye(n + 1, k=-1))
    return np.diag(m), K, [(i + 1, "x", i / n, 0.0, 0.0) for i in range(n + 1)]


def beam(a, b, A, I):
    """Stiffness (6 x 6) of a beam from a to b: x, y, rz of each end."""
    L = np.linalg.norm(b - a)
    c, s = (b - a) / L
    k = np.zeros((6, 6))
    k[np.ix_([0, 3], [0, 3])] = E * A / L * np.array([[1, -1], [-1, 1]])
    k[np.ix_([1, 2, 4, 5], [1, 2, 4, 5])] = E * I / L**3 * np.array(
        [[12, 6 * L, -12, 6 * L], [6 * L, 4 * L**2, -6 * L, 2 * L**2],
         [-12, -6 * L, 12, -6 * L], [6 * L, 2 * L**2, -6 * L, 4 * L**2]])
    turn = np.kron(np.eye(2), np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]))
    return turn.T @ k @ turn


def towers():
    """M, K and dofs of the frames without the nodes on the ground."""
    places, beams, mass = {}, [], {}
    for name, frame in FRAMES.items():
        step = frame["height"] / PARTS
        for column, x in enumerate(frame["x"], 1):
            nodes = [f"{name}{column}_{i}" for i in range(STOREYS * PARTS + 1)]
            for i, node in enumerate(nodes):
                places[node] = np.array([x, i * step])
                mass[node] = DENSITY * COLUMN[0] * step + (frame["mass"] / 2 if i % PARTS == 0 else 0.0)
            beams += [(a, b, *COLUMN) for a, b in zip(nodes, nodes[1:])]
        beams += [(f"{name}1_{i}", f"{name}2_{i}", *BEAM) for i in range(PARTS, STOREYS * PARTS + 1, PARTS)]
    free = [node for node in places if not node.endswith("_0")]
    order = free + [node for node in places if node.endswith("_0")]
    K = np.zeros((3 * len(order), 3 * len(order)))
    for a, b, A, I in beams:
        at = [3 * order.index(node) + i for node in (a, b) for i in range(3)]
        K[np.ix_(at, at)] += beam(places[a], places[b], A, I)
    size = 3 * len(free)
    K = ((K + K.T) / 2)[:size, :size]
    M = np.diag([mass[node] if direction != "rz" else 0.0 for node in free for direction in ("x", "y", "rz")])
    return M, K, [(node, direction, *places[node].round(9).tolist(), 0.0) for node in free for direction in ("x", "y", "rz")]


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    folder.mkdir(parents=True, exist_ok=True)
    for name, (M, K, dofs) in {"bar": bar(ELEMENTS), "towers": towers()}.items():
        write_matrices(folder / name, M=M, K=K)
        write_dofs(folder / f"{name}.dofs.csv", dofs)


if __name__ == "__main__":
    main()
