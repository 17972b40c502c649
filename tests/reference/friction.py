"""The friction oscillator of [F], solved a second time by a route that shares nothing with the Rust program.

What is solved (dimensionless: T = omega_n t, X = x/Delta, forces over nu N):

    X'' + X + S = 0,   X(0) = x0,  X'(0) = 0,   X''(0) = -x0 - S(0)
    displacement-control  S = (X - Xs)/alpha, return mapping: where that is beyond +-1, S = +-1 and Xs = X -+ alpha
    velocity-control      S = X'/beta, cut to -1 .. 1
    initial slip          Xs(0) = x0 (unloaded), x0 - sign(x0) alpha (pulled), x0 + sign(x0) alpha (sliding)

One step of the constant average acceleration method, written for the unknown acceleration a at its end:

    X1(a) = X + dT V + dT^2/4 (A + a),   V1(a) = V + dT/2 (A + a),   g(a) = a + X1(a) + S(X1(a), V1(a)) = 0

g rises by at least one for each unit of a, so it has one root. It is found in two ways, which must agree:
`by_branches` solves the three linear equations (inside the zone, S = +1, S = -1) and takes the one whose solution
lies in its own zone; `by_bisection` halves a bracket of g and knows nothing of branches.

The exact Coulomb solution is not taken from a formula for the whole motion: `Coulomb` integrates event by event. At a
rest point it compares the spring force with the friction limit; if it slides, it follows the circle in the phase plane
about the centre -S until the velocity is zero again. `coulomb_by_quadrature` knows no circle: Runge-Kutta steps of the
differential equation with the zeros of the velocity found by halving the step; `agree` compares the two.

Run:  python3 friction.py confirm     the numbers printed in the issue, in double precision (standard library only)
      python3 friction.py data FILE   tests/data/friction.json, with 50 digits (needs mpmath)
      python3 friction.py agree       the two ways to the root and two precisions compared (needs mpmath)
"""

import json
import math
import sys

TOLERANCE = 1e-12  # relative, for times that mean a multiple of pi or of the step but carry rounding


class Double:
    """Arithmetic in double precision."""

    def __init__(self):
        self.number, self.pi = float, math.pi
        self.cos, self.sin, self.sqrt, self.acos = math.cos, math.sin, math.sqrt, math.acos


class Digits50:
    """Arithmetic with 50 digits; parameters enter as the exact values of their doubles."""

    def __init__(self):
        import mpmath
        mpmath.mp.dps = 50
        self.number, self.pi = mpmath.mpf, +mpmath.pi
        self.cos, self.sin, self.sqrt, self.acos = mpmath.cos, mpmath.sin, mpmath.sqrt, mpmath.acos


def sign(x):
    return (x > 0) - (x < 0)


def steps_of(duration, step):
    """N of the contract, in double precision as the contract writes it."""
    return math.floor(duration / step * (1 + 1e-12))


def force(law, width, x, v, slip):
    """S and the slip after return mapping."""
    if law == "velocity-control":
        s = v / width
        return (1 if s > 1 else -1 if s < -1 else s), slip
    s = (x - slip) / width
    if s > 1:
        return x * 0 + 1, x - width
    if s < -1:
        return x * 0 - 1, x + width
    return s, slip


def by_branches(law, width, dt, x, v, a, slip):
    """Acceleration at the end of the step: each branch solved, the one that lies in its own zone taken."""
    x_free = x + dt * v + dt * dt / 4 * a  # X1 and V1 at a = 0
    v_free = v + dt / 2 * a
    mass = 1 + dt * dt / 4
    if law == "velocity-control":
        inside = (-x_free - v_free / width) / (mass + dt / 2 / width)
        measure = lambda acc: (v_free + dt / 2 * acc) / width
    else:
        inside = (-x_free - (x_free - slip) / width) / (mass + dt * dt / 4 / width)
        measure = lambda acc: (x_free + dt * dt / 4 * acc - slip) / width
    found = []
    if -1 <= measure(inside) <= 1:
        found.append(inside)
    plus = (-x_free - 1) / mass
    if measure(plus) > 1:
        found.append(plus)
    minus = (-x_free + 1) / mass
    if measure(minus) < -1:
        found.append(minus)
    if len(found) != 1:
        raise ArithmeticError(f"{len(found)} branches agree with themselves")
    return found[0]


def by_bisection(law, width, dt, x, v, a, slip, halvings=200):
    """Acceleration at the end of the step, by halving a bracket of g."""
    def g(acc):
        x1 = x + dt * v + dt * dt / 4 * (a + acc)
        v1 = v + dt / 2 * (a + acc)
        return acc + x1 + force(law, width, x1, v1, slip)[0]
    reach = abs(g(x * 0)) + 1  # g changes by at least the change of its argument
    low, high = -reach, reach
    for _ in range(halvings):
        mid = (low + high) / 2
        if mid == low or mid == high:
            break
        if g(mid) > 0:
            high = mid
        else:
            low = mid
    return (low + high) / 2


def solve(case, arithmetic, root=by_branches):
    """Columns T, X, V, S at steps 0..N."""
    num = arithmetic.number
    law, dt, x0 = case["law"], num(case["dT"]), num(case["x0"])
    width = num(case["alpha" if law == "displacement-control" else "beta"])
    slip = x0
    if law == "displacement-control":
        slip += {"unloaded": 0, "pulled": -1, "sliding": 1}[case.get("initial_slip", "unloaded")] * sign(x0) * width
    x, v = x0, num(0)
    s = num({"unloaded": 0, "pulled": 1, "sliding": -1}[case.get("initial_slip", "unloaded")] * sign(x0))
    a = -x - s
    T, X, V, S = [num(0)], [x], [v], [s]
    for i in range(1, steps_of(case["duration"], case["dT"]) + 1):
        a1 = root(law, width, dt, x, v, a, slip)
        x, v = x + dt * v + dt * dt / 4 * (a + a1), v + dt / 2 * (a + a1)
        s, slip = force(law, width, x, v, slip)
        a = a1
        T.append(i * dt), X.append(x), V.append(v), S.append(num(s))
    return T, X, V, S


class Coulomb:
    """The exact motion with Coulomb friction, event by event."""

    def __init__(self, x0, arithmetic):
        self.ar = arithmetic
        self.pieces = []  # (start time, position at the start, centre of the circle)
        t, x = arithmetic.number(0), arithmetic.number(x0)
        while abs(x) > 1:  # the spring pulls harder than friction can hold
            s = -sign(x)  # it will move towards zero, friction resists that motion
            centre = arithmetic.number(-s)
            self.pieces.append((t, x, centre))
            # X = centre + (x - centre) cos(tau) until the velocity -(x - centre) sin(tau) is zero again, at tau = pi
            t, x = t + arithmetic.pi, 2 * centre - x
        self.m, self.rest_time, self.rest = len(self.pieces), t, x
        self.peaks = [p for _, p, _ in self.pieces[1:]] + ([x] if self.pieces else [])  # at pi, 2 pi, .. m pi
        self.directions = [sign(centre - x) for _, x, centre in self.pieces]  # of motion in half-cycles 0..m-1

    def at(self, t):
        """X and V at time t >= 0."""
        if t >= self.rest_time:
            return self.rest, self.ar.number(0)
        start, x, centre = next(p for p in reversed(self.pieces) if p[0] <= t)
        return (centre + (x - centre) * self.ar.cos(t - start), -(x - centre) * self.ar.sin(t - start))


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


def at_least(t, limit):
    """t >= limit, where both may carry rounding."""
    return t >= limit * (1 - TOLERANCE)


def metrics(case, history, exact, exact_x, ar):
    """All metrics of the contract; None is an empty cell."""
    T, X, _, S = history
    x0 = abs(ar.number(case["x0"]))
    e, m, n = exact_x, exact.m, len(T) - 1
    duration = case["duration"]
    out = {}
    out["rms_error"] = ar.sqrt(sum((c - d) ** 2 for c, d in zip(X, e)) / (n + 1)) / x0
    out["max_error"] = max(abs(c - d) for c, d in zip(X, e)) / x0

    worst = None
    for k in range(1, m + 1):
        s = exact.directions[k - 1]  # the motion into peak k goes to the peak's side
        window = [c for t, c in zip(T, X) if at_least(t, (k - 0.5) * ar.pi) and at_least((k + 0.5) * ar.pi, t)]
        if not window:
            worst = None
            break
        error = abs(s * max(s * c for c in window) - exact.peaks[k - 1]) / x0
        worst = error if worst is None else max(worst, error)
    out["peak_error"] = worst

    rests = at_least(duration, m * ar.pi)
    out["rest_error"] = abs(X[n] - e[n]) / x0 if rests else None
    late = [c for t, c in zip(T, X) if at_least(t, (m + 1) * ar.pi)]
    out["residual_motion"] = (max(late) - min(late)) / 2 / x0 if late else None
    out["work_error"] = None
    if rests and m >= 1:
        out["work_error"] = friction_work(history) / ((x0 ** 2 - exact.rest ** 2) / 2) - 1
    cc, ee, ce = sum(c * c for c in X), sum(d * d for d in e), sum(c * d for c, d in zip(X, e))
    magnitude = ar.sqrt(cc / ee) - 1 if ee > 0 else None
    phase = ar.acos(max(-1, min(1, ce / ar.sqrt(cc * ee)))) / ar.pi if cc * ee > 0 else None
    out["sprague_geers_magnitude"], out["sprague_geers_phase"] = magnitude, phase
    out["sprague_geers_combined"] = (
        None if magnitude is None or phase is None else ar.sqrt(magnitude ** 2 + phase ** 2))
    return out


def friction_work(history):
    _, X, _, S = history
    return sum((S[i] + S[i + 1]) * (X[i + 1] - X[i]) / 2 for i in range(len(X) - 1))


def run(case, arithmetic, root=by_branches):
    """History (T, X, V, S), exact X and V, metrics."""
    history = solve(case, arithmetic, root)
    exact = Coulomb(case["x0"], arithmetic)
    pairs = [exact.at(t) for t in history[0]]
    ex, ev = [p[0] for p in pairs], [p[1] for p in pairs]
    return history, ex, ev, metrics(case, history, exact, ex, arithmetic)


def displacement(alpha, dT, x0=12.0, duration=8 * math.pi, slip="unloaded"):
    return {"law": "displacement-control", "alpha": alpha, "dT": dT, "duration": duration, "x0": x0,
            "initial_slip": slip}


def velocity(beta, dT, x0=12.0, duration=8 * math.pi):
    return {"law": "velocity-control", "beta": beta, "dT": dT, "duration": duration, "x0": x0}


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


def CASES():
    """The cases of tests/data/friction.json."""
    pi = math.pi
    d, v = displacement, velocity
    return [
        d(0.1, pi / 10), d(1.0, pi / 10), d(5.0, pi / 10),
        d(0.1, pi / 10, slip="pulled"), d(1.0, pi / 10, slip="pulled"), d(5.0, pi / 10, slip="sliding"),
        d(0.1, pi / 5), d(0.1, pi / 3), d(0.1, pi / 80),
        v(0.1, pi / 10), v(1.0, pi / 10), v(5.0, pi / 10), v(0.303, pi / 5), v(0.303, pi / 3),
        d(0.1, pi / 10, -12.0), d(0.1, pi / 10, -12.0, slip="sliding"), v(0.303, pi / 5, -12.0),
        d(0.5, pi / 20, 12.5, 12 * pi), v(0.1, pi / 20, 12.5, 12 * pi), v(0.001, 0.1, 12.5, 40.0),
        d(0.2, 0.25, 11.2, 30.0, "pulled"), v(0.05, 0.25, 11.2, 30.0), d(0.001, pi / 50, 11.2),
        d(0.3, 0.1, 0.5, 20.0), v(0.3, 0.1, 0.5, 20.0), d(2.0, 0.3, 0.5, 25.0, "sliding"), v(10.0, pi / 10, 0.5),
        d(0.1, 0.05, 1.0, 10.0), v(0.01, 0.2, 1.0, 3.0), d(0.01, pi / 10, 3.0, 4 * pi),
        v(0.2, pi / 10, 3.0, 4 * pi), d(1.0, 0.7, 3.0, 5.0, "pulled"),
        d(0.05, pi / 10, 100.0, 52 * pi), v(0.5, pi / 10, 100.0, 52 * pi), d(10.0, pi / 7, 100.0, 30.0),
        d(0.01, pi / 1000, 3.0, 3 * pi), v(0.001, pi / 1000, 3.0, 3 * pi), d(0.1, pi / 1000, 12.0, 8 * pi),
        d(0.1, 2.0, 12.0, 31.0), v(0.1, 2.0, 12.5, 31.0), v(10.0, 2.0, 12.0, 25.0), d(0.001, 1.0, 12.0, 17.0),
        d(1.0, 0.4, 12.0, 1.2), d(1.0, 5.0, 12.0, 5.0), v(1.0, 0.3, 11.2, 6 * pi), d(0.1, pi / 6, 12.0, 6 * pi),
    ]


def data(path):
    ar = Digits50()
    cases = []
    for case in CASES():
        (T, X, V, S), ex, ev, values = run(case, ar)
        n = len(T) - 1
        stride = max(1, -(-n // 30))
        picked = list(range(0, n, stride)) + [n]
        cases.append({
            "parameters": case, "steps": n,
            "metrics": {k: None if x is None else float(x) for k, x in values.items()},
            "history": [[i] + [float(q[i]) for q in (T, X, V, S, ex, ev)] for i in picked]})
    out = {"problem": "friction-oscillator", "history_columns": ["step", "T", "X", "V", "S", "X_exact", "V_exact"]}
    with open(path, "w", encoding="utf-8") as file:
        file.write(json.dumps(out)[:-1] + ', "cases": [\n')
        file.write(",\n".join(json.dumps(c) for c in cases) + "\n]}\n")


if __name__ == "__main__":
    verb = sys.argv[1] if len(sys.argv) > 1 else ""
    if verb == "confirm":
        confirm()
    elif verb == "agree":
        agree()
    elif verb == "data" and len(sys.argv) == 3:
        data(sys.argv[2])
    else:
        sys.exit(__doc__)
