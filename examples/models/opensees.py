"""Any OpenSees model as files for a study: build the model without contacts and loads, then `export("frame")`. Needs openseespy.

GimmeMCK is an integrator whose matrix is m M + c C + k K. No system is solved: the messages of OpenSees that the matrix is singular
mean nothing. The constraints (`fix`, `equalDOF`, `rigidLink`, `rigidDiaphragm`, chains of them) are read from the Penalty handler,
which adds penalties times the squares of those of `fix` and of the others. The dofs that they tie are no rows of the matrices:
PREFIX.ties.csv has them as sums of dofs that are. `supports`, {tag: name}, are nodes that the study moves; leave them free.

Only a linear model has matrices. Loads are refused, and elements whose matrices change where all nodes move: leave them out and model
them as contacts of the study, or write their matrices at the present state by `nonlinear=True`. The model is at its start afterwards.
"""

import numpy as np
import openseespy.opensees as ops

from condense import check, condense, condensed
from matrix_market import write_dofs, write_matrices, write_ties

# By the numbers of coordinates and of dofs of a node. Of other nodes the caller gives the directions.
DIRECTIONS = {(1, 1): ["x"], (2, 2): ["x", "y"], (2, 3): ["x", "y", "rz"], (3, 3): ["x", "y", "z"], (3, 6): ["x", "y", "z", "rx", "ry", "rz"]}


# Displacements of the nodes over the size of the model, and rotations, at which an element must have the same matrices, and the
# part of an entry below which its change is round-off.
MOVED, SAME = 1.0, 1e-9


def refuse_loads():
    """A load, and a motion by `sp`, would be lost, or hold a node that the study moves."""
    for pattern in ops.getPatterns() or []:
        loads = [f"a load on node {node}" for node in ops.getNodeLoadTags(pattern) or []]
        loads += [f"a load on element {element}" for element in ops.getEleLoadTags(pattern) or []]
        what = ", ".join(loads) or "a motion of nodes (`sp`) or of the ground"
        raise ValueError(f"pattern {pattern} has {what}: a study has its own loads and motions; `remove('loadPattern', {pattern})` first")


def changing(matrix):
    """The elements whose K or C is another one where all nodes have moved, and move: [[tag, nodes], ...]."""
    places = np.array([node for node in ops.getNodeTags() for _ in ops.nodeDOFs(node)])
    order = np.array([dof for node in ops.getNodeTags() for dof in ops.nodeDOFs(node)])
    coordinates = np.array([[*ops.nodeCoord(node), 0.0, 0.0][:3] for node in ops.getNodeTags()])
    size = np.ptp(coordinates, axis=0).max() or 1.0
    first, changed = [matrix(0.0, 0.0, 1.0), matrix(0.0, 1.0, 0.0)], np.zeros((len(order),) * 2, bool)
    for sign in (1.0, -1.0):
        moved = move(sign * MOVED, size)
        for one, other in zip(first, [matrix(0.0, 0.0, 1.0), matrix(0.0, 1.0, 0.0)] if moved else [np.inf, np.inf]):
            changed |= ~(np.abs(other - one) <= SAME * np.maximum(np.abs(one), np.abs(one).max() * SAME))
        ops.reset()
    changed = changed[np.ix_(order, order)]
    found = []
    for element in ops.getEleTags() or []:
        nodes = ops.eleNodes(element)
        pairs = [(a, b) for a in nodes for b in nodes if a != b] or [(nodes[0], nodes[0])]
        if any(changed[np.ix_(places == a, places == b)].any() for a, b in pairs):
            found.append((element, nodes))
    return found or ([("?", [])] if changed.any() else [])


def move(part, size):
    """One step in which all nodes get displacements and velocities without any pattern; whether the elements can."""
    tag = 1 + max([0, *(ops.getPatterns() or [])])
    ops.timeSeries("Linear", series := 87_654_321)
    ops.pattern("Plain", tag, series)
    for node in ops.getNodeTags():
        held = ops.getFixedDOFs(node) if node in (ops.getFixedNodes() or []) else []
        lengths = len(ops.nodeCoord(node)) if len(ops.nodeDOFs(node)) > 1 else 1
        for dof in range(1, len(ops.nodeDOFs(node)) + 1):
            if dof not in held:
                ops.sp(node, dof, part * np.sin(1.0 + 7.3 * node + 2.9 * dof) * (size if dof <= lengths else 1.0))
    ops.wipeAnalysis()
    for command, *values in [("system", "FullGeneral"), ("numberer", "Plain"), ("constraints", "Penalty", 1e16, 0.0),
                             ("algorithm", "Linear"), ("integrator", "Newmark", 0.5, 0.25), ("analysis", "Transient")]:
        getattr(ops, command)(*values)
    done = ops.analyze(1, 1.0) == 0
    ops.wipeAnalysis()
    ops.remove("loadPattern", tag)
    ops.remove("timeSeries", series)
    return done


def export(prefix, directions=None, supports=None, nonlinear=False):
    """Writes PREFIX.M.mtx, PREFIX.C.mtx, PREFIX.K.mtx, PREFIX.dofs.csv and, with tied dofs, PREFIX.ties.csv."""
    def matrix(m, c, k, fixed=0.0, others=0.0):
        ops.wipeAnalysis()
        for command, *values in [("system", "FullGeneral"), ("numberer", "Plain"), ("constraints", "Penalty", fixed, others),
                                 ("algorithm", "Linear"), ("integrator", "GimmeMCK", m, c, k), ("analysis", "Transient")]:
            getattr(ops, command)(*values)
        ops.analyze(1, 0.0)
        a = np.array(ops.printA("-ret")).reshape(ops.systemSize(), -1)
        return (a + a.T) / 2

    refuse_loads()
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
    if found := changing(matrix):
        names = "; ".join(f"element {element} of nodes {', '.join(map(str, nodes))}" for element, nodes in found[:10])
        text = f"{len(found)} elements have other matrices where their nodes move ({names}): the files have those of the present state"
        if not nonlinear:
            raise ValueError(f"{text}; model them as contacts of the study, or allow it by `nonlinear=True`")
        print(f"export: {text}")
    M, C, K = (condensed(a, T)[0] for a in (M, C, K))
    write_matrices(prefix, M=M, K=K, **({"C": C} if C.any() else {}))
    write_dofs(f"{prefix}.dofs.csv", [dofs[i] for i in kept], supports)
    write_ties(f"{prefix}.ties.csv", dofs, T, kept)
    ops.wipeAnalysis()
