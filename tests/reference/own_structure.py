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

import csv
import itertools
import json
from pathlib import Path

import numpy as np
from scipy.io import mmread
from scipy.linalg import lu_factor, lu_solve

REAL = np.longdouble


class Model:
    """Matrices over the free degrees of freedom, and `fixed`, over those of supports: (name, direction) of each column."""

    def __init__(self, structure, folder):
        self.structure, folder = structure, Path(folder)
        blocks, self.places, self.directions, owners = [], {}, [], []
        for name, entry in structure.get("matrices", {}).items():
            M, K = (mmread(folder / entry[x]) for x in "MK")
            C = mmread(folder / entry["C"]) if "C" in entry else 0 * K
            blocks.append([np.asarray(a.todense() if hasattr(a, "todense") else a) for a in (M, C, K)])
            with open(folder / entry["dofs"], encoding="utf-8") as file:
                for row in csv.DictReader(file):
                    self.places[f"{name}.{row['node']}.{row['direction']}"] = len(self.directions)
                    self.directions.append(row["direction"])
                    owners.append(row.get("support") or None)
        for name, mass in structure.get("masses", {}).items():
            self.places[name] = len(self.directions)
            self.directions.append("x")
            owners.append(None)
            blocks.append([np.array([[x]]) for x in (mass, 0.0, 0.0)])
        n = len(self.directions)
        M, C, K = np.zeros((3, n, n), REAL)
        at = 0
        for block in blocks:
            for whole, part in zip((M, C, K), block):
                whole[at:at + len(part), at:at + len(part)] = part
            at += len(block[0])
        self.supports = list(structure.get("supports", {}))
        for spring in structure.get("springs", []):
            b, s = self.column(spring, n)
            if s.any():
                raise ValueError("springs to supports are not read")
            K += spring["k"] * np.outer(b, b)
            C += spring.get("c", 0.0) * np.outer(b, b)
        damping = structure.get("rayleigh", {})
        C += damping.get("mass", 0.0) * M + damping.get("stiffness", 0.0) * K
        self.contacts = {}
        for name, contact in structure.get("contacts", {}).items():
            for key, part in read_pairs(name, contact, folder):
                self.contacts[key] = contact, *self.column(part, n)
        free = np.array([owner is None for owner in owners])
        self.free, self.owned = np.flatnonzero(free), np.flatnonzero(~free)
        self.owners = [(owners[i], self.directions[i]) for i in self.owned]
        self.M, self.C, self.K = (a[np.ix_(free, free)] for a in (M, C, K))
        self.Mfs, self.Cfs, self.Kfs = (a[np.ix_(free, ~free)] for a in (M, C, K))
        self.B = np.array([b[free] for _, b, _ in self.contacts.values()], REAL).reshape(len(self.contacts), len(self.free)).T
        self.Bs = np.array([s for _, _, s in self.contacts.values()], REAL).reshape(len(self.contacts), len(self.supports)).T
        self.gap = np.array([c.get("gap", 0.0) for c, _, _ in self.contacts.values()], REAL)
        self.influence = {d: np.array([self.directions[i] == d for i in self.free], REAL) for d in "xyz"}

    def column(self, part, n):
        along = part.get("along") or dict(zip(part["between"], (-1.0, 1.0)))
        b, s = np.zeros(n, REAL), np.zeros(len(self.supports), REAL)
        for name, factor in along.items():
            if name in self.supports:
                s[self.supports.index(name)] += factor
            elif name != "ground":
                b[self.places[name]] += factor
        return b, s


def read_pairs(name, contact, folder):
    if "pairs" not in contact:
        return [(name, contact)]
    with open(folder / contact["pairs"], encoding="utf-8") as file:
        rows = list(csv.reader(file))[1:]
    return [(f"{name}.{row[0]}", {"along": {d: float(f) for d, f in (cell.rsplit(":", 1) for cell in row[1:] if cell)}})
            for row in rows]


class Motion:
    """Acceleration, velocity and displacement of a record at rest before its first sample, straight between its samples."""

    def __init__(self, data, folder):
        table = np.loadtxt(Path(folder) / data["record"], delimiter=",", skiprows=1).astype(REAL)
        self.t, self.a = table[:, 0] - table[0, 0], table[:, 1] * REAL(data.get("scale", 1.0))
        self.delay = REAL(data.get("delay", 0.0))
        h = np.diff(self.t)
        self.v = np.concatenate([[0], np.cumsum(h * (self.a[:-1] + self.a[1:]) / 2)])
        self.u = np.concatenate([[0], np.cumsum(h * self.v[:-1] + h**2 * (2 * self.a[:-1] + self.a[1:]) / 6)])

    def at(self, t):
        """a, v, u; after the last sample a is 0."""
        t = t - self.delay
        if t < 0:
            return np.zeros(3, REAL)
        if t >= self.t[-1]:
            rest = t - self.t[-1]
            return np.array([self.a[-1] if rest == 0 else 0, self.v[-1], self.u[-1] + rest * self.v[-1]], REAL)
        i = int(np.searchsorted(self.t, t, side="right")) - 1
        x, h = t - self.t[i], self.t[i + 1] - self.t[i]
        slope = (self.a[i + 1] - self.a[i]) / h
        return np.array([self.a[i] + slope * x, self.v[i] + x * (self.a[i] + slope * x / 2),
                         self.u[i] + x * (self.v[i] + x * (self.a[i] / 2 + slope * x / 6))], REAL)


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
    shaken = {name: {d: Motion(x, folder) for d, x in (data if "record" not in data else {"x": data}).items()}
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
    import sys

    study = Path(sys.argv[1])
    m, rows, names, _ = solve(json.loads(study.read_text(encoding="utf-8")), study.parent)
    every = max(1, (len(rows) - 1) // 20)
    print(",".join(["t", *(f"{n}.u" for n in names), *(f"{c}.{q}" for c in m.contacts for q in ("r", "S"))]))
    for t, u, _, r, S in rows[::every]:
        print(",".join(repr(float(x)) for x in (t, *u, *(q for pair in zip(r, S) for q in pair))))


if __name__ == "__main__":
    main()
