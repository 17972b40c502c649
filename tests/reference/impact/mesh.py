"""Two equal bars of finite elements on the impact spring in continuous time, all degrees of freedom, by numpy.

Both bars are assembled, neither symmetry nor closed-form modes are used; events are found on a dense grid and then by
Brent's method. Writes ../../data/mesh.json: the times at which the ends part and touch, and r and rdot in between.

Run:  python3 mesh.py     (needs numpy and scipy)
"""

import json
import pathlib

import numpy as np
from scipy.linalg import eigh
from scipy.optimize import brentq

GRID = 2e-6  # spacing in T_I; shorter touches would be missed


def assemble(n, mass):
    """M, K of both bars (each of mass 1/2, trip 1, in 2 F0 T_I/c and T_I) and b with r = b^T u + gap."""
    size = 2 * (n + 1)
    M, K, b = np.zeros((size, size)), np.zeros((size, size)), np.zeros(size)
    m = 0.5 / n
    k = m * (2.0 * n) ** 2
    own, other = (m / 2, 0.0) if mass == "lumped" else (m / 3, m / 6)
    for start in (0, n + 1):
        for i in range(start, start + n):
            M[i:i + 2, i:i + 2] += [[own, other], [other, own]]
            K[i:i + 2, i:i + 2] += [[k, -k], [-k, k]]
    b[n], b[n + 1] = -1.0, 1.0
    return M, K, b


class Piece:
    """Free motion in the modes of M, K from u, v on."""

    def __init__(self, M, modes, b, u, v):
        w2, self.shapes = modes
        self.w = np.sqrt(np.maximum(w2, 0.0))
        self.rigid = self.w < 1e-5
        self.safe = np.where(self.rigid, 1.0, self.w)
        self.b = b @ self.shapes
        self.q, self.p = self.shapes.T @ M @ u, self.shapes.T @ M @ v

    def modal(self, s):
        wave, turn = np.cos(np.multiply.outer(s, self.w)), np.sin(np.multiply.outer(s, self.w))
        s = np.asarray(s)[..., None]
        q = np.where(self.rigid, self.q + self.p * s, self.q * wave + self.p * turn / self.safe)
        p = np.where(self.rigid, self.p, self.p * wave - self.q * self.w * turn)
        return q, p

    def r(self, s):
        return self.modal(s)[0] @ self.b

    def state(self, s):
        q, p = self.modal(s)
        return self.shapes @ q, self.shapes @ p


def run(gamma, n, mass, gap, end, times):
    M, K, b = assemble(n, mass)
    spring = 2.0 * gamma * n
    modes = {False: eigh(K, M), True: eigh(K + spring * np.outer(b, b), M)}
    u, v = np.zeros(len(b)), np.repeat([1.0, -1.0], n + 1)
    now, touching, events, rows = gap / 2, True, [], []
    while True:
        piece = Piece(M, modes[touching], b, u, v)
        last = int((end - now) / GRID) + 1
        found = None
        for first in range(1, last + 1, 4000):
            s = GRID * np.arange(first, min(first + 4000, last + 1))
            wrong = (piece.r(s) > 0) == touching
            if first == 1:
                wrong[:1] = False  # r = 0 here but for round-off
            if wrong.any():
                at = s[np.argmax(wrong)]
                found = brentq(lambda x: float(piece.r(x)), at - GRID, at, xtol=1e-15)
                break
        until = end if found is None else now + found
        for t in times:
            if now <= t < until:
                q, p = piece.modal(t - now)
                rows.append([t, float(q @ piece.b), 0.5 * float(p @ piece.b)])
        if found is None:
            return events, rows
        u, v = piece.state(found)
        now = until
        events.append(now)
        touching = not touching


def main():
    cases = []
    for gamma, n, mass, gap in [
        (1.0, 10, "lumped", 0.0), (0.25, 20, "lumped", 0.0), (5.0, 2, "lumped", 0.0), (0.3, 1, "lumped", 0.4),
        (0.02, 40, "lumped", 0.0), (2.03, 20, "lumped", 0.0), (2.035, 20, "lumped", 0.0), (2.04, 20, "lumped", 0.0),
        (2.12, 20, "lumped", 0.0), (10.0, 10, "lumped", 0.0), (1.0, 10, "consistent", 0.1), (4.0, 7, "consistent", 0.0),
    ]:
        times = [gap / 2 + (j + 0.5) / 16 for j in range(24)]
        events, rows = run(gamma, n, mass, gap, gap / 2 + 1.5, times)
        cases.append({"gamma": gamma, "n": n, "mass": mass, "gap": gap, "events": events, "rows": rows})
        print(gamma, n, mass, len(events))
    path = pathlib.Path(__file__).parents[2] / "data" / "mesh.json"
    path.write_text(json.dumps(cases, indent=0) + "\n")


main()
