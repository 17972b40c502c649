"""Writes matrices and their degrees of freedom as the files that a study reads: the recipe for any program.

    write_matrices("tower", M=M, K=K)      tower.M.mtx, tower.K.mtx
    write_dofs("tower.dofs.csv", dofs)
    write_ties("tower.ties.csv", all_dofs, T, kept)      if constraints tie dofs
    write_forces("tower.forces.csv", dofs, forces)       if a study asks for forces of members

The matrices are symmetric arrays or scipy.sparse matrices. dofs has one row for each row of the matrices: (node, direction) or
(node, direction, X, Y, Z). The direction is x, y, z, rx, ry or rz. `supports`, {node: name}, has the nodes that move as supports
of the study do. With u = T u[kept] of all dofs, the matrices are T'MT, and dofs the kept ones; the others are the ties.
forces, {name: (quantity, row)}, are products of a row with u of dofs, each a `force` or a `moment`. Needs scipy.
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


def write_ties(path, dofs, T, kept):
    """Writes the dofs that are not kept and move as sums `dof:factor` of kept ones; without such dofs, no file."""
    kept, T = list(kept), scipy.sparse.csr_array(T)
    lines = []
    for i in sorted(set(range(len(dofs))) - set(kept)):
        terms = range(T.indptr[i], T.indptr[i + 1])
        cells = [f"{{}}.{{}}:{float(T.data[t])!r}".format(*dofs[kept[T.indices[t]]]) for t in terms]
        if cells:
            lines.append(",".join([*map(str, dofs[i][:2]), *cells]))
    if lines:
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(["node,direction,terms", *lines]) + "\n")


def write_forces(path, dofs, forces):
    """Writes forces as sums `dof:factor` of displacements; without forces, no file."""
    if forces:
        with open(path, "w", encoding="utf-8") as file:
            file.write("name,quantity,terms\n")
            for name, (quantity, row) in forces.items():
                cells = [f"{node}.{direction}:{float(factor)!r}" for (node, direction, *_), factor in zip(dofs, row) if factor]
                file.write(",".join([name, quantity, *cells]) + "\n")
