"""Writes matrices and their degrees of freedom as the files that a study reads: the recipe for any program.

    write_matrices("tower", M=M, K=K)      tower.M.mtx, tower.K.mtx
    write_dofs("tower.dofs.csv", dofs)

The matrices are symmetric arrays or scipy.sparse matrices. dofs has one row for each row of the matrices: (node, direction) or
(node, direction, X, Y, Z). The direction is x, y, z, rx, ry or rz. `supports`, {node: name}, has the nodes that move as supports
of the study do. Needs scipy.
"""

import scipy.sparse
from scipy.io import mmwrite


def write_matrices(prefix, **matrices):
    for name, matrix in matrices.items():
        with open(f"{prefix}.{name}.mtx", "wb") as file:
            mmwrite(file, scipy.sparse.coo_array(matrix), precision=17, symmetry="symmetric")


def write_dofs(path, dofs, supports=None):
    rows = [("node", "direction", "X", "Y", "Z")[:len(dofs[0])], *dofs]
    if supports:
        rows = [(*row[:2], supports.get(row[0], "") if i else "support", *row[2:]) for i, row in enumerate(rows)]
    with open(path, "w", encoding="utf-8") as file:
        for row in rows:
            file.write(",".join(map(str, row)) + "\n")
