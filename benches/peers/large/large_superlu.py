"""Newmark's steps of the block in numpy with SuperLU, without contacts."""

from scipy.sparse import diags_array
from scipy.sparse.linalg import splu


def superlu(of, count):
    """u after the steps."""
    khat = (diags_array(of.mass * 4 / of.dt**2) + of.K).tocsc()
    factor = splu(khat, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    dt, mass = of.dt, of.mass
    u, v = of.start()
    a = -(of.K @ u) / mass
    for _ in range(count):
        new = factor.solve(mass * (u * (4 / dt**2) + v * (4 / dt) + a))
        da = (new - u) * (4 / dt**2) - v * (4 / dt) - a
        u, v, a = new, v + (a + da) * (dt / 2), da
    return u
