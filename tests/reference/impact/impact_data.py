"""Writes tests/data/impact.json: cases, metrics, thinned histories and profiles of impact.py, with 50 digits.

Run:  python3 impact_data.py ../../data/impact.json     (needs mpmath; about a minute)
"""

import json
import sys

from impact import Digits50, Setup, profile, solve
from impact_metrics import run


def CASES():
    """The cases of tests/data/impact.json.

    No gap is met exactly at a step: there round-off would decide the sign of r. k_I = 1e4 of Fig. 3 is left out: moving
    r(0) by 1e-13 moves its history by 2e-5 (its metrics all the same stand in `confirm`).
    """
    def case(n, dt, duration, **more):
        return {"n": n, "dt": dt, "duration": duration, **more}
    steel = {"E": 210.0, "A": 2.5, "rho": 0.0078, "L": 3.0, "V0": 0.02}
    return [
        *(case(10, 0.001, 1.5, k_I=k) for k in (10.0, 100.0, 1000.0)),
        *(case(n, 0.01, 1.5, k_I=100.0) for n in (2, 10, 40)),
        *(case(10, dt, 2.0, k_I=100.0) for dt in (0.5, 0.05, 0.01)),
        case(20, 0.001, 1.2, gamma=0.25), case(20, 0.001, 1.2, gamma=2.0), case(40, 0.002, 1.1, gamma=5.0),
        case(1, 0.02, 3.0, gamma=0.1), case(3, 0.013, 2.0, gamma=10.0), case(7, 0.1, 1.7, gamma=0.5),
        case(10, 0.003, 1.4, gamma=1.0, mass="consistent"), case(5, 0.05, 2.0, gamma=3.0, mass="consistent"),
        case(1, 0.01, 2.0, gamma=1.0, mass="consistent", gap=0.0537),
        case(10, 0.01, 1.8, gamma=1.0, gap=0.333), case(10, 0.5, 3.0, gamma=1.0, gap=0.7),
        case(12, 0.004, 1.6, gamma=1.5, gap=0.1234), case(10, 0.05, 0.3, gamma=1.0, gap=1.0),
        case(10, 0.05, 0.7, gamma=0.5), case(10, 0.2, 0.2, gamma=1.0),
        case(10, 0.005, 2.0, gamma=1.0, right={"A": 0.5, "V0": 0.0}),
        case(10, 0.005, 2.5, gamma=1.0, right={"L": 20.0, "n": 20}),
        case(10, 0.005, 2.5, gamma=2.0, gap=0.217, right={"L": 14.0, "A": 2.0, "n": 7, "V0": 0.03}),
        case(16, 0.01, 2.0, gamma=0.7, mass="consistent", right={"E": 400.0, "rho": 0.02, "L": 7.0, "n": 9}),
        case(6, 0.0125, 2.0, gamma=0.8, right={"n": 13}),
        case(9, 0.008, 1.9, k_I=300.0, right={"rho": 0.04, "L": 5.0}),
        case(10, 0.002, 1.5, gamma=1.0, right="wall"), case(10, 0.01, 1.6, gamma=0.5, gap=0.151, right="wall"),
        case(8, 0.02, 2.0, k_I=60.0, mass="consistent", right="wall", V0=3.0),
        case(10, 0.01, 1.5, gamma=1.0, V0=1.1, right={"V0": 0.9}),
        case(10, 0.01, 1.5, gamma=1.0, V0=-0.1, right={"V0": -0.3}),
        case(11, 0.007, 1.8, gamma=1.2, gap=0.0911, **steel),
        case(11, 0.007, 2.2, gamma=1.2, **steel, right={"E": 70.0, "rho": 0.0027, "n": 8}),
        # Mirrored pairs: the same motion in units of the other bar. A run that the exact contact outlasts.
        case(20, 0.0025, 1.25, gamma=1.0, L=20.0, right={"L": 10.0, "n": 10}),
        case(10, 0.005, 4.0, gamma=6.0, gap=0.137, right={"L": 30.0, "n": 30}),
        case(30, 0.005 / 3, 4.0 / 3, gamma=6.0, gap=0.137 / 3, L=30.0, right={"L": 10.0, "n": 10}),
        case(10, 0.02, 1.5, gamma=1.0, right={"L": 20.0, "n": 20}),
        case(10, 0.5, 2.0, gamma=1.0, gap=0.253),
        # A free flight, and one that ends at the touch itself.
        case(4, 0.1, 0.5, gamma=1.0, gap=7.3), case(4, 0.05, 0.3, gamma=1.0, gap=0.6),
    ]


def PROFILES():
    """Cases whose state at the end of the run is written to the data file, with the exact one."""
    def at(t, **more):
        return {"n": 10, "dt": 0.05, "duration": t, "gamma": 1.0, **more}
    return [
        at(0.25), at(0.5), at(0.75), at(1.2), at(0.6, dt=0.01, gap=0.217), at(0.4, dt=0.01, right="wall"),
        at(0.55, dt=0.01, right={"A": 0.5, "V0": 0.0}), at(1.3, dt=0.01, right={"A": 0.5, "V0": 0.0}),
        at(1.37, dt=0.01, right={"L": 20.0, "n": 20}), at(0.83, dt=0.01, right={"L": 14.0, "A": 2.0, "n": 7, "V0": 0.03}),
    ]


def exact_profile(setup, exact, t):
    """Velocity and stress of the exact solution at the element centres, left bar's free end first."""
    velocity, stress = [], []
    for name, bar in (("left", setup.left), ("right", setup.right)):
        if bar is None:
            continue
        places = [(j + setup.ar.number("0.5")) / bar.n * bar.L / bar.C / setup.T for j in range(bar.n)]
        for s in reversed(places) if name == "left" else places:
            v, force = exact.inside(name, s, t)
            velocity.append(2 * v - 1)
            stress.append(-force)
    return velocity, stress


def extremes(one, two):
    """Largest difference of r, rdot, force over all steps."""
    return max(abs(a - b) for p, q in zip(one["rows"], two["rows"]) for a, b in zip(p[1:], q[1:]))


def data(path):
    ar, cases, profiles = Digits50(), [], []
    for case in CASES():
        setup, solution, exact, values = run(case, ar)
        moved = Setup(case, ar)
        moved.gap += ar.number("1e-13")
        sensitivity = float(extremes(solution, solve(moved)) / ar.number("1e-13"))
        stride = max(1, -(-setup.steps // 24))
        rows = []
        for i in [*range(0, setup.steps, stride), setup.steps]:
            r, rdot, _ = exact.at(solution["rows"][i][0])
            rows.append([i] + [float(x) for x in (*solution["rows"][i], r, rdot)])
        touch, force = ([[None if x is None else float(x) for x in y] for y in part] for part in exact.phases())
        cases.append({"parameters": case, "steps": setup.steps, "sensitivity": float(f"{sensitivity:.3g}"),
                      "metrics": {k: None if x is None else x if k == "separations" else float(x)
                                  for k, x in values.items()},
                      "exact": {"touch": touch, "force": force}, "history": rows})
    for case in PROFILES():
        setup = Setup(case, ar)
        solution = solve(setup)
        state = (*profile(setup, solution), *exact_profile(setup, setup.exact(), solution["rows"][-1][0]))
        names = ("velocity", "stress", "velocity_exact", "stress_exact")
        profiles.append({"parameters": case, **{k: [float(x) for x in row] for k, row in zip(names, state)}})
    head = {"problem": "bar-impact",
            "history_columns": ["step", "t", "r", "rdot", "force", "r_exact", "rdot_exact"]}
    with open(path, "w", encoding="utf-8") as file:
        file.write(json.dumps(head)[:-1] + ', "cases": [\n')
        file.write(",\n".join(json.dumps(c) for c in cases) + '\n], "profiles": [\n')
        file.write(",\n".join(json.dumps(p) for p in profiles) + "\n]}\n")


if __name__ == "__main__":
    data(sys.argv[1]) if len(sys.argv) == 2 else sys.exit(__doc__)
