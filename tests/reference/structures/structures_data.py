"""Writes tests/data/structures.json: structures as plain data, and their motion by structures.py.

Run:  python3 structures_data.py ../../data/structures.json     (needs numpy and scipy; some minutes)
"""

import json
import sys

import numpy as np

from structures import solve

SAMPLES = 20
QUANTITIES = ("u", "v", "r", "rdot", "S")


def sine(amplitude, omega, phase=0.0):
    return {"sine": {"amplitude": amplitude, "omega": omega, "phase": phase}}


def table(t, f):
    return {"table": {"t": t, "f": f}}


def limit(constant, factor=0.0, signal=None):
    return {"constant": constant, "factor": factor, "signal": signal}


def impact(i, j, gap, k):
    return {"law": "impact", "between": [i, j], "gap": gap, "k": k}


def displacement(i, j, k, most):
    return {"law": "displacement-control", "between": [i, j], "gap": 0.0, "k": k, "limit": most}


def velocity(i, j, c, most):
    return {"law": "velocity-control", "between": [i, j], "gap": 0.0, "c": c, "limit": most}


def load(signal, *pattern):
    return {"pattern": [list(x) for x in pattern], "signal": signal}


def structure(name, end, masses, springs, contacts, loads, u=None, v=None):
    zero = [0.0] * len(masses)
    return {"name": name, "end": end, "masses": masses, "springs": springs, "contacts": contacts, "loads": loads,
            "displacement": u or zero, "velocity": v or zero}


def rayleigh(masses, springs, alpha, beta):
    """Springs with dashpots of stiffness damping, and dashpots of mass damping to the ground."""
    return [[i, j, k, c + beta * k] for i, j, k, c in springs] + [[None, i, 0.0, alpha * m] for i, m in enumerate(masses)]


def ground(signal, masses):
    return load(signal, *((i, -m) for i, m in enumerate(masses)))


def bar():
    """A bar of nine elements on a pier's spring, under a ground acceleration of straight lines."""
    k, masses = 1.5e6 * 9 / 40, [500 / 18] + [500 / 9] * 8 + [500 / 18]
    springs = rayleigh(masses, [[i, i + 1, k, 0.0] for i in range(9)], 0.0, 1e-3) + [[None, 0, 24000.0, 380.0]]
    acceleration = table([0.0, 0.31, 0.55, 0.83, 1.3, 1.62, 1.97, 2.44, 2.71, 3.2, 3.6, 4.1],
                         [0.0, 1.9, -2.4, 2.8, -3.1, 2.2, -1.6, 3.3, -2.9, 1.4, -0.8, 0.0])
    contacts = [displacement(None, 9, 245 / 0.0051, limit(245.0)), impact(9, None, 0.0317, k)]
    return structure("bar with bearing and stop", 5.0, masses, springs, contacts, [ground(acceleration, masses)])


def STRUCTURES():
    one, force = [[None, 0, 1.0, 0.05]], load(sine(1.0, 0.8, 0.3), (0, 1.0))
    pair, row = [1.0, 0.6], [1.0, 0.7, 1.3]
    weight = 2.0 * 9.81
    shaken = limit(0.4 * weight, 0.4 * 2.0, sine(1.3 * 9.81, 9.0, 0.4))  # nu W (1 + a/g), below zero for a part of each cycle
    pressed = table([0.0, 2.2, 3.1, 4.7, 6.0, 8.3, 9.1, 11.7], [0.5, 2.0, -0.7, 1.5, 0.4, 0.4, -1.1, 1.8])
    jump = table([0.5, 2.0, 2.0, 4.5, 6.1, 6.1, 9.0], [0.0, 6.0, -5.0, 3.0, 7.0, -2.0, 0.0])
    return [
        structure("one mass, displacement-control", 40.0, [1.0], one, [displacement(None, 0, 3.0, limit(0.3))], [force]),
        structure("one mass, velocity-control", 40.0, [1.0], one, [velocity(None, 0, 6.0, limit(0.3))], [force]),
        structure("two masses, impact spring", 10.0, pair, [[None, 0, 40.0, 0.6], [0, None, 0.0, 0.1], [None, 1, 61.0, 0.4]],
                  [impact(0, 1, 0.05, 3000.0)], [ground(sine(2.5, 6.7, 0.2), pair)]),
        structure("three masses, two gaps, friction", 10.0, row,
                  rayleigh(row, [[None, 0, 90.0, 0.0], [None, 1, 130.0, 0.0], [None, 2, 60.0, 0.0], [0, 2, 11.0, 0.0]], 0.15, 0.004),
                  [impact(0, 1, 0.021, 2500.0), impact(1, 2, 0.034, 1900.0), displacement(None, 2, 700.0, limit(1.1))],
                  [ground(sine(3.1, 7.3, 0.5), row)], v=[0.3, 0.0, -0.2]),
        structure("block that lifts off, displacement-control", 6.0, [2.0], [], [displacement(None, 0, 4000.0, shaken)],
                  [load(sine(7.0, 5.0, 0.1), (0, 1.0))]),
        bar(),
        structure("two frictions at one mass", 30.0, [1.5], [[None, 0, 2.0, 0.04]],
                  [displacement(None, 0, 9.0, limit(0.25)), displacement(0, None, 3.5, limit(0.6))],
                  [load(sine(1.9, 1.1, -0.4), (0, 1.0))]),
        structure("two frictions in series", 15.0, [0.8, 2.0], [[None, 1, 5.0, 0.1]],
                  [displacement(None, 0, 60.0, limit(0.9)), velocity(0, 1, 8.0, limit(0.6))],
                  [load(sine(4.0, 2.3, 0.7), (1, 1.0)), load(sine(0.5, 3.1, 0.0), (0, 1.0), (1, -0.4))]),
        structure("velocity-control under a normal force of straight lines", 13.0, [1.0], [[None, 0, 3.0, 0.02]],
                  [velocity(None, 0, 9.0, limit(0.1, 0.5, pressed))], [load(sine(1.6, 1.4, 0.2), (0, 1.0))]),
        structure("displacement-control under a normal force that swings", 20.0, [1.0], [[None, 0, 3.0, 0.02]],
                  [displacement(None, 0, 40.0, limit(0.5, 0.3, sine(1.0, 2.9, 1.0)))], [load(sine(1.7, 1.4, 0.2), (0, 1.0))]),
        structure("friction and stops on both sides, load with jumps", 10.0, [1.0, 1.4], [[None, 0, 12.0, 0.1], [0, 1, 30.0, 0.2]],
                  [impact(None, 1, 0.17, 900.0), impact(1, None, 0.23, 1400.0), velocity(0, 1, 3.0, limit(0.8)),
                   displacement(None, 0, 150.0, limit(0.7, 0.2, pressed))],
                  [load(jump, (0, 0.5), (1, 1.0))]),
    ]


def amplitudes(motion):
    return {key: max((abs(x) for row in motion.rows for x in row[key]), default=0.0) for key in QUANTITIES}


def difference(one, two):
    """Largest difference of all quantities over their amplitudes, and of the events' times over the last time."""
    size = amplitudes(one)
    apart = [abs(a - b) / size[key] for p, q in zip(one.rows, two.rows) for key in QUANTITIES for a, b in zip(p[key], q[key])]
    if [e[1:] for e in one.events] != [e[1:] for e in two.events]:
        raise ArithmeticError("other events")
    return max(apart), max(abs(a[0] - b[0]) for a, b in zip(one.events, two.events)) / one.times[-1]


def record(data):
    times = [data["end"] * i / SAMPLES for i in range(SAMPLES + 1)]
    motion, coarse = solve(data, times), solve(data, times, 1e-12)
    apart, late = difference(motion, coarse)
    energy = motion.books()
    swing = max(abs(x) for row in motion.rows for x in row["work"])
    print(f"{data['name']:58} {len(motion.events):4} events, tolerances differ by {apart:.1e}, events by {late:.1e}, "
          f"energy {np.ptp(energy) / swing:.1e}", flush=True)
    rows = {"t": times, **{key: [row[key] for row in motion.rows] for key in QUANTITIES}}
    return {**data, "difference": float(f"{max(apart, late):.1e}"), "amplitude": amplitudes(motion), "events": motion.events, "rows": rows}


def data(path):
    with open(path, "w", encoding="utf-8") as file:
        file.write("[\n" + ",\n".join(json.dumps(record(x)) for x in STRUCTURES()) + "\n]\n")


if __name__ == "__main__":
    data(sys.argv[1]) if len(sys.argv) == 2 else sys.exit(__doc__)
