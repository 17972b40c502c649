#!/usr/bin/env python3
"""Friction and impact as a researcher writes them: scipy's solve_ivp between events.

A sticking contact is a constraint, a sliding one has the force of its limit, an impact spring the force k r where r < 0. Each change is
an event. Numbers: `tolerance`, the relative one of solve_ivp (1e-10).
"""
import numpy as np

import lines

LAWS = ["coulomb", "impact-spring"]
scipy = lines.engine("scipy", LAWS)
solve_ivp = lines.engine("scipy.integrate", LAWS).solve_ivp
REST = 1e-9  # Largest velocity of a contact at rest, over the largest velocity so far.


def run(case):
    mass, damping, stiffness = (lines.matrix(case, name) for name in "MCK")
    inverse, p = np.linalg.inv(mass), lines.loads(case, mass)
    n, dt, contacts = len(mass), case["dt"], case["contacts"]
    b = np.array([lines.direction(case, contact) for contact in contacts]).reshape(len(contacts), n)
    is_friction = [contact["law"] == "coulomb" for contact in contacts]
    limit = [lines.constant_limit(c) if f else 0.0 for c, f in zip(contacts, is_friction)]
    tolerance = case["numbers"].get("tolerance", 1e-10)
    cost = 0

    def forces(t, y, states, first):
        """S of all contacts: given ones, then those that hold the sticking contacts."""
        u, v = y[:n], y[n:]
        load = p[first] + (p[first + 1] - p[first]) * (t / dt - first) - damping @ v - stiffness @ u
        s = np.zeros(len(contacts))
        for c, state in enumerate(states):
            if is_friction[c]:
                s[c] = limit[c] * state
            elif state:
                s[c] = contacts[c]["numbers"]["k"] * (contacts[c]["numbers"]["gap"] + b[c] @ u)
        stuck = [c for c, state in enumerate(states) if is_friction[c] and state == 0]
        if stuck:
            hold = b[stuck]
            free = hold @ inverse @ (load - b.T @ s)
            s[stuck] = np.linalg.solve(hold @ inverse @ hold.T, free)
        return s, inverse @ (load - b.T @ s)

    def settle(t, y, states, first, fastest):
        """The states after an event: contacts without velocity stick if their limit holds them, else they slide against it."""
        rates, moves = b @ y[n:], list(states)
        for c, contact in enumerate(contacts):
            if is_friction[c]:
                moves[c] = 0 if abs(rates[c]) <= REST * fastest else int(np.sign(rates[c]))
            else:
                r = contact["numbers"]["gap"] + b[c] @ y[:n]
                moves[c] = int(r < 0 or (abs(r) < 1e-12 and rates[c] < 0))
        return loosen(t, y, moves, first)

    def loosen(t, y, states, first):
        """The states in which no sticking contact has more than its limit; the one that exceeds it most slides first."""
        for _ in contacts:
            s, _ = forces(t, y, states, first)
            more = {c: abs(s[c]) - limit[c] * (1 + 1e-9) for c, state in enumerate(states) if is_friction[c] and state == 0}
            worst = max(more, key=more.get, default=None)
            if worst is None or more[worst] <= 0:
                break
            states[worst] = int(np.sign(s[worst]))
        return states

    def stop(y, states):
        """The motion with exactly no velocity of the sticking contacts."""
        hold = b[[c for c, state in enumerate(states) if is_friction[c] and state == 0]]
        if len(hold):
            y[n:] -= inverse @ hold.T @ np.linalg.solve(hold @ inverse @ hold.T, hold @ y[n:])
        return y

    y, t = np.array(case["start"]["u"] + case["start"]["v"], dtype=float), 0.0
    fastest = max(np.abs(y[n:]).max(initial=0.0), case["scales"]["velocity"] * 1e-3)
    states = settle(t, y, [0] * len(contacts), 0, fastest)
    rows, shown = [y], [forces(t, y, states, 0)[0]]
    for first in range(case["steps"]):
        end = (first + 1) * dt
        for _ in range(1000):
            if end - t <= 1e-12 * end:
                break

            def crossing(c):
                def event(t, y):
                    if not is_friction[c]:
                        return contacts[c]["numbers"]["gap"] + b[c] @ y[:n]
                    if states[c] == 0:
                        return limit[c] - abs(forces(t, y, states, first)[0][c])
                    return b[c] @ y[n:]

                event.terminal = True
                # Not the event at which the state begins: an open contact closes, a closed one opens, what slides comes to rest.
                event.direction = (1 if states[c] else -1) if not is_friction[c] else (-1 if states[c] >= 0 else 1)
                return event

            slope = lambda t, y: np.concatenate([y[n:], forces(t, y, states, first)[1]])
            found = solve_ivp(
                slope, (t, end), y, "DOP853", events=[crossing(c) for c in range(len(contacts))],
                rtol=tolerance, atol=tolerance * 1e-3 * case["scales"]["length"],
            )
            cost += found.nfev
            t, y = found.t[-1], found.y[:, -1]
            fastest = max(fastest, np.abs(y[n:]).max(initial=0.0))
            if found.status == 1:
                hit = [c for c in range(len(contacts)) if len(found.t_events[c])]
                for c in hit:
                    if is_friction[c] and states[c] == 0:  # It breaks loose in the direction of its force.
                        states[c] = int(np.sign(forces(t, y, states, first)[0][c]))
                    elif is_friction[c]:
                        states[c] = 0
                    else:
                        states[c] = 1 - states[c]
                # A contact whose force jumps beyond its limit, and one that does not stay at rest, slides on.
                y = stop(y, states)
                states = loosen(t, y, states, first)
        else:
            raise RuntimeError(f"1000 events before t = {end}")
        rows.append(y)
        shown.append(forces(t, y, states, first)[0])
    rows, shown = np.array(rows), np.array(shown)
    return rows[:, :n], rows[:, n:], {c["name"]: shown[:, i] for i, c in enumerate(contacts)}, cost


if __name__ == "__main__":
    lines.serve("scipy solve_ivp", scipy.__version__, LAWS, run)
