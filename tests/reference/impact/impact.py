"""The impact of two bars of [I], solved a second time by a route that shares nothing with the Rust program.

Each bar is n equal two-node elements, assembled with its own dimensions (E, A, rho, L as given, nothing scaled
beforehand): K = EA/h [1 -1; -1 1], M = rho A h [1/2 0; 0 1/2] (lumped) or rho A h/6 [2 1; 1 2] (consistent). The facing
ends are joined by S = k_I <r> r, r = u_right - u_left + gap; a wall is a right end that stays at 0. Equations

    M u'' + K u + b S(r) = 0,   b = -1 at the left bar's end, +1 at the right bar's,   u(0) = 0,  u''(0) = 0 for gap >= 0

Constant average acceleration for the accelerations a1 at the end of the step, with p = u + dt v + dt^2/4 a:

    open    (M + dt^2/4 K) a1 = -K p                                      r1 >= 0
    closed  (M + dt^2/4 (K + k_I b b')) a1 = -K p - k_I b (b'p + gap)     r1 < 0

Both systems are solved at every step and the one is taken whose answer has the sign it assumed; that exactly one does
is checked. The degrees of freedom run from the left bar's free end to the right bar's, so both matrices are tridiagonal
(elimination without pivoting: they are positive definite). impact_checks.py does the same with numpy's general solver
on full matrices. The exact solution is in waves.py.

Metrics are in impact_metrics.py; the programs that use this are impact_checks.py, impact_data.py, claims.py.
"""

import math

from waves import Exact

DEFAULTS = {"gap": 0.0, "mass": "lumped", "E": 100.0, "A": 1.0, "rho": 0.01, "L": 10.0, "V0": 0.1, "right": {}}


class Double:
    def __init__(self):
        self.number, self.sqrt = float, math.sqrt


class Digits50:
    def __init__(self):
        import mpmath
        mpmath.mp.dps = 50
        self.number, self.sqrt = mpmath.mpf, mpmath.sqrt


class Bar:
    """E, A, rho, L, n, V0 and what follows from them."""

    def __init__(self, values, ar):
        self.E, self.A, self.rho, self.L, self.V = (ar.number(values[k]) for k in ("E", "A", "rho", "L", "V0"))
        self.n = values["n"]
        self.C = ar.sqrt(self.E / self.rho)
        self.Z = self.E * self.A / self.C
        self.mass = self.rho * self.A * self.L


class Setup:
    """A case in its own dimensions, and the scales of the contract."""

    def __init__(self, case, ar):
        full = {**DEFAULTS, **case}
        self.full, self.ar = full, ar
        self.left = left = Bar(full, ar)
        self.right = None
        if full["right"] != "wall":
            self.right = Bar({**full, "V0": -full["V0"], **full["right"]}, ar)
        right = self.right
        stiffness = left.n * left.E * left.A / left.L
        self.k = ar.number(full["gamma"]) * stiffness if "gamma" in full else ar.number(full["k_I"])
        self.gamma = self.k / stiffness
        self.T = 2 * left.L / left.C
        self.c = left.V - (right.V if right else 0)
        self.F0 = self.c * (left.Z * right.Z / (left.Z + right.Z) if right else left.Z)
        self.gap = ar.number(full["gap"])
        self.dt, self.duration = full["dt"], full["duration"]
        self.steps = math.floor(self.duration / self.dt * (1 + 1e-12))

    def exact(self, end=None):
        """The exact solution up to `end` in T_I; without one, to a T_I beyond the run."""
        one, left, right = self.ar.number(1), self.left, self.right
        end = self.ar.number(self.duration) + 1 if end is None else end
        if right is None:
            return Exact(self.gap, None, one, one * 0, end, one)
        total = left.Z + right.Z
        return Exact(self.gap, 2 * right.L / right.C / self.T, right.Z / total, left.Z / total, end, one)


class Tridiagonal:
    """Symmetric tridiagonal matrix."""

    def __init__(self, size, zero):
        self.diagonal, self.off = [zero] * size, [zero] * (size - 1)

    def add_element(self, i, d, o):
        self.diagonal[i] += d
        self.diagonal[i + 1] += d
        self.off[i] += o

    def times(self, x):
        y = [d * xi for d, xi in zip(self.diagonal, x)]
        for i, o in enumerate(self.off):
            y[i] += o * x[i + 1]
            y[i + 1] += o * x[i]
        return y

    def plus(self, factor, other):
        sum_ = Tridiagonal(len(self.diagonal), 0)
        sum_.diagonal = [a + factor * b for a, b in zip(self.diagonal, other.diagonal)]
        sum_.off = [a + factor * b for a, b in zip(self.off, other.off)]
        return sum_

    def factor(self):
        self.pivot, self.ratio = [self.diagonal[0]], []
        for i, o in enumerate(self.off):
            self.ratio.append(o / self.pivot[i])
            self.pivot.append(self.diagonal[i + 1] - o * self.ratio[i])
        return self

    def solve(self, y):
        x = list(y)
        for i, m in enumerate(self.ratio):
            x[i + 1] -= m * x[i]
        for i in reversed(range(len(x))):
            x[i] /= self.pivot[i]
            if i + 1 < len(x):
                x[i] -= self.ratio[i] * x[i + 1]
        return x


class Model:
    """Assembled M, K, k_I b b' and the initial velocities."""

    def __init__(self, setup):
        ar, left, right = setup.ar, setup.left, setup.right
        zero = ar.number(0)
        size = left.n + 1 + (right.n + 1 if right else 0)
        self.M, self.K, self.spring = (Tridiagonal(size, zero) for _ in range(3))
        for bar, first in ((left, 0), (right, left.n + 1)):
            if bar is None:
                continue
            h = bar.L / bar.n
            k, m = bar.E * bar.A / h, bar.rho * bar.A * h
            for j in range(first, first + bar.n):
                self.K.add_element(j, k, -k)
                if setup.full["mass"] == "lumped":
                    self.M.add_element(j, m / 2, zero)
                else:
                    self.M.add_element(j, m / 3, m / 6)
        self.i = left.n  # contact end of the left bar; i + 1 is that of the right bar
        self.wall = right is None
        self.spring.diagonal[self.i] = setup.k
        if not self.wall:
            self.spring.diagonal[self.i + 1] = setup.k
            self.spring.off[self.i] = -setup.k
        self.v0 = [left.V] * (left.n + 1) + ([right.V] * (right.n + 1) if right else [])

    def relative(self, x):
        return -x[self.i] + (0 if self.wall else x[self.i + 1])

    def add_b(self, x, factor):
        x[self.i] -= factor
        if not self.wall:
            x[self.i + 1] += factor


def solve(setup, keep_states=False):
    """Per step (t, r, rdot, force) in the contract's scales, energy over its first value, momentum, end velocities."""
    ar, model = setup.ar, Model(setup)
    M, K, spring, k = model.M, model.K, model.spring, setup.k
    dt = ar.number(setup.dt) * setup.T
    length = setup.c * setup.T / 2
    gap = setup.gap * length
    q = dt * dt / 4
    open_matrix, closed_matrix = M.plus(q, K).factor(), M.plus(q, K.plus(1, spring)).factor()
    u, v = [ar.number(0)] * len(model.v0), list(model.v0)
    a = list(u)
    r, S = gap, ar.number(0)
    mass_right = setup.right.mass if setup.right else None
    frame = setup.left.V * setup.left.mass + (setup.right.V * mass_right if setup.right else 0)
    frame = frame / (setup.left.mass + mass_right) if setup.right else ar.number(0)

    def energy():
        w = [x - frame for x in v]
        return (dot(w, M.times(w)) + dot(u, K.times(u)) + (k * r * r if r < 0 else 0)) / 2

    out = {"rows": [(ar.number(0), r / length, model.relative(v) / setup.c, -S / setup.F0)],
           "energy": [energy()], "momentum": [sum(M.times(v))], "states": []}
    for step in range(1, setup.steps + 1):
        p = [x + dt * y + q * z for x, y, z in zip(u, v, a)]
        rhs = [-x for x in K.times(p)]
        free = open_matrix.solve(rhs)
        r_open = model.relative(p) + gap + q * model.relative(free)
        model.add_b(rhs, -k * (model.relative(p) + gap))
        held = closed_matrix.solve(rhs)
        r_closed = model.relative(p) + gap + q * model.relative(held)
        if (r_open >= 0) == (r_closed < 0):
            raise ArithmeticError(f"step {step}: both branches or none agree with themselves")
        r, a1 = (r_open, free) if r_open >= 0 else (r_closed, held)
        S = k * r if r < 0 else ar.number(0)
        u = [x + q * y for x, y in zip(p, a1)]
        v = [x + dt / 2 * (y + z) for x, y, z in zip(v, a, a1)]
        a = a1
        out["rows"].append((step * ar.number(setup.dt), r / length, model.relative(v) / setup.c, -S / setup.F0))
        out["energy"].append(energy())
        out["momentum"].append(sum(M.times(v)))
        if keep_states:
            out["states"].append((u, v))
    momentum = M.times(v)
    first = sum(momentum[: setup.left.n + 1]) / setup.left.mass
    second = sum(momentum[setup.left.n + 1:]) / mass_right if setup.right else ar.number(0)
    out["restitution"] = (second - first) / setup.c
    out["means"] = first, second
    out["u"], out["v"] = u, v
    return out


def dot(x, y):
    return sum(a * b for a, b in zip(x, y))


def profile(setup, solution):
    """Velocity at the nodes and stress in the elements at the end of the run, in the contract's scales."""
    v, u = solution["v"], solution["u"]
    mean = (setup.left.V + (setup.right.V if setup.right else 0)) / 2
    stress = []
    for bar, first in ((setup.left, 0), (setup.right, setup.left.n + 1)):
        if bar is not None:
            k = bar.E * bar.A / (bar.L / bar.n)
            stress += [k * (u[j + 1] - u[j]) / setup.F0 for j in range(first, first + bar.n)]
    return [(x - mean) / (setup.c / 2) for x in v], stress
