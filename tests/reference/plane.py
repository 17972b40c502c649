"""A mass on springs and friction in two directions, for docs/findings-plane.md: a disc, two uncoupled directions (a square), and a fan of
n sliders. Steps in which friction acts on the velocity at the end (implicit Euler for friction, explicit for the spring), so small that
the results of two steps give those of none. Independent of slipgap. Needs numpy.

    plane.py circle     ground (cos t, b sin t) and (cos t, b cos t), 40 cycles from rest
    plane.py fan        four sliders under a circle and a line in x, 40 cycles from rest
    plane.py recorded   the two stations of studies/records/ with both horizontal components; with `fan` four sliders, too
"""

import math
import pathlib
import sys

import numpy as np

from records import smc

RECORDS = pathlib.Path(__file__).parents[2] / "studies" / "records"
SITES = {
    "Redwood City": ("lomaprieta-1989-redwoodcity-apeel2-043.smc", "lomaprieta-1989-redwoodcity-apeel2-133.smc", 2.7233),
    "Shafter": ("lomaprieta-1989-sanfrancisco-shafter-360.smc", "lomaprieta-1989-sanfrancisco-shafter-270.smc", 1.0444),
}


def disc(v, most):
    """The velocity that is left after a change of at most `most` against it."""
    speed = np.hypot(v[0], v[1])
    return v * np.maximum(0.0, 1.0 - most / np.maximum(speed, 1e-300))


def square(v, most, turn):
    """The same for two directions alone, turned by an angle."""
    c, s = np.cos(turn), np.sin(turn)
    w = np.array([c * v[0] + s * v[1], c * v[1] - s * v[0]])
    w = np.sign(w) * np.maximum(0.0, abs(w) - most)
    return np.array([c * w[0] - s * w[1], s * w[0] + c * w[1]])


def fan(v, most, n, turn):
    """n sliders with the mean limit of a disc: the changes are the nearest point to v of the sum of n intervals, a polygon."""
    each = most * math.pi / (2 * n)
    angles = [math.pi * i / n + turn for i in range(n)]
    part = [np.zeros_like(v[0]) for _ in angles]
    rest = v.copy()
    for _ in range(20):
        for i, a in enumerate(angles):
            c, s = np.cos(a), np.sin(a)
            along = rest[0] * c + rest[1] * s + part[i]
            new = np.clip(along, -each, each)
            rest = rest - (new - part[i]) * np.array([c + 0 * new, s + 0 * new])
            part[i] = new
    return rest


def move(ground, dt, steps, limit, stiffness, friction):
    """Largest distance, its rms, the last one, and the work of friction, for all cases side by side, from rest."""
    u = np.zeros((2, len(limit)))
    v = np.zeros((2, len(limit)))
    peak, work, squares = np.zeros((3, len(limit)))
    for i in range(steps):
        t = i * dt
        a = ground(t + 0.5 * dt)
        w = v - dt * (np.array(a).reshape(2, -1) + stiffness * u)
        v = friction(w, dt * limit)
        work += np.sum((w - v) * v, axis=0)
        u = u + dt * v
        distance = np.hypot(u[0], u[1])
        peak = np.maximum(peak, distance)
        squares += distance**2
    return peak, np.sqrt(squares / steps), distance, work


def circle():
    etas, periods = (0.2, 0.4, 0.6, 0.8, 0.9), (1.5, 2.0, 3.0, 5.0)
    limit = np.array([e for e in etas for _ in periods])
    stiffness = np.array([1 / p**2 for _ in etas for p in periods])
    for name, b, straight in (("circle", 1.0, False), ("ellipse", 0.5, False), ("line at 45 degrees", 1.0, True)):
        def ground(t):
            return math.cos(t), b * (math.cos(t) if straight else math.sin(t))
        results = []
        for kind in (disc, lambda v, most: square(v, most, 0.0)):
            two = [np.array(move(ground, 2 * math.pi / n, 40 * n, limit, stiffness, kind)) for n in (1000, 2000)]
            results.append(2 * two[1] - two[0])
        for i, (eta, k) in enumerate(zip(limit, stiffness)):
            exact = math.sqrt(1 - eta**2) / abs(k - 1) if b == 1 and not straight else math.nan
            (peak, rms, last, work), (p, r, l, w) = results[0][:, i], results[1][:, i]
            print(f"{name}: eta {eta}, T {k**-0.5:.3g}: disc peak {peak:.5f} rms {rms:.5f} last {last:.5f} (steady {exact:.5f}), "
                  f"square over disc: peak {p / peak:.4f} rms {r / rms:.4f} work {w / work:.4f}")


def sliders():
    limit = np.array([0.2, 0.4, 0.6, 0.8])
    for name, b in (("circle", 1.0), ("line", 0.0)):
        def ground(t):
            return math.cos(t), b * math.sin(t)
        rms = []
        for kind in (disc, lambda v, most: fan(v, most, 4, 0.0)):
            two = [move(ground, 2 * math.pi / n, 40 * n, limit, 0.25 + 0 * limit, kind)[1] for n in (500, 1000)]
            rms.append(2 * two[1] - two[0])
        print(name, "four sliders over disc, rms", rms[1] / rms[0])


def recorded():
    cases = [(eta, T, turn) for eta in (0.1, 0.2, 0.4) for T in (2.0, 4.0) for turn in (0.0, 45.0)]
    eta, T, turn = (np.array(x) for x in zip(*cases))
    turn = turn * math.pi / 180
    for site, (first, second, pga) in SITES.items():
        components = []
        for file in (first, second):
            dt, unit, values = smc((RECORDS / file).read_text().splitlines())
            components.append(unit * values)
        end = min(map(len, components))
        a = np.array([c[:end] for c in components])

        def ground(t):
            at = min(t / dt, end - 1.001)
            i = int(at)
            return (a[:, i] + (at - i) * (a[:, i + 1] - a[:, i])).tolist()

        kinds = {"disc": disc, "square": lambda v, m: square(v, m, turn), "fan 4": lambda v, m: fan(v, m, 4, turn)}
        for kind, friction in kinds.items():
            if kind == "fan 4" and "fan" not in sys.argv[2:]:
                continue
            two = [np.array(move(ground, dt / n, (end - 1) * n, eta * pga, (2 * np.pi / T) ** 2, friction)) for n in (10, 20)]
            peak, _, last, work = 2 * two[1] - two[0]
            for i, case in enumerate(cases):
                print(f"{site}, {kind}, eta, T, turn {case}: peak {peak[i]:.5f} last {last[i]:.5f} work {work[i]:.5f} "
                      f"(change {abs(two[1] - two[0])[0][i] / peak[i]:.4f})")


if __name__ == "__main__":
    {"circle": circle, "fan": sliders, "recorded": recorded}[sys.argv[1]]()
