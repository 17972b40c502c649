"""Two rigid masses that collide with laws that yield, by Runge-Kutta steps; writes ../../data/parts.json.

m dv/dt = -F, ddelta/dt = v, from delta = 0, v = v0, m = m1 m2/(m1 + m2). While the masses approach, F is that of the first loading; from
the largest overlap d_m on, where F is F_m, it is that of unloading:

    gap-yield       k delta up to Fy, then Fy + eta (k delta - Fy);   F_m - k (d_m - delta)
    hyperbolic-gap  delta/(1/k + Rf delta/Fult);                      F_m - ku (d_m - delta)
    impact-yield    k1 delta up to dy, then k1 dy + k2 (delta - dy);  the larger of F_m - k1 (d_m - delta) and k2 delta

The parting ends where the force is 0. No closed form of a collision is used. Each corner of a force ends a run of the integrator.
`difference` is that between the tolerances 1e-13 and 1e-11, relative.

Run:  python3 parts.py     (needs numpy and scipy)
"""

import json
import pathlib

from scipy.integrate import solve_ivp


def until(force, m, start, event, far, tolerance):
    """The state [delta, v, t] where `event` passes through zero, or None if it does not."""
    event.terminal = True
    rhs = lambda _, s: [s[1], -force(s[0]) / m, 1.0]
    found = solve_ivp(rhs, (0.0, far), start, events=[event], method="DOP853", rtol=tolerance, atol=tolerance * 1e-3 * far)
    return found.y_events[0][0] if found.t_events[0].size else None


def branches(law, n):
    """The force of loading up to the corner, the corner, the force beyond it; and the forces of unloading from (d_m, F_m)."""
    if law == "hyperbolic-gap":
        curve = lambda d: d / (1 / n["k"] + n["Rf"] * d / n["Fult"])
        return curve, None, curve, lambda dm, fm: [lambda d: fm - n["k_unloading"] * (dm - d)]
    if law == "gap-yield":
        k, soft = n["k"], n["hardening"] * n["k"]
        corner = n["Fy"] / k
        back = lambda dm, fm: [lambda d: fm - k * (dm - d)]
    else:
        k, soft = n["k1"], n["k2"]
        corner = n["delta_y"]
        back = lambda dm, fm: [lambda d: fm - k * (dm - d), lambda d: soft * d]
    return lambda d: k * d, corner, lambda d: k * corner + soft * (d - corner), back


def collide(law, n, m, v0, tolerance):
    first, corner, second, back = branches(law, n)
    far = 60 * v0
    turn = lambda _, s: s[1]
    top, load = None, second
    if corner is None:
        top = until(second, m, [0.0, v0, 0.0], turn, far, tolerance)
    else:
        # The turn without yielding, if the corner is beyond it.
        top, load = until(first, m, [0.0, v0, 0.0], turn, far, tolerance), first
        if top is None or top[0] > corner:
            at = until(first, m, [0.0, v0, 0.0], lambda _, s: s[0] - corner, far, tolerance)
            top, load = until(second, m, at, turn, far, tolerance), second
    state, force = [top[0], 0.0, top[2]], load(top[0])
    lines = back(top[0], force)
    if corner is not None and load is first:
        lines = [first]
    for i, line in enumerate(lines):
        below = lines[i + 1] if i + 1 < len(lines) else lambda d: 0.0
        state = until(line, m, state, lambda _, s: line(s[0]) - below(s[0]), far, tolerance)
    return -state[1] / v0, state[2], top[0]


def main():
    laws = [
        ("gap-yield", {"k": 1.5, "Fy": 1.0, "hardening": 0.0, "damage": 1}),
        ("gap-yield", {"k": 1.5, "Fy": 1.0, "hardening": 0.3, "damage": 0}),
        ("gap-yield", {"k": 1.5, "Fy": 9.0, "hardening": 0.3, "damage": 1}),
        ("hyperbolic-gap", {"k": 1.5, "Fult": 1.2, "Rf": 0.7, "k_unloading": 1.5}),
        ("hyperbolic-gap", {"k": 1.5, "Fult": 1.2, "Rf": 1.0, "k_unloading": 4.0}),
        ("impact-yield", {"k1": 1.5, "k2": 0.6, "delta_y": 0.3}),
        ("impact-yield", {"k1": 1.5, "k2": 1.4, "delta_y": 0.1}),
    ]
    rows = []
    for law, numbers in laws:
        for m, v0 in ((1.0, 1.0), (0.7, 2.5)):
            fine = collide(law, numbers, m, v0, 1e-13)
            coarse = collide(law, numbers, m, v0, 1e-11)
            difference = max(abs(a / b - 1) for a, b in zip(fine, coarse))
            rows.append({"law": law, "numbers": numbers, "m": m, "v0": v0, "restitution": fine[0], "duration": fine[1],
                         "overlap": fine[2], "difference": difference})
            print(law, *(f"{x:.12f}" for x in fine), f"{difference:.0e}")
    out = pathlib.Path(__file__).parents[2] / "data" / "parts.json"
    out.write_text("[\n" + ",\n".join(json.dumps(row) for row in rows) + "\n]\n")


if __name__ == "__main__":
    main()
