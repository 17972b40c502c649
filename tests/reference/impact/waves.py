"""Exact impact of two elastic bars, or of a bar and a rigid wall, by characteristics: any lengths, any gap.

Derivation. In a bar, p (compressive force) and v obey rho A v_t = -p_x and p_t = -EA v_x, so p/Z + v is constant
along dx/dt = +C and p/Z - v along dx/dt = -C, with Z = EA/C. Take the left bar, its contact end on the right. What
arrives there is a(t) = v + p/Z. With a contact force F(t) (p = F at the end) the end moves at v = a - F/Z and sends
back p/Z - v = 2F/Z - a. The free end (p = 0) turns the sign, and after T = 2L/C, the time there and back, the contact
end receives

    a(t + T) = a(t) - 2 F(t)/Z          left bar,  v_end = a - F/Z
    a(t + T) = a(t) + 2 F(t)/Z          right bar, v_end = a + F/Z   (the same, mirrored)

with a(t) = V0 for t < T. A wall is a(t) = 0 and 1/Z = 0. So a bar is a delay line, and all that is left is a law at one
point. With w = a_left - a_right:

    open      (r > 0)        F = 0, rdot = -w; it closes when r = 0 is reached
    touching  (r = 0), w > 0 F = w Z1 Z2/(Z1 + Z2), rdot = 0
    touching, w = 0          F = 0, rdot = 0: no force, but the ends still move together
    touching, w < 0          F would be tensile: F = 0, rdot = -w > 0, it opens

F, a and rdot are piecewise constant, r is piecewise linear. The program goes from event to event. A bar holds its
fronts in flight as pairs (time of arrival at the contact end, jump of a). At each event time t:

  1. take all fronts of both bars that arrive at t (within TIME_TOLERANCE: bars 1 : 2 or 2 : 1 have fronts that
     arrive together, and treating them one after the other would open the contact for no time) and sum their jumps da
     for each bar;
  2. if open and r has come to 0 at t, now touching;
  3. find F from w (|w| below SPEED_TOLERANCE counts as 0), dF its jump;
  4. each bar gets one new front at t + T with jump da -+ 2 dF/Z (left -, right +), unless that is 0.

The next event is the earliest arrival, or the closing time t + r/w if that comes first.

Number of fronts. A bar gets one front per event, and events lie at t_c + i T_left + j T_right with t_c the time of a
closing and i, j >= 0; openings happen at arrivals and add no times of their own. While open a bar's fronts only go
round. So up to time t there are at most (closings) (t/T_left + 1)(t/T_right + 1) events: quadratic for lengths without
common measure, linear otherwise, never exponential. Jumps shrink as well, by the reflection factor at the contact.

Velocity and force inside a bar follow from the same two functions of time. At the distance s from the contact end

    P = a(t + s/C),  Q = a(t - s/C) - 2 F(t - s/C)/Z     left:  v = (P + Q)/2,  p/Z = (P - Q)/2
    P = a(t + s/C),  Q = a(t - s/C) + 2 F(t - s/C)/Z     right: v = (P + Q)/2,  p/Z = (Q - P)/2

where a(t + s/C) needs F up to t - L/C only (for s <= L), and times before 0 have a = V0, F = 0.

Scales: time T_I = 2 L/C of the left bar, velocity c (closing speed) in the frame of the right bar, r over c T_I/2
(so dr/dt = 2 rdot), force F0 = c Z1 Z2/(Z1 + Z2) (wall: c Z1). Then F = w in contact, and 1/Z becomes
share_left = Z2/(Z1 + Z2), share_right = Z1/(Z1 + Z2) (wall: 1 and 0).
"""

import bisect
import heapq

TIME_TOLERANCE = 1e-12  # in T_I, relative for times above 1
SPEED_TOLERANCE = 1e-12  # in the closing speed


class Line:
    """One bar as a delay line: what arrives at its contact end, past and in flight."""

    def __init__(self, start, delay, share, direction):
        self.value, self.delay, self.share, self.direction = start, delay, share, direction
        self.flying = []  # heap of (arrival, jump)
        self.times, self.values = [], []  # arrivals so far, value after each
        self.start = start

    def arrive(self, t, tolerance):
        jump = 0
        while self.flying and self.flying[0][0] <= t + tolerance:
            jump += heapq.heappop(self.flying)[1]
        if jump:
            self.value += jump
            self.times.append(t), self.values.append(self.value)
        return jump

    def send(self, t, jump, force_jump):
        out = jump + self.direction * 2 * self.share * force_jump
        if self.delay is not None and abs(out) > SPEED_TOLERANCE / 10:
            heapq.heappush(self.flying, (t + self.delay, out))


class Exact:
    """Pieces (t, r at t, rdot, force, touching) from 0 to a little beyond `end`, each valid until the next one's t."""

    def __init__(self, gap, delay_right, share_left, share_right, end, one=1.0):
        zero = one * 0
        self.shares = share_left, share_right
        self.left, self.right = Line(one, one, share_left, -1), Line(zero, delay_right, share_right, 1)
        self.pieces = []
        t, r, touching, force = zero, gap * one, gap == 0, zero
        jump_left = jump_right = 0
        while True:
            w = self.left.value - self.right.value
            if abs(w) < SPEED_TOLERANCE:
                w = zero
            if touching and w < 0:
                touching = False
            new = w if touching and w > 0 else zero
            rdot = zero if touching else -w
            self.pieces.append((t, r, rdot, new, touching))
            self.left.send(t, jump_left, new - force)
            self.right.send(t, jump_right, new - force)
            force = new
            if t > end:
                break
            times = [line.flying[0][0] for line in (self.left, self.right) if line.flying]
            if not touching and rdot < 0:
                times.append(t - r / (2 * rdot))
            later = min(times) if times else end + one
            r = r + 2 * rdot * (later - t)
            t = later
            tolerance = TIME_TOLERANCE * max(1, t)
            if not touching and rdot < 0 and r <= 2 * tolerance * -rdot:
                touching, r = True, zero
            jump_left, jump_right = self.left.arrive(t, tolerance), self.right.arrive(t, tolerance)
        self.times = [p[0] for p in self.pieces]

    def at(self, t, side=1):
        """r, rdot, force at t; side -1 takes the limit from the left where t is at a jump, +1 from the right."""
        tolerance = TIME_TOLERANCE * max(1, t)
        i = bisect.bisect_right(self.times, t + side * tolerance) - 1
        start, r, rdot, force, _ = self.pieces[max(i, 0)]
        return r + 2 * rdot * (t - start), rdot, force

    def touch(self):
        """Time of the first touch."""
        return next(p[0] for p in self.pieces if p[4])

    def phases(self):
        """Lists of (from, to) of touch and of force, maximal intervals; an open end is None."""
        def intervals(on):
            out, start = [], None
            for p in self.pieces:
                if on(p) and start is None:
                    start = p[0]
                if not on(p) and start is not None:
                    out.append((start, p[0]))
                    start = None
            return out + ([(start, None)] if start is not None else [])
        return intervals(lambda p: p[4]), intervals(lambda p: p[3] > 0)

    def impulse(self, end):
        """Integral of the force from 0 to end."""
        stops = self.times[1:] + [None]
        return sum((p[3] * (min(s, end) - p[0]) for p, s in zip(self.pieces, stops)
                    if p[0] < end and s is not None), self.pieces[0][3] * 0)

    def _force(self, t):
        return 0 if t < 0 else self.pieces[max(bisect.bisect_right(self.times, t) - 1, 0)][3]

    def inside(self, bar, distance, t):
        """Velocity (frame of the right bar, over c) and compressive force (over F0) at `distance` from the contact
        end, in travel times (s/C in T_I: a bar reaches to half its delay); valid up to `end`."""
        line, share = (self.left, self.shares[0]) if bar == "left" else (self.right, self.shares[1])

        def arriving(time):
            i = bisect.bisect_right(line.times, time) - 1
            value = line.values[i] if i >= 0 else line.start
            return value + sum(jump for at, jump in line.flying if at <= time)
        p, q = arriving(t + distance), arriving(t - distance) + line.direction * 2 * share * self._force(t - distance)
        return (p + q) / 2, -line.direction * (p - q) / 2 / share
