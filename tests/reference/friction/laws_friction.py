"""The friction laws on an oscillator, integrated by a program that shares nothing with the time step methods.

    X'' + X + S = P sin(W T),   P = 2, W = 0.8,   X(0) = 0.5, X'(0) = 0,   at T = 10;  the limit of S is 1

Each law is a set of smooth differential equations between events: a velocity, a deflection or a distance from a limit that changes
its sign. Every piece is integrated by DOP853 (SciPy) with relative and absolute tolerance 1e-13 and ends at the root of its event
function; the next piece starts there with the sign changed. An integration with tolerance 1e-11 shows the accuracy.

Run:  python3 laws_friction.py     (needs numpy, scipy)

The program prints X, X', S at T = 10 for crates/contact/src/contact/friction_tests.rs, and the largest difference between both integrations.
"""

import math

import numpy as np
from scipy.integrate import solve_ivp

P, W, X0, END = 2.0, 0.8, 0.5, 10.0


class Law:
    """S(y, signs) and derivatives of the states beyond X, V; `events` are functions whose signs switch the equations."""

    def __init__(self, force, rates=lambda y, s: [], events=(), states=()):
        self.force, self.rates, self.events, self.states = force, rates, list(events), list(states)


def velocity(y):
    return y[1]


def tanh(beta):
    return Law(lambda y, s: math.tanh(y[1] / beta))


def tanh_bearing(beta, ratio, a):
    return Law(lambda y, s: (1 - (1 - ratio) * math.exp(-a * s[0] * y[1])) * math.tanh(y[1] / beta), events=[velocity])


def bearing(beta, ratio, a):
    def limit(v):
        return 1 - (1 - ratio) * math.exp(-a * max(v, 0.0))
    # s[1], s[2]: beyond the limit to the right, to the left
    def force(y, s):
        return limit(y[1]) if s[1] > 0 else -limit(-y[1]) if s[2] > 0 else y[1] / beta
    return Law(force, events=[velocity, lambda y: y[1] / beta - limit(y[1]), lambda y: -y[1] / beta - limit(-y[1])])


def stribeck(beta, static, width):
    edge = beta * static
    def force(y, s):
        if s[0] > 0:
            return 1 + (static - 1) * math.exp(-(y[1] - edge) / width)
        if s[1] > 0:
            return -1 - (static - 1) * math.exp((y[1] + edge) / width)
        return y[1] / beta
    return Law(force, events=[lambda y: y[1] - edge, lambda y: -y[1] - edge])


def hyperbolic(beta, static, width):
    edge = beta * static
    def force(y, s):
        if s[0] > 0:
            return 1 + (static - 1) / (1 + (y[1] - edge) / width)
        if s[1] > 0:
            return -1 - (static - 1) / (1 - (y[1] + edge) / width)
        return y[1] / beta
    return Law(force, events=[lambda y: y[1] - edge, lambda y: -y[1] - edge])


def bouc_wen(alpha, n, beta=0.5):
    def rates(y, s):
        return [y[1] / alpha * (1 - max(s[1] * y[2], 0.0) ** n * (s[0] * s[1] * beta + 1 - beta))]
    return Law(lambda y, s: y[2], rates, [velocity, lambda y: y[2]], [0.0])


def dahl(alpha, n):
    def rates(y, s):
        return [y[1] / alpha * max(1 - s[0] * y[2], 0.0) ** n]
    return Law(lambda y, s: y[2], rates, [velocity], [0.0])


def lugre(sigma0, sigma1, sigma2, static, width):
    def rate(y, s):
        g = 1 + (static - 1) * math.exp(-(y[1] / width) ** 2)
        return y[1] - sigma0 * s[0] * y[1] * y[2] / g
    return Law(lambda y, s: sigma0 * y[2] + sigma1 * rate(y, s) + sigma2 * y[1], lambda y, s: [rate(y, s)], [velocity], [0.0])


CASES = {
    "tanh(0.1)": tanh(0.1),
    "tanh(0.1, 0.4, 2)": tanh_bearing(0.1, 0.4, 2.0),
    "bearing(0.1, 0.4, 2)": bearing(0.1, 0.4, 2.0),
    "stribeck(0.1, 1.5, 0.5)": stribeck(0.1, 1.5, 0.5),
    "stribeck-hyperbolic(0.1, 1.5, 0.5)": hyperbolic(0.1, 1.5, 0.5),
    "bouc-wen(0.1, 1)": bouc_wen(0.1, 1.0),
    "bouc-wen(0.1, 2)": bouc_wen(0.1, 2.0),
    "bouc-wen(0.1, 5)": bouc_wen(0.1, 5.0),
    "bouc-wen(0.1, 1, 0.9)": bouc_wen(0.1, 1.0, 0.9),
    "bouc-wen(0.1, 2, 1.6)": bouc_wen(0.1, 2.0, 1.6),
    "bouc-wen(0.1, 2, 0.2)": bouc_wen(0.1, 2.0, 0.2),
    "bouc-wen(0.1, 5, 0.9)": bouc_wen(0.1, 5.0, 0.9),
    "dahl(0.1, 1)": dahl(0.1, 1.0),
    "dahl(0.1, 1.5)": dahl(0.1, 1.5),
    "dahl(0.1, 0.5)": dahl(0.1, 0.5),
    "lugre(10, 0, 0, 1, 1)": lugre(10.0, 0.0, 0.0, 1.0, 1.0),
    "lugre(10, 0.5, 0.1, 1, 1)": lugre(10.0, 0.5, 0.1, 1.0, 1.0),
    "lugre(10, 0.5, 0.4, 1.5, 0.5)": lugre(10.0, 0.5, 0.4, 1.5, 0.5),
}


def integrate(law, tolerance):
    """X, V, S at T = END, and the number of events."""
    y, t, count = np.array([X0, 0.0] + law.states), 0.0, 0

    def derivative(signs):
        return lambda t, y: [y[1], P * math.sin(W * t) - y[0] - law.force(y, signs)] + list(law.rates(y, signs))

    # The signs just after the start: the motion begins to the left.
    after = y + 1e-6 * np.array([0.0, -1.0] + [-1.0] * len(law.states))
    signs = [1.0 if event(after) > 0 else -1.0 for event in law.events]
    while t < END:
        events = []
        for event, sign in zip(law.events, signs):
            function = lambda t, y, event=event: event(y)
            function.terminal, function.direction = True, -sign
            events.append(function)
        out = solve_ivp(derivative(signs), (t, END), y, "DOP853", rtol=tolerance, atol=tolerance, events=events or None)
        assert out.success
        t, y = out.t[-1], out.y[:, -1]
        if out.status == 1:
            for k, times in enumerate(out.t_events):
                if len(times):
                    signs[k], count = -signs[k], count + 1
    return [y[0], y[1], law.force(y, signs)], count


def main():
    for name, law in CASES.items():
        fine, count = integrate(law, 1e-13)
        coarse, _ = integrate(law, 1e-11)
        error = max(abs(a - b) for a, b in zip(fine, coarse))
        print(f"{name:32} {', '.join(f'{x:.12f}' for x in fine)}   ({count} events, {error:.0e})")


if __name__ == "__main__":
    main()
