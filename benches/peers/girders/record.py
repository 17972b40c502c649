"""The ground acceleration of the girders: noise after Clough and Penzien under Jennings' envelope, from a seed."""

import math

import numpy as np

DT, LAST, PEAK, G = 0.01, 30.0, 0.3, 9.80665


def splitmix64(seed, count):
    """The first numbers of SplitMix64 in 0..1, from the upper 53 bits."""
    found, mask = [], 2**64 - 1
    for _ in range(count):
        seed = (seed + 0x9E3779B97F4A7C15) & mask
        z = seed
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9 & mask
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB & mask
        found.append(((z ^ (z >> 31)) >> 11) / 2**53)
    return found


def synthetic(seed):
    """a_g at 0, 0.01 .. 30 s in m/s2."""
    t = np.arange(round(LAST / DT) + 1) * DT
    dw = 2 * math.pi / LAST
    a = np.zeros(len(t))
    for k, u in enumerate(splitmix64(seed, round(2 * math.pi * 25 / dw)), 1):
        w = k * dw
        x, y = (w / 15.6) ** 2, (w / 1.56) ** 2
        density = (1 + 1.44 * x) / ((1 - x) ** 2 + 1.44 * x) * y**2 / ((1 - y) ** 2 + 1.44 * y)
        a += math.sqrt(density) * np.cos(w * t + 2 * math.pi * u)
    a *= np.where(t < 2, (t / 2) ** 2, np.where(t > 10, np.exp(-0.25 * (t - 10)), 1.0))
    return a * (PEAK * G / np.max(np.abs(a)))


def spectral_displacement(a, period, ratio=0.05):
    """Largest displacement of an oscillator, by constant average acceleration in steps of 0.005 s."""
    w, dt = 2 * math.pi / period, DT / 2
    u = v = most = 0.0
    acceleration = -a[0]
    for load in np.interp(np.arange(1, 2 * len(a) - 1) * dt, np.arange(len(a)) * DT, a):
        rate = v + dt / 2 * acceleration
        place = u + dt * v + dt**2 / 4 * acceleration
        acceleration = -(load + 2 * ratio * w * rate + w**2 * place) / (1 + ratio * w * dt + (w * dt) ** 2 / 4)
        u, v = place + dt**2 / 4 * acceleration, rate + dt / 2 * acceleration
        most = max(most, abs(u))
    return most


def check():
    """The numbers that are known of seed 1. The exact spectral displacements are 0.048385, 0.095284 and 0.227234 m."""
    assert splitmix64(1, 3) == [0.5665615751722809, 0.7457817572627011, 0.9710027535867962]
    a = synthetic(1)
    arias = math.pi / (2 * G) * float(np.trapezoid(a**2, dx=DT))
    assert abs(arias - 1.8006723669) < 1e-10, arias
    assert round(int(np.argmax(np.abs(a))) * DT, 2) == 6.52
    for period, most in ((0.5, 0.048366), (1.0, 0.095253), (2.0, 0.227229)):
        assert abs(spectral_displacement(a, period) - most) < 1e-6
