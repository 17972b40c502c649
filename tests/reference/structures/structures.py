"""Structures with softened contacts in continuous time, by Dormand and Prince's method of order 8 from event to event.

What is solved (u_ground = 0, B with -1 at node I and +1 at node J of a contact):

    M u'' + C u' + K u + B S = p(t),   r = u_J - u_I + gap
    impact                S = k min(r, 0)
    displacement-control  S' = k r' within -L(t) .. L(t), S(0) = 0; on a limit S = +-L until k r' turns back from +-L'
    velocity-control      S = c r', cut to -L(t) .. L(t)
    L(t) = max(constant + factor signal(t), 0)

Each contact has a mode: open or closed; stick (elastic or viscous), + or - (on a limit), off (L = 0). In fixed modes the right side
is smooth, so the integrator keeps its order. A mode has guards, functions that are positive while the mode lasts. After each step the
guards are read at 24 places of its dense output. A root found there is improved with the integrator itself, from the step's start,
because the dense output has an order less. Kinks of the signals and zeros of N(t) are known before; the integrator stops there, too.

After a slip ends, L - S starts from zero with slope zero. A guard that has not yet risen above the round-off is not armed. One that
falls below it unarmed means that the motion grazes an event: then the program stops instead of a guess.

A structure is a dictionary of plain data, see structures_data.py. structures_checks.py tests this program.
"""

import math

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq

from structures_contacts import Contact, breaks, piece

PLACES = np.arange(1, 25) / 24
UNARMED = 1e-9  # of the largest value of a guard's terms so far


class Structure:
    """Matrices and loads of plain data."""

    def __init__(self, data):
        self.data, n = data, len(data["masses"])
        self.masses, self.m = np.array(data["masses"]), len(data["contacts"])
        self.K, self.C = np.zeros((n, n)), np.zeros((n, n))
        for i, j, k, c in data["springs"]:
            b = self.column([i, j])
            self.K += k * np.outer(b, b)
            self.C += c * np.outer(b, b)
        self.B = np.array([self.column(c["between"]) for c in data["contacts"]]).reshape(self.m, n)
        self.gap = np.array([c.get("gap", 0.0) for c in data["contacts"]])
        self.patterns = np.zeros((len(data["loads"]), n))
        for row, load in zip(self.patterns, data["loads"]):
            for node, factor in load["pattern"]:
                row[node] += factor

    def column(self, between):
        b = np.zeros(len(self.data["masses"]))
        for node, sign in zip(between, (-1.0, 1.0)):
            if node is not None:
                b[node] += sign
        return b


def solve(data, times, rtol=1e-13):
    """Motion with absolute tolerances from a coarse run."""
    largest = Motion(data, times, 1e-7).largest
    return Motion(data, times, rtol, largest + 1e-30)


class Motion:
    """The motion from t = 0 to `end`: `at` the times given, and `events` (t, contact, mode before, mode after)."""

    def __init__(self, data, times, rtol, size=None, max_step=math.inf):
        self.s, self.rtol, self.max_step = Structure(data), rtol, max_step
        n, m = len(data["masses"]), self.s.m
        self.n, self.modes, self.events, self.rows, self.times = n, [None] * m, [], [], list(times)
        self.y = np.concatenate([data["displacement"], data["velocity"], np.zeros(m), np.zeros(3)])
        self.atol = 1e-12 if size is None else rtol * size  # size: the largest value of each state in a coarse run
        self.largest = np.abs(self.y)
        edges = breaks(data, max(times))
        for start, end in zip(edges, edges[1:]):
            self.smooth(start, end)

    def contact_states(self, y):
        n = self.n
        return zip(self.s.B @ y[:n] + self.s.gap, self.s.B @ y[n:2 * n], y[2 * n:])

    def smooth(self, start, end):
        """One smooth piece of all signals: events until its end."""
        n, data = self.n, self.s.data
        self.loads = [piece(load["signal"], (start + end) / 2)[0] for load in data["loads"]]
        self.contacts = [Contact(c, start, end) for c in data["contacts"]]
        entered = [c.enter(start, *state) for c, state in zip(self.contacts, self.contact_states(self.y))]
        self.events += [(start, i, before, mode)
                        for i, (before, (mode, _)) in enumerate(zip(self.modes, entered)) if before not in (None, mode)]
        self.modes = [mode for mode, _ in entered]
        self.y[2 * n:2 * n + self.s.m] = [S for _, S in entered]
        if start == 0:
            self.record(0.0, self.y)
        t = start
        while t < end:
            t = self.until_event(t, end)
        self.keep_forces(end)

    def keep_forces(self, t):
        """Writes the forces to the state, where those of a slip are not kept by the integrator."""
        states = self.contact_states(self.y)
        self.y[2 * self.n:-3] = [c.force(mode, t, *x) for c, mode, x in zip(self.contacts, self.modes, list(states))]

    def slopes(self, t, y):
        n, m, s = self.n, self.s.m, self.s
        u, v = y[:n], y[n:2 * n]
        S = np.array([c.force(mode, t, *state) for c, mode, state
                      in zip(self.contacts, self.modes, self.contact_states(y))])
        p = np.array([load(t) for load in self.loads]) @ s.patterns
        rate, drag = s.B @ v, s.C @ v
        a = (p - drag - s.K @ u - S @ s.B) / s.masses
        own = [c.k * x if c.law == "displacement-control" and mode == "stick" else 0.0
               for c, mode, x in zip(self.contacts, self.modes, rate)]
        return np.concatenate([v, a, own, [p @ v, drag @ v, S @ rate]])

    def guards(self, t, y):
        return [(i, *guard) for i, (c, mode, state) in enumerate(zip(self.contacts, self.modes, self.contact_states(y)))
                for guard in c.guards(mode, t, *state)]

    def solver(self, t, y, end):
        return DOP853(self.slopes, t, y, end, rtol=self.rtol, atol=self.atol, max_step=self.max_step)

    def carry(self, t, y, end):
        """State at `end` by steps of the integrator from t on."""
        solver = self.solver(t, y, end)
        while solver.status == "running":
            solver.step()
        return solver.y

    def until_event(self, t, end):
        solver = self.solver(t, self.y, end)
        first = self.guards(t, self.y)
        size = [g[2] for g in first]
        armed = [g[1] > UNARMED * max(g[2], 1e-300) for g in first]
        while solver.status == "running":
            before = solver.y.copy()
            solver.step()
            if solver.status == "failed":
                raise ArithmeticError(f"no step from t = {solver.t}")
            self.largest = np.maximum(self.largest, np.abs(solver.y))
            old, dense = solver.t_old, solver.dense_output()
            found, last = [], old
            for x in old + PLACES * (solver.t - old):
                for i, (contact, g, terms, mode) in enumerate(self.guards(x, dense(x))):
                    size[i] = max(size[i], terms)
                    if g > UNARMED * size[i]:
                        armed[i] = True
                    elif g < 0 and armed[i]:
                        def guard(t, i=i, at=dense):
                            return self.guards(t, at(t))[i][1]
                        found.append((brentq(guard, last, x, xtol=1e-14), i, contact, mode))
                    elif g < -UNARMED * size[i]:
                        raise ArithmeticError(f"contact {contact} grazes an event near t = {x}")
                if found:
                    return self.change(old, before, dense, sorted(found))
                last = x
            self.record_until(old, before, solver.t)
        self.y = solver.y.copy()
        return end

    def change(self, old, before, dense, found):
        """Improves the first event's time with the integrator, and changes modes there; of all contacts that turn at one time."""
        t, first = found[0][:2]
        together = [(contact, mode) for x, _, contact, mode in found if x - t <= 1e-9 * max(t - old, 1e-9)]
        width = 1e-4 * max(t - old, 1e-9)
        sides = [self.guards(x, dense(x))[first][1] for x in (t - width, t + width)]
        rate = (sides[1] - sides[0]) / (2 * width)
        for _ in range(6):
            y = self.carry(old, before, t)
            step = -self.guards(t, y)[first][1] / rate
            if abs(step) <= 2e-16 * max(t, 1e-3):
                break
            t = max(t + step, old + 1e-300)
        self.record_until(old, before, t)
        self.y = y
        self.keep_forces(t)
        for contact, mode in together:
            self.events.append((float(t), contact, self.modes[contact], mode))
            self.modes[contact] = mode
        return t

    def record_until(self, old, before, t):
        while len(self.rows) < len(self.times) and self.times[len(self.rows)] <= t:
            at = self.times[len(self.rows)]
            self.record(at, before if at == old else self.carry(old, before, at))

    def record(self, t, y):
        if self.times[len(self.rows)] == t:
            states = list(self.contact_states(y))
            S = [c.force(mode, t, *state) for c, mode, state in zip(self.contacts, self.modes, states)]
            self.rows.append({"t": t, "u": y[:self.n].tolist(), "v": y[self.n:2 * self.n].tolist(),
                              "r": [float(x[0]) for x in states], "rdot": [float(x[1]) for x in states],
                              "S": [float(x) for x in S], "work": y[-3:].tolist()})

    def books(self):
        """Kinetic and strain energy plus work on dashpots and contacts less work of the loads, at each row; constant."""
        totals = []
        for row in self.rows:
            u, v, (load, drag, contacts) = np.array(row["u"]), np.array(row["v"]), row["work"]
            totals.append(self.s.masses @ v ** 2 / 2 + u @ self.s.K @ u / 2 + drag + contacts - load)
        return totals
