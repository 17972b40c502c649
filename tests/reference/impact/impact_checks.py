"""Checks of impact.py and waves.py.

Run:  python3 impact_checks.py confirm   numbers of the issue, in double precision (standard library only)
      python3 impact_checks.py exact     the exact solution: closed forms, energy, unequal bars, touching again, meshes
      python3 impact_checks.py agree     sensitivity of each case, double against 50 digits, full matrices
                                         (needs mpmath and numpy)
"""

import math
import random
import sys

from impact import Digits50, Double, Model, Setup, solve
from impact_data import CASES, extremes
from impact_metrics import norm_right_hand, norm_split, run
from waves import Exact

KEYS = ("contact_duration", "separations", "max_overlap", "peak_force", "restitution", "rms_error_r", "rms_error_rdot")


def show(case, keys=KEYS):
    values = run(case, Double())[3]
    print({k: v for k, v in case.items()}, {k: None if values[k] is None else round(values[k], 5) for k in keys})


def confirm():
    """The numbers of the issue; mesh and step of the three figures; gaps at the largest step."""
    for k in (10.0, 100.0, 1000.0, 10000.0):
        show({"k_I": k, "n": 10, "dt": 0.001, "duration": 1.5})
    for n in (2, 10, 40):
        show({"k_I": 100.0, "n": n, "dt": 0.01, "duration": 1.5})
    for dt in (0.5, 0.05, 0.01):
        show({"k_I": 100.0, "n": 10, "dt": dt, "duration": 2.0})
    setup, solution, _, values = run({"k_I": 100.0, "n": 10, "dt": 0.5, "duration": 2.0}, Double())
    r = [row[1] for row in solution["rows"]]
    end = next(i for i in range(1, 5) if r[i] >= 0 > r[i - 1])
    print("dt = 0.5: contact by the metric", values["contact_duration"], "with the end interpolated",
          (end - 1 + r[end - 1] / (r[end - 1] - r[end])) * 0.5, "r", [round(x, 5) for x in r])
    print("readings of the norms of rdot (own limits, right-hand limits, split at jumps):")
    for gap, dt in ((0.0, 0.01), (0.1, 0.01), (0.11, 0.01), (0.0, 0.3), (0.5, 0.1)):
        setup, solution, exact, values = run({"gamma": 1.0, "n": 10, "dt": dt, "duration": 1.5, "gap": gap}, Double())
        t, rdot = [row[0] for row in solution["rows"]], [row[2] for row in solution["rows"]]
        print("  gap", gap, "dt", dt, values["rms_error_rdot"], norm_right_hand(setup, t, rdot, exact, 1),
              norm_split(setup, t, rdot, exact, 1))


def exact_of(length, impedance, gap, end, one=1.0):
    """Exact solution for a right bar of `length` and `impedance` over the left one's, at equal wave speed."""
    return Exact(gap, length, impedance / (1 + impedance), 1 / (1 + impedance), end, one)


def energy_inside(exact, length, impedance, t):
    """Kinetic plus strain energy over rho A L c^2 of the left bar, frame of the right bar; sums over constant pieces."""
    total = 0.0
    for bar, half, weight in (("left", 0.5, 1.0), ("right", length / 2, impedance)):
        edges = {0.0, half}
        line = exact.left if bar == "left" else exact.right
        for time in [*line.times, *(at for at, _ in line.flying)]:
            if 0 < time - t < half:
                edges.add(time - t)
        for time in [*line.times, *exact.times]:
            if 0 < t - time < half:
                edges.add(t - time)
        edges = sorted(edges)
        share = exact.shares[0] if bar == "left" else exact.shares[1]
        for p, q in zip(edges, edges[1:]):
            v, force = exact.inside(bar, (p + q) / 2, t)
            total += weight * (v * v + (force * share) ** 2) / 2 * (q - p) / 0.5
    return total


def exact_checks():
    pulse = exact_of(1.0, 1.0, 0.0, 3.0)
    print("equal bars", [tuple(round(x, 12) for x in p[:4]) for p in pulse.pieces], pulse.phases())
    worst = 0.0
    for i in range(2000):  # d'Alembert: behind the front v = mean and force 1, elsewhere before +-1/2 from the mean
        t, s = random.random() * 1.6, random.random() * 0.5
        v, force = pulse.inside("left", s, t)
        if t < 0.5:
            want = (0.5, 1.0) if s < t else (1.0, 0.0)
        elif t < 1.0:
            want = (0.5, 1.0) if s < 1.0 - t else (0.0, 0.0)
        else:
            want = (0.0, 0.0)
        worst = max(worst, abs(v - want[0]), abs(force - want[1]))
    print("equal bars, d'Alembert in the left bar:", worst)
    for name, length, impedance in (("impedance left 2, right 1", 1.0, 0.5), ("lengths 1 : 2", 2.0, 1.0),
                                    ("lengths 2 : 1", 0.5, 1.0), ("impedance left 1, right 2", 1.0, 2.0),
                                    ("length sqrt 2, impedance 3", math.sqrt(2), 3.0)):
        exact = exact_of(length, impedance, 0.0, 6.0)
        momenta = exact.impulse(6.0)  # velocity change over c of a bar: F0 T_I J/(rho A L) = 2 J share, over its length
        print(name, "touch, force:", [[tuple(None if y is None else round(y, 9) for y in x) for x in part]
                                      for part in exact.phases()],
              "means over c:", 1 - 2 * momenta * exact.shares[0], 2 * momenta * exact.shares[1] / length)
    wall = Exact(0.3, None, 1.0, 0.0, 3.0)
    print("wall, gap 0.3:", [tuple(round(x, 12) for x in p[:4]) for p in wall.pieces])
    random.seed(1)
    again, forces, most, least, late, tried = 0, 0, 0, 0.0, 0, 20000
    for _ in range(tried):
        length, impedance = math.exp(random.uniform(-4, 4)), math.exp(random.uniform(-4, 4))
        if random.random() < 0.3:
            length = random.choice((0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 1 / 3, 1.5, 2 / 3))
        if random.random() < 0.3:
            impedance = random.choice((0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 1 / 3, 1.5, 2 / 3))
        exact = exact_of(length, impedance, 0.0, 10 * max(1.0, length) if length < 6 else 5 * length)
        touch, force = exact.phases()
        again, forces, most = again + (len(touch) > 1), forces + (len(force) > 1), max(most, len(exact.pieces))
        least = min(least, *(p[2] for p in exact.pieces if p[0] >= touch[0][1]))
        late += touch[0][1] > max(1.0, length) + 1e-9
    print(f"unequal bars, {tried} at random: {again} touch again, least rdot after separation {least}, {forces} with "
          f"force in more than one interval, {late} in touch beyond the longer 2L/C; most pieces {most}")
    worst = 0.0
    for _ in range(300):
        length, impedance = math.exp(random.uniform(-2, 2)), math.exp(random.uniform(-2, 2))
        exact = exact_of(length, impedance, 0.2, 8.0)
        worst = max(worst, *(abs(energy_inside(exact, length, impedance, random.random() * 8) - 0.5) for _ in range(5)))
        for t in (random.random() * 8 for _ in range(5)):
            _, rdot, force = exact.at(t)
            (v1, f1), (v2, f2) = exact.inside("left", 0.0, t), exact.inside("right", 0.0, t)
            worst = max(worst, abs(v2 - v1 - rdot), abs(f1 - force), abs(f2 - force))
    print("energy, and ends against rdot and force, worst:", worst)
    print("meshes towards the exact solution (gamma 4, dt 0.1/n): rms error of r")
    for right in ({"L": 20.0}, {"L": 14.0, "A": 2.0}, {"E": 200.0, "V0": 0.0, "L": 5.0}, "wall"):
        line = []
        for n in (10, 40, 160):
            other = right if right == "wall" else {**right, "n": n}
            line.append(run({"gamma": 4.0, "n": n, "dt": 0.1 / n, "duration": 2.5, "gap": 0.2, "right": other},
                            Double())[3]["rms_error_r"])
        print("   ", right, [f"{x:.5f}" for x in line])


def agree():
    """How far each case moves when r(0) moves by 1e-13, and how far double precision is from 50 digits."""
    high, low = Digits50(), Double()
    for case in CASES():
        exactly = solve(Setup(case, high))
        moved = Setup(case, high)
        moved.gap += high.number("1e-13")
        one, two = run(case, high)[3], run(case, low)[3]
        metric = max(abs(one[k] - two[k]) if one[k] is not None else 0 for k in one)
        same = all((one[k] is None) == (two[k] is None) for k in one) and one["separations"] == two["separations"]
        print(f"r(0) + 1e-13: {float(extremes(exactly, solve(moved))):.1e}  double: "
              f"{float(extremes(exactly, solve(Setup(case, low)))):.1e}  metrics {float(metric):.1e} {same}"
              f"  dense: {dense_difference(case):.1e}", case)


def dense_difference(case):
    """The same problem with full matrices, np.linalg.solve and the displacement form of the method."""
    import numpy as np
    setup = Setup(case, Double())
    model = Model(setup)
    full = lambda t: np.diag(t.diagonal) + np.diag(t.off, 1) + np.diag(t.off, -1)
    M, K, B = full(model.M), full(model.K), full(model.spring)
    b = np.zeros(len(M))
    model.add_b(b, 1.0)
    dt, gap = setup.dt * setup.T, setup.gap * setup.c * setup.T / 2
    u, v, a = np.zeros(len(M)), np.array(model.v0), np.zeros(len(M))
    rows, r = [], gap
    for step in range(setup.steps + 1):
        S = setup.k * r if r < 0 else 0.0
        rows.append((0.0, r / (setup.c * setup.T / 2), b @ v / setup.c, -S / setup.F0))
        rhs = M @ (4 / dt ** 2 * u + 4 / dt * v + a)
        new = np.linalg.solve(4 / dt ** 2 * M + K, rhs)
        r = b @ new + gap
        if r < 0:
            new = np.linalg.solve(4 / dt ** 2 * M + K + B, rhs - setup.k * gap * b)
            r = b @ new + gap
        a, v, u = 4 / dt ** 2 * (new - u) - 4 / dt * v - a, 2 / dt * (new - u) - v, new
    return extremes({"rows": rows}, solve(setup))


if __name__ == "__main__":
    verb = sys.argv[1] if len(sys.argv) == 2 else ""
    {"confirm": confirm, "exact": exact_checks, "agree": agree}.get(verb, lambda: sys.exit(__doc__))()
