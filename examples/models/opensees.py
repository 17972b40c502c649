"""Any OpenSees model as files for a study: build the model without contacts and loads, then `export("frame")`. Needs openseespy.

GimmeMCK is an integrator whose matrix is m M + c C + k K of the degrees of freedom that `fix` leaves free. No system is solved: the
messages of OpenSees that M or C is singular mean nothing. Models with `equalDOF` or rigid floors are not covered.
`supports`, {tag: name}, are nodes that the study moves; leave them free.
"""

import numpy as np
import openseespy.opensees as ops

from matrix_market import write_dofs, write_matrices

DIRECTIONS = {2: ["x", "y"], 3: ["x", "y", "rz"], 6: ["x", "y", "z", "rx", "ry", "rz"]}


def export(prefix, directions=None, supports=None):
    """Writes PREFIX.M.mtx, PREFIX.C.mtx, PREFIX.K.mtx and PREFIX.dofs.csv."""
    ops.wipeAnalysis()
    for command, name in [("system", "FullGeneral"), ("numberer", "Plain"), ("constraints", "Plain"), ("algorithm", "Linear")]:
        getattr(ops, command)(name)

    def matrix(m, c, k):
        ops.integrator("GimmeMCK", m, c, k)
        ops.analysis("Transient")
        ops.analyze(1, 0.0)
        a = np.array(ops.printA("-ret")).reshape(ops.systemSize(), -1)
        return (a + a.T) / 2

    M, C, K = matrix(1.0, 0.0, 0.0), matrix(0.0, 1.0, 0.0), matrix(0.0, 0.0, 1.0)
    rows = [None] * len(K)
    for node in ops.getNodeTags():
        equations, place = ops.nodeDOFs(node), [*ops.nodeCoord(node), 0.0][:3]
        for direction, row in zip(directions or DIRECTIONS[len(equations)], equations):
            if row >= 0 and rows[row]:
                raise ValueError(f"nodes {rows[row][0]} and {node} share an equation: equalDOF is not covered")
            if row >= 0:
                rows[row] = (node, direction, *place)
    write_matrices(prefix, M=M, K=K, **({"C": C} if C.any() else {}))
    write_dofs(f"{prefix}.dofs.csv", rows, supports)
    ops.wipeAnalysis()
