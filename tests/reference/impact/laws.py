"""Two rigid masses that collide with each law of impact, by Runge-Kutta steps; writes ../../data/laws.json.

m dv/dt = -F(delta, v), ddelta/dt = v, from delta = 0, v = v0, m = m1 m2/(m1 + m2). The forces are those of the papers:

    kelvin-voigt   max(0, k delta + c v), c = 2 xi sqrt(k m), xi = -ln e/sqrt(pi^2 + ln^2 e)         Anagnostopoulos 1988
    hertz          k delta^1.5                                                                     Goldsmith 1960
    hertz-damp     k delta^1.5 (1 + 3 (1 - e^2)/(4 v0) v)                                           Lankarani, Nikravesh 1990
    hunt-crossley  k delta^1.5 (1 + 3 (1 - e)/(2 v0) v)                                             Hunt, Crossley 1975
    ye             k delta^1.5 (1 + 8 (1 - e)/(5 e v0) v)                                           Ye, Li, Zhu 2009
    jankowski      k delta^1.5 + c v for v > 0, k delta^1.5 for v < 0; c = 2 xi sqrt(k sqrt(delta) m),
                   xi = (9 sqrt 5/2) (1 - e^2)/(e (e (9 pi - 16) + 16))                             Jankowski 2005, 2006

The approach ends where v = 0, the parting where the force is 0: for kelvin-voigt k delta + c v = 0, else delta = 0. No closed
form of a collision is used. The powers are not smooth at delta = 0; the steps are as short there as the tolerance asks.
`difference` is that between the tolerances 1e-13 and 1e-11, relative.

Run:  python3 laws.py     (needs numpy and scipy)
"""

import json
import math
import pathlib

from scipy.integrate import solve_ivp


def force(law, e, k, m, v0):
    if law == "kelvin-voigt":
        xi = -math.log(e) / math.hypot(math.pi, math.log(e))
        c = 2 * xi * math.sqrt(k * m)
        return lambda d, v: k * d + c * v
    if law == "jankowski":
        xi = 4.5 * math.sqrt(5) * (1 - e * e) / (e * (e * (9 * math.pi - 16) + 16))
        c = 2 * xi * math.sqrt(k * m)
        return lambda d, v: k * d**1.5 + (c * d**0.25 * v if v > 0 else 0.0)
    a = {
        "hertz": 0.0,
        "hertz-damp": 3 * (1 - e * e) / (4 * v0),
        "hunt-crossley": 3 * (1 - e) / (2 * v0),
        "ye": 8 * (1 - e) / (5 * e * v0),
    }[law]
    return lambda d, v: k * d**1.5 * (1 + a * v)


def until(rhs, start, event, far, tolerance):
    """The state where `event` falls through zero; its last number is the time."""
    event.terminal, event.direction = True, -1
    options = {"method": "DOP853", "rtol": tolerance, "atol": tolerance * 1e-3 * far, "first_step": 1e-9 * far}
    found = solve_ivp(rhs, (0.0, far), start, events=event, **options)
    assert found.t_events[0].size == 1, found.message
    return found.y_events[0][0]


def collide(law, e, k, m, v0, tolerance):
    f = force(law, e, k, m, v0)
    linear = law == "kelvin-voigt"
    far = 20 * (math.sqrt(m / k) if linear else (m * v0 * v0 / k) ** 0.4 / v0)

    def rhs(_, s):
        # Beyond the end of the parting, where the event is looked for.
        return [s[1], -f(max(s[0], 0.0), s[1]) / m, 1.0]

    top = until(rhs, [0.0, v0, 0.0], lambda _, s: s[1], far, tolerance)
    end = until(rhs, top, (lambda _, s: f(s[0], s[1])) if linear else (lambda _, s: s[0]), far, tolerance)
    return -end[1] / v0, end[2], top[0]


def main():
    rows = []
    for law in ("kelvin-voigt", "hertz", "hertz-damp", "hunt-crossley", "ye", "jankowski"):
        for e in (0.2, 0.35, 0.5, 0.65, 0.8, 0.95):
            for k, m, v0 in ((1.0, 1.0, 1.0), (300.0, 0.7, 2.5)):
                fine = collide(law, e, k, m, v0, 1e-13)
                coarse = collide(law, e, k, m, v0, 1e-11)
                difference = max(abs(a / b - 1) for a, b in zip(fine, coarse))
                rows.append({"law": law, "target": e, "k": k, "m": m, "v0": v0, "restitution": fine[0],
                             "duration": fine[1], "overlap": fine[2], "difference": difference})
                if k == 1.0:
                    print(law, e, *(f"{x:.12f}" for x in fine), f"{difference:.0e}")
    out = pathlib.Path(__file__).parents[2] / "data" / "laws.json"
    out.write_text("[\n" + ",\n".join(json.dumps(row) for row in rows) + "\n]\n")


if __name__ == "__main__":
    main()
