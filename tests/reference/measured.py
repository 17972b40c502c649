"""Tests made by computation; writes pounding.csv, bearing.csv and the folder sliding in ../../studies/calibrate/measured, and ../data/sliding.json.

Run:  python3 measured.py     (needs numpy and scipy)

`pounding`: two oscillators on a shaking table collide. The law is hertz-damp (Lankarani and Nikravesh 1990), F = k_h delta^1.5
(1 + 3 (1 - e^2)/(4 v0) ddelta/dt), v0 the closing speed at delta = 0. `bearing`: LuGre friction (Canudas de Wit et al. 1995) under a
displacement that goes from turn to turn as 3 s^2 - 2 s^3. Both are integrated by DOP853 with a tolerance of 1e-11, from event to event
and from point to point of the ground motion, which is straight between its points. Each channel has normal noise of 1 % of its rms.
Rounding is below a twentieth of the noise.
`sliding`: a block on a spring slides with Coulomb friction on a table that moves as a sine, whose amplitude, frequency and phase are drawn
anew for each test. Steps of 0.1 ms by Moreau: the friction is what stops the block, at most its limit. 20 tests are files, the peaks and
rms of 100 times 30 others are numbers. True numbers are the constants below; studies/calibrate/calibrate-*.json repeat them.
"""

import json
import math
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

import records

G = 9.80665
OUT = records.HERE.parents[1] / "studies" / "calibrate" / "measured"
OPTIONS = {"method": "DOP853", "rtol": 1e-11, "dense_output": True}

# Pounding: kg, N, m, s. `delay` is the time of the file at which the table starts.
RECORD, START, SCALE = "lomaprieta-1989-redwoodcity-apeel2-043.smc", 9.0, 0.7
MASSES, PERIODS, RATIO = (320.0, 540.0), (0.5, 0.85), 0.03
GAP, RESTITUTION, STIFFNESS, REFERENCE = 0.006, 0.6, 8e5, 0.005
DELAY = 0.1374

# Bearing: kN, m, s.
TURNS_T = [0, 1, 3, 5, 7, 9, 11, 12]
TURNS_U = [0, 0.01, -0.01, 0.02, -0.02, 0.04, -0.04, 0]
LIMIT, STATIC, STRIBECK, SIGMA0, SIGMA1, SIGMA2 = 8.0, 1.35, 0.006, 16000.0, 15.0, 12.0

# Sliding: kN over t, m, s; DT is the step, TIMES are those of the files.
SLIDING_OMEGA, SLIDING_LIMIT, SLIDING_DT, SLIDING_TIMES = 2 * math.pi, 1.5, 1e-4, np.arange(301) * 0.02
DATA = records.HERE.parents[0] / "data" / "sliding.json"


def ground():
    dt, unit, a = records.smc((records.RECORDS / RECORD).read_text(encoding="latin-1").splitlines())
    return dt, SCALE * unit * a[round(START / dt) :]


def pounding(times):
    """Displacements of both masses over the table, absolute acceleration of the light one and force of the contact at the rising `times`."""
    dt, a = ground()
    m1, m2 = MASSES
    w1, w2 = (2 * math.pi / period for period in PERIODS)
    k_h = STIFFNESS / math.sqrt(REFERENCE)
    damping = 3 * (1 - RESTITUTION**2) / 4
    state, v0, shut = np.zeros(4), 0.0, False

    def force(x):
        overlap = x[0] - x[1] - GAP
        if not shut or overlap <= 0:
            return 0.0
        return max(0.0, k_h * overlap**1.5 * (1 + damping * (x[2] - x[3]) / v0))

    rows, last, now, begins = [], times[-1], 0.0, []
    while now < last:
        i = int(now / dt + 1e-9)
        end = (i + 1) * dt

        def rates(t, x):
            table = a[i] + (t / dt - i) * (a[i + 1] - a[i])
            f = force(x)
            return [x[2], x[3], -table - w1 * (w1 * x[0] + 2 * RATIO * x[2]) - f / m1, -table - w2 * (w2 * x[1] + 2 * RATIO * x[3]) + f / m2]

        def event(_, x):
            return x[0] - x[1] - GAP

        event.terminal, event.direction = True, -1 if shut else 1
        found = solve_ivp(rates, (now, end), state, events=event, atol=1e-14, max_step=dt / 4, **OPTIONS)
        reached = found.t[-1]
        for t in times[(times >= now) & (times < reached)]:
            x = found.sol(t)
            rows.append([x[0], x[1], -w1 * (w1 * x[0] + 2 * RATIO * x[2]) - force(x) / m1, -force(x)])
        now, state = reached, found.y[:, -1]
        if found.t_events[0].size:
            shut = not shut
            if shut:
                v0 = state[2] - state[3]
                begins.append((now, v0))
    return np.array(rows), begins


def imposed(t):
    i = min(np.searchsorted(TURNS_T, t, side="right"), len(TURNS_T) - 1) - 1
    length, change = TURNS_T[i + 1] - TURNS_T[i], TURNS_U[i + 1] - TURNS_U[i]
    s = (t - TURNS_T[i]) / length
    return TURNS_U[i] + change * s * s * (3 - 2 * s), change / length * 6 * s * (1 - s)


def bearing(times):
    """Displacement and force at the rising `times`."""

    def bend(t, z):
        v = imposed(t)[1]
        return v - SIGMA0 * abs(v) * z / (LIMIT * (1 + (STATIC - 1) * math.exp(-((v / STRIBECK) ** 2))))

    rows, z = [], np.zeros(1)
    for begin, end in zip(TURNS_T[:-1], TURNS_T[1:]):
        found = solve_ivp(bend, (begin, end), z, atol=1e-17, max_step=1e-3, **OPTIONS)
        inside = (times >= begin) & ((times < end) | (end == TURNS_T[-1]))
        for t in times[inside]:
            u, v = imposed(t)
            x = found.sol(t)
            rows.append([u, SIGMA0 * x[0] + SIGMA1 * bend(t, x)[0] + SIGMA2 * v])
        z = found.y[:, -1]
    return np.array(rows)


def sliding(count, seed):
    """Displacements (m) of the block at SLIDING_TIMES in `count` tests, with the peak and the rms over all steps."""
    random = np.random.default_rng(seed)
    amplitude, omega, phase = (random.uniform(*ends, count) for ends in (np.log((3.0, 4.0)), (5.0, 5.5), (0.0, 2 * math.pi)))
    amplitude = np.exp(amplitude)
    u, v = np.zeros(count), np.zeros(count)
    rows, peak, squares, steps = [u], np.zeros(count), np.zeros(count), round(SLIDING_TIMES[-1] / SLIDING_DT)
    every = round(SLIDING_TIMES[1] / SLIDING_DT)
    for i in range(1, steps + 1):
        table = amplitude * np.sin(omega * (i - 0.5) * SLIDING_DT + phase)
        free = v - SLIDING_DT * (table + SLIDING_OMEGA**2 * (u + 0.5 * SLIDING_DT * v))
        v = free - np.clip(free, -SLIDING_DT * SLIDING_LIMIT, SLIDING_DT * SLIDING_LIMIT)
        u = u + SLIDING_DT * v
        peak, squares = np.maximum(peak, np.abs(u)), squares + u * u
        if i % every == 0:
            rows.append(u)
    return np.array(rows), peak, np.sqrt(squares / (steps + 1))


def write_sliding():
    rows, _, _ = sliding(20, 3)
    for i, u in enumerate(rows.T, 1):
        write(f"sliding/{i:02}.csv", "t_s,u_mm", ["%.2f", "%.3f"], np.column_stack([SLIDING_TIMES, 1e3 * u]), "no measurement")
    _, peak, rms = sliding(3000, 4)
    text = {name: [[float(f"{x:.6g}") for x in own] for own in all.reshape(100, 30)] for name, all in (("peak", peak), ("rms", rms))}
    DATA.write_text(json.dumps(text, separators=(",", ":")) + "\n")


def noisy(values, seed):
    noise = np.random.default_rng(seed).standard_normal(values.shape)
    return values + 0.01 * np.sqrt(np.mean(values**2, axis=0)) * noise


def write(name, header, formats, table, what="with noise of 1 % of the rms of each channel: no measurement"):
    lines = [f"# Made by tests/reference/measured.py, {what}.", header]
    lines += [",".join(form % value for form, value in zip(formats, row)) for row in table]
    (OUT / name).parent.mkdir(parents=True, exist_ok=True)
    (OUT / name).write_text("\n".join(lines) + "\n")
    print(name, len(table), "points")


def main():
    times = np.arange(1000) * 0.0052
    table = times[times >= DELAY] - DELAY
    rows, begins = pounding(table)
    rows = np.vstack([np.zeros((len(times) - len(rows), 4)), rows])
    print("impacts at", *(f"{t:.4f} s with {v:.3f} m/s" for t, v in begins), sep="\n  ")
    print("largest", np.abs(rows).max(axis=0), "rms", np.sqrt(np.mean(rows**2, axis=0)))
    write("pounding.csv", "t_s,light_mm,heavy_mm,light_g,force_kN", ["%.4f", "%.3f", "%.3f", "%.5f", "%.4f"], np.column_stack([times, noisy(rows, 1) * [1e3, 1e3, 1 / G, 1e-3]]))
    times = np.arange(1000) * 0.012
    rows = bearing(times)
    print("largest", np.abs(rows).max(axis=0), "rms", np.sqrt(np.mean(rows**2, axis=0)))
    write("bearing.csv", "t_s,u_mm,force_kN", ["%.3f", "%.3f", "%.4f"], np.column_stack([times, noisy(rows, 2) * [1e3, 1]]))
    write_sliding()


if __name__ == "__main__":
    main()
