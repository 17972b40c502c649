"""Any OpenSees model as files for a study: build the model without contacts, then `export("frame")`. Needs openseespy and scipy.

The matrices are read in blocks: the rows of few nodes while `sp` holds all others, so that no matrix of all dofs is formed. GimmeMCK is
an integrator whose matrix is m M + c C + k K; the Auto handler adds penalties times the squares of the constraints (`equalDOF`,
`rigidLink`, `rigidDiaphragm`, chains of them). The dofs that these or `fix` hold are no rows of the matrices: PREFIX.ties.csv has those
that follow others as sums of dofs that are. `supports`, {tag: name}, are nodes that the study moves; leave them free.

Only a linear model has matrices. Elements whose matrices change where all nodes move are refused: leave them out and model them as
contacts of the study, or write their matrices at the present state by `nonlinear=True`. Loads are refused too, unless the model is at rest
under them, as after gravity: then K is that of this state (P-delta), and a study counts displacements and forces from it.

`forces`, {name: [(element, response, number), ...]}, are sums of forces of elements, in PREFIX.forces.csv: a response of `eleResponse`
("force", "localForce") and the number of a dof in it, from 1. The model is at its start afterwards.
"""

import contextlib
import io

import numpy as np
import openseespy.opensees as ops
import scipy.sparse as sparse
from scipy.sparse.csgraph import reverse_cuthill_mckee

from condense import check, condense, condensed
from matrix_market import write_dofs, write_forces, write_matrices, write_ties

# By the numbers of coordinates and of dofs of a node. Of other nodes the caller gives the directions.
DIRECTIONS = {(1, 1): ["x"], (2, 2): ["x", "y"], (2, 3): ["x", "y", "rz"], (3, 3): ["x", "y", "z"], (3, 6): ["x", "y", "z", "rx", "ry", "rz"]}

# Displacements of the nodes over the size of the model, and rotations, at which an element must have the same matrices, and the
# part of an entry below which its change is round-off.
MOVED, SAME = 1.0, 1e-9

# Rows of a part of the nodes: a block has those of two. A tag that no model has.
PART, TAG = 250, 87_654_321


class Model:
    """The dofs of the nodes, (node, direction, X, Y, Z), with their rows, and the pairs of parts of the nodes that elements and
    constraints couple."""

    def __init__(self, directions):
        self.nodes, self.rows, self.dofs = ops.getNodeTags(), {}, []
        for node in self.nodes:
            place, count = ops.nodeCoord(node), len(ops.nodeDisp(node))
            names = directions or DIRECTIONS.get((len(place), count), [])
            if len(names) != count:
                raise ValueError(f"node {node} has {count} dofs and {len(place)} coordinates: give `directions` of so many dofs")
            self.rows[node] = range(len(self.dofs), len(self.dofs) + count)
            self.dofs += [(node, direction, *[*place, 0.0, 0.0][:3]) for direction in names]
        self.turns = np.array([direction.startswith("r") for _, direction, *_ in self.dofs])
        # The size of the model.
        self.length = np.ptp([dof[2:] for dof in self.dofs], axis=0).max() or 1.0
        self.elements = {element: ops.eleNodes(element) for element in ops.getEleTags() or []}
        self.followed = {node: ops.getRetainedNodes(node) for node in ops.getConstrainedNodes() or []}
        self.divide()

    def divide(self):
        place = {node: i for i, node in enumerate(self.nodes)}
        groups = [*self.elements.values(), *([node, *others] for node, others in self.followed.items())]
        edges = np.reshape([(place[a], place[b]) for group in groups for a in group for b in group], (-1, 2)).astype(int)
        graph = sparse.csr_array((np.ones(len(edges)), edges.T), shape=(len(place),) * 2)
        order, counts = reverse_cuthill_mckee(graph, symmetric_mode=True), np.array([len(self.rows[node]) for node in self.nodes])
        self.part = np.empty(len(order), int)
        self.part[order] = np.unique((np.cumsum(counts[order]) - counts[order]) // PART, return_inverse=True)[1]
        self.pairs = {*map(tuple, np.sort(self.part[edges], axis=1).tolist()), *((p, p) for p in self.part.tolist())}
        # Damping of modes couples nodes that no element joins.
        C, of_rows = self.read((0.0, 1.0, 0.0))[0], np.repeat(np.arange(len(order)), counts)
        if any(graph[i, j] == 0.0 for i, j in set(zip(*(of_rows[rows].tolist() for rows in C.nonzero())))):
            self.pairs = {(p, q) for q in range(self.part.max() + 1) for p in range(q + 1)}

    def read(self, *factors, others=0.0, pairs=None):
        """For each (m, c, k) the matrix m M + c C + k K, with penalties of the constraints between nodes."""
        terms, done = [[] for _ in factors], set()
        pairs = self.pairs if pairs is None else set(pairs)
        # Blocks of one part are in those of two.
        inside = {p for pair in pairs if pair[0] != pair[1] for p in pair}
        for pair in sorted(pair for pair in pairs if pair[0] != pair[1] or pair[0] not in inside):
            block = {node: part for node, part in zip(self.nodes, self.part.tolist()) if part in pair}
            with held(self, block):
                analysis("FullGeneral", "Auto", "-userPenalty", others)
                # A step without length numbers the dofs, and is refused before anything is solved.
                with contextlib.redirect_stderr(io.StringIO()):
                    ops.analyze(1, 0.0)
                row, part = np.empty((2, ops.systemSize()), int)
                for node, its in block.items():
                    row[ops.nodeDOFs(node)], part[ops.nodeDOFs(node)] = self.rows[node], its
                new = (part[:, None] != part) | ~np.isin(part, list(done))
                for found, (m, c, k) in zip(terms, factors):
                    ops.integrator("GimmeMCK", m, c, k)
                    a = np.array(ops.printA("-ret")).reshape(len(row), -1)
                    i, j = np.nonzero(new & (a != 0.0))
                    found.append((a[i, j], row[i], row[j]))
            done.update(pair)
        matrices = []
        for found in terms:
            values, i, j = (np.concatenate(parts) for parts in zip(*found)) if found else ([], [], [])
            a = sparse.csr_array((values, (i, j)), shape=(len(self.dofs),) * 2)
            matrices.append((a + a.T) / 2)
        return matrices

    def changing(self, C, K):
        """The elements whose C or K is another one where all nodes have moved, and move: [[tag, nodes], ...]."""
        changed, node = set(), np.array([dof[0] for dof in self.dofs])
        for sign in (1.0, -1.0):
            waves = np.sin([1.0 + 7.3 * node + 2.9 * dof for node, rows in self.rows.items() for dof in range(1, len(rows) + 1)])
            self.move(sign * MOVED * waves * np.where(self.turns, 1.0, self.length))
            for one, other in zip((C, K), self.read((0.0, 1.0, 0.0), (0.0, 0.0, 1.0))):
                more = (abs(other - one) - SAME * abs(one)).tocoo()
                new = ~(more.data <= abs(one).max() * SAME**2)
                changed.update(zip(node[more.row[new]].tolist(), node[more.col[new]].tolist()))
            ops.reset()
        found = []
        for element, nodes in self.elements.items():
            pairs = [(a, b) for a in nodes for b in nodes if a != b] or [(nodes[0], nodes[0])]
            if changed.intersection(pairs):
                found.append((element, nodes))
        return found or ([("?", [])] if changed else [])

    def move(self, displacements, duration=1.0):
        """A step to these displacements of all nodes, by penalties that leave nothing of the matrix but its diagonal."""
        with held(self, {}, displacements):
            analysis("Diagonal", "Penalty", 1e25, 0.0)
            ops.analyze(1, duration)

    def forces(self, names):
        """Sums of forces of elements as rows over all dofs: {name: (quantity, row)}. Differences are exact up to the second order."""
        terms, asked = [(name, *term) for name, terms in names.items() for term in terms], {}
        for name, element, response, number in terms:
            dofs = [dof for node in self.elements.get(element, []) for dof in self.rows[node]]
            if not dofs or len(ops.eleResponse(element, response) or []) != len(dofs) or not 1 <= number <= len(dofs):
                raise ValueError(f"force {name}: element {element} has no `{response}` of its {len(dofs)} dofs with a number {number}")
            asked[element, response] = dofs
        columns = self.derivatives(asked)
        found = {name: (set(), np.zeros(len(self.dofs))) for name in names}
        for name, element, response, number in terms:
            dofs = asked[element, response]
            found[name][0].add("moment" if self.turns[dofs[number - 1]] else "force")
            for dof in dofs:
                found[name][1][dof] += columns[element, response, dof][number - 1]
        for name, (quantities, _) in found.items():
            if len(quantities) != 1:
                raise ValueError(f"force {name} must be a sum of forces, or of moments")
        return {name: (quantities.pop(), row) for name, (quantities, row) in found.items()}

    def derivatives(self, asked):
        """Of responses by the dofs of their elements. Nodes that no element joins move at once."""
        start = np.concatenate([ops.nodeDisp(node) for node in self.nodes])
        groups, ends = [], {element: self.elements[element] for element, _ in asked}
        for node in dict.fromkeys(node for nodes in ends.values() for node in nodes):
            near = {other for nodes in ends.values() if node in nodes for other in nodes}
            group = next((group for group in groups if not near & group), None)
            if group is None:
                groups.append(group := set())
            group.add(node)
        found = {}
        for group in groups:
            for number in range(max(len(self.rows[node]) for node in group)):
                moved = [self.rows[node][number] for node in group if number < len(self.rows[node])]
                sizes = np.where(self.turns, MOVED, MOVED * self.length)
                values = []
                for sign in (1.0, -1.0):
                    place = start.copy()
                    place[moved] += sign * sizes[moved]
                    self.move(place, 1e12)
                    values.append({of: np.array(ops.eleResponse(*of)) for of in asked})
                for of, dofs in asked.items():
                    for dof in set(dofs).intersection(moved):
                        found[*of, dof] = (values[0][of] - values[1][of]) / (2.0 * sizes[dof])
        self.move(start, 1e12)
        return found


def analysis(system, *handler):
    ops.wipeAnalysis()
    for command, *values in [("system", system), ("numberer", "Plain"), ("constraints", *handler),
                             ("algorithm", "Linear"), ("integrator", "Newmark", 0.5, 0.25), ("analysis", "Transient")]:
        getattr(ops, command)(*values)


@contextlib.contextmanager
def held(model, free, displacements=None):
    """All nodes but these are held, or get displacements."""
    tag = 1 + max([0, *(ops.getPatterns() or [])])
    ops.timeSeries("Constant", TAG)
    ops.pattern("Plain", tag, TAG)
    for node, rows in model.rows.items():
        if node not in free:
            for dof, row in enumerate(rows, 1):
                ops.sp(node, dof, 0.0 if displacements is None else displacements[row])
    try:
        yield
    finally:
        ops.wipeAnalysis()
        ops.remove("loadPattern", tag)
        ops.remove("timeSeries", TAG)


@contextlib.contextmanager
def released():
    """The dofs that `fix` holds, by their nodes, while it does not hold them."""
    fixed = {node: sorted(set(ops.getFixedDOFs(node))) for node in ops.getFixedNodes() or []}
    for node, dofs in fixed.items():
        for dof in dofs:
            ops.remove("sp", node, dof)
    try:
        yield fixed
    finally:
        for node, dofs in fixed.items():
            ops.fix(node, *(int(dof in dofs) for dof in range(1, len(ops.nodeDisp(node)) + 1)))


def loads():
    """What the patterns load, by their tags. A motion by `sp` would be lost, or hold a node that the study moves."""
    found = {}
    for pattern in ops.getPatterns() or []:
        names = [f"a load on node {node}" for node in ops.getNodeLoadTags(pattern) or []]
        names += [f"a load on element {element}" for element in ops.getEleLoadTags(pattern) or []]
        if not names:
            raise ValueError(f"pattern {pattern} has a motion of nodes (`sp`) or of the ground: a study has its own motions; "
                             f"`remove('loadPattern', {pattern})` first")
        found[pattern] = ", ".join(names[:10])
    return found


def at_rest(model, T, kept):
    """Whether the forces of the elements and the loads are in equilibrium."""
    forces = np.concatenate([ops.nodeReaction(node) for node in model.nodes])
    largest = np.abs(forces[~model.turns]).max(initial=0.0)
    return largest > 0.0 and (np.abs(T.T @ forces) <= 1e-6 * largest * np.where(model.turns[kept], model.length, 1.0)).all()


def constraints_of(model, fixed):
    """Rows whose products with u are 0, and the dofs that follow others."""
    rows = [{model.rows[node][dof - 1]: 1.0} for node, dofs in fixed.items() for dof in dofs]
    tied = np.zeros(len(model.dofs), bool)
    squares = model.read((0.0, 0.0, 0.0), others=1.0)[0] if model.followed else None
    for node, followed in model.followed.items():
        others = [row for other in followed for row in model.rows[other]]
        for dof in ops.getConstrainedDOFs(node):
            # 1 at the tied dof: its products with the dofs of the node that it follows are of this constraint alone.
            row = model.rows[node][dof - 1]
            products = squares[[row], :][:, others].toarray().ravel()
            rows.append({row: 1.0, **{other: value for other, value in zip(others, products.tolist()) if value}})
            tied[row] = True
    i, j, values = zip(*((i, j, value) for i, row in enumerate(rows) for j, value in row.items())) if rows else ((), (), ())
    return sparse.csr_array((values, (i, j)), shape=(len(rows), len(model.dofs))), tied


def export(prefix, directions=None, supports=None, nonlinear=False, forces=None):
    """Writes PREFIX.M.mtx, .C.mtx, .K.mtx, .dofs.csv and, with tied dofs, .ties.csv, with forces, .forces.csv."""
    loaded = loads()
    ops.reactions()
    with released() as fixed:
        model = Model(directions)
        M, C, K = model.read((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
        rows, tied = constraints_of(model, fixed)
        T, kept = condense(rows, M, tied)
        for pattern, names in loaded.items():
            if not at_rest(model, T, kept):
                raise ValueError(f"pattern {pattern} has {names}: a study has its own loads; `remove('loadPattern', {pattern})` first, "
                                 "or analyze the model until it is at rest under them (gravity)")
            print(f"export: K is that at rest under pattern {pattern}; displacements and forces of the study count from there")
        check(M, K, T, kept, model.dofs, supports, loaded=bool(loaded or nonlinear))
        rows = {name: (quantity, T.T @ row) for name, (quantity, row) in model.forces(forces or {}).items()}
        found = model.changing(C, K)
    if found:
        names = "; ".join(f"element {element} of nodes {', '.join(map(str, nodes))}" for element, nodes in found[:10])
        text = f"{len(found)} elements have other matrices where their nodes move ({names}): the files have those of the present state"
        # Under loads, elastic members are those of P-delta.
        if not nonlinear and not (loaded and all(element != "?" and "elastic" in ops.eleType(element).lower() for element, _ in found)):
            raise ValueError(f"{text}; model them as contacts of the study, or allow it by `nonlinear=True`")
        print(f"export: {text}")
    M, C, K = (condensed(a, T)[0] for a in (M, C, K))
    write_matrices(prefix, M=M, K=K, **({"C": C} if C.nnz else {}))
    write_dofs(f"{prefix}.dofs.csv", [model.dofs[i] for i in kept], supports)
    write_ties(f"{prefix}.ties.csv", model.dofs, T, kept)
    write_forces(f"{prefix}.forces.csv", [model.dofs[i] for i in kept], rows)
    ops.wipeAnalysis()
