"""Checks of friction.py.

Run:  python3 friction_checks.py confirm   numbers of the issue, in double precision (standard library only)
      python3 friction_checks.py agree     the two ways to the root, two precisions, two ways to the exact motion
                                           (needs mpmath)
"""

import math
import sys

from friction import Coulomb, Digits50, Double, by_bisection, friction_work, run, sign, solve, steps_of
from friction_data import CASES, displacement, velocity


def confirm():
    """Prints the numbers of the issue and of the reference page."""
    pi, ar = math.pi, Double()
    rows = [("Fig. 5", [displacement(a, pi / 10) for a in (0.1, 1.0, 5.0)]),
            ("Fig. 5 pulled", [displacement(a, pi / 10, slip="pulled") for a in (0.1, 1.0, 5.0)]),
            ("Fig. 5 sliding", [displacement(a, pi / 10, slip="sliding") for a in (0.1, 1.0, 5.0)]),
            ("Fig. 6", [displacement(0.1, pi / k) for k in (10, 5, 3)]),
            ("Fig. 7", [velocity(b, pi / 10) for b in (0.1, 1.0, 5.0)]),
            ("Fig. 8", [velocity(0.303, pi / k) for k in (10, 5, 3)]),
            ("alpha 0.1, pi/3 .. pi/80", [displacement(0.1, pi / k) for k in (3, 5, 10, 20, 40, 80)])]
    for name, cases in rows:
        print(f"{name:26}", *(f"{run(c, ar)[3]['rms_error']:.6f}" for c in cases))
    for k in (10, 1000):
        print(f"friction work, pi/{k:<9}", *(f"{friction_work(solve(displacement(a, pi / k), ar)):.4f}"
                                              for a in (0.1, 1.0, 5.0)))
    for x0 in (11.2, 11.5, 12.0, 12.5, 3.0, 1.0, 0.5, -12.0):
        exact = Coulomb(x0, ar)
        print(f"x0 = {x0:5}: m = {exact.m}, rest at {exact.rest:.10f}, T/pi = {exact.rest_time / pi:.10f}")
    for name, cases in rows[:6]:
        for c in cases:
            print(name, c.get("alpha", c.get("beta")), f"pi/{pi / c['dT']:.0f}",
                  {k: v if v is None else round(v, 6) for k, v in run(c, ar)[3].items()})


def coulomb_by_quadrature(x0, duration, step=1e-3):
    """Rows (T, X, V) of X'' = -X - sign(X'), by Runge-Kutta steps and halving at the zeros of the velocity."""
    def advance(x, v, s, h):
        f = lambda x, v: (v, -x - s)
        k1 = f(x, v)
        k2 = f(x + h / 2 * k1[0], v + h / 2 * k1[1])
        k3 = f(x + h / 2 * k2[0], v + h / 2 * k2[1])
        k4 = f(x + h * k3[0], v + h * k3[1])
        return tuple(y + h / 6 * (a + 2 * b + 2 * c + d) for y, a, b, c, d in zip((x, v), k1, k2, k3, k4))

    t, x, v, rows = 0.0, float(x0), 0.0, [(0.0, float(x0), 0.0)]
    while t < duration and abs(x) > 1:
        s = -sign(x)
        while t < duration:
            x1, v1 = advance(x, v, s, step)
            if v1 * s > 0:  # still moving the way friction resists
                t, x, v = t + step, x1, v1
                rows.append((t, x, v))
                continue
            low, high = 0.0, step
            for _ in range(60):
                mid = (low + high) / 2
                low, high = (mid, high) if advance(x, v, s, mid)[1] * s > 0 else (low, mid)
            t, x, v = t + high, advance(x, v, s, high)[0], 0.0
            rows.append((t, x, v))
            break
    return rows


def agree():
    """Largest difference between the two roots (50 digits) and between double and 50 digits, over all cases."""
    ar, dbl = Digits50(), Double()
    for x0 in (12.0, 12.5, -11.2, 3.5):
        exact = Coulomb(x0, dbl)
        rows = coulomb_by_quadrature(x0, 30.0)
        worst = max(max(abs(x - exact.at(t)[0]), abs(v - exact.at(t)[1])) for t, x, v in rows)
        print(f"Coulomb, x0 = {x0}: {worst:.1e}, rests at {rows[-1][1]:.12f} from T/pi = {rows[-1][0] / math.pi:.12f}")
    for case in CASES():
        if steps_of(case["duration"], case["dT"]) > 600:
            continue
        one, two, low = solve(case, ar), solve(case, ar, by_bisection), solve(case, dbl)
        diff = lambda p, q: max(abs(a - b) for c, d in zip(p, q) for a, b in zip(c, d))
        print(f"roots {float(diff(one, two)):.1e}  double {float(diff(one, low)):.1e}", case)


if __name__ == "__main__":
    verb = sys.argv[1] if len(sys.argv) == 2 else ""
    {"confirm": confirm, "agree": agree}.get(verb, lambda: sys.exit(__doc__))()
