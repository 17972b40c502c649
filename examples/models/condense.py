"""Constraints of a model as u = T u_kept, so that T'MT, T'CT and T'KT are matrices without them. All matrices are sparse. Needs scipy."""

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import splu

# Part of the terms of a sum below which it is their round-off.
ROUND_OFF = 1e-13

# Part of the sums below which an eigenvalue is not below 0.
NEGATIVE = -1e-12


def condense(constraints, M, tied):
    """T and the places of the dofs that are kept. `constraints` u is 0; of `tied` dofs as few as possible are kept.

    If these leave a singular M, as of a mast whose mass is at its tied end, dofs with mass are kept before others: then M of the
    dofs with mass is regular, and the others have zero rows.
    """
    massive = abs(M).sum(axis=1) > 0.0
    for last in (np.zeros(M.shape[0], bool), massive):
        T, kept = eliminate(constraints, np.lexsort((~tied, last)))
        own, sizes = condensed(M, T)
        rows = np.flatnonzero(abs(own).sum(axis=1))
        if not len(rows) or not factored(scaled(own[rows][:, rows], sizes[rows]), 1e-9)[1]:
            break
    return T, kept


def condensed(a, T):
    """T'aT without its round-off, and the sizes of what is summed up on its diagonal: a rigid body has no part of its elements."""
    own, sizes = sparse.csr_array(T.T @ a @ T), sparse.csr_array(abs(T).T @ abs(a) @ abs(T))
    own = own.multiply(abs(own) - ROUND_OFF * sizes > 0.0).tocsr()
    own.eliminate_zeros()
    return (own + own.T) / 2, sizes.diagonal()


def eliminate(constraints, order):
    """T by elimination of the dofs in this order. What is left at its end is kept."""
    def scales(size):
        return np.where(size > 0.0, size, 1.0)

    constraints, count = sparse.csr_array(constraints), len(order)
    # Arms have the unit of length: of rotations times their arms, all numbers are about 1.
    of_dofs = scales(abs(constraints).max(axis=0).toarray().ravel() if constraints.shape[0] else np.zeros(count))
    rows, places = [], [set() for _ in range(count)]
    for i, row in enumerate(np.split(np.arange(constraints.nnz), constraints.indptr[1:-1])):
        dofs, values = constraints.indices[row], constraints.data[row] / of_dofs[constraints.indices[row]]
        rows.append(dict(zip(dofs.tolist(), (values / scales(np.abs(values).max(initial=0.0))).tolist())))
        for dof in rows[i]:
            places[dof].add(i)
    # The dof of a pivot, and its row.
    pivots, used = {}, set()
    for dof in order.tolist():
        free = [(-abs(rows[i][dof]), i) for i in places[dof] if i not in used]
        if not free or -min(free)[0] <= 1e-9:
            continue
        best = pivots[dof] = min(free)[1]
        used.add(best)
        pivot = {other: value / rows[best][dof] for other, value in rows[best].items()}
        rows[best] = pivot
        for i in [i for i in places[dof] if i != best]:
            row, factor = rows[i], rows[i][dof]
            for other, value in pivot.items():
                row[other] = row.get(other, 0.0) - factor * value
                if abs(row[other]) < ROUND_OFF or other == dof:
                    del row[other]
                    places[other].discard(i)
                else:
                    places[other].add(i)
    kept = np.setdiff1d(np.arange(count), list(pivots))
    columns = {dof: i for i, dof in enumerate(kept.tolist())}
    terms = [(dof, i, 1.0) for dof, i in columns.items()]
    terms += [(dof, columns[other], -value * of_dofs[other] / of_dofs[dof])
              for dof, i in pivots.items() for other, value in rows[i].items() if other in columns]
    i, j, values = zip(*terms) if terms else ((), (), ())
    return sparse.csr_array((values, (i, j)), shape=(count, len(kept))), kept


def scaled(a, sizes):
    """A matrix over the sizes of its dofs."""
    by = sparse.diags_array(1.0 / np.sqrt(np.where(sizes > 0.0, sizes, 1.0)))
    return sparse.csc_array(by @ a @ by)


def factored(a, shift):
    """The factors of a - shift, and the number of eigenvalues of a below the shift: that of the pivots below 0 (Sylvester)."""
    unit = sparse.eye_array(a.shape[0], format="csc")
    while True:
        factors = splu(sparse.csc_array(a - shift * unit), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
        if (factors.perm_r == factors.perm_c).all():
            return factors, int((factors.U.diagonal() < 0.0).sum())
        shift *= 1.001  # A pivot is 0.


def below_zero(a, sizes):
    """Eigenvalues below 0 of a matrix over the sizes of its dofs, from the lowest, and the place that moves most in each vector."""
    a = scaled(a, sizes)
    count, shift = factored(a, NEGATIVE)[1], NEGATIVE
    if not count:
        return []
    while factored(a, shift)[1]:
        shift *= 4.0
    # Iteration of a subspace, with a few vectors more so that it converges.
    factors, x = factored(a, shift)[0], np.sin(np.outer(np.arange(1.0, a.shape[0] + 1.0), np.arange(1.0, min(a.shape[0], count + 8) + 1.0)))
    for _ in range(100):
        x = np.linalg.qr(factors.solve(x))[0]
    values, vectors = np.linalg.eigh(x.T @ (a @ x))
    return list(zip(values[:count], np.abs(x @ vectors).argmax(axis=0)))


def check(M, K, T, kept, dofs, supports=None, loaded=False):
    """Raises ValueError with the name of the dof where the condensed matrices are not those of a structure at rest.

    `loaded`: under loads, K may have eigenvalues below 0. They are printed.
    """
    def name(i):
        return f"{dofs[i][0]}.{dofs[i][1]}"

    supports, rows = supports or {}, set(kept.tolist())
    for i, dof in enumerate(dofs):
        if dof[0] in supports and i not in rows:
            raise ValueError(f"{name(i)} is fixed or tied, but its node is a support; leave it free, and let others follow it")
    masses = condensed(M, T)[0]
    for what, a in (("M", M), ("K", K)):
        found = below_zero(*condensed(a, T))
        if found and what == "K" and loaded:
            names = ", ".join(dict.fromkeys(name(kept[place]) for _, place in found[:10]))
            print(f"export: K has {len(found)} eigenvalue{'s' * (len(found) > 1)} below 0, largest at {names}: contacts or springs of the study must hold it")
        elif found:
            value, place = found[0]
            raise ValueError(f"{what} has an eigenvalue below 0 ({value:.3g} at a unit diagonal), most of it at {name(kept[place])}")
    if not masses.nnz:
        raise ValueError("M is 0: no dof that moves has a mass, such as " + name(kept[0]))
    # A study shakes the kept dofs of a direction; the tied ones must follow as a whole.
    moves = np.diff(T.indptr) > 0
    for direction in ("x", "y", "z"):
        shaken = np.array([dof[1] == direction for dof in dofs])
        error = np.abs(T.T @ (M @ (shaken * moves)) - masses @ shaken[kept])
        # Forces on dofs, each over that of all masses in its own motion.
        error /= np.sqrt(np.where(masses.diagonal() > 0.0, masses.diagonal(), 1.0) * max(abs(M[shaken]).sum(), 1e-300))
        worst = error.argmax()
        if error[worst] > 1e-9:
            raise ValueError(f"a motion of the ground in {direction} is not that of the constraint of {name(kept[worst])} with a fixed dof: "
                             "leave the fixed node free and name it in `supports`")
