"""Metrics of an impact from the formulas of the contract. How open points were read: README.md."""

from impact import Setup, dot, solve

TOLERANCE = 1e-12  # for times that mean a multiple of the step but carry rounding


def later(t, limit):
    """t >= limit, where both may carry rounding."""
    return t >= limit - TOLERANCE * max(1, abs(limit))


def metrics(setup, solution, exact):
    """All metrics of the contract; None is an empty cell."""
    rows, dt, n = solution["rows"], setup.ar.number(setup.dt), setup.steps
    t = [row[0] for row in rows]
    r, rdot, force = ([row[j] for row in rows] for j in (1, 2, 3))
    touch = setup.gap / 2
    out = {}
    inside = [i for i in range(n + 1) if r[i] < 0]
    out["contact_duration"] = None
    if inside and inside[-1] < n:
        out["contact_duration"] = t[inside[-1] + 1] - t[inside[0] - 1]
    limit, opened, count = touch + setup.ar.number("0.9" if not isinstance(touch, float) else 0.9), None, 0
    for i in range(1, n + 1):
        if r[i - 1] < 0 <= r[i] and later(limit, t[i]):
            opened = i
        if r[i - 1] >= 0 > r[i] and opened is not None and later(limit, t[i]):
            count += 1
            opened = None
    out["separations"] = count
    out["max_overlap"] = max(-x for x in r)
    window = [rdot[i] for i in range(n + 1) if later(t[i], touch + 0.3) and later(touch + 0.9, t[i])]
    out["rdot_oscillation"] = setup.ar.sqrt(dot(window, window) / len(window)) if window else None
    out["peak_force"] = max(force)
    impulse = sum((force[i] + force[i + 1]) * dt / 2 for i in range(n))
    separation = exact.phases()[0]
    separation = separation[0][1] if separation else None
    out["impulse_error"] = None
    if separation is not None and not later(separation, setup.duration):
        out["impulse_error"] = impulse / exact.impulse(t[-1]) - 1
    out["restitution"] = solution["restitution"]
    drift = [e / solution["energy"][0] - 1 for e in solution["energy"]]
    out["energy_drift_max"] = max(drift, key=abs)
    out["energy_drift_final"] = drift[-1]
    out["rms_error_r"] = norm(setup, t, r, exact, 0)
    out["rms_error_rdot"] = norm(setup, t, rdot, exact, 1)
    return out


def norm(setup, t, c, exact, which):
    """sqrt(1/duration times the integral of (c - e)^2): a trapezoid for each step, at its left end the exact limit from
    the right, at its right end that from the left. A jump inside a step is not looked for."""
    total = 0
    for i in range(len(t) - 1):
        a = c[i] - exact.at(t[i], 1)[which]
        b = c[i + 1] - exact.at(t[i + 1], -1)[which]
        total += (a * a + b * b) / 2 * (t[i + 1] - t[i])
    return setup.ar.sqrt(total / setup.duration)


def norm_right_hand(setup, t, c, exact, which):
    """The other reading: the history's own right-hand values at both ends of every step."""
    d = [x - exact.at(s, 1)[which] for s, x in zip(t, c)]
    total = sum((d[i] ** 2 + d[i + 1] ** 2) / 2 * (t[i + 1] - t[i]) for i in range(len(t) - 1))
    return setup.ar.sqrt(total / setup.duration)


def norm_split(setup, t, c, exact, which):
    """A third reading: steps split at the jumps inside them, c linear between steps, trapezoids on the parts."""
    total = 0
    for i in range(len(t) - 1):
        cuts = [t[i]] + [s for s in exact.times if t[i] + TOLERANCE < s < t[i + 1] - TOLERANCE] + [t[i + 1]]
        for p, q in zip(cuts, cuts[1:]):
            cp, cq = (c[i] + (c[i + 1] - c[i]) * (s - t[i]) / (t[i + 1] - t[i]) for s in (p, q))
            total += ((cp - exact.at(p, 1)[which]) ** 2 + (cq - exact.at(q, -1)[which]) ** 2) / 2 * (q - p)
    return setup.ar.sqrt(total / setup.duration)


def run(case, ar):
    setup = Setup(case, ar)
    solution, exact = solve(setup), setup.exact()
    return setup, solution, exact, metrics(setup, solution, exact)
