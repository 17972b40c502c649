"""Checks of structures.py.

Run:  python3 structures_checks.py confirm   closed forms and the numbers known of friction under a sine
      python3 structures_checks.py agree     tolerances, step lengths and the book of energy, for all structures
      python3 structures_checks.py laws      forces against the laws at many small steps, which know no events
      python3 structures_checks.py steps     the papers' method towards the motion, at order 2
                                             (needs numpy and scipy; `steps` some minutes)
"""

import itertools
import math
import sys

import numpy as np

from structures import Motion, Structure, solve
from structures_contacts import piece
from structures_data import STRUCTURES, difference, displacement, impact, limit, load, sine, structure, velocity

LOW, FREE, HIGH = -1, 0, 1


def samples(data, count=20):
    return [data["end"] * i / count for i in range(count + 1)]


def confirm():
    """A mass on a spring and an elastic stop; friction under a sine with narrow zones against [Den Hartog 1931]."""
    k, gap = 300.0, 0.3
    data = structure("", 30.0, [1.0], [[None, 0, 1.0, 0.0]], [impact(0, None, gap, k)], [], [-1.0], [0.0])
    w = math.sqrt(1 + k)
    touch, speed, centre = math.acos(-gap), math.sqrt(1 - gap**2), k * gap / (1 + k)
    # In touch about `centre`, from gap with `speed`, until it is back.
    half = (math.pi - 2 * math.atan((gap - centre) * w / speed)) / w
    events = [e[0] for e in solve(data, [0.0, 30.0]).events]
    closed = [touch + i // 2 * (2 * touch + half) + i % 2 * half for i in range(len(events))]
    print(f"elastic stop, {len(events)} events: {max(abs(a - b) for a, b in zip(events, closed)):.1e}")
    exact, period = 2.6261048757, math.tau / 0.8
    for law, widths in ((displacement, (1e-1, 1e-2, 1e-3, 1e-4)), (velocity, (1e-1, 1e-2, 1e-3))):
        line = []
        for width in widths:
            data = structure("", 101 * period, [1.0], [[None, 0, 1.0, 0.0]], [law(None, 0, 0.3 / width, limit(0.3))],
                             [load(sine(1.0, 0.8, math.pi / 2), (0, 1.0))])
            rows = solve(data, [0.0, *(period * (100 + i / 400) for i in range(401))], 1e-9).rows
            # The peak from the sample next to it: u'' = -u near it, but for a force of size 1 that does not change there.
            most = max(rows, key=lambda row: abs(row["u"][0]))
            a = math.cos(0.8 * most["t"]) - most["u"][0] - most["S"][0]
            line.append(abs(most["u"][0] - most["v"][0] ** 2 / (2 * a)) / exact - 1)
        print(f"{law.__name__}-control, widths {widths}: amplitude over Den Hartog's less 1:", *(f"{x:.5f}" for x in line))


def agree():
    for data in STRUCTURES():
        times = samples(data)
        best = solve(data, times)
        size = Motion(data, times, 1e-7).largest + 1e-30
        others = [solve(data, times, 1e-11), solve(data, times, 1e-12), solve(data, times, 3e-14),
                  Motion(data, times, 1e-13, size, max_step=data["end"] / 5000)]
        apart = [f"{difference(best, other)[0]:.1e}" for other in others]
        swing = max(abs(x) for row in best.rows for x in row["work"])
        print(f"{data['name']:58} tolerance 1e-11, 1e-12, 3e-14: {', '.join(apart[:3])}; short steps {apart[3]}; "
              f"energy {np.ptp(best.books()) / swing:.1e}", flush=True)


def limit_at(data, t, middle):
    if not data["signal"]:
        return data["constant"]
    return max(data["constant"] + data["factor"] * piece(data["signal"], middle)[0](t), 0.0)


def laws():
    """S of the motion at many times, against the law with r and r' of these times alone; of the amplitude."""
    for data in STRUCTURES():
        worst = []
        for count in (1000, 4000):
            motion = solve(data, samples(data, count), 1e-10)
            apart = 0.0
            for c, contact in enumerate(data["contacts"]):
                S, size = 0.0, max(abs(row["S"][c]) for row in motion.rows)
                for before, row in zip(motion.rows, motion.rows[1:]):
                    if contact["law"] == "impact":
                        S = contact["k"] * min(row["r"][c], 0.0)
                    else:
                        most = limit_at(contact["limit"], row["t"], (before["t"] + row["t"]) / 2)
                        moved = row["r"][c] - before["r"][c]
                        S = contact["c"] * row["rdot"][c] if "c" in contact else S + contact["k"] * moved
                        S = max(-most, min(most, S))
                    apart = max(apart, abs(S - row["S"][c]) / size)
            worst.append(apart)
        print(f"{data['name']:58} {worst[0]:.1e} with 1000, {worst[1]:.1e} with 4000", flush=True)


def stepped(data, count):
    """Displacements at 20 times by constant average acceleration; patterns of the contacts are tried until one fits."""
    s, dt, m = Structure(data), data["end"] / count, len(data["contacts"])
    inverse = np.linalg.inv(4 / dt**2 * np.diag(s.masses) + 2 / dt * s.C + s.K)
    W = inverse @ s.B.T
    H = s.B @ W
    softness = np.array([dt / (2 * c["c"]) if "c" in c else 1 / c["k"] for c in data["contacts"]])
    A = H + np.diag(softness)
    patterns = list(itertools.product((LOW, FREE, HIGH), repeat=m))
    u, v, S = np.array(data["displacement"]), np.array(data["velocity"]), np.zeros(m)
    r, rate = s.B @ u + s.gap, s.B @ v
    for c, contact in enumerate(data["contacts"]):
        if contact["law"] == "impact":
            S[c] = contact["k"] * min(r[c], 0.0)
        elif contact["law"] == "velocity-control":
            most = limit_at(contact["limit"], 0.0, dt / 2)
            S[c] = max(-most, min(most, contact["c"] * rate[c]))
    rows, last = [u], patterns[0]
    for step in range(1, count + 1):
        t0, t1, middle = (step - 1) * dt, step * dt, (step - 0.5) * dt
        loads = [piece(x["signal"], middle)[0] for x in data["loads"]]
        p0, p1 = (np.array([f(t) for f in loads]) @ s.patterns for t in (t0, t1))
        # From equilibrium, so that a jump of the load counts from its time on.
        a = (p0 - s.C @ v - s.K @ u - S @ s.B) / s.masses
        free = inverse @ (p1 + s.masses * (4 / dt**2 * u + 4 / dt * v + a) + s.C @ (2 / dt * u + v))
        c, low, high = np.zeros(m), np.zeros(m), np.zeros(m)
        for i, contact in enumerate(data["contacts"]):
            if contact["law"] == "impact":
                low[i] = -math.inf
                continue
            high[i] = limit_at(contact["limit"], t1, middle)
            low[i] = -high[i]
            c[i] = r[i] + dt / 2 * rate[i] if "c" in contact else r[i] - S[i] / contact["k"]
        d = s.B @ free + s.gap - c
        for pattern in [last, *patterns]:
            S1 = fit(A, d, low, high, np.array(pattern))
            if S1 is not None:
                break
        else:
            raise ArithmeticError(f"no pattern fits at step {step}")
        last, S = pattern, S1
        u1 = free - W @ S
        u, v = u1, 2 / dt * (u1 - u) - v
        r, rate = s.B @ u + s.gap, s.B @ v
        if step % (count // 20) == 0:
            rows.append(u)
    return np.array(rows)


def fit(A, d, low, high, pattern):
    """Forces of a pattern, or `None` where they contradict it."""
    S = np.where(pattern == LOW, low, np.where(pattern == HIGH, high, 0.0))
    if not np.isfinite(S).all():
        return None
    free = pattern == FREE
    if free.any():
        S[free] = np.linalg.solve(A[np.ix_(free, free)], d[free] - A[np.ix_(free, ~free)] @ S[~free])
    q = d - A @ S
    tiny = 1e-12 * (np.abs(d) + np.abs(A) @ np.abs(S))
    inside = (S >= low - tiny / A.diagonal()) & (S <= high + tiny / A.diagonal())
    fits = np.where(free, inside, np.where(pattern == LOW, q <= tiny, q >= -tiny)) | (low == high)
    return S if fits.all() else None


def steps():
    for data in STRUCTURES():
        u = np.array([row["u"] for row in solve(data, samples(data)).rows])
        apart = [np.max(np.abs(stepped(data, count) - u)) / np.max(np.abs(u)) for count in (4000, 16000, 64000)]
        print(f"{data['name']:58}", *(f"{x:.1e}" for x in apart), f"orders {math.log(apart[0] / apart[1], 4):.2f} "
              f"{math.log(apart[1] / apart[2], 4):.2f}", flush=True)


if __name__ == "__main__":
    verb = sys.argv[1] if len(sys.argv) == 2 else ""
    verbs = {"confirm": confirm, "agree": agree, "laws": laws, "steps": steps}
    verbs.get(verb, lambda: sys.exit(__doc__))()
