"""Constraints of a model as u = T u_kept, so that T'MT, T'CT and T'KT are matrices without them. Needs numpy."""

import numpy as np

# Part of the terms of a sum below which it is their round-off.
ROUND_OFF = 1e-13

# Part of the sums below which an eigenvalue is not below 0, in hundreds of dofs.
NEGATIVE = -1e-12


def condense(constraints, M, tied):
    """T and the places of the dofs that are kept. `constraints` u is 0; of `tied` dofs as few as possible are kept.

    If these leave a singular M, as of a mast whose mass is at its tied end, dofs with mass are kept before others: then M of the
    dofs with mass is regular, and the others have zero rows.
    """
    massive = M.any(axis=1)
    for last in (np.zeros(len(M), bool), massive):
        T, kept = eliminate(constraints, np.lexsort((~tied, last)))
        own, sizes = condensed(M, T)
        rows = own.any(axis=1)
        if not rows.any() or least(own[np.ix_(rows, rows)], sizes[rows])[0] > 1e-9:
            break
    return T, kept


def condensed(a, T):
    """T'aT without its round-off, and the sizes of what is summed up on its diagonal: a rigid body has no part of its elements."""
    own, sizes = T.T @ a @ T, np.abs(T).T @ np.abs(a) @ np.abs(T)
    own[np.abs(own) <= ROUND_OFF * sizes] = 0.0
    return (own + own.T) / 2, sizes.diagonal()


def eliminate(constraints, order):
    """T by elimination of the dofs in this order. What is left at its end is kept."""
    def scales(a):
        size = np.abs(a).max(axis=0, initial=0.0)
        return np.where(size > 0.0, size, 1.0)

    # Arms have the unit of length: of rotations times their arms, all numbers are about 1.
    of_dofs = scales(constraints)
    a, pivots = (constraints / of_dofs)[:, order], []
    a /= scales(a.T)[:, None]
    for column in range(len(order)):
        row = len(pivots)
        if row == len(a):
            break
        best = row + np.abs(a[row:, column]).argmax()
        if abs(a[best, column]) <= 1e-9:
            continue
        a[[row, best]] = a[[best, row]]
        a[row] /= a[row, column]
        others = (np.arange(len(a)) != row) & (a[:, column] != 0.0)
        a[others] -= np.outer(a[others, column], a[row])
        a[np.abs(a) < ROUND_OFF] = 0.0
        pivots.append(column)
    free = np.setdiff1d(np.arange(len(order)), pivots)
    T = np.zeros((len(order), len(free)))
    T[order[free], np.arange(len(free))] = 1.0
    T[order[pivots]] = -a[:len(pivots), free] * of_dofs[order[free]] / of_dofs[order[pivots]][:, None]
    by_row = np.argsort(order[free])
    return T[:, by_row], order[free][by_row]


def least(a, sizes):
    """Smallest eigenvalue of a matrix over the sizes of its dofs, and the place that moves most in its vector."""
    scale = np.sqrt(np.where(sizes > 0.0, sizes, 1.0))
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
    masses = condensed(M, T)[0]
    for what, a in (("M", M), ("K", K)):
        value, place = least(*condensed(a, T))
        if value < NEGATIVE:
            raise ValueError(f"{what} has an eigenvalue below 0 ({value:.3g} at a unit diagonal), most of it at {name(kept[place])}")
    if not masses.any():
        raise ValueError("M is 0: no dof that moves has a mass, such as " + name(kept[0]))
    # A study shakes the kept dofs of a direction; the tied ones must follow as a whole.
    moves = T.any(axis=1)
    for direction in ("x", "y", "z"):
        shaken = np.array([dof[1] == direction for dof in dofs])
        error = np.abs(T.T @ M @ (shaken * moves) - masses @ shaken[kept])
        # Forces on dofs, each over that of all masses in its own motion.
        error /= np.sqrt(np.where(masses.diagonal() > 0.0, masses.diagonal(), 1.0) * max(np.abs(M[shaken]).sum(), 1e-300))
        worst = error.argmax()
        if error[worst] > 1e-9:
            raise ValueError(f"a motion of the ground in {direction} is not that of the constraint of {name(kept[worst])} with a fixed dof: "
                             "leave the fixed node free and name it in `supports`")
