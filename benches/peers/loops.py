"""The sweeps as a researcher writes them: a numpy loop, and the same loops compiled by numba."""

import math

import numba
import numpy as np

from cases import BAR_DT, BAR_STEPS, DT, N, STEPS, X0, exact_oscillator


def oscillator(alpha, exact):
    """rms_error of one case: constant average acceleration, the law's root by return mapping."""
    a0, a2 = 4 / DT**2, 4 / DT
    x, v, slip, s = X0, 0.0, X0, 0.0
    a = -x - s
    total = 0.0
    for i in range(1, STEPS + 1):
        inertia = a0 * x + a2 * v + a
        h = 1 / (a0 + 1)
        free = inertia * h
        s = (free - slip) / (alpha + h)
        if s > 1:
            s = 1.0
        elif s < -1:
            s = -1.0
        new = free - h * s
        v = 2 / DT * (new - x) - v
        x = new
        a = -x - s
        if abs(s) == 1.0:
            slip = x - alpha * s
        total += (x - exact[i]) ** 2
    return math.sqrt(total / (STEPS + 1)) / X0


def chain():
    """Mass and stiffness of both bars in T_I, c T_I/2 and F0: lumped, 2 (n + 1) nodes; and b."""
    size = 2 * (N + 1)
    mass, stiffness = np.zeros(size), np.zeros((size, size))
    element, spring = 0.5 / N, 2.0 * N
    for first in (0, N + 1):
        for i in range(first, first + N):
            mass[i] += element / 2
            mass[i + 1] += element / 2
            stiffness[i, i] += spring
            stiffness[i + 1, i + 1] += spring
            stiffness[i, i + 1] -= spring
            stiffness[i + 1, i] -= spring
    b = np.zeros(size)
    b[N], b[N + 1] = -1.0, 1.0
    v = np.where(np.arange(size) <= N, 1.0, -1.0)
    return mass, stiffness, b, v


def bars_numpy(gamma):
    """peak_force of one case by matrices."""
    mass, stiffness, b, v = chain()
    k_i = 2 * gamma * N
    a0, a2 = 4 / BAR_DT**2, 4 / BAR_DT
    inverse = np.linalg.inv(np.diag(a0 * mass) + stiffness)
    compliance = inverse @ b
    h = b @ compliance
    u, s, peak = np.zeros(len(b)), 0.0, 0.0
    a = -(stiffness @ u + b * s) / mass
    for _ in range(BAR_STEPS):
        free = inverse @ (mass * (a0 * u + a2 * v + a))
        s = min((b @ free) / (1 / k_i + h), 0.0)
        new = free - compliance * s
        v = 2 / BAR_DT * (new - u) - v
        u = new
        a = -(stiffness @ u + b * s) / mass
        peak = max(peak, -s)
    return peak


def bars_modal(gamma, omega2, phi2, w, x, v):
    """The same in modes, n + 1 for each bar, closed-form root."""
    modes = len(omega2)
    k_i = 2 * gamma * (modes // 2 - 1)
    h = 0.0
    for k in range(modes):
        d = 1 + omega2[k] * BAR_DT**2 / 4
        h += phi2[k] * BAR_DT**2 / (4 * d)
        x[k] = 0.0
        v[k] = w[k]
    s, peak = 0.0, 0.0
    for _ in range(BAR_STEPS):
        free = 0.0
        for k in range(modes):
            d = 1 + omega2[k] * BAR_DT**2 / 4
            inertia = x[k] + BAR_DT * v[k] - BAR_DT**2 / 4 * (omega2[k] * x[k] + phi2[k] * s)
            free += inertia / d
        new = min(free / (1 / k_i + h), 0.0)
        for k in range(modes):
            d = 1 + omega2[k] * BAR_DT**2 / 4
            inertia = x[k] + BAR_DT * v[k] - BAR_DT**2 / 4 * (omega2[k] * x[k] + phi2[k] * s)
            moved = (inertia - BAR_DT**2 / 4 * phi2[k] * new) / d
            v[k] = 2 / BAR_DT * (moved - x[k]) - v[k]
            x[k] = moved
        s = new
        peak = max(peak, -s)
    return peak


def modes(n=N):
    """omega^2, phi^2 and start velocities of both bars' modes, with n elements each."""
    j = np.arange(n + 1)
    omega2 = 4 * np.sin(j * math.pi / (2 * n)) ** 2 * (2 * n) ** 2
    mass = np.where((j == 0) | (j == n), 0.5, 0.25)
    start = np.where(j == 0, -1.0, 0.0)
    return np.tile(omega2, 2), np.tile(1 / mass, 2), np.tile(start, 2)


fast_oscillator = numba.njit(oscillator)
fast_bars = numba.njit(bars_modal)


@numba.njit
def sweep_oscillator(alphas, exact):
    found = np.empty(len(alphas))
    for i in range(len(alphas)):
        found[i] = fast_oscillator(alphas[i], exact)
    return found


@numba.njit
def sweep_bars(gammas, omega2, phi2, start):
    found = np.empty(len(gammas))
    x, v = np.empty(len(omega2)), np.empty(len(omega2))
    for i in range(len(gammas)):
        found[i] = fast_bars(gammas[i], omega2, phi2, start, x, v)
    return found


def numpy_oscillator(alphas):
    exact = exact_oscillator()
    return np.array([oscillator(alpha, exact) for alpha in alphas])


def numpy_bars(gammas):
    return np.array([bars_numpy(gamma) for gamma in gammas])


def numba_oscillator(alphas):
    return sweep_oscillator(alphas, exact_oscillator())


def numba_bars(gammas, n=N):
    return sweep_bars(gammas, *modes(n))
