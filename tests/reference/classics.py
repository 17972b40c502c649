"""The classics of pounding and sliding, by small steps of Runge-Kutta: docs/benchmarks.md and studies/benchmarks/classics-*.json.

Run:  python3 classics.py free | hinge | towers | collision | sliding      (needs numpy, numba)

`free` prints the largest displacements of the frames of the hinge without contact, from the spectral displacements of
records.py; the study has them as free_2 and, for each motion, f1 to f4. `collision` prints the largest force of one collision
of two floors of the towers at 1 m/s. The others print the numbers that the checks of the studies have.
Steps are fixed and 50 to 200 times shorter than those of the studies; the ground's acceleration is straight between its points.
"""

import math
import sys

import numpy as np
from numba import njit

import records

G = 9.80665
MOTIONS = {
    "APEEL 043": "lomaprieta-1989-redwoodcity-apeel2-043.smc",
    "APEEL 133": "lomaprieta-1989-redwoodcity-apeel2-133.smc",
    "Shafter 360": "lomaprieta-1989-sanfrancisco-shafter-360.smc",
    "Shafter 270": "lomaprieta-1989-sanfrancisco-shafter-270.smc",
}
RATIOS = [0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]
LAWS = ["spring", "kelvin-voigt", "hertz", "hertz-damp", "hunt-crossley", "ye", "jankowski", "rigid"]


def motion(name):
    """Time step and accelerations with the largest one 1 g."""
    text = (records.RECORDS / MOTIONS[name]).read_text(encoding="latin-1")
    dt, _, a = records.smc(text.splitlines())
    return dt, a * (G / np.abs(a).max())


@njit
def at(a, dt, t):
    i = int(t / dt)
    if i + 1 >= len(a):
        return a[-1] if i + 1 == len(a) and t <= i * dt else 0.0
    x = t / dt - i
    return a[i] + x * (a[i + 1] - a[i])


@njit
def impact(law, d, v, v0, k, kh, e, m):
    """Force of an overlap d that grows with the velocity v and began with v0; never a pull."""
    if d <= 0 or law == 7:
        return 0.0
    if law == 0:
        return k * d
    if law == 1:
        xi = -math.log(e) / math.sqrt(math.pi**2 + math.log(e) ** 2)
        return max(0.0, k * d + 2 * xi * math.sqrt(k * m) * v)
    force = kh * d**1.5
    if law == 6:
        xi = 4.5 * math.sqrt(5) * (1 - e * e) / (e * (e * (9 * math.pi - 16) + 16))
        return force + (2 * xi * math.sqrt(kh * math.sqrt(d) * m) * v if v > 0 else 0.0)
    factor = 0.0
    if law == 3:
        factor = 3 * (1 - e * e) / 4
    elif law == 4:
        factor = 3 * (1 - e) / 2
    elif law == 5:
        factor = 8 * (1 - e) / (5 * e)
    return max(0.0, force * (1 + factor * v / v0)) if v0 > 0 else force


@njit
def pound(a, dt_a, end, h, masses, k, c, fy, floors, law, gap, ki, kh, e):
    """Two shear buildings of `floors` storeys each: largest |u| of every floor, largest force of every contact, last u."""
    n = 2 * floors
    u, v, f = np.zeros(n), np.zeros(n), np.zeros(n)
    v0 = np.zeros(floors)
    top, push = np.zeros(n), np.zeros(floors)
    m = masses[0] * masses[floors] / (masses[0] + masses[floors])
    du, dv, df = np.zeros((4, n)), np.zeros((4, n)), np.zeros((4, n))
    for step in range(int(round(end / h))):
        for floor in range(floors):
            if u[floors + floor] - u[floor] + gap >= 0:
                v0[floor] = v[floor] - v[floors + floor]
        for stage in range(4):
            part = 0.0 if stage == 0 else (1.0 if stage == 3 else 0.5)
            before = max(stage - 1, 0)
            us, vs, fs = u + part * h * du[before], v + part * h * dv[before], f + part * h * df[before]
            ground = at(a, dt_a, (step + part) * h)
            acc = np.full(n, -ground)
            for i in range(n):
                low = i % floors == 0
                rate = vs[i] - (0.0 if low else vs[i - 1])
                force = max(-fy[i], min(fy[i], fs[i]))
                df[stage, i] = k[i] * rate
                acc[i] -= (force + c[i] * rate) / masses[i]
                if not low:
                    acc[i - 1] += (force + c[i] * rate) / masses[i - 1]
            for floor in range(floors):
                i, j = floor, floors + floor
                p = impact(law, us[i] - us[j] - gap, vs[i] - vs[j], v0[floor], ki, kh, e, m)
                acc[i] -= p / masses[i]
                acc[j] += p / masses[j]
                push[floor] = max(push[floor], p)
            du[stage], dv[stage] = vs, acc
        u += h / 6 * (du[0] + 2 * du[1] + 2 * du[2] + du[3])
        v += h / 6 * (dv[0] + 2 * dv[1] + 2 * dv[2] + dv[3])
        f += h / 6 * (df[0] + 2 * df[1] + 2 * df[2] + df[3])
        for i in range(n):
            f[i] = max(-fy[i], min(fy[i], f[i]))
            top[i] = max(top[i], abs(u[i]))
        for floor in range(floors):
            i, j = floor, floors + floor
            if law == 7 and u[j] - u[i] + gap < 0 and v[j] < v[i]:
                p = (1 + e) * m * (v[i] - v[j])
                v[i] -= p / masses[i]
                v[j] += p / masses[j]
    return top, push, u


@njit
def slide(alpha, friction, omega, cycles, h):
    """A structure on a sliding foundation, Coulomb's law: largest deformation and slip from rest."""
    x = np.zeros(4)  # slip, its rate, deformation, its rate
    sign, top, slip, sticks = 0.0, 0.0, 0.0, True

    rates = np.zeros((4, 4))
    for step in range(int(round(2 * math.pi / omega * cycles / h))):
        t = step * h
        if sticks:
            # The base rests: (1 - alpha) (-a_g) + k w + c w' is what friction resists.
            need = -(1 - alpha) * math.sin(omega * t) + alpha * (x[2] + 0.1 * x[3])
            if abs(need) > friction:
                sticks, sign = False, 1.0 if need > 0 else -1.0
        for stage in range(4):
            part = 0.0 if stage == 0 else (1.0 if stage == 3 else 0.5)
            y = x + part * h * rates[max(stage - 1, 0)]
            ground = math.sin(omega * (t + part * h))
            spring = alpha * (y[2] + 0.1 * y[3])
            base = 0.0 if sticks else (spring - sign * friction) / (1 - alpha) - ground
            rates[stage, 0], rates[stage, 1] = y[1], base
            rates[stage, 2], rates[stage, 3] = y[3], -ground - base - spring / alpha
        x = x + h / 6 * (rates[0] + 2 * rates[1] + 2 * rates[2] + rates[3])
        if not sticks and x[1] * sign < 0:
            x[3] += x[1]  # the velocity of the top stays
            x[1], sticks = 0.0, True
        top, slip = max(top, abs(x[2])), max(slip, abs(x[0]))
    return top, slip


def frames(ratio):
    """Masses, stiffnesses and dashpots of both frames, t and kN/m; T_2 is 1 s."""
    m = np.full(2, 2268.0)
    w = 2 * math.pi / np.array([ratio, 1.0])
    return m, m * w * w, 0.1 * m * w


def free():
    for name in MOTIONS:
        dt, a = motion(name)
        tops = [records.spectral_displacement(a, dt, ratio) for ratio in RATIOS]
        print(name, [float(f"{top:.8g}") for top in tops])


def hinge():
    for name, ratio, level in [("APEEL 043", 0.3, 0.8), ("Shafter 270", 0.5, 0.8), ("APEEL 133", 0.7, 0.2)]:
        dt, a = motion(name)
        m, k, c = frames(ratio)
        alone = [records.spectral_displacement(a * level, dt, period) for period in [ratio, 1.0]]
        for law, label in enumerate(LAWS):
            for h in [4e-5, 2e-5]:
                top, push, _ = pound(a * level, dt, 25.0, h, m, k, c, np.full(2, 1e30), 1, law, 0.0127, 4.378e6, 2.747e7, 0.8)
                print(name, ratio, level, label, h, *[f"{x:.6g}" for x in [*(top / alone), push[0]]])


def towers():
    m = np.array([25e3] * 3 + [1e6] * 3)
    k = np.array([3.46e6] * 3 + [2.215e9] * 3)
    c = np.array([6.609e4] * 3 + [1.057e7] * 3)
    for name in MOTIONS:
        dt, a = motion(name)
        for storeys, fy in [("elastic", [1e30] * 6), ("yielding", [1.369e5] * 3 + [1.442e7] * 3)]:
            for gap in [0.02, 10.0]:
                for h in [4e-5, 2e-5]:
                    top, push, last = pound(a * 0.348, dt, 30.0, h, m, k, c, np.array(fy), 3, 6, gap, 0.0, 2.75e9, 0.65)
                    print(name, storeys, gap, h, *[f"{x:.6g}" for x in [top[2], top[5], last[2], push[2]]])


def collision():
    m = 25e3 * 1e6 / 1.025e6
    for e in [0.4, 0.55, 0.65, 0.75, 0.9]:
        d, v, h, top = 0.0, 1.0, 1e-6, 0.0
        while d >= 0:
            force = impact(6, max(d, 1e-15), v, 1.0, 0.0, 2.75e9, e, m)
            top = max(top, force)
            v -= h * force / m
            d += h * v
        print(e, f"{top:.4g} N, parts at {-v:.3f} m/s")


def sliding():
    for alpha in [0.25, 0.75]:
        for friction in [0.2, 0.4, 0.6, 0.8]:
            for omega in [0.5, 1.0, 2.0]:
                for h in [2e-4, 1e-4]:
                    top, slip = slide(alpha, friction, omega, math.ceil(max(24, 24 * omega)), h)
                    print(alpha, friction, omega, h, f"{top:.6g} {slip:.6g}")


if __name__ == "__main__":
    {"free": free, "hinge": hinge, "towers": towers, "collision": collision, "sliding": sliding}[sys.argv[1]]()
