"""Data and solutions of the test cases of other programs in docs/benchmarks.md, independent of slipgap. Needs numpy and scipy.

    benchmarks.py beams     Code_Aster V5.02.105 (SDNL105): modes of the beams for studies/benchmarks/benchmark-sdnl105.json, and the
                            motion by Runge-Kutta steps
    benchmarks.py wear      Code_Aster V5.01.104 (SDND104): power of wear by the closed form of a block on a shaking plane
    benchmarks.py static    Code_Aster V5.01.106 (SDND106): the motion by closed forms between events
"""

import sys

import numpy as np
import scipy.linalg
from scipy.integrate import solve_ivp
from scipy.optimize import brentq


def beam(elements=10):
    """Natural frequencies and modes at mid-span of a clamped tube by Hermite elements with consistent mass (POU_D_E)."""
    E, rho, length, radius, wall = 1e10, 1e8, 1.0, 0.1, 0.01
    inner, h = radius - wall, length / elements
    area, inertia = np.pi * (radius**2 - inner**2), np.pi / 4 * (radius**4 - inner**4)
    k = E * inertia / h**3 * np.array(
        [[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h],
         [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]])
    m = rho * area * h / 420 * np.array(
        [[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h],
         [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h * h, -22 * h, 4 * h * h]])
    K, M = np.zeros((2, 2 * elements + 2, 2 * elements + 2))
    for e in range(elements):
        rows = slice(2 * e, 2 * e + 4)
        K[rows, rows] += k
        M[rows, rows] += m
    held = slice(2, -2)
    squares, modes = scipy.linalg.eigh(K[held, held], M[held, held])
    return squares, modes[2 * (elements // 2 - 1)]


def beams():
    squares, middle = beam()
    within = np.sqrt(squares) / (2 * np.pi) < 35.0
    print("modes below 35 Hz:", np.sqrt(squares[within]) / (2 * np.pi), "Hz")
    # Modes with a node at mid-span do not move.
    kept = within & (abs(middle) > 1e-9 * abs(middle).max())
    squares, middle = squares[kept], abs(middle[kept])
    print("squares of the circular frequencies", *(f"{w:.15g}" for w in squares))
    print("modes at mid-span", *(f"{p:.15g}" for p in middle))
    n = len(squares)

    def rate(_, y):
        q = y[:3 * n].reshape(3, n)
        u = q @ middle
        first, second = 1e8 * np.maximum([u[0] - u[1] - 1e-3, u[1] - u[2] - 1e-3], 0)
        force = np.array([1e6 - first, first - second, second])
        return np.r_[y[3 * n:], (force[:, None] * middle - q * squares).ravel()]

    end = solve_ivp(rate, (0, 1), np.zeros(6 * n), method="DOP853", rtol=1e-11, atol=1e-15, max_step=1e-3).y[:, -1]
    print("displacements at 1 s", end[:3 * n].reshape(3, n) @ middle)
    print("velocities at 1 s", end[3 * n:].reshape(3, n) @ middle)


def wear():
    """A block with N = 10, mu = 0.1 on a ground a sin(2 pi t): N times the mean speed. Units of the slip: a/omega^2."""
    for a in (1.5, 1.01):
        eta, omega = 1 / a, 2 * np.pi
        t1 = np.arcsin(eta)
        t2 = brentq(lambda t: np.cos(t1) - np.cos(t) - eta * (t - t1), t1 + 1e-3, 2 * np.pi)
        slip = np.cos(t1) * (t2 - t1) - (np.sin(t2) - np.sin(t1)) - eta * (t2 - t1) ** 2 / 2
        # Two slips in a period of 1 s.
        print(f"a {a}: {10 * 2 * abs(slip) * a / omega**2:.9g}")


def static():
    """Two masses of 5 on a spring of 1e4; friction 3000 at rest, 2000 sliding, on the first one; 3000 on the second to 0.2 s."""
    m, k, F, held, sliding = 5.0, 1e4, 3000.0, 3000.0, 2000.0
    w = np.sqrt(k / m)
    t1 = np.arccos(1 - held / F) / w
    x, v = np.array([0.0, F / k * (1 - np.cos(w * t1))]), np.array([0.0, F / k * w * np.sin(w * t1)])

    def slide(x, v, force, t):
        """Mean motion and half the difference under constant forces, t after x and v."""
        s, ds = x.sum() / 2, v.sum() / 2
        d, dd = (x[1] - x[0]) / 2, (v[1] - v[0]) / 2
        a, rest = (force - sliding) / (2 * m), (force + sliding) / (2 * m) / (2 * w * w)
        W = np.sqrt(2) * w
        c, n = np.cos(W * t), np.sin(W * t)
        D, dD = rest + (d - rest) * c + dd / W * n, -(d - rest) * W * n + dd * c
        S, dS = s + ds * t + a * t * t / 2, ds + a * t
        return np.array([S - D, S + D]), np.array([dS - dD, dS + dD])

    print(f"t1 {t1:.7f}")
    print("x at 0.15", slide(x, v, F, 0.15 - t1)[0])
    x, v = slide(x, v, F, 0.2 - t1)
    times = np.linspace(0, 0.2, 20001)
    speeds = [slide(x, v, 0.0, t)[1][0] for t in times]
    first = next(i for i, speed in enumerate(speeds) if speed < 0)
    stop = brentq(lambda t: slide(x, v, 0.0, t)[1][0], times[first - 1], times[first], xtol=1e-15)
    print(f"t3 {0.2 + stop:.7f}")
    x, v = slide(x, v, 0.0, stop)
    print("held:", abs(k * (x[1] - x[0])) < held)
    for t in (0.34, 0.339965):
        late = w * (t - 0.2 - stop)
        print(f"x2 at {t}:", x[0] + (x[1] - x[0]) * np.cos(late) + v[1] / w * np.sin(late))


if __name__ == "__main__":
    {"beams": beams, "wear": wear, "static": static}[sys.argv[1]]()
