"""Writes ../data/records.json: the records of ../../records read by fixed columns, and their measures by closed forms.

Run:  python3 records.py      (needs numpy)

pgv and pgd are those of the acceleration as it is, straight between its points, from rest, in continuous time. sd are spectral
displacements with 5 % damping: the closed form of each step, and the extremes between the points by bisection. tm is the mean period
of Rathje et al. 1998, by the fast Fourier transform without padding, from 0.25 to 20 Hz.
"""

import json
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
RECORDS = HERE.parents[1] / "studies" / "records"
G = 9.80665
PERIODS = [0.2, 0.5, 1.0, 2.0, 3.0]


def cells(line, width):
    line = line.rstrip()
    return [line[i : i + width] for i in range(0, len(line), width)]


def smc(lines):
    whole = [int(cell) for line in lines[11:17] for cell in cells(line, 10)]
    numbers = [float(cell) for line in lines[17:27] for cell in cells(line, 15)]
    data = [line for line in lines[27:] if not line.startswith("|")]
    values = [float(cell) for line in data for cell in cells(line, 10)]
    assert len(values) == whole[16]
    return 1 / numbers[1], 0.01, np.array(values)


def v2a(lines):
    count = int(cells(lines[19], 8)[3])
    step = float(cells(lines[22], 8)[5])
    data = lines[26 : 26 + (count + 9) // 10]
    values = [float(cell) for line in data for cell in cells(line, 8)]
    assert len(values) == count
    return step, 0.001, np.array(values)


def roots_of_line(a, b):
    """Where the line from a at 0 to b at 1 is 0."""
    return [a / (a - b)] if a * b < 0 else []


def velocity_and_displacement(a, dt):
    """Largest |v| and |u| from rest, with the extremes between the points."""
    v = u = top_v = top_u = 0.0
    for a0, a1 in zip(a[:-1], a[1:]):
        rate = (a1 - a0) / dt

        def speed(t):
            return v + t * (a0 + t * rate / 2)

        def place(t):
            return u + t * (v + t * (a0 / 2 + t * rate / 6))

        for x in roots_of_line(a0, a1):
            top_v = max(top_v, abs(speed(x * dt)))
        turns = np.roots([rate / 2, a0, v]) if rate else np.array([])
        for t in turns[np.isreal(turns)].real:
            if 0 < t < dt:
                top_u = max(top_u, abs(place(t)))
        u, v = place(dt), speed(dt)
        top_v, top_u = max(top_v, abs(v)), max(top_u, abs(u))
    return top_v, top_u


def spectral_displacement(a, dt, period, ratio=0.05):
    w = 2 * np.pi / period
    wd = w * np.sqrt(1 - ratio**2)

    def motion(state, a0, a1, t):
        """u and v of u'' + 2 z w u' + w^2 u = -(a0 + s t): a line and a free vibration."""
        s = (a1 - a0) / dt
        rate = -s / w**2
        rest = -a0 / w**2 + 2 * ratio * s / w**3
        c = state[0] - rest
        d = (state[1] - rate + ratio * w * c) / wd
        e, co, si = np.exp(-ratio * w * t), np.cos(wd * t), np.sin(wd * t)
        u = rest + rate * t + e * (c * co + d * si)
        v = rate + e * ((d * wd - ratio * w * c) * co - (c * wd + ratio * w * d) * si)
        return u, v

    state, top = (0.0, 0.0), 0.0
    for a0, a1 in zip(a[:-1], a[1:]):
        after = motion(state, a0, a1, dt)
        if state[1] * after[1] < 0:
            low, high = 0.0, dt
            for _ in range(60):
                middle = (low + high) / 2
                if motion(state, a0, a1, middle)[1] * state[1] > 0:
                    low = middle
                else:
                    high = middle
            top = max(top, abs(motion(state, a0, a1, low)[0]))
        state, top = after, max(top, abs(after[0]))
    return top


def measures(a, dt):
    pgv, pgd = velocity_and_displacement(a, dt)
    energy = np.concatenate([[0], np.cumsum((a[1:] ** 2 + a[:-1] ** 2) / 2 * dt)])
    times = np.arange(len(a)) * dt
    d5, d95 = np.interp([0.05, 0.95], energy / energy[-1], times)
    amplitude = np.abs(np.fft.rfft(a)) ** 2
    f = np.fft.rfftfreq(len(a), dt)
    part = (f >= 0.25) & (f <= 20)
    return {
        "pga": float(np.abs(a).max()),
        "pgv": float(pgv),
        "pgd": float(pgd),
        "arias": float(np.pi / (2 * G) * energy[-1]),
        "d5_95": float(d95 - d5),
        "tm": float((amplitude[part] / f[part]).sum() / amplitude[part].sum()),
        "sd": [float(spectral_displacement(a, dt, period)) for period in PERIODS],
    }


def record(path):
    lines = path.read_text(encoding="latin1").splitlines()
    dt, unit, values = (smc if path.suffix == ".smc" else v2a)(lines)
    a = values * unit
    return {
        "file": path.name,
        "dt": dt,
        "unit": unit,
        "count": len(values),
        "ends": [float(values[0]), float(values[-1])],
        "sum_of_squares": float((values**2).sum()),
        "pgv_without_mean": float(velocity_and_displacement(a - a.mean(), dt)[0]),
        **measures(a, dt),
    }


if __name__ == "__main__":
    files = sorted(path for path in RECORDS.iterdir() if path.suffix in (".smc", ".v2a"))
    text = json.dumps({"periods": PERIODS, "records": [record(path) for path in files]}, indent=1)
    (HERE.parent / "data" / "records.json").write_text(text + "\n")
