"""Files and `structure` of a study as matrices and motions of own_structure.py, in long double."""

import csv
from pathlib import Path

import numpy as np
from scipy.io import mmread

REAL = np.longdouble


class Model:
    """Matrices over the free degrees of freedom, and `fixed`, over those of supports: (name, direction) of each column."""

    def __init__(self, structure, folder):
        self.structure, folder = structure, Path(folder)
        blocks, self.places, self.directions, owners = [], {}, [], []
        for name, entry in structure.get("matrices", {}).items():
            M, K = (mmread(folder / entry[x]) for x in "MK")
            C = mmread(folder / entry["C"]) if "C" in entry else 0 * K
            blocks.append([np.asarray(a.todense() if hasattr(a, "todense") else a) for a in (M, C, K)])
            with open(folder / entry["dofs"], encoding="utf-8") as file:
                for row in csv.DictReader(file):
                    self.places[f"{name}.{row['node']}.{row['direction']}"] = len(self.directions)
                    self.directions.append(row["direction"])
                    owners.append(row.get("support") or None)
        for name, mass in structure.get("masses", {}).items():
            self.places[name] = len(self.directions)
            self.directions.append("x")
            owners.append(None)
            blocks.append([np.array([[x]]) for x in (mass, 0.0, 0.0)])
        n = len(self.directions)
        M, C, K = np.zeros((3, n, n), REAL)
        at = 0
        for block in blocks:
            for whole, part in zip((M, C, K), block):
                whole[at:at + len(part), at:at + len(part)] = part
            at += len(block[0])
        self.supports = list(structure.get("supports", {}))
        for spring in structure.get("springs", []):
            b, s = self.column(spring, n)
            if s.any():
                raise ValueError("springs to supports are not read")
            K += spring["k"] * np.outer(b, b)
            C += spring.get("c", 0.0) * np.outer(b, b)
        damping = structure.get("rayleigh", {})
        C += damping.get("mass", 0.0) * M + damping.get("stiffness", 0.0) * K
        self.contacts = {}
        for name, contact in structure.get("contacts", {}).items():
            for key, part in read_pairs(name, contact, folder):
                self.contacts[key] = contact, *self.column(part, n)
        free = np.array([owner is None for owner in owners])
        self.free, self.owned = np.flatnonzero(free), np.flatnonzero(~free)
        self.owners = [(owners[i], self.directions[i]) for i in self.owned]
        self.M, self.C, self.K = (a[np.ix_(free, free)] for a in (M, C, K))
        self.Mfs, self.Cfs, self.Kfs = (a[np.ix_(free, ~free)] for a in (M, C, K))
        self.B = np.array([b[free] for _, b, _ in self.contacts.values()], REAL).reshape(len(self.contacts), len(self.free)).T
        self.Bs = np.array([s for _, _, s in self.contacts.values()], REAL).reshape(len(self.contacts), len(self.supports)).T
        self.gap = np.array([c.get("gap", 0.0) for c, _, _ in self.contacts.values()], REAL)
        self.influence = {d: np.array([self.directions[i] == d for i in self.free], REAL) for d in "xyz"}

    def column(self, part, n):
        along = part.get("along") or dict(zip(part["between"], (-1.0, 1.0)))
        b, s = np.zeros(n, REAL), np.zeros(len(self.supports), REAL)
        for name, factor in along.items():
            if name in self.supports:
                s[self.supports.index(name)] += factor
            elif name != "ground":
                b[self.places[name]] += factor
        return b, s


def read_pairs(name, contact, folder):
    if "pairs" not in contact:
        return [(name, contact)]
    with open(folder / contact["pairs"], encoding="utf-8") as file:
        rows = list(csv.reader(file))[1:]
    return [(f"{name}.{row[0]}", {"along": {d: float(f) for d, f in (cell.rsplit(":", 1) for cell in row[1:] if cell)}})
            for row in rows]


class Motion:
    """Acceleration, velocity and displacement of a record at rest before its first sample, straight between its samples."""

    def __init__(self, data, folder):
        table = np.loadtxt(Path(folder) / data["record"], delimiter=",", skiprows=1).astype(REAL)
        self.t, self.a = table[:, 0] - table[0, 0], table[:, 1] * REAL(data.get("scale", 1.0))
        self.delay = REAL(data.get("delay", 0.0))
        h = np.diff(self.t)
        self.v = np.concatenate([[0], np.cumsum(h * (self.a[:-1] + self.a[1:]) / 2)])
        self.u = np.concatenate([[0], np.cumsum(h * self.v[:-1] + h**2 * (2 * self.a[:-1] + self.a[1:]) / 6)])

    def at(self, t):
        """a, v, u; after the last sample a is 0."""
        t = t - self.delay
        if t < 0:
            return np.zeros(3, REAL)
        if t >= self.t[-1]:
            rest = t - self.t[-1]
            return np.array([self.a[-1] if rest == 0 else 0, self.v[-1], self.u[-1] + rest * self.v[-1]], REAL)
        i = int(np.searchsorted(self.t, t, side="right")) - 1
        x, h = t - self.t[i], self.t[i + 1] - self.t[i]
        slope = (self.a[i + 1] - self.a[i]) / h
        return np.array([self.a[i] + slope * x, self.v[i] + x * (self.a[i] + slope * x / 2),
                         self.u[i] + x * (self.v[i] + x * (self.a[i] / 2 + slope * x / 6))], REAL)
