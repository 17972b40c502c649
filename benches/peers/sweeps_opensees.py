"""The sweeps by a general finite element program, OpenSees: its elements, materials, Newmark and Newton."""

import math

import numpy as np
import openseespy.opensees as ops

from cases import BAR_DT, BAR_STEPS, DT, N, STEPS, X0, exact_oscillator


def analysis():
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("ProfileSPD")
    ops.test("NormUnbalance", 1e-9, 50)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")


def oscillator(alpha, exact):
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.node(1, 0.0)
    ops.node(2, 0.0, "-mass", 1.0)
    ops.fix(1, 1)
    ops.uniaxialMaterial("Elastic", 1, 1.0)
    # Elastic up to alpha about the place of release, then plastic: [F (9)].
    ops.uniaxialMaterial("ElasticPP", 2, 1 / alpha, alpha, -alpha, X0)
    ops.element("zeroLength", 1, 1, 2, "-mat", 1, 2, "-dir", 1, 1)
    ops.setNodeDisp(2, 1, X0, "-commit")
    # Equilibrium at release: the spring's force alone.
    ops.setNodeAccel(2, 1, -X0, "-commit")
    analysis()
    total = 0.0
    for i in range(1, STEPS + 1):
        if ops.analyze(1, DT) != 0:
            return math.nan
        total += (ops.nodeDisp(2, 1) - exact[i]) ** 2
    return math.sqrt(total / (STEPS + 1)) / X0


def bars(gamma):
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    element, spring = 0.5 / N, 2.0 * N
    for first, velocity in ((1, 1.0), (N + 2, -1.0)):
        for i in range(N + 1):
            mass = element / 2 if i in (0, N) else element
            ops.node(first + i, float(first + i), "-mass", mass)
            ops.setNodeVel(first + i, 1, velocity, "-commit")
    ops.uniaxialMaterial("Elastic", 1, spring)
    ops.uniaxialMaterial("ENT", 2, 2 * gamma * N)
    tag = 0
    for first in (1, N + 2):
        for i in range(N):
            tag += 1
            ops.element("Truss", tag, first + i, first + i + 1, 1.0, 1)
    # The facing ends stand a unit apart, and so do the nodes of every element: strains are stretches.
    ops.element("Truss", tag + 1, N + 1, N + 2, 1.0, 2)
    analysis()
    peak = 0.0
    for _ in range(BAR_STEPS):
        if ops.analyze(1, BAR_DT) != 0:
            return math.nan
        peak = max(peak, -ops.basicForce(tag + 1)[0])
    return peak


def opensees_oscillator(alphas):
    exact = exact_oscillator()
    return np.array([oscillator(alpha, exact) for alpha in alphas])


def opensees_bars(gammas):
    return np.array([bars(gamma) for gamma in gammas])
