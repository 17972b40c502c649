"""Any OpenSees model as files for a study: build the model without contacts and loads, then `export("frame")`. Needs openseespy.

GimmeMCK is an integrator whose matrix is m M + c C + k K. No system is solved: the messages of OpenSees that the matrix is singular
mean nothing. The constraints (`fix`, `equalDOF`, `rigidLink`, `rigidDiaphragm`, chains of them) are read from the Penalty handler: with
a penalty of 1 it adds the sum of the squares of all constraints, with 0 nothing. The dofs that they tie are no rows of the matrices:
PREFIX.ties.csv has them as sums of dofs that are.
`supports`, {tag: name}, are nodes that the study moves; leave them free.
"""

import numpy as np
import openseespy.opensees as ops

from condense import check, condense
from matrix_market import write_dofs, write_matrices, write_ties

DIRECTIONS = {2: ["x", "y"], 3: ["x", "y", "rz"], 6: ["x", "y", "z", "rx", "ry", "rz"]}


def export(prefix, directions=None, supports=None):
    """Writes PREFIX.M.mtx, PREFIX.C.mtx, PREFIX.K.mtx, PREFIX.dofs.csv and, with tied dofs, PREFIX.ties.csv."""
    def matrix(m, c, k, penalty=0.0):
        ops.wipeAnalysis()
        for command, *values in [("system", "FullGeneral"), ("numberer", "Plain"), ("constraints", "Penalty", penalty, penalty),
                                 ("algorithm", "Linear"), ("integrator", "GimmeMCK", m, c, k), ("analysis", "Transient")]:
            getattr(ops, command)(*values)
        ops.analyze(1, 0.0)
        a = np.array(ops.printA("-ret")).reshape(ops.systemSize(), -1)
        return (a + a.T) / 2

    constraints, M, C, K = matrix(0.0, 0.0, 0.0, 1.0), matrix(1.0, 0.0, 0.0), matrix(0.0, 1.0, 0.0), matrix(0.0, 0.0, 1.0)
    dofs, tied = [None] * len(M), np.zeros(len(M), bool)
    constrained = set(ops.getConstrainedNodes() or [])
    for node in ops.getNodeTags():
        rows, place = ops.nodeDOFs(node), [*ops.nodeCoord(node), 0.0, 0.0][:3]
        for row, direction in zip(rows, directions or DIRECTIONS[len(rows)], strict=True):
            dofs[row] = (node, direction, *place)
        if node in constrained:
            tied[[rows[dof - 1] for dof in ops.getConstrainedDOFs(node)]] = True
    T, kept = condense(constraints, M, tied)
    check(M, K, T, kept, dofs, supports)
    M, C, K = ((a + a.T) / 2 for a in (T.T @ a @ T for a in (M, C, K)))
    write_matrices(prefix, M=M, K=K, **({"C": C} if C.any() else {}))
    write_dofs(f"{prefix}.dofs.csv", [dofs[i] for i in kept], supports)
    write_ties(f"{prefix}.ties.csv", dofs, T, kept)
    ops.wipeAnalysis()
