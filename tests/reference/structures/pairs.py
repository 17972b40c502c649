"""Writes ../../data/pairs.json: strengths of pairs of records, factors to a target, and the factors of sets by the rules of codes.

Run:  python3 pairs.py      (needs numpy)

The response to each component is that of matrix exponentials for straight lines between the samples, at 16 times in each step; it is
turned by 0, 1, .., 179 degrees, and each peak is refined by a parabola with the velocity and the acceleration there. RotD50 is the median
over the angles, RotD100 the largest value (Boore 2010).
"""

import json
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from records import G, RECORDS, smc  # noqa: E402

PAIRS = {
    "redwood": [
        "lomaprieta-1989-redwoodcity-apeel2-043.smc",
        "lomaprieta-1989-redwoodcity-apeel2-133.smc",
    ],
    "shafter": [
        "lomaprieta-1989-sanfrancisco-shafter-360.smc",
        "lomaprieta-1989-sanfrancisco-shafter-270.smc",
    ],
}
RATIO = 0.05
PARTS = 16
COMPONENTS = ["geometric-mean", "srss", "rotd50", "rotd100"]
ANGLES = np.radians(np.arange(180))
TURN = np.array([np.cos(ANGLES), np.sin(ANGLES)])


def exponential(a):
    """By scaling and squaring of the series."""
    squarings = max(0, int(np.ceil(np.log2(np.abs(a).max() + 1e-300))) + 4)
    a = a / 2**squarings
    term = total = np.eye(len(a))
    for k in range(1, 20):
        term = term @ a / k
        total = total + term
    for _ in range(squarings):
        total = total @ total
    return total


def propagators(period, dt):
    """Rows of (u, v) at the parts of a step, of (u, v, a at the start, slope)."""
    w = 2 * np.pi / period
    system = np.array([[0, 1, 0, 0], [-w * w, -2 * RATIO * w, -1, 0], [0, 0, 0, 1], [0, 0, 0, 0.0]])
    return [exponential(system * dt * part / PARTS)[:2] for part in range(PARTS + 1)]


def response(a, dt, period):
    """u, v and the acceleration of the oscillator relative to the ground, at all parts of all steps and two periods after the end."""
    w = 2 * np.pi / period
    a = np.concatenate([a, np.zeros(int(np.ceil(2 * period / dt)) + 2)])
    # The motion ends with a jump to 0 at its last sample.
    ends = np.concatenate([a[1:], [0.0]])
    starts = a.copy()
    slopes = (ends - starts) / dt
    last = np.flatnonzero(a)[-1]
    slopes[last] = starts[last] = 0.0
    rows = propagators(period, dt)
    step = rows[-1]
    states = np.zeros((len(a), 2))
    state = np.zeros(2)
    for i in range(len(a)):
        states[i] = state
        state = step[:, :2] @ state + step[:, 2] * starts[i] + step[:, 3] * slopes[i]
    known = np.column_stack([states, starts, slopes])
    parts = np.stack([known @ rows[part].T for part in range(PARTS)], axis=1)
    ground = starts[:, None] + slopes[:, None] * (np.arange(PARTS) * dt / PARTS)[None, :]
    u, v = parts[:, :, 0].ravel(), parts[:, :, 1].ravel()
    return u, v, -ground.ravel() - 2 * RATIO * w * v - w * w * u


def refined(u, v, a, h):
    """Largest |u| with a parabola at each of the largest samples."""
    size = np.abs(u)
    near = size >= 0.995 * size.max()
    u, v, a = u[near], v[near], a[near]
    turn = np.divide(-v, a, out=np.full_like(v, np.inf), where=a != 0)
    inside = np.abs(turn) <= h
    return max(np.abs(u).max(), np.abs(u + 0.5 * v * turn)[inside].max(initial=0.0))


def turned(pair, dt, period):
    """Pseudo-acceleration for each angle."""
    if period == 0:
        return np.abs(np.column_stack(pair) @ TURN).max(axis=0)
    both = [response(a, dt, period) for a in pair]
    u, v, a = (np.column_stack([own[k] for own in both]) for k in range(3))
    coarse = np.abs(u[::PARTS] @ TURN).max(axis=0)
    rows = np.hypot(u[:, 0], u[:, 1]) >= 0.99 * coarse.min()
    u, v, a = u[rows] @ TURN, v[rows] @ TURN, a[rows] @ TURN
    w = 2 * np.pi / period
    return np.array([w * w * refined(u[:, k], v[:, k], a[:, k], dt / PARTS) for k in range(180)])


def strengths(pair, dt, period):
    all_angles = turned(pair, dt, period)
    x, y = all_angles[0], all_angles[90]
    values = [np.sqrt(x * y), np.hypot(x, y), np.median(all_angles), all_angles.max()]
    return dict(zip(COMPONENTS, map(float, values))) | {"x": float(x), "y": float(y)}


class Station:
    def __init__(self, files):
        read = [smc((RECORDS / file).read_text(encoding="latin1").splitlines()) for file in files]
        self.dt = read[0][0]
        count = max(len(own[2]) for own in read)
        self.pair = [np.pad(own[2] * own[1], (0, count - len(own[2]))) for own in read]
        self.known = {}

    def at(self, period):
        if period not in self.known:
            self.known[period] = strengths(self.pair, self.dt, period)
        return self.known[period]

    def spectrum(self, periods, component):
        return np.array([self.at(period)[component] for period in periods])


def target(period):
    """EN 1998-1, 5 %: a_g 0.3 g, S 1.2, T_B 0.15, T_C 0.5, T_D 2."""
    period = np.asarray(period, float)
    plateau = np.where(period < 0.15, 1 + period / 0.15 * 1.5, 2.5)
    return 0.3 * G * 1.2 * np.where(period <= 0.5, plateau, np.where(period <= 2, 1.25 / np.maximum(period, 1e-9), 0))


LINEAR = list(np.linspace(0.2, 2, 101))
LOGARITHMIC = list(np.geomspace(0.2, 2, 101))
ISOLATION = list(np.geomspace(0.2 * 0.8, 1.25 * 1.2, 101))
TO_1_5 = list(np.geomspace(0.2, 1.5, 101))


def factors(station):
    found = {}
    for component in COMPONENTS:
        own, wanted = station.spectrum(LINEAR, component), target(LINEAR)
        logs = np.log(target(LOGARITHMIC) / station.spectrum(LOGARITHMIC, component))
        found[component] = {
            "linear": float(own @ wanted / (own @ own)),
            "logarithmic": float(np.exp(logs.mean())),
        }
    return found


def factor_of_set(spectra, periods, least, statistic=np.mean):
    ratios = statistic(spectra, axis=0) / (least * target(periods))
    place = int(ratios.argmin())
    return {"factor": float(1 / ratios[place]), "period": float(periods[place])}


if __name__ == "__main__":
    stations = {name: Station(files) for name, files in PAIRS.items()}
    both = list(stations.values())
    own = [factors(station) for station in both]

    def spectra(periods, component, scales):
        all_spectra = [station.spectrum(periods, component) for station in both]
        return np.array([scale * own for scale, own in zip(scales, all_spectra)])

    by_rotd50 = [known["rotd50"]["logarithmic"] for known in own]
    by_mean = [known["geometric-mean"]["linear"] for known in own]
    peaks = np.mean([scale * station.at(0)["geometric-mean"] for scale, station in zip(by_mean, both)])
    of_1998_1 = factor_of_set(spectra(LOGARITHMIC, "geometric-mean", by_mean), LOGARITHMIC, 0.9)
    at_zero = float(target(0) / peaks)
    data = {
        "pairs": [
            {
                "files": PAIRS[name],
                "strengths": {str(period): station.at(period) for period in [0, 0.2, 0.5, 1, 2, 3]},
                "factors": known,
            }
            for (name, station), known in zip(stations.items(), own)
        ],
        "sets": {
            "EN 1998-1": {"factor": max(of_1998_1["factor"], at_zero), "spectrum": of_1998_1, "zero": at_zero},
            "EN 1998-2": factor_of_set(spectra(TO_1_5, "srss", by_rotd50), TO_1_5, 1.3),
            "ASCE 7-16": factor_of_set(spectra(LOGARITHMIC, "rotd100", by_rotd50), LOGARITHMIC, 0.9),
            "ASCE 7-16 isolation": factor_of_set(spectra(ISOLATION, "srss", by_rotd50), ISOLATION, 1),
            "envelope": factor_of_set(spectra(LOGARITHMIC, "rotd50", [1, 1]), LOGARITHMIC, 1, np.max),
            "alone": factor_of_set(
                np.array([station.spectrum(LOGARITHMIC, "x") for station in both]), LOGARITHMIC, 0.9
            ),
        },
    }
    path = HERE.parents[1] / "data" / "pairs.json"
    path.write_text(json.dumps(data, indent=1) + "\n")
    print(path)
