"""The girders as a loop compiled by numba: L D L^T in the band, one solve and one box problem for each step."""

import time

import numba
import numpy as np

from girders import EVERY, GAP, LIMIT, STEP, STEPS, WIDTH, Girders, acceleration

IMPACTS, CONTACTS = 2, 5  # the first two contacts are gaps, the others bearings
LO, FREE, HI = -1, 0, 1


@numba.njit
def factor(diagonal, below):
    """L D L^T of a tridiagonal matrix, in place: D, and the entries of L below its diagonal."""
    for i in range(1, len(diagonal)):
        ratio = below[i - 1] / diagonal[i - 1]
        diagonal[i] -= ratio * below[i - 1]
        below[i - 1] = ratio


@numba.njit
def solve(D, low, x):
    for i in range(1, len(x)):
        x[i] -= low[i - 1] * x[i - 1]
    x[-1] /= D[-1]
    for i in range(len(x) - 2, -1, -1):
        x[i] = x[i] / D[i] - low[i] * x[i + 1]


@numba.njit
def box(A, d, lo, hi, pattern, size, S):
    """Forces that minimise S A S/2 - S d between their limits, by block principal pivoting; rounds."""
    m = len(d)
    wrong, kind = np.empty(m, np.int64), np.empty(m, np.int64)
    least, left, rounds = m + 1, 3, 0
    while True:
        rounds += 1
        free = 0
        for i in range(m):
            if pattern[i] == FREE:
                kind[free] = i
                free += 1
            else:
                S[i] = lo[i] if pattern[i] == LO else hi[i]
        if free > 0:
            F, b = np.empty((free, free)), np.empty(free)
            for p in range(free):
                b[p] = d[kind[p]]
                for j in range(m):
                    if pattern[j] != FREE:
                        b[p] -= A[kind[p], j] * S[j]
                for q in range(p + 1):
                    F[p, q] = A[kind[p], kind[q]]
            # Cholesky, forward and backward.
            for p in range(free):
                for q in range(p + 1):
                    total = F[p, q]
                    for k in range(q):
                        total -= F[p, k] * F[q, k]
                    F[p, q] = np.sqrt(total) if p == q else total / F[q, q]
            for p in range(free):
                for k in range(p):
                    b[p] -= F[p, k] * b[k]
                b[p] /= F[p, p]
            for p in range(free - 1, -1, -1):
                for k in range(p + 1, free):
                    b[p] -= F[k, p] * b[k]
                b[p] /= F[p, p]
                S[kind[p]] = b[p]
        count = 0
        for i in range(m):
            q, total = d[i], size[i]
            for j in range(m):
                q -= A[i, j] * S[j]
                total += abs(A[i, j] * S[j])
            t = 1e-13 * total
            s = t / A[i, i]
            if (pattern[i] == FREE and (S[i] < lo[i] - s or S[i] > hi[i] + s)) or (pattern[i] == LO and q > t) or (
                    pattern[i] == HI and q < -t):
                wrong[count] = i
                count += 1
        if count == 0:
            for i in range(m):
                S[i] = min(max(S[i], lo[i]), hi[i])
            return rounds
        first = 0
        if count < least:
            least, left = count, 3
        elif left > 0:
            left -= 1
        else:
            first = count - 1
        for k in range(first, count):
            i = wrong[k]
            pattern[i] = (LO if S[i] < lo[i] else HI) if pattern[i] == FREE else FREE


@numba.njit
def march(masses, k_diagonal, k_below, c_diagonal, c_below, ends, k_i, a_g, rows):
    """Fills `rows` with the displacements at every EVERY steps; rounds of the box problem."""
    n, m, dt = len(masses), len(ends), STEP
    D = 4 / dt**2 * masses + 2 / dt * c_diagonal + k_diagonal
    low = 2 / dt * c_below + k_below
    factor(D, low)
    W = np.zeros((m, n))  # K^-1 B, by columns
    for c in range(m):
        if ends[c, 0] >= 0:
            W[c, ends[c, 0]] = -1.0
        W[c, ends[c, 1]] = 1.0
        solve(D, low, W[c])
    A = np.empty((m, m))
    for c in range(m):
        for e in range(m):
            A[c, e] = W[e, ends[c, 1]] - (W[e, ends[c, 0]] if ends[c, 0] >= 0 else 0.0)
    k_c = LIMIT / WIDTH
    lo, hi = np.full(m, -LIMIT), np.full(m, LIMIT)
    for c in range(m):
        A[c, c] += 1 / k_i if c < IMPACTS else 1 / k_c
        if c < IMPACTS:
            lo[c], hi[c] = -np.inf, 0.0
    u, v, du = np.zeros(n), np.zeros(n), np.empty(n)
    a = -a_g[0] * np.ones(n)
    S, d, size = np.zeros(m), np.empty(m), np.empty(m)
    pattern = np.where(np.arange(m) < IMPACTS, HI, FREE)
    rows[0] = u
    total = 0
    for step in range(1, len(a_g)):
        # K^ du = p - K u + C v + M (4/dt v + a): increments keep the digits of u.
        for i in range(n):
            x = masses[i] * (4 / dt * v[i] + a[i] - a_g[step]) - k_diagonal[i] * u[i] + c_diagonal[i] * v[i]
            if i > 0:
                x += c_below[i - 1] * v[i - 1] - k_below[i - 1] * u[i - 1]
            if i < n - 1:
                x += c_below[i] * v[i + 1] - k_below[i] * u[i + 1]
            du[i] = x
        solve(D, low, du)
        for c in range(m):
            i, j = ends[c, 0], ends[c, 1]
            before = u[j] - (u[i] if i >= 0 else 0.0)
            moved = du[j] - (du[i] if i >= 0 else 0.0)
            if c < IMPACTS:
                d[c] = before + moved + GAP
                size[c] = abs(d[c])
            else:
                d[c] = moved + S[c] / k_c  # r* less r_i - S_i/k
                size[c] = abs(before + moved) + abs(before - S[c] / k_c)
        total += box(A, d, lo, hi, pattern, size, S)
        for c in range(m):
            if S[c] != 0.0:
                for i in range(n):
                    du[i] -= W[c, i] * S[c]
        for i in range(n):
            u[i] += du[i]
            rate = 2 / dt * du[i] - v[i]
            a[i] = 2 / dt * (rate - v[i]) - a[i]
            v[i] = rate
        if step % EVERY == 0:
            rows[step // EVERY] = u
    return total


def run(n):
    """Names, times, displacements, ns a step (the second run: the first one compiles), rounds a step."""
    g = Girders(n)
    size = len(g.names)
    k_diagonal, c_diagonal, k_below, c_below = np.zeros(size), np.zeros(size), np.zeros(size - 1), np.zeros(size - 1)
    for i, j, k, c in g.springs:
        k_diagonal[j] += k
        c_diagonal[j] += c
        if i is not None:
            assert j == i + 1
            k_diagonal[i] += k
            c_diagonal[i] += c
            k_below[i] -= k
            c_below[i] -= c
    ends = np.array([(-1 if i is None else i, j) for i, j in g.gaps + g.bearings])
    rows = np.zeros((STEPS // EVERY + 1, size))
    given = np.array(g.masses), k_diagonal, k_below, c_diagonal, c_below, ends, g.impact_stiffness, acceleration(), rows
    march(*given)
    start = time.perf_counter()
    rounds = march(*given)
    seconds = time.perf_counter() - start
    return g.names, np.arange(len(rows)) * EVERY * STEP, rows, seconds / STEPS * 1e9, rounds / STEPS
