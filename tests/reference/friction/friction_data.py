"""Writes tests/data/friction.json: cases, metrics and thinned histories of friction.py, with 50 digits.

Run:  python3 friction_data.py ../../data/friction.json     (needs mpmath)
"""

import json
import math
import sys

from friction import Digits50, run


def displacement(alpha, dT, x0=12.0, duration=8 * math.pi, slip="unloaded"):
    return {"law": "displacement-control", "alpha": alpha, "dT": dT, "duration": duration, "x0": x0,
            "initial_slip": slip}


def velocity(beta, dT, x0=12.0, duration=8 * math.pi):
    return {"law": "velocity-control", "beta": beta, "dT": dT, "duration": duration, "x0": x0}


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
    data(sys.argv[1]) if len(sys.argv) == 2 else sys.exit(__doc__)
