"""Fragility functions by mpmath, with 40 digits.

The likelihoods are written in the median and the dispersion (of a cloud in intercept, slope and deviation), and their derivatives
are zero by Newton's method. The intervals are those of the inverse of the second derivatives. The frequency is the integral of
P(x) |dH| over the curve H by quadrature, where slipgap has closed forms of the integral of H dP. The numbers are in the tests of
crates/statistics/src/fragility.

    python fragility.py                     # these numbers
    python fragility.py results.csv         # of studies/recorded/recorded-fragility.json, from its results, into ../../data/fragility.json
"""

import csv
import json
import sys
from pathlib import Path

from mpmath import betainc, diff, erfc, exp, findroot, gammainc, log, matrix, mp, mpf, nstr, quad, sqrt

mp.dps = 40
Z = sqrt(2) * mp.erfinv(mpf("0.95"))


def phi(u):
    return erfc(-u / sqrt(2)) / 2


def log_density(u):
    return -u * u / 2 - log(2 * mp.pi) / 2


def gradient(f, p):
    return [diff(f, p, tuple(int(i == j) for j in range(len(p)))) for i in range(len(p))]


def hessian(f, p):
    n = range(len(p))
    return matrix([[diff(f, p, tuple(int(k == i) + int(k == j) for k in n)) for j in n] for i in n])


def stationary(f, start):
    root = findroot(lambda *p: gradient(f, p), start, tol=1e-60, maxsteps=60)
    return tuple(x.real for x in root)


def show(name, logarithm, covariance, numbers, z=Z):
    """Numbers with their intervals by the delta method: `numbers` gives the logarithms of median and dispersion."""
    row = [exp(of(*logarithm)) for of in numbers]
    for of in numbers:
        g = matrix(gradient(of, logarithm))
        half = z * sqrt((g.T * covariance * g)[0])
        row += [exp(of(*logarithm) - half), exp(of(*logarithm) + half)]
    if name:
        print(name, ", ".join(nstr(x.real, 17) for x in row))
    return [x.real for x in row]


TWO = [lambda m, s: m, lambda m, s: s]


def fit(name, f, start):
    """The largest f of ln(median) and ln(dispersion)."""
    p = stationary(f, start)
    return show(name, p, -(hessian(f, p) ** -1), TWO)


def trials(rows):
    def f(m, s):
        total = mpf(0)
        for at, exceeded, count in rows:
            u = (log(mpf(at)) - m) / exp(s)
            total += exceeded * log(phi(u)) + (count - exceeded) * log(phi(-u))
        return total

    return f


def capacities(reached, beyond, before):
    def f(m, s):
        u = lambda x: (log(mpf(x)) - m) / exp(s)
        total = sum(log_density(u(x)) - s for x in reached)
        return total + sum(log(phi(-u(x))) for x in beyond) + sum(log(phi(u(x))) for x in before)

    return f


def cloud(name, points, beyond, limit, collapse, start):
    """Intercept, slope and logarithm of the deviation; of the cases beyond it is known that y is not below `collapse`."""

    def f(a, b, s):
        u = lambda x, y: (log(mpf(y)) - a - b * log(mpf(x))) / exp(s)
        return sum(log_density(u(*p)) - s for p in points) + sum(log(phi(-u(x, collapse))) for x in beyond)

    p = stationary(f, start)
    if name:
        print(name, "slope and deviation", nstr(p[1], 17), nstr(exp(p[2]), 17))
    own = [lambda a, b, s: (log(mpf(limit)) - a) / b, lambda a, b, s: s - log(b)]
    t = student(len(points) - 2, mpf("0.95"))
    return show(name, p, -(hessian(f, p) ** -1), own, t) + [p[1], exp(p[2]), p[0]]


def frequency(name, curve, median, dispersion):
    """By quadrature over each segment of the curve and beyond its ends, and the part beyond."""
    median, dispersion = mpf(median), mpf(dispersion)
    points = [(log(mpf(x)), log(mpf(y))) for x, y in curve]
    steep = lambda i: (points[i][1] - points[i + 1][1]) / (points[i + 1][0] - points[i][0])

    def part(i, low, high):
        k, (at, height) = steep(i), points[i]
        # |dH| = k H dz.
        of = lambda z: phi((z - log(median)) / dispersion) * k * exp(height - k * (z - at))
        breaks = [low] + [b for b in [log(median) + j * dispersion for j in range(-12, 13, 2)] if low < b < high] + [high]
        return quad(of, breaks)

    last = len(points) - 2
    inner = sum(part(i, points[i][0], points[i + 1][0]) for i in range(last + 1))
    below = part(0, points[0][0] - 60, points[0][0])
    above = part(last, points[-1][0], points[-1][0] + 60)
    all = inner + below + above
    # What lies beyond is a part of the integral of H dP.
    density = lambda i, low, high: quad(
        lambda z: exp(points[i][1] - steep(i) * (z - points[i][0])) * exp(log_density((z - log(median)) / dispersion)) / dispersion,
        [low, high],
    )
    outside = density(0, points[0][0] - 60, points[0][0]) + density(last, points[-1][0], points[-1][0] + 60)
    i = max([j for j in range(last + 1) if points[j][0] < log(median)] or [0])
    closed = exp(points[i][1] - steep(i) * (log(median) - points[i][0]) + steep(i) ** 2 * dispersion**2 / 2)
    if name:
        print(name, nstr(all, 17), "outside", nstr(outside / all, 17), "closed form", nstr(closed, 17))
    return all, outside / all, closed


def student(free, p):
    """The t whose magnitude is exceeded with probability 1 - p."""
    inside = lambda t: 1 - betainc(mpf(free) / 2, mpf(1) / 2, 0, free / (free + t * t), regularized=True)
    return findroot(lambda t: inside(t) - p, (mpf(1), mpf(5)), solver="anderson", tol=1e-50)


def chi_square(free, p):
    below = lambda x: gammainc(mpf(free) / 2, 0, x / 2, regularized=True)
    return findroot(lambda x: below(x) - p, (mpf(free) / 20, mpf(free) * 3), solver="anderson", tol=1e-50)


def line(points):
    """Means, slope, deviation and sum of squares of x, and the probability of the slope."""
    n = len(points)
    x, y = sum(p[0] for p in points) / n, sum(p[1] for p in points) / n
    sxx = sum((p[0] - x) ** 2 for p in points)
    b = sum((p[0] - x) * (p[1] - y) for p in points) / sxx
    s = sqrt(sum((p[1] - y - b * (p[0] - x)) ** 2 for p in points) / (n - 2))
    t = b * sqrt(sxx) / s
    return x, y, b, s, sxx, betainc(mpf(n - 2) / 2, mpf(1) / 2, 0, (n - 2) / (n - 2 + t * t), regularized=True)


def of_all(values):
    """Capacities that are all known: exact intervals."""
    z, n = [log(x) for x in values], len(values)
    m = sum(z) / n
    s = sqrt(sum((x - m) ** 2 for x in z) / (n - 1))
    half = student(n - 1, mpf("0.95")) * s / sqrt(n)
    ends = [s * sqrt((n - 1) / chi_square(n - 1, mpf(p))) for p in ("0.975", "0.025")]
    return [exp(m), s, exp(m - half), exp(m + half)] + ends


def study(path):
    """The rows of studies/recorded/recorded-fragility.json."""
    rows = list(csv.DictReader(open(path)))
    number = lambda row, name: mpf(float(row[name]))
    records = sorted({row["record"] for row in rows})
    levels = [mpf(x) for x in (0.05, 0.02, 0.006, 0.0014, 0.00025, 3e-5)]
    places = {"pga": [0.05, 0.1, 0.2, 0.4, 0.8, 1.6], "ground.Sa(0.9)": [0.5, 1, 2, 4, 8, 16]}
    result = {}
    for name, along, limit, kind, collapse in [
        ("pga", "pga", 0.08, "incremental", None),
        ("sa", "ground.Sa(0.9)", 0.08, "incremental", None),
        ("cloud", "ground.Sa(0.9)", 0.08, "cloud", 0.4),
        ("truncated", "ground.Sa(0.9)", 0.4, "incremental", None),
        ("stripes", "pga", 0.08, "likelihood", 0.4),
    ]:
        limit = mpf(limit)
        gone = lambda y: collapse is not None and y >= mpf(collapse)
        members = {}
        for record in records:
            own = [(number(r, along), number(r, "opening"), r) for r in rows if r["record"] == record]
            members[record] = sorted(own, key=lambda case: case[0])
        bounds, own = {}, {}
        for record, cases in members.items():
            i = next((i for i, case in enumerate(cases) if case[1] > limit), None)
            if i is None:
                bounds[record] = [cases[-1][0], mp.inf]
                continue
            (x0, y0, _), (x1, y1, _) = cases[i - 1], cases[i]
            bounds[record] = [x0, x1]
            own[record] = x0 + (x1 - x0) * (limit - y0) / (y1 - y0)
        above = {}
        if kind == "incremental":
            beyond = [bounds[r][0] for r in records if r not in own]
            start = [log(x) for x in of_all(list(own.values()))[:2]]
            found = fit(None, capacities(own.values(), beyond, []), start) if beyond else of_all(list(own.values()))
            bounds.update({r: [x, x] for r, x in own.items()})
            above = {r: log(x / found[0]) for r, x in own.items()}
        elif kind == "likelihood":
            stripes = sorted({case[0] for cases in members.values() for case in cases})
            at = lambda x: [case[1] for cases in members.values() for case in cases if case[0] == x]
            of = trials([(x, sum(y > limit for y in at(x)), len(at(x))) for x in stripes])
            found = fit(None, of, [log(mpf(0.22)), log(mpf(0.28))])
        else:
            cases = [case for own in members.values() for case in own]
            points = [(x, y) for x, y, _ in cases if not gone(y)]
            start = line([(log(x), log(y)) for x, y in points])
            start = [start[1] - start[2] * start[0], start[2], log(start[3])]
            found = cloud(None, points, [x for x, y, _ in cases if gone(y)], limit, collapse, start)
            b, a = found[6], found[8]
            for record, own in members.items():
                residuals = [log(y) - a - b * log(x) for x, y, _ in own if not gone(y)]
                above[record] = sum(residuals) / len(residuals)
                bounds[record] = [exp((log(limit) - a - above[record]) / b)] * 2
        numbers = found[:8] if kind == "cloud" else found[:6]
        for column in ["magnitude", "ground.Tm"] if kind != "likelihood" else []:
            if name == "truncated" and column == "ground.Tm":
                continue
            of = lambda r: sum(number(case[2], column) for case in members[r]) / len(members[r])
            trend = line([(of(r), above[r]) for r in above])
            numbers += [trend[2], trend[5]]
        curve = list(zip(places[along], levels))
        numbers += list(frequency(None, curve, found[0], found[1]))

        def hazard(z):
            i = max([j for j in range(len(curve) - 1) if log(mpf(curve[j][0])) < z] or [0])
            (x0, y0), (x1, y1) = [(log(mpf(x)), log(y)) for x, y in curve[i : i + 2]]
            return exp(y0 + (y1 - y0) * (z - x0) / (x1 - x0))

        def mean(low, high):
            """Over a normal distribution of the logarithm between the bounds."""
            if low == high:
                return hazard(log(low))
            m, s = log(found[0]), found[1]
            ends = [log(low), log(high) if mp.isfinite(high) else log(low) + 40 * s]
            breaks = sorted({*ends, *[log(mpf(x)) for x, _ in curve if ends[0] < log(mpf(x)) < ends[1]]})
            density = lambda z: exp(log_density((z - m) / s)) / s
            return quad(lambda z: hazard(z) * density(z), breaks) / quad(density, breaks)

        each = [mean(*bounds[r]) for r in records]
        shares = {r.split("/")[-1]: [float(x), float(x / sum(each))] for r, x in zip(records, each)}
        result[name] = {"curve": [float(x) for x in numbers], "members": shares}
    text = json.dumps(result, indent=1)
    (Path(__file__).parent / "../../data/fragility.json").write_text(text + "\n")


def recorded_numbers():
    """The numbers in the tests of the crate."""
    sets = [
        ([(0.25, 0, 20), (0.5, 2, 20), (0.75, 7, 20), (1.0, 11, 20), (1.5, 16, 20), (2.0, 20, 20)], (0.92, 0.45)),
        ([(0.1, 1, 5), (0.2, 1, 5), (0.3, 2, 5), (0.4, 1, 5), (0.8, 4, 5)], (0.49, 1.33)),
        ([(1.0, 1, 2), (1.1, 0, 3), (1.2, 3, 3)], (1.1, 0.11)),
        ([(1e-3, 40, 100), (2e-3, 45, 100), (3e-3, 55, 100)], (0.00235, 3.05)),
    ]
    for rows, start in sets:
        fit("trials", trials(rows), [log(mpf(x)) for x in start])
    reached = [0.21, 0.33, 0.5, 0.47, 0.8, 0.29, 1.1]
    for beyond, before in [([1.5, 0.9], []), ([], [0.2, 0.3]), ([0.9, 1.5, 1.5], [0.2])]:
        fit("capacities", capacities(reached, beyond, before), [log(mpf(0.5)), log(mpf(0.6))])
    fit("capacities", capacities([3.0, 3.0], [2.0, 4.0, 4.0], []), [log(mpf(3.5)), log(mpf(0.2))])
    x, y = [0.1, 0.2, 0.35, 0.5, 0.6, 0.9, 1.3, 0.15], [0.012, 0.02, 0.05, 0.048, 0.09, 0.12, 0.15, 0.017]
    for beyond in [[1.2, 1.6], [0.4]]:
        cloud("cloud", list(zip(x, y)), beyond, 0.07, 0.07, [mpf(-2), mpf(1), log(mpf(0.2))])
    below, beyond = [(x, y) for x, y in zip(x, y) if y < 0.11], [x for x, y in zip(x, y) if y >= 0.11]
    cloud("cloud with collapse", below, beyond, 0.07, 0.11, [mpf(-2), mpf(1), log(mpf(0.2))])
    curve = [(0.05, 0.02), (0.1, 0.008), (0.3, 0.001), (0.8, 1e-4), (2.0, 5e-6)]
    for median, dispersion in [(0.9, 0.45), (0.2, 0.3), (5.0, 0.6)]:
        frequency("frequency", curve, median, dispersion)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        study(sys.argv[1])
    else:
        recorded_numbers()
