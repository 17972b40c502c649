"""Statements of the reference page that can be derived, checked by numbers. Derivations: README.md, "Notes".

Run:  python3 claims.py     (needs numpy)
"""

import math
import pathlib
import sys

import numpy as np

for folder in ("friction", "impact"):
    sys.path.insert(0, str(pathlib.Path(__file__).parent / folder))

import friction  # noqa: E402
from friction_data import displacement, velocity  # noqa: E402
from impact import Double, Model, Setup, solve  # noqa: E402
from impact_metrics import run  # noqa: E402

AR = Double()


def step_energy():
    """Energy over a contact step and a friction step, momentum: largest deviation from the identities."""
    for case in ({"n": 10, "dt": 0.001, "duration": 1.5, "k_I": 1000.0},
                 {"n": 5, "dt": 0.05, "duration": 2.0, "gamma": 3.0, "mass": "consistent", "gap": 0.0537},
                 {"n": 10, "dt": 0.005, "duration": 2.5, "gamma": 2.0, "right": {"L": 14.0, "A": 2.0, "n": 7, "V0": 0.03}}):
        setup = Setup(case, AR)
        out = solve(setup)
        length = setup.c * setup.T / 2
        r = [row[1] * length for row in out["rows"]]
        S = [-row[3] * setup.F0 for row in out["rows"]]
        E = out["energy"]
        worst = max(abs(E[i + 1] - E[i] - (S[i + 1] * r[i] - S[i] * r[i + 1]) / 2) for i in range(len(r) - 1)) / E[0]
        still = max(abs(E[i + 1] - E[i]) for i in range(len(r) - 1) if (r[i] < 0) == (r[i + 1] < 0)) / E[0]
        momentum = max(abs(p - out["momentum"][0]) for p in out["momentum"]) / (setup.left.mass * setup.c)
        print(f"contact step: identity {worst:.1e} of E0, without change of state {still:.1e}, momentum {momentum:.1e}")
    for case in (displacement(0.1, math.pi / 10), displacement(0.3, 0.25, 11.2, 30.0, "pulled"),
                 velocity(0.1, math.pi / 10), velocity(1.0, 0.9, 12.5)):
        T, X, V, S = friction.solve(case, AR)
        kind = case["law"] == "displacement-control"
        width = case.get("alpha", 0.0)
        # the slip from the law alone: r^S = r - alpha S
        slip = [x - width * s if kind else x for x, s in zip(X, S)]
        E = [(x * x + v * v) / 2 for x, v in zip(X, V)]
        pairs = range(len(X) - 1)
        balance = max(abs(E[i + 1] - E[i] + (S[i] + S[i + 1]) * (X[i + 1] - X[i]) / 2) for i in pairs)
        lost = [(S[i] + S[i + 1]) * (slip[i + 1] - slip[i]) / 2 for i in pairs]
        stored = max(abs((S[i] + S[i + 1]) * (X[i + 1] - X[i]) / 2 - lost[i] - width * (S[i + 1] ** 2 - S[i] ** 2) / 2)
                     for i in pairs)
        print(f"friction step: balance {balance:.1e}, work = lost + stored {stored:.1e}, least lost {min(lost):.1e}")


def period():
    """Constant average acceleration of a free oscillator: phase per step 2 atan(omega dt/2)."""
    for omega_dt in (0.1, 1.0, 2.0):
        q = omega_dt ** 2 / 4
        a, b = 1.0, 0.0  # x, v dt
        for _ in range(7):
            x = (a * (1 - q) + b) / (1 + q)
            a, b = x, b - 2 * q * (a + x)
        print(f"omega dt = {omega_dt}: {abs(a - math.cos(7 * 2 * math.atan(omega_dt / 2))):.1e}")


def newton():
    """Velocity-control, plain Newton from the last state: where it first cycles."""
    for beta in (0.1, 0.15, 0.16):
        dt, x, v, a = math.pi / 10, 12.0, 0.0, -12.0
        for step in range(1, 81):
            acc = a
            for _ in range(50):
                x1, v1 = x + dt * v + dt * dt / 4 * (a + acc), v + dt / 2 * (a + acc)
                s = max(-1.0, min(1.0, v1 / beta))
                residual = acc + x1 + s
                if abs(residual) < 1e-10:
                    break
                acc -= residual / (1 + dt * dt / 4 + (dt / 2 / beta if abs(v1) < beta else 0))
            else:
                print(f"beta = {beta}: Newton from the last acceleration fails at step {step}")
                break
            x, v, a = x1, v1, acc
        else:
            print(f"beta = {beta}: Newton never fails in 80 steps")
    print("limit at pi/10:", 2 * (math.pi / 10) / (4 + (math.pi / 10) ** 2))


def contact_mode():
    for n in (20, 40):
        for gamma in (0.25, 0.5, 1.0, 2.0):
            setup = Setup({"n": n, "dt": 0.0002, "duration": 0.9, "gamma": gamma}, AR)
            out = solve(setup, keep_states=True)
            root = math.sqrt(1 + 4 * gamma ** 2)
            xi, omega = root - 2 * gamma, math.sqrt(2 + 2 * root)
            shape = np.array([(-xi) ** j for j in range(n, -1, -1)])
            mass = np.ones(n + 1)
            mass[0] = mass[-1] = 0.5
            rate = np.array([shape @ (mass * np.array(v[:n + 1])) for _, v in out["states"]]) / (shape @ (mass * shape))
            t = np.array([row[0] for row in out["rows"][1:]])
            # omega C0/h over T_I: C0 T_I/h = 2 n
            Omega_dt = omega * 2 * n * 0.0002
            angle = np.arange(1, len(t) + 1) * 2 * math.atan(Omega_dt / 2)
            amplitude = 1 - 1 / root
            worst = np.max(np.abs(rate / (setup.c / 2) - amplitude * np.cos(angle)))
            window = (t > 0.3) & (t < 0.85)
            rows = np.array(out["rows"][1:])
            contact = (rows[t < 0.9, 1] < 0).all()
            print(f"n {n} gamma {gamma}: modal amplitude {amplitude:.4f}, Omega {omega:.4f}, projection off by {worst:.1e}"
                  f" (always in contact: {contact}), largest |rdot| 0.3..0.85: {np.abs(rows[window, 2]).max():.4f},"
                  f" first peak {rows[:, 3].max():.4f}, late crest {rows[window, 3].max():.4f},"
                  f" mode alone {1 + 2 * gamma * amplitude / omega:.4f}")
    for n in (20, 40):
        for gamma in (2.0, 2.03, 2.034, 2.036, 2.04, 2.1, 2.12, 2.13):
            values = [run({"n": n, "dt": dt, "duration": 1.2, "gamma": gamma}, AR)[3]["separations"]
                      for dt in (0.0002, 0.001)]
            print(f"n {n} gamma {gamma}: separations {values} at dt 0.0002, 0.001")
    low, high = 1.5, 3.0
    for _ in range(50):  # the mode alone: valley 1 - 2 gamma A/Omega = 0
        g = (low + high) / 2
        root = math.sqrt(1 + 4 * g * g)
        low, high = (g, high) if 2 * g * (1 - 1 / root) / math.sqrt(2 + 2 * root) < 1 else (low, g)
    print("the mode alone separates from gamma =", g)


def continuum_spring():
    """Delay equation tau F' = w - F, w(t + T_I) = w(t) - 2 F(t), by small steps; and chains towards it."""
    low, high = 0.5, 5.0
    for _ in range(60):
        s = (low + high) / 2
        low, high = (s, high) if (2 + 2 * s) * math.exp(-s) > 1 else (low, s)
    print("contact beyond T_I over tau:", s)
    for gn in (0.2, 0.404, 1.0, 10.0):
        tau, per = 1 / (4 * gn), 4000
        h, F, W, t = 1 / per, [0.0], [1.0] * per, 0
        while True:
            w = W[t]
            W.append(W[t] - 2 * F[t])
            f = w + (F[t] - w) * math.exp(-h / tau)  # w is held over the step: first order
            t += 1
            if f <= 0 and t > per / 2:
                break
            F.append(f)
        closed = "-"
        if t / per <= 2.001:
            error = max(abs(F[i] - ((1 - math.exp(-i * h / tau)) if i <= per else
                                    -1 + (2 * (i * h - 1) / tau + 2 - math.exp(-1 / tau)) * math.exp(-(i * h - 1) / tau)))
                        for i in range(len(F)))
            closed = f"{error:.1e}"
        print(f"gamma n = {gn}: contact {t / per:.4f} T_I, off the closed form by {closed}")
    for n in (10, 40, 160):
        values = run({"n": n, "dt": 0.0005, "duration": 1.3, "k_I": 100.0}, AR)[3]
        print(f"chain n = {n}, k_I = 100: contact {values['contact_duration']:.4f} (continuum {1 + s / 40:.4f}), "
              f"overlap {values['max_overlap']:.4f} (bound 0.05)")


def un_iterated():
    """dt = 0.5 T_I, one solution per step with the tangent of the state at its start, acceleration by the method.

    Two ways to take the force at the start of a step: by the law, S(r) (so what was unbalanced enters the next step),
    or as the sum of the increments, which never corrects what was unbalanced.
    """
    for gap in (0.0, 0.1, 0.3, 0.5, 0.7, 0.9):
        said = []
        for by_law in (True, False):
            setup = Setup({"n": 10, "dt": 0.5, "duration": 10.0, "k_I": 100.0, "gap": gap}, AR)
            model = Model(setup)
            full = lambda t: np.diag(t.diagonal) + np.diag(t.off, 1) + np.diag(t.off, -1)
            M, K, B = full(model.M), full(model.K), full(model.spring)
            b = np.zeros(len(M))
            model.add_b(b, 1.0)
            length = setup.c * setup.T / 2
            dt, g = setup.dt * setup.T, gap * length
            u, v, a = np.zeros(len(M)), np.array(model.v0), np.zeros(len(M))
            r, summed, rs = g, 0.0, [gap]
            for _ in range(setup.steps):
                k = setup.k if r < 0 else 0.0
                S = k * r if by_law else summed
                du = np.linalg.solve(4 / dt ** 2 * M + K + (B if r < 0 else 0), M @ (4 / dt * v + a) - K @ u - b * S)
                summed += k * (b @ du)
                a = 4 / dt ** 2 * du - 4 / dt * v - a
                v, u = 2 / dt * du - v, u + du
                r = b @ u + g
                rs.append(float(r / length))
            crossings = [(i + rs[i] / (rs[i] - rs[i + 1])) * 0.5 for i in range(len(rs) - 1)
                         if (rs[i] < 0) != (rs[i + 1] < 0)]
            said.append(f"{crossings[-1] - crossings[0]:.3f} T_I" if rs[-1] >= 0 else "in contact to the end")
        print(f"un-iterated, gap {gap}, contact from the first to the last zero of r: force by the law {said[0]}, "
              f"by increments alone {said[1]}")


def second_impact(case, flight):
    """A bar between two walls: the speed at which its far end meets the second wall, and its own speed after that.

    Mirror images that strike on a spring k_I are bars on walls with 2 k_I each. Both contacts are there all the time;
    of the four states of contact the one is taken whose answer has the signs it assumed.
    """
    setup = Setup({"right": "wall", "duration": 1.0, **case}, AR)
    model, size = Model(setup), setup.left.n + 1
    full = lambda t: np.diag(t.diagonal) + np.diag(t.off, 1) + np.diag(t.off, -1)
    M, K = full(model.M), full(model.K)
    dt, V = setup.dt * setup.T, setup.left.V
    unit = V * setup.T / 2  # half of c T_I/2, c = 2 V0: the way of one bar of a pair
    room = [setup.gap * unit, (2 * flight - setup.gap) * unit]  # right and left of the bar at t = 0
    out = np.zeros((2, size))
    out[0, -1], out[1, 0] = -1.0, 1.0
    states = [(0, 0), (1, 0), (0, 1), (1, 1)]
    stiff = {s: K + sum(2 * setup.k * on * np.outer(o, o) for on, o in zip(s, out)) for s in states}
    solver = {s: np.linalg.inv(M + dt * dt / 4 * stiff[s]) for s in states}
    u, v, a = np.zeros(size), np.full(size, V), np.zeros(size)
    closing = None
    for step in range(round((setup.gap / 2 + flight + 2.25) / setup.dt)):
        p = u + dt * v + dt * dt / 4 * a
        for s in states:
            pull = sum(2 * setup.k * (o @ p + d) * o for on, o, d in zip(s, out, room) if on)
            a1 = solver[s] @ (-K @ p - pull)
            u1 = p + dt * dt / 4 * a1
            if all((o @ u1 + d < 0) == bool(on) for on, o, d in zip(s, out, room)):
                break
        else:
            raise ArithmeticError(f"step {step}: no state agrees with itself")
        v1 = v + dt / 2 * (a + a1)
        before, after = out[1] @ u + room[1], out[1] @ u1 + room[1]
        if closing is None and after < 0:
            closing = -(v[0] + before / (before - after) * (v1[0] - v[0])) / V
        u, v, a = u1, v1, a1
    return float(closing), float(np.ones(size) @ M @ v / setup.left.mass / V)


def second_impacts():
    lumped = {"n": 10, "dt": 0.001}
    for case, flight in (({**lumped, "k_I": 100.0}, 0.83), ({**lumped, "k_I": 10000.0}, 0.83),
                         ({"n": 7, "dt": 0.004, "gamma": 0.5, "mass": "consistent", "gap": 0.22}, 0.6)):
        print(f"{case}, flight {flight}: closing and rebound speed {second_impact(case, flight)}")
    flights = [0.5 + 0.07 * i for i in range(22)]
    for k in (100.0, 10000.0):
        speeds = np.array([second_impact({**lumped, "k_I": k}, flight) for flight in flights])
        off = np.sqrt(np.mean((speeds - 1) ** 2, axis=0))
        print(f"k_I = {k}, 22 flights: off by {off}, from {speeds.min(axis=0)} to {speeds.max(axis=0)}")


if __name__ == "__main__":
    step_energy()
    period()
    newton()
    contact_mode()
    continuum_spring()
    un_iterated()
    second_impacts()
