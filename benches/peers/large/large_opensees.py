"""The block by OpenSees: `quad` elements, Newmark, and springs without tension as contacts.

Without contacts, the matrix is factored once (`Linear -factorOnce`). With them, Newton factors it in every iteration.
"""

import time

import numpy as np
import openseespy.opensees as ops

from large import LENGTH, NU, STIFFNESS, WIDTH

SYSTEM = "SparseSYM"


def build(of, contacts):
    """Node i is node i + 1; the other ends of the contacts follow."""
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 2)
    mass = of.mass.reshape(-1, 2)
    for i, (x, y) in enumerate(of.places.tolist()):
        ops.node(i + 1, x, y, "-mass", *mass[i].tolist())
    ops.nDMaterial("ElasticIsotropic", 1, 1.0, NU)
    element = 0
    for i in range(of.nx):
        for j in range(of.ny):
            first = i * (of.ny + 1) + j + 1
            element += 1
            corners = [first, first + of.ny + 1, first + of.ny + 2, first + 1]
            ops.element("quad", element, *corners, 1.0, "PlaneStress", 1)
    if contacts:
        ops.uniaxialMaterial("ENT", 2, STIFFNESS)
        for i, node in enumerate(of.face):
            wall = len(mass) + i + 1
            ops.node(wall, *of.places[node].tolist())
            ops.fix(wall, 1, 1)
            ops.element("zeroLength", element + i + 1, node + 1, wall, "-mat", 2, "-dir", 1)
    for i in range(len(mass)):
        ops.setNodeVel(i + 1, 1, 1.0, "-commit")
    ops.constraints("Plain")
    ops.numberer("RCM")
    ops.system(SYSTEM)
    if contacts:
        ops.test("NormUnbalance", 1e-10, 50)
        ops.algorithm("Newton")
    else:
        ops.algorithm("Linear", "-factorOnce")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")


def run(of, contacts, steps):
    """Seconds of the first step, ms of a later one (mean), and u after all."""
    build(of, contacts)
    times = []
    for _ in range(steps):
        start = time.process_time()
        if ops.analyze(1, of.dt):
            raise ArithmeticError("OpenSees does not converge")
        times.append(time.process_time() - start)
    u = np.array([ops.nodeDisp(i + 1) for i in range(len(of) // 2)]).ravel()
    ops.wipe()
    return times[0], 1e3 * float(np.mean(times[1:])), u
