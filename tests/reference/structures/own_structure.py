"""Structures of matrices by average acceleration: M, C, K of files, contacts between any degrees of freedom, moving supports.

    M a + C v + K u + B S = p(t),   r = B^T u + (factors of supports) u_support + gap,   v, a by average acceleration

Independent of slipgap's way: no flexibility of the contacts is formed. Every contact has a mode, in which its force is a line of r at the
end of the step; the stiffness of the lines is added to the matrix of the step, all degrees of freedom are solved for, and the modes
are changed until each agrees with the solution. The equations are strictly convex, so modes that agree are the answer. Linear
systems are refined with residuals in long double until they stand still, and states are long doubles: results are right to about
1e-15 of the largest value.

Degrees of freedom without mass have no acceleration; those without mass and damping have no velocity as a state. At t = 0 they are in
equilibrium with the others.

`solve(study, folder)` reads the `structure` of a study as plain data: matrices, masses, springs and contacts (`between` or
`along`, `pairs`), `ground` and `supports` with records of two columns, `start`. Contacts: impact with k, displacement-control
and velocity-control with a constant limit. Expressions, bars, loads, units and baselines of records are not read.
"""

import itertools
import json
import sys
from pathlib import Path

import numpy as np
from scipy.linalg import lu_factor, lu_solve

from own_structure_model import REAL, Model, Motion


def line(contact, mode, r, before, dt):
    """(slope, value at r = 0) of S over r at the end of the step; `before` has r, rdot, S of its start, None at t = 0."""
    law = contact["law"]
    if law == "impact":
        return (REAL(contact["k"]), REAL(0)) if mode == "in" else (REAL(0), REAL(0))
    if mode != "in":
        return REAL(0), REAL(contact["limit"]) * (1 if mode == "+" else -1)
    r0, rate0, S0 = before
    if law == "displacement-control":
        return REAL(contact["k"]), S0 - contact["k"] * r0
    if law == "velocity-control":
        c = REAL(contact["c"])
        return 2 / dt * c, -c * (2 / dt * r0 + rate0)
    raise ValueError(f"unknown law {law}")


def agreed(contact, mode, r, before, dt, scale):
    """The mode that the solution r asks for; the present one if both give the same to round-off."""
    slope, value = line(contact, "in", r, before, dt)
    S = slope * r + value
    tie = REAL(1e-16) * slope * scale
    low, high = (-np.inf, 0.0) if contact["law"] == "impact" else (-contact["limit"], contact["limit"])
    below, above = ("-", "out") if contact["law"] == "impact" else ("-", "+")
    asked = below if S < low else above if S > high else "in"
    near = min(abs(S - low), abs(S - high)) <= tie
    return mode if near else asked


class Solver:
    """Solves A x + B S(r) = f with r = R^T x + r_0 for x and S; the factors of every set of modes are kept."""

    def __init__(self, A, B, contacts):
        self.A, self.B, self.contacts, self.factors = A, B, contacts, {}

    def solve(self, f, r0, modes, before, dt):
        tried = {}
        while modes not in tried:
            tried[modes] = None
            answer, asked = self.asked(f, r0, modes, before, dt)
            if asked == modes:
                return *answer, modes
            modes = asked
        # A cycle: all sets of modes in turn. One of them agrees.
        for modes in itertools.product(*(("in", "out") if c["law"] == "impact" else ("in", "+", "-") for c in self.contacts)):
            answer, asked = self.asked(f, r0, modes, before, dt)
            if asked == modes:
                return *answer, modes
        raise ArithmeticError("no set of modes agrees")

    def asked(self, f, r0, modes, before, dt):
        *answer, scale = self.with_modes(f, r0, modes, before, dt)
        r = answer[1]
        return answer, tuple(agreed(c, mode, r[i], before[i], dt, scale[i])
                             for i, (c, mode) in enumerate(zip(self.contacts, modes)))

    def with_modes(self, f, r0, modes, before, dt):
        lines = np.array([line(c, m, None, before[i], dt) for i, (c, m) in enumerate(zip(self.contacts, modes))], REAL).reshape(-1, 2)
        slopes, values = lines.T
        if modes not in self.factors:
            A = self.A + (self.B * slopes) @ self.B.T
            self.factors[modes] = A, lu_factor(A.astype(float))
        A, factor = self.factors[modes]
        f = f - self.B @ (slopes * r0 + values)
        x = np.zeros(len(f), REAL)
        for _ in range(12):
            dx = lu_solve(factor, (f - A @ x).astype(float))
            x = x + dx
            if np.abs(dx).max(initial=0) <= 1e-18 * np.abs(x).max(initial=0):
                break
        r = self.B.T @ x + r0
        return x, r, slopes * r + values, np.abs(self.B.T) @ np.abs(x) + np.abs(r0)


def solve(study, folder, split=False):
    """Steps 0 .. n: t, and u, v (of the free degrees of freedom, by name), r, S (of the contacts).

    With supports, the steps are those of u or, with `split`, those of w = u - R u_s, R = -K^-1 K_fs: the rest of u follows the
    supports without inertia. The motion in continuous time is the same.
    """
    p, structure = study["parameters"], study["structure"]
    m = Model(structure, folder)
    dt = REAL(p["dt"])
    count = round(p["duration"] / p["dt"])
    ground = {d: Motion(g, folder) for d, g in structure.get("ground", {}).items()}
    shaken = {name: {d: Motion({**x, "delay": data.get("delay", 0.0)}, folder)
                     for d, x in (data if "record" not in data else {"x": data}).items() if d in "xyz"}
              for name, data in structure.get("supports", {}).items()}

    follow = refined(m.K, -m.Kfs) if split else np.zeros_like(m.Kfs)
    Mfs, Cfs, Kfs = m.Mfs + m.M @ follow, m.Cfs + m.C @ follow, m.Kfs + m.K @ follow

    def loads(t):
        """p, displacements of the supports in x, and R times displacement and velocity of the supports."""
        p = np.zeros(len(m.free), REAL)
        moved = np.zeros((2, len(m.free)), REAL)
        for d, motion in ground.items():
            p -= m.M @ m.influence[d] * motion.at(t)[0]
        for i, (name, d) in enumerate(m.owners):
            if d in shaken[name]:
                a, v, u = shaken[name][d].at(t)
                p -= Mfs[:, i] * a + Cfs[:, i] * v + Kfs[:, i] * u
                moved += np.outer([u, v], follow[:, i])
        return p, np.array([shaken[name]["x"].at(t)[2] for name in m.supports], REAL), moved

    names = {i: name for name, i in m.places.items()}
    u, v, a = np.zeros((3, len(m.free)), REAL)
    for at, values in structure.get("start", {}).items():
        for i, place in enumerate(m.free):
            whole, direction = names[place].split(".")[0], m.directions[place]
            if at in (names[place], f"{whole}.{direction}"):
                u[i], v[i] = u[i] + values.get("u", 0.0), v[i] + values.get("v", 0.0)
    contacts = [c for c, _, _ in m.contacts.values()]
    M, C, K, B = m.M, m.C, m.K, m.B
    massive = np.abs(M).sum(axis=1) > 0
    damped = ~massive & (np.abs(C).sum(axis=1) > 0)
    still = ~massive & ~damped
    # At t = 0 the unknowns are the accelerations of masses, velocities of damped rows and displacements of the others.
    f, us, moved = loads(REAL(0))
    A = np.where(massive, M, np.where(damped, C, K))
    r0 = B.T @ u + m.Bs.T @ us + m.gap
    friction = [{**c, "law": "displacement-control", "k": 0.0, "limit": 1.0} if c["law"] != "impact" else c for c in contacts]
    modes = tuple("in" if c["law"] != "impact" or r < 0 else "out" for c, r in zip(contacts, r0))
    before = [(REAL(0), REAL(0), REAL(0))] * len(contacts)
    # Only the still rows move r: with u as the unknown, the rest of B enters through the known displacements.
    start = InitialSolver(A, B, friction, still)
    x, r, S, modes = start.solve(f - C @ v - K @ u, r0, modes, before, dt)
    a[massive], v[damped], u[still] = x[massive], v[damped] + x[damped], u[still] + x[still]
    rate = B.T @ np.where(still, 0, v)
    if any(c["law"] == "velocity-control" and x != 0 for c, x in zip(contacts, rate)):
        raise ValueError("velocity-control in motion at t = 0 is not read: its force is not 0 then")
    khat = Solver(4 / dt**2 * M + 2 / dt * C + K, B, contacts)
    rows = [(REAL(0), u + moved[0], v + moved[1], r, S)]
    for step in range(1, count + 1):
        t = step * dt
        f, us, moved = loads(t)
        f = f + M @ (4 / dt**2 * u + 4 / dt * v + a) + C @ (2 / dt * u + v)
        before = list(zip(r, rate, S))
        new, r1, S, modes = khat.solve(f, B.T @ moved[0] + m.Bs.T @ us + m.gap, modes, before, dt)
        a = np.where(massive, 4 / dt**2 * (new - u) - 4 / dt * v - a, 0)
        v = np.where(still, 0, 2 / dt * (new - u) - v)
        rate = 2 / dt * (r1 - r) - rate
        u, r = new, r1
        rows.append((t, u + moved[0], v + moved[1], r, S))
    return m, rows, [names[i] for i in m.free], {"massive": massive, "still": still}


def refined(A, f):
    """A^-1 f by columns."""
    x, factor = np.zeros_like(f), lu_factor(A.astype(float))
    for _ in range(12):
        x = x + lu_solve(factor, (f - A @ x).astype(float))
    return x


class InitialSolver(Solver):
    """The equations at t = 0, in which only rows without mass and damping move the contacts."""

    def __init__(self, A, B, contacts, still):
        super().__init__(A, B, contacts)
        self.moved = B * still[:, None]

    def with_modes(self, f, r0, modes, before, dt):
        slopes, values = np.array([line(c, m, None, before[i], dt) for i, (c, m) in enumerate(zip(self.contacts, modes))],
                                  REAL).reshape(-1, 2).T
        A = self.A + (self.B * slopes) @ self.moved.T
        f = f - self.B @ (slopes * r0 + values)
        x, factor = np.zeros(len(f), REAL), lu_factor(A.astype(float))
        for _ in range(12):
            x = x + lu_solve(factor, (f - A @ x).astype(float))
        r = self.moved.T @ x + r0
        return x, r, slopes * r + values, np.abs(self.moved.T) @ np.abs(x) + np.abs(r0)


def main():
    study = Path(sys.argv[1])
    m, rows, names, _ = solve(json.loads(study.read_text(encoding="utf-8")), study.parent)
    every = max(1, (len(rows) - 1) // 20)
    print(",".join(["t", *(f"{n}.u" for n in names), *(f"{c}.{q}" for c in m.contacts for q in ("r", "S"))]))
    for t, u, _, r, S in rows[::every]:
        print(",".join(repr(float(x)) for x in (t, *u, *(q for pair in zip(r, S) for q in pair))))


if __name__ == "__main__":
    main()
