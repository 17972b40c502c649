#!/usr/bin/env python3
"""OpenSees as a program: its zero-length elements for springs, dashpots, friction and gaps, average acceleration and Newton.

M must be diagonal. Numbers: `stiffness` of friction before it slides (default 1e4 limit/length), `tolerance` of Newton (1e-10, of the
norm of the displacement increments over the typical length).
"""
import numpy as np

import lines

# coulomb and displacement-control are ElasticPP, impact-spring is ElasticPPGap.
LAWS = ["coulomb", "displacement-control", "impact-spring"]
ops = lines.engine("openseespy.opensees", LAWS)
GROUND = 1  # The node that does not move; those of the degrees of freedom follow.


def ends(contact):
    """The nodes i and j of a zero-length element whose deformation u_j - u_i is r less the gap."""
    along = sorted((value, i + 2) for i, value in contact["along"])
    if [value for value, _ in along] == [-1.0, 1.0]:
        return along[0][1], along[1][1]
    if [value for value, _ in along] == [1.0]:
        return GROUND, along[0][1]
    if [value for value, _ in along] == [-1.0]:
        return along[0][1], GROUND
    raise ValueError(f"contact {contact['name']}: no element between more than two nodes, or with other factors")


def links(full):
    """The springs of a symmetric matrix: pairs of nodes with their stiffness."""
    n = len(full)
    for i in range(n):
        for j in range(i):
            if full[i, j] != 0:
                yield i + 2, j + 2, -full[i, j]
        # What the links to other nodes leave on the diagonal; round-off of them is none.
        ground = full[i].sum()
        if abs(ground) > 1e-12 * np.abs(full[i]).sum():
            yield GROUND, i + 2, ground


def material(tag, contact, case):
    """The law of a contact as a uniaxial material."""
    numbers = contact["numbers"]
    if contact["law"] == "impact-spring":
        # In compression only: a negative gap and a negative yield force, which is never reached.
        k, gap = numbers["k"], numbers["gap"]
        ops.uniaxialMaterial("ElasticPPGap", tag, k, -1e6 * k * (abs(gap) + case["scales"]["length"]), -gap)
        return
    limit = lines.constant_limit(contact)
    usual = 1e4 * limit / case["scales"]["length"]
    k = numbers["k"] if contact["law"] == "displacement-control" else case["numbers"].get("stiffness", usual)
    ops.uniaxialMaterial("ElasticPP", tag, k, limit / k)


def run(case):
    mass, damping, stiffness = (lines.matrix(case, name) for name in "MCK")
    if np.count_nonzero(mass - np.diag(np.diag(mass))):
        raise ValueError("no masses off the diagonal")
    p, n, dt, steps, contacts = lines.loads(case, mass), len(mass), case["dt"], case["steps"], case["contacts"]
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.node(GROUND, 0.0)
    ops.fix(GROUND, 1)
    for i in range(n):
        ops.node(i + 2, 0.0)
        ops.mass(i + 2, float(mass[i, i]))
    tag = 0
    for full, kind in [(stiffness, "Elastic"), (damping, "Viscous")]:
        for i, j, value in links(full):
            tag += 1
            ops.uniaxialMaterial(kind, tag, *([value] if kind == "Elastic" else [value, 1.0]))
            ops.element("zeroLength", tag, i, j, "-mat", tag, "-dir", 1)
    gaps = {}
    for friction in [False, True]:  # Friction begins without a force, at the displacements of the start.
        if friction:
            for i in range(n):
                ops.setNodeDisp(i + 2, 1, case["start"]["u"][i], "-commit")
                ops.setNodeVel(i + 2, 1, case["start"]["v"][i], "-commit")
                ops.setNodeAccel(i + 2, 1, case["start"]["a"][i], "-commit")
        for contact in contacts:
            if contact["law"] == "displacement-control" and case["start"]["S"][contact["name"]] != 0:
                raise ValueError(f"contact {contact['name']}: no force at the start")
            if (contact["law"] != "impact-spring") == friction:
                tag += 1
                gaps[contact["name"]] = tag
                material(tag, contact, case)
                ops.element("zeroLength", tag, *ends(contact), "-mat", tag, "-dir", 1)
    for i in range(n):
        if np.any(p[:, i]):
            ops.timeSeries("Path", i + 1, "-dt", dt, "-values", *p[:, i], p[-1, i])
            ops.pattern("Plain", i + 1, i + 1)
            ops.load(i + 2, 1.0)
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.test("NormDispIncr", case["numbers"].get("tolerance", 1e-10) * case["scales"]["length"], 50)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    u, v = [np.array(case["start"]["u"])], [np.array(case["start"]["v"])]
    forces, cost = {name: [case["start"]["S"][name]] for name in gaps}, 0
    for step in range(1, steps + 1):
        if ops.analyze(1, dt) != 0:
            raise RuntimeError(f"did not converge at t = {step * dt:.6g}")
        cost += ops.testIter()
        u.append(np.array([ops.nodeDisp(i + 2, 1) for i in range(n)]))
        v.append(np.array([ops.nodeVel(i + 2, 1) for i in range(n)]))
        for name, element in gaps.items():
            forces[name].append(ops.basicForce(element)[0])
    return np.array(u), np.array(v), forces, cost


if __name__ == "__main__":
    lines.serve("openseespy", str(ops.version()), LAWS, run)
