"""Constraints of a model as u = T u_kept, so that T'MT, T'CT and T'KT are matrices without them. Needs numpy."""

import numpy as np

# Decimals of T; what is behind them is round-off.
DIGITS = 12


def condense(constraints, M, tied):
    """T and the places of the dofs that are kept. `constraints` u is 0; of `tied` dofs as few as possible are kept.

    If these leave a singular M, as of a mast whose mass is at its tied end, dofs with mass are kept before others: then M of the
    dofs with mass is regular, and the others have zero rows.
    """
    massive = M.any(axis=1)
    for last in (np.zeros(len(M), bool), massive):
        T, kept = eliminate(constraints, np.lexsort((~tied, last)))
        own = T.T @ M @ T
        own = own[np.ix_(own.any(axis=1), own.any(axis=1))]
        if not len(own) or least(own)[0] > 1e-9:
            break
    return T, kept


def eliminate(constraints, order):
    """T by elimination of the dofs in this order. What is left at its end is kept."""
    a = constraints[:, order].astype(float)
    size, pivots = np.abs(a).max(initial=0.0), []
    for column in range(len(order)):
        row = len(pivots)
        if row == len(a):
            break
        best = row + np.abs(a[row:, column]).argmax()
        if abs(a[best, column]) <= 1e-9 * size:
            continue
        a[[row, best]] = a[[best, row]]
        a[row] /= a[row, column]
        others = np.arange(len(a)) != row
        a[others] -= np.outer(a[others, column], a[row])
        pivots.append(column)
    free = np.setdiff1d(np.arange(len(order)), pivots)
    T = np.zeros((len(order), len(free)))
    T[order[free], np.arange(len(free))] = 1.0
    T[order[pivots]] = -a[:len(pivots), free]
    T = np.round(T, DIGITS)
    by_row = np.argsort(order[free])
    return T[:, by_row], order[free][by_row]


def least(a):
    """Smallest eigenvalue of a matrix with a unit diagonal by the same scales, and the place that moves most in its vector."""
    diagonal = np.abs(a.diagonal())
    scale = np.sqrt(np.where(diagonal > 0.0, diagonal, 1.0))
    values, vectors = np.linalg.eigh(a / np.outer(scale, scale))
    return values[0], np.abs(vectors[:, 0]).argmax()


def check(M, K, T, kept, dofs, supports=None):
    """Raises ValueError with the name of the dof where the condensed matrices are not those of a structure at rest."""
    def name(i):
        return f"{dofs[i][0]}.{dofs[i][1]}"

    supports = supports or {}
    for i, row in enumerate(T):
        if dofs[i][0] in supports and i not in kept:
            raise ValueError(f"{name(i)} is fixed or tied, but its node is a support; leave it free, and let others follow it")
    masses, stiffnesses = T.T @ M @ T, T.T @ K @ T
    for what, a in (("M", masses), ("K", stiffnesses)):
        value, place = least(a)
        if value < -1e-9:
            raise ValueError(f"{what} has an eigenvalue below 0 ({value:.3g} at a unit diagonal), most of it at {name(kept[place])}")
    if not masses.any():
        raise ValueError("M is 0: no dof that moves has a mass, such as " + name(kept[0]))
    # A study shakes the kept dofs of a direction; the tied ones must follow as a whole.
    moves = T.any(axis=1)
    for direction in ("x", "y", "z"):
        shaken = np.array([dof[1] == direction for dof in dofs])
        error = np.abs(T.T @ M @ (shaken * moves) - masses @ shaken[kept])
        worst = error.argmax()
        if error[worst] > 1e-9 * np.abs(masses).max():
            raise ValueError(f"a motion of the ground in {direction} is not that of the constraint of {name(kept[worst])} with a fixed dof: "
                             "leave the fixed node free and name it in `supports`")
