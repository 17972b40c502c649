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
about the centre -S until the velocity is zero again. friction_checks.py compares it with
Runge-Kutta steps of the differential equation.

The programs that use this are friction_checks.py and friction_data.py.
"""

import math

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
    # A window that the run does not reach the end of may hold steps before the peak only.
    out["peak_error"] = worst if at_least(duration, (m + 0.5) * ar.pi) else None

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
