"""Signals and contacts of structures.py on the pieces of time on which they are smooth."""

import math
from bisect import bisect_right


def piece(signal, middle):
    """Value and slope of a signal as functions of time, on the smooth piece around `middle`."""
    if "sine" in signal:
        a, w, phase = (signal["sine"][key] for key in ("amplitude", "omega", "phase"))
        return lambda t: a * math.sin(w * t + phase), lambda t: a * w * math.cos(w * t + phase)
    t, f = signal["table"]["t"], signal["table"]["f"]
    k = bisect_right(t, middle)
    if k == 0 or k == len(t):
        level = f[0] if k == 0 else f[-1]
        return lambda _: level, lambda _: 0.0
    t0, f0, slope = t[k - 1], f[k - 1], (f[k] - f[k - 1]) / (t[k] - t[k - 1])
    return lambda t: f0 + slope * (t - t0), lambda _: slope


def zeros(limit, end):
    """Times at which constant + factor signal is zero."""
    level, signal = -limit["constant"] / limit["factor"], limit["signal"]
    if "sine" in signal:
        a, w, phase = (signal["sine"][key] for key in ("amplitude", "omega", "phase"))
        if abs(level) >= abs(a):
            return []
        first = math.asin(level / a)
        turns = range(math.floor(phase / math.tau) - 1, math.ceil((w * end + phase) / math.tau) + 2)
        return [(x + math.tau * k - phase) / w for k in turns for x in (first, math.pi - first)]
    t, f = signal["table"]["t"], signal["table"]["f"]
    return [t0 + (t1 - t0) * (level - f0) / (f1 - f0)
            for t0, t1, f0, f1 in zip(t, t[1:], f, f[1:]) if t1 > t0 and (f0 - level) * (f1 - level) < 0]


def breaks(structure, end):
    """Times, 0 and the end among them, between which all signals and limits are smooth."""
    times = {0.0, end}
    limits = [c["limit"] for c in structure["contacts"] if "limit" in c]
    for signal in [x["signal"] for x in [*structure["loads"], *limits] if x.get("signal")]:
        times.update(signal.get("table", {"t": []})["t"])
    for limit in limits:
        if limit["signal"]:
            times.update(zeros(limit, end))
    return sorted(t for t in times if 0 <= t <= end)


class Contact:
    """A contact on one smooth piece of its limit. States come as (r, r', S), S only where it is a state of its own."""

    def __init__(self, data, start, end):
        self.law, self.middle = data["law"], (start + end) / 2
        self.k = data["c" if self.law == "velocity-control" else "k"]
        if self.law != "impact":
            self.set_limit(data["limit"])

    def set_limit(self, limit):
        if not limit["signal"]:
            level = limit["constant"]
            self.limit, self.slope = lambda _: level, lambda _: 0.0
            return
        value, slope = piece(limit["signal"], self.middle)
        constant, factor = limit["constant"], limit["factor"]
        if constant + factor * value(self.middle) <= 0:
            self.limit = self.slope = lambda _: 0.0
        else:
            self.limit = lambda t: max(constant + factor * value(t), 0.0)
            self.slope = lambda t: factor * slope(t)

    def enter(self, t, r, rate, S):
        """Mode at the start of a smooth piece, and S."""
        if self.law == "impact":
            return ("closed" if r < 0 else "open"), self.k * min(r, 0.0)
        if self.limit(self.middle) == 0:
            return "off", 0.0
        most, slope, k_rate = self.limit(t), self.slope(t), self.k * rate
        if self.law == "velocity-control":
            S = max(-most, min(most, k_rate))
            return ("stick" if abs(k_rate) < most else "+" if rate > 0 else "-"), S
        S = max(-most, min(most, S))
        # On a limit but for round-off, and not pulled back inside faster than the limit moves.
        tiny = 1e-12 * self.limit(self.middle)
        if S >= most - tiny and k_rate > slope:
            return "+", S
        if S <= -most + tiny and k_rate < -slope:
            return "-", S
        return "stick", S

    def force(self, mode, t, r, rate, S):
        if mode in ("open", "off"):
            return 0.0
        if mode == "closed":
            return self.k * r
        if mode == "stick":
            return self.k * rate if self.law == "velocity-control" else S
        return self.limit(t) if mode == "+" else -self.limit(t)

    def guards(self, mode, t, r, rate, S):
        """For each guard its value, the size of its terms, and the mode when it falls below zero."""
        if mode in ("open", "closed"):
            return [(r, abs(r), "closed")] if mode == "open" else [(-r, abs(r), "open")]
        if mode == "off":
            return []
        most, k_rate = self.limit(t), self.k * rate
        if mode == "stick":
            F = k_rate if self.law == "velocity-control" else S
            return [(most - F, most + abs(F), "+"), (most + F, most + abs(F), "-")]
        turn = most if self.law == "velocity-control" else self.slope(t)
        sign = 1 if mode == "+" else -1
        # S = +-L leaves its limit where k r' = +-L', c r' where it is +-L.
        return [(sign * k_rate - turn, abs(k_rate) + abs(turn), "stick")]
