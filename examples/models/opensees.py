"""Any OpenSees model as files for a study: build the model without contacts and loads, then `export("frame")`. Needs openseespy.

GimmeMCK is an integrator whose matrix is m M + c C + k K. No system is solved: the messages of OpenSees that the matrix is singular
mean nothing. The constraints (`fix`, `equalDOF`, `rigidLink`, `rigidDiaphragm`, chains of them) are read from the Penalty handler,
which adds penalties times the squares of those of `fix` and of the others. The dofs that they tie are no rows of the matrices:
PREFIX.ties.csv has them as sums of dofs that are. `supports`, {tag: name}, are nodes that the study moves; leave them free.
"""

import numpy as np
import openseespy.opensees as ops

from condense import check, condense, condensed
from matrix_market import write_dofs, write_matrices, write_ties

# By the numbers of coordinates and of dofs of a node. Of other nodes the caller gives the directions.
DIRECTIONS = {(1, 1): ["x"], (2, 2): ["x", "y"], (2, 3): ["x", "y", "rz"], (3, 3): ["x", "y", "z"], (3, 6): ["x", "y", "z", "rx", "ry", "rz"]}


def export(prefix, directions=None, supports=None):
    """Writes PREFIX.M.mtx, PREFIX.C.mtx, PREFIX.K.mtx, PREFIX.dofs.csv and, with tied dofs, PREFIX.ties.csv."""
    def matrix(m, c, k, fixed=0.0, others=0.0):
        ops.wipeAnalysis()
        for command, *values in [("system", "FullGeneral"), ("numberer", "Plain"), ("constraints", "Penalty", fixed, others),
                                 ("algorithm", "Linear"), ("integrator", "GimmeMCK", m, c, k), ("analysis", "Transient")]:
            getattr(ops, command)(*values)
        ops.analyze(1, 0.0)
        a = np.array(ops.printA("-ret")).reshape(ops.systemSize(), -1)
        return (a + a.T) / 2

    M, C, K = matrix(1.0, 0.0, 0.0), matrix(0.0, 1.0, 0.0), matrix(0.0, 0.0, 1.0)
    rows = {node: ops.nodeDOFs(node) for node in ops.getNodeTags()}
    dofs = [None] * len(M)
    for node, own in rows.items():
        place = ops.nodeCoord(node)
        names = directions or DIRECTIONS.get((len(place), len(own)), [])
        if len(names) != len(own):
            raise ValueError(f"node {node} has {len(own)} dofs and {len(place)} coordinates: give `directions` of so many dofs")
        for row, direction in zip(own, names):
            dofs[row] = (node, direction, *[*place, 0.0, 0.0][:3])
    fixed, squares = matrix(0.0, 0.0, 0.0, fixed=1.0).diagonal() > 0.0, matrix(0.0, 0.0, 0.0, others=1.0)
    constraints, tied = [row for row in np.eye(len(M))[fixed]], np.zeros(len(M), bool)
    for node in ops.getConstrainedNodes() or []:
        for dof in ops.getConstrainedDOFs(node):
            # 1 at the tied dof: its products with the dofs of the node that it follows are of this constraint alone.
            row = np.eye(len(M))[rows[node][dof - 1]]
            others = [i for retained in ops.getRetainedNodes(node) for i in rows[retained]]
            row[others] = squares[rows[node][dof - 1], others]
            constraints.append(row)
            tied[rows[node][dof - 1]] = True
    constraints = np.reshape(constraints, (-1, len(M)))
    T, kept = condense(constraints, M, tied)
    check(M, K, T, kept, dofs, supports)
    M, C, K = (condensed(a, T)[0] for a in (M, C, K))
    write_matrices(prefix, M=M, K=K, **({"C": C} if C.any() else {}))
    write_dofs(f"{prefix}.dofs.csv", [dofs[i] for i in kept], supports)
    write_ties(f"{prefix}.ties.csv", dofs, T, kept)
    ops.wipeAnalysis()
