"""Three girders on three piers, with gaps between them and frictional bearings, under a synthetic earthquake.

The structure of girders.json as numbers: what girders_loop.py and girders_opensees.py solve. Units t, kN, m, s.
"""

import math

import numpy as np

from record import DT as SAMPLE
from record import check, synthetic

STEP, STEPS, EVERY = 0.001, 20_000, 100  # s; displacements are written at every 0.1 s
L, EA, MASS, STIFFNESS_DAMPING = 40.0, 1.5e8, 500.0, 1.5e-4
PERIODS, PIER, ON_PIER, RATIO = (1.0, 0.7, 1.2), 100.0, 600.0, 0.05
HINGE, GAP = 2e6, 0.02
LIMIT, WIDTH = 245.0, 0.0005


class Girders:
    """Nodes p1, g1.left, g1.1 .. g1.right, p2, g2.left .. in a row: springs join neighbours only."""

    def __init__(self, n):
        self.n = n
        self.names, self.masses, self.springs, self.places = [], [], [], {}
        for bar, period in enumerate(PERIODS, 1):
            w = 2 * math.pi / period
            pier = self.add(f"p{bar}", PIER)
            self.springs.append((None, pier, ON_PIER * w**2, 2 * RATIO * w * ON_PIER))
            ends = [self.add(f"g{bar}.{'left' if i == 0 else 'right' if i == n else i}",
                             MASS / n / (2 if i in (0, n) else 1)) for i in range(n + 1)]
            self.springs.append((pier, ends[0], HINGE, 0.0))
            self.springs += [(i, i + 1, EA * n / L, STIFFNESS_DAMPING * EA * n / L) for i in ends[:-1]]
        at = self.places.__getitem__
        self.gaps = [(at("g1.right"), at("g2.left")), (at("g2.right"), at("g3.left"))]
        self.bearings = [(at("p2"), at("g1.right")), (at("p3"), at("g2.right")), (None, at("g3.right"))]
        self.impact_stiffness = n * EA / L

    def add(self, name, mass):
        self.places[name] = len(self.names)
        self.names.append(name)
        self.masses.append(mass)
        return self.places[name]


def record():
    """a_g at 0, 0.01 .. 30 s."""
    check()
    return synthetic(1)


def acceleration():
    """a_g at every step."""
    samples = record()
    return np.interp(np.arange(STEPS + 1) * STEP, np.arange(len(samples)) * SAMPLE, samples)

