"""Metrics of an impact from the formulas of the contract. How open points were read: README.md."""

from impact import Setup, dot, solve

TOLERANCE = 1e-12  # for times that mean a multiple of the step but carry rounding


# Metrics of contact, empty where there is none.
CONTACT = ("contact_duration", "contact_steps", "separations", "max_overlap", "rdot_oscillation", "peak_force",
           "impulse_error", "restitution")


def contact_duration(setup):
    """How long the exact contact lasts: at most the longer of the two times 2L/C."""
    left, right = setup.left, setup.right
    longest = setup.T if right is None else max(setup.T, 2 * right.L / right.C)
    touch = setup.exact(setup.gap / 2 + longest / setup.T + 1).phases()[0]
    return touch[0][1] - touch[0][0]


def restitution(setup, exact, end):
    """Relative velocity of the mass centres at `end` over c: means of the exact velocity along the bars, piece by piece
    between fronts. The impulse is not used."""
    means = []
    for name, bar in (("left", setup.left), ("right", setup.right)):
        if bar is None:
            means.append(exact.at(end)[1] * 0)  # a wall stays
            continue
        half = bar.L / bar.C / setup.T
        line = exact.left if name == "left" else exact.right
        edges = {half * 0, half}
        edges.update(at - end for at in [*line.times, *(at for at, _ in line.flying)] if 0 < at - end < half)
        edges.update(end - at for at in [*line.times, *exact.times] if 0 < end - at < half)
        edges = sorted(edges)
        means.append(sum(exact.inside(name, (p + q) / 2, end)[0] * (q - p) for p, q in zip(edges, edges[1:])) / half)
    return means[1] - means[0]


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
    out["contact_duration"] = out["contact_steps"] = None
    if inside and inside[-1] < n:
        zeros = [t[i] + (t[i + 1] - t[i]) * r[i] / (r[i] - r[i + 1]) for i in (inside[0] - 1, inside[-1])]
        out["contact_duration"] = zeros[1] - zeros[0]
        out["contact_steps"] = t[inside[-1] + 1] - t[inside[0] - 1]
    lasts = contact_duration(setup)
    early, limit = touch + setup.ar.number("0.3") * lasts, touch + setup.ar.number("0.9") * lasts
    opened, count = None, 0
    for i in range(1, n + 1):
        if r[i - 1] < 0 <= r[i] and later(limit, t[i]):
            opened = i
        if r[i - 1] >= 0 > r[i] and opened is not None and later(limit, t[i]):
            count += 1
            opened = None
    out["separations"] = count
    out["max_overlap"] = max(-x for x in r)
    window = [rdot[i] - exact.at(t[i], 1)[1] for i in range(n + 1) if later(t[i], early) and later(limit, t[i])]
    out["rdot_oscillation"] = setup.ar.sqrt(dot(window, window) / len(window)) if window else None
    out["peak_force"] = max(force)
    impulse = sum((force[i] + force[i + 1]) * dt / 2 for i in range(n))
    separation = exact.phases()[0]
    separation = separation[0][1] if separation else None
    out["impulse_error"] = None
    if separation is not None and not later(separation, setup.duration):
        out["impulse_error"] = impulse / exact.impulse(t[-1]) - 1
    out["restitution"] = solution["restitution"]
    reference = {"contact_duration_exact": lasts if later(t[-1], touch + lasts) else None,
                 "peak_force_exact": max(p[3] for p in exact.pieces if p[0] < t[-1]),
                 "restitution_exact": restitution(setup, exact, t[-1])}
    out.update(reference)
    if not inside or not touch < t[-1] * (1 - TOLERANCE):
        # No contact, or one at the last step that is round-off: nothing that is a property of a contact.
        out.update(dict.fromkeys(CONTACT + tuple(reference)))
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
