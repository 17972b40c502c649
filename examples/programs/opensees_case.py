#!/usr/bin/env python3
"""OpenSees as a program: its zero-length elements for springs, dashpots, friction and gaps, average acceleration and Newton.

Friction in a plane is its section Bidirectional. M must be diagonal. Numbers: `stiffness` of friction before it slides (default 1e4
limit/length), `tolerance` of Newton (1e-10, of the norm of the displacement increments over the typical length).
"""
import numpy as np

import lines

# coulomb and displacement-control are ElasticPP, impact-spring is ElasticPPGap.
LAWS = ["coulomb", "displacement-control", "impact-spring"]
ops = lines.engine("openseespy.opensees", LAWS)
GROUND = 1  # The node that does not move; those of the degrees of freedom follow.


def nodes(case):
    """The node and the direction of each degree of freedom: those of a body on a contact in a plane have one node."""
    found = {i: (i + 2, 1) for i in range(len(case["dofs"]))}
    for contact in case["contacts"]:
        first, second = ({value: i for i, value in axis} for axis in contact.get("plane", [[], []]))
        for value, i in first.items():
            j = second.get(value, i)
            if i == j or found[i][1] == 2 or found[j] not in [(j + 2, 1), (i + 2, 2)]:
                raise ValueError(f"contact {contact['name']}: no body with other directions than in another contact")
            found[j] = i + 2, 2
    return found


def ends(contact, axis, known):
    """The nodes i and j of a zero-length element whose deformation u_j - u_i is r less the gap, and its direction."""
    along = {value: known[i] for i, value in axis}
    directions = {direction for _, direction in along.values()}
    if len(along) != len(axis) or not along.keys() <= {-1.0, 1.0} or len(directions) != 1:
        raise ValueError(f"contact {contact['name']}: no element between more than two nodes, or with other factors")
    return along.get(-1.0, (GROUND,))[0], along.get(1.0, (GROUND,))[0], directions.pop()


def links(full, known):
    """The springs of a symmetric matrix: pairs of nodes with the direction and the stiffness."""
    n = len(full)
    for i in range(n):
        for j in range(i):
            if full[i, j] != 0:
                if known[i][1] != known[j][1]:
                    raise ValueError("no spring or dashpot between two directions")
                yield known[i][0], *known[j], -full[i, j]
        # What the links to other nodes leave on the diagonal; round-off of them is none.
        ground = full[i].sum()
        if abs(ground) > 1e-12 * np.abs(full[i]).sum():
            yield GROUND, *known[i], ground


def element(tag, contact, case, known):
    """A contact as an element of displacements since the start, with its law as a uniaxial material, or in a plane as a section."""
    numbers, u = contact["numbers"], case["start"]["u"]
    *pair, direction = ends(contact, contact.get("along") or contact["plane"][0], known)
    if contact["law"] == "impact-spring":
        # In compression only: a negative gap and a negative yield force, which is never reached.
        k, gap = numbers["k"], numbers["gap"] + sum(value * u[i] for i, value in contact["along"])
        ops.uniaxialMaterial("ElasticPPGap", tag, k, -1e6 * k * (abs(gap) + case["scales"]["length"]), -gap)
        ops.element("zeroLength", tag, *pair, "-mat", tag, "-dir", direction)
        return
    limit = lines.constant_limit(contact)
    usual = 1e4 * limit / case["scales"]["length"]
    k = numbers["k"] if contact["law"] == "displacement-control" else case["numbers"].get("stiffness", usual)
    if any(case["start"]["S"][name] for name in lines.names(contact)) and contact["law"] == "displacement-control":
        raise ValueError(f"contact {contact['name']}: no force at the start")
    if "plane" in contact:
        ops.section("Bidirectional", tag, k, limit, 0.0, 0.0)
        ops.element("zeroLengthSection", tag, *pair, tag)
        return
    ops.uniaxialMaterial("ElasticPP", tag, k, limit / k)
    ops.element("zeroLength", tag, *pair, "-mat", tag, "-dir", direction)


def run(case):
    mass, damping, stiffness = (lines.matrix(case, name) for name in "MCK")
    if np.count_nonzero(mass - np.diag(np.diag(mass))):
        raise ValueError("no masses off the diagonal")
    start, n, dt, steps, known = case["start"], len(mass), case["dt"], case["steps"], nodes(case)
    # Of displacements since the start, so that friction begins without a force.
    p = lines.loads(case, mass) - stiffness @ np.array(start["u"])
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    for node in {GROUND} | {node for node, _ in known.values()}:
        ops.node(node, 0.0, 0.0)
        ops.fix(node, *(int((node, direction) not in known.values()) for direction in (1, 2, 3)))
        ops.mass(node, *(sum(float(mass[i, i]) for i in known if known[i] == (node, direction)) for direction in (1, 2, 3)))
    for i, place in known.items():
        ops.setNodeVel(*place, start["v"][i], "-commit")
        ops.setNodeAccel(*place, start["a"][i], "-commit")
    tag = 0
    for full, kind in [(stiffness, "Elastic"), (damping, "Viscous")]:
        for i, j, direction, value in links(full, known):
            tag += 1
            ops.uniaxialMaterial(kind, tag, *([value] if kind == "Elastic" else [value, 1.0]))
            ops.element("zeroLength", tag, i, j, "-mat", tag, "-dir", direction)
    elements = {}
    for contact in case["contacts"]:
        tag += 1
        element(tag, contact, case, known)
        # The section has the force in y before that in x.
        elements |= {name: (tag, i) for i, name in enumerate(reversed(lines.names(contact)))}
    for i, (node, direction) in known.items():
        if np.any(p[:, i]):
            ops.timeSeries("Path", i + 1, "-dt", dt, "-values", *p[:, i], p[-1, i])
            ops.pattern("Plain", i + 1, i + 1)
            ops.load(node, *(float(axis == direction) for axis in (1, 2, 3)))
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.test("NormDispIncr", case["numbers"].get("tolerance", 1e-10) * case["scales"]["length"], 50)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    u, v, cost = [np.array(start["u"])], [np.array(start["v"])], 0
    forces = {name: [start["S"][name]] for name in elements}
    for step in range(1, steps + 1):
        if ops.analyze(1, dt) != 0:
            raise RuntimeError(f"did not converge at t = {step * dt:.6g}")
        cost += ops.testIter()
        u.append(u[0] + np.array([ops.nodeDisp(*known[i]) for i in range(n)]))
        v.append(np.array([ops.nodeVel(*known[i]) for i in range(n)]))
        for name, (element_tag, row) in elements.items():
            forces[name].append(ops.basicForce(element_tag)[row])
    return np.array(u), np.array(v), forces, cost


if __name__ == "__main__":
    lines.serve("openseespy", str(ops.version()), LAWS, run)
