"""Elastic blocks of plane-stress elements with four nodes, as files for a study.

    python3 plane_stress.py --nx 50 --ny 10 --length 1 --width 0.2 --nu 0.3 --to blocks
    python3 plane_stress.py --nx 316 --ny 157 --wall --to large           (about 10^5 degrees of freedom)

writes into the folder `blocks`:

    block.M.mtx, block.K.mtx       the matrices of one block, which are those of both
    left.dofs.csv, right.dofs.csv  nodes 1, 2, .. with directions and places: the right block begins where the left one ends
    face.csv, ends.csv             pairs of facing nodes: the inner ones and the two at the ends of the face

With --wall there is one block, block.dofs.csv, and its right face meets a wall.

A face that resists the overlap by k per unit of area gives a pair of nodes the stiffness k t w: t is the thickness, w the width
of the face that belongs to the pair. w is width/ny for inner pairs and half of it for the two at the ends. So the pairs are two
groups of contacts, and the ends have half the stiffness. A factor in a pair cannot do this: it scales r as well, a factor f gives
the stiffness k f^2, and the gap would have to be scaled, too.

Needs numpy and scipy.
"""

import argparse
from pathlib import Path

import numpy as np
from scipy.sparse import coo_array, diags_array

from matrix_market import write_dofs, write_matrices

CORNERS = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
GAUSS = CORNERS / np.sqrt(3)


def element(hx, hy, E, nu, rho, thickness):
    """Mass and stiffness (8 x 8) of a rectangle hx x hy, corners counterclockwise, x and y of each; 2 x 2 Gauss points."""
    elastic = E / (1 - nu**2) * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])
    m, k = np.zeros((8, 8)), np.zeros((8, 8))
    for xi, eta in GAUSS:
        x, y = CORNERS.T
        shape = (1 + x * xi) * (1 + y * eta) / 4
        dx, dy = x * (1 + y * eta) / (2 * hx), y * (1 + x * xi) / (2 * hy)
        strain, N = np.zeros((3, 8)), np.zeros((2, 8))
        strain[0, ::2], strain[1, 1::2], strain[2, ::2], strain[2, 1::2] = dx, dy, dy, dx
        N[0, ::2], N[1, 1::2] = shape, shape
        volume = thickness * hx * hy / 4
        k += volume * strain.T @ elastic @ strain
        m += volume * rho * N.T @ N
    return (m + m.T) / 2, (k + k.T) / 2


def block(nx, ny, length, width, E=1.0, nu=0.0, rho=1.0, thickness=1.0, mass="lumped"):
    """M, K (sparse) and the places of the nodes (rows X, Y). Node i (ny + 1) + j is in column i and row j of the mesh."""
    i, j = (a.ravel() for a in np.meshgrid(np.arange(nx), np.arange(ny), indexing="ij"))
    first = i * (ny + 1) + j
    nodes = np.stack([first, first + ny + 1, first + ny + 2, first + 1], axis=1)
    dofs = np.stack([2 * nodes, 2 * nodes + 1], axis=2).reshape(-1, 8)
    rows, columns = np.repeat(dofs, 8, axis=1).ravel(), np.tile(dofs, 8).ravel()
    size = 2 * (nx + 1) * (ny + 1)
    m, k = element(length / nx, width / ny, E, nu, rho, thickness)
    M, K = (coo_array((np.tile(a.ravel(), nx * ny), (rows, columns)), shape=(size, size)).tocsr() for a in (m, k))
    if mass == "lumped":
        M = diags_array(M.sum(axis=1))
    X, Y = np.meshgrid(np.linspace(0, length, nx + 1), np.linspace(-width / 2, width / 2, ny + 1), indexing="ij")
    return M, K, np.stack([X.ravel(), Y.ravel()], axis=1)


def dofs(places, shift=0.0):
    return [(node, direction, X + shift, Y, 0.0) for node, (X, Y) in enumerate(places.tolist(), 1) for direction in "xy"]


def pairs(path, cells):
    """Rows of a file of pairs: a name and the cells DOF:FACTOR."""
    with open(path, "w", encoding="utf-8") as file:
        file.write("name" + "".join(f",dof{i}" for i in range(1, len(cells[0]) + 1)) + "\n")
        for name, row in enumerate(cells, 1):
            file.write(f"{name}," + ",".join(row) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name, value in [("length", 1.0), ("width", 0.2), ("E", 1.0), ("nu", 0.3), ("rho", 1.0), ("thickness", 1.0)]:
        parser.add_argument(f"--{name}", type=float, default=value)
    parser.add_argument("--nx", type=int, default=50)
    parser.add_argument("--ny", type=int, default=10)
    parser.add_argument("--mass", choices=["lumped", "consistent"], default="lumped")
    parser.add_argument("--wall", action="store_true", help="one block and a wall")
    parser.add_argument("--to", type=Path, default=Path("."), help="folder, which is made")
    a = parser.parse_args()
    if a.ny < 3:
        parser.error("--ny must be at least 3, so that the face has inner pairs")
    M, K, places = block(a.nx, a.ny, a.length, a.width, a.E, a.nu, a.rho, a.thickness, a.mass)
    a.to.mkdir(parents=True, exist_ok=True)
    write_matrices(a.to / "block", M=M, K=K)
    last = a.nx * (a.ny + 1)
    if a.wall:
        write_dofs(a.to / "block.dofs.csv", dofs(places))
        cells = [[f"block.{last + j}.x:-1"] for j in range(1, a.ny + 2)]
    else:
        write_dofs(a.to / "left.dofs.csv", dofs(places))
        write_dofs(a.to / "right.dofs.csv", dofs(places, a.length))
        cells = [[f"left.{last + j}.x:-1", f"right.{j}.x:1"] for j in range(1, a.ny + 2)]
    pairs(a.to / "face.csv", cells[1:-1])
    pairs(a.to / "ends.csv", [cells[0], cells[-1]])


if __name__ == "__main__":
    main()
