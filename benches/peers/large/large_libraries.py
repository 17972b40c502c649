"""Solutions with the factor of M + dt^2/4 K by other libraries, and Newmark's steps with them in numpy, without contacts."""

import time

import numpy as np
from cvxopt import cholmod, matrix, spmatrix
from scipy.sparse import diags_array
from scipy.sparse.linalg import splu


def median_ms(call, count):
    times = []
    for _ in range(count):
        start = time.process_time()
        call()
        times.append(time.process_time() - start)
    return 1e3 * float(np.median(times))


def superlu(of, count):
    """Seconds of the factor, ms of a solution and of a step, and u after the steps."""
    khat = (diags_array(of.mass * 4 / of.dt**2) + of.K).tocsc()
    start = time.process_time()
    factor = splu(khat, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    seconds = time.process_time() - start
    b = np.arange(len(of)) % 7 + 1.0
    solution = median_ms(lambda: factor.solve(b), count)
    dt, mass = of.dt, of.mass
    u, v = of.start()
    a = -(of.K @ u) / mass

    def step():
        nonlocal u, v, a
        new = factor.solve(mass * (u * (4 / dt**2) + v * (4 / dt) + a))
        da = (new - u) * (4 / dt**2) - v * (4 / dt) - a
        u, v, a = new, v + (a + da) * (dt / 2), da

    return seconds, solution, median_ms(step, count), u


def cholesky(of, count):
    """Seconds of the factor and ms of a solution by the faster of both forms of CHOLMOD."""
    khat = (diags_array(of.mass * 4 / of.dt**2) + of.K).tocoo()
    lower = khat.row >= khat.col
    rows, columns = (a[lower].tolist() for a in (khat.row, khat.col))
    khat = spmatrix(khat.data[lower].tolist(), rows, columns, khat.shape)
    best = None
    for supernodal in (0, 2):
        cholmod.options["supernodal"] = supernodal
        start = time.process_time()
        factor = cholmod.symbolic(khat)
        cholmod.numeric(khat, factor)
        seconds = time.process_time() - start
        b = matrix([i % 7 + 1.0 for i in range(len(of))])
        ms = median_ms(lambda: cholmod.solve(factor, b), count)
        best = min(best or (ms, seconds), (ms, seconds))
    return best[1], best[0]
