"""The girders by OpenSees: zero-length elements with its materials, Newmark, Newton until round-off.

What OpenSees needs for this:

- `ElasticPPGap` for a gap that closes takes a negative yield force and a negative gap. Its force is E (strain - gap) below the gap,
  0 above: the impact spring with S = force. The yield force is out of reach.
- `ElasticPP` for displacement-control: S and the slip are of the last committed step until the next one has converged, so that
  iterations do not add slip. This is the return mapping of [F (9)].
- `Viscous` with exponent 1 for dashpots. Rayleigh damping of a `region` of the bars' elements gives the same displacements, no faster.
- Residuals below 1e-7 kN are round-off: stiffness times that of u is some 1e-8 kN. A limit of 1e-9 kN, or increments below
  1e-13 m, takes more iterations and gets no nearer to the numba loop.
- The time is set before each step. The program adds steps up, which alone moves the displacements by 3e-13 m.
"""

import time

import numpy as np
import openseespy.opensees as ops

from girders import EVERY, GAP, LIMIT, SAMPLE, STEP, STEPS, WIDTH, Girders, record

TOLERANCE, ITERATIONS = 1e-7, 50


def build(g):
    """Node i of the girders is node i + 2; node 1 is the ground."""
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.node(1, 0.0)
    ops.fix(1, 1)
    for i, mass in enumerate(g.masses):
        ops.node(i + 2, 0.0, "-mass", mass)
    tags = {}

    def material(kind, *numbers):
        key = kind, *numbers
        if key not in tags:
            tags[key] = len(tags) + 1
            ops.uniaxialMaterial(kind, tags[key], *numbers)
        return tags[key]

    elements = []

    def element(ends, *materials):
        elements.append(len(elements) + 1)
        nodes = [1 if end is None else end + 2 for end in ends]
        ops.element("zeroLength", elements[-1], *nodes, "-mat", *materials, "-dir", *[1] * len(materials))

    for i, j, k, c in g.springs:
        dashpot = [material("Viscous", c, 1.0)] if c else []
        element((i, j), material("Elastic", k), *dashpot)
    for ends in g.gaps:
        element(ends, material("ElasticPPGap", g.impact_stiffness, -1e20, -GAP))
    for ends in g.bearings:
        element(ends, material("ElasticPP", LIMIT / WIDTH, WIDTH))
    ops.timeSeries("Path", 1, "-dt", SAMPLE, "-values", *record())
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    ops.constraints("Plain")
    ops.numberer("RCM")
    ops.system("ProfileSPD")
    ops.test("NormUnbalance", TOLERANCE, ITERATIONS)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")


def run(n):
    """Names, times, displacements, ns a step, iterations a step."""
    g = Girders(n)
    build(g)
    nodes = range(2, len(g.names) + 2)
    rows = np.zeros((STEPS // EVERY + 1, len(g.names)))
    seconds, iterations = 0.0, 0
    for step in range(1, STEPS + 1):
        start = time.perf_counter()
        ops.setTime((step - 1) * STEP)
        failed = ops.analyze(1, STEP)
        seconds += time.perf_counter() - start
        if failed:
            raise ArithmeticError(f"OpenSees does not converge at step {step}")
        iterations += ops.testIter()
        if step % EVERY == 0:
            rows[step // EVERY] = [ops.nodeDisp(node, 1) for node in nodes]
    return g.names, np.arange(len(rows)) * EVERY * STEP, rows, seconds / STEPS * 1e9, iterations / STEPS
