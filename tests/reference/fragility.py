"""Fragility functions by mpmath, with 40 digits.

The likelihoods are written in the median and the dispersion (of a cloud in intercept, slope and deviation), and their derivatives
are zero by Newton's method. The intervals are those of the inverse of the second derivatives. The frequency is the integral of
P(x) |dH| over the curve H by quadrature, where slipgap has closed forms of the integral of H dP. The numbers are in the tests of
crates/statistics/src/fragility.
"""

from mpmath import diff, erfc, exp, findroot, log, matrix, mp, mpf, nstr, quad, sqrt

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


def show(name, logarithm, covariance, numbers):
    """Numbers with their intervals by the delta method: `numbers` gives the logarithms of median and dispersion."""
    row = [exp(of(*logarithm)) for of in numbers]
    for of in numbers:
        g = matrix(gradient(of, logarithm))
        half = Z * sqrt((g.T * covariance * g)[0])
        row += [exp(of(*logarithm) - half), exp(of(*logarithm) + half)]
    print(name, ", ".join(nstr(x.real, 17) for x in row))


TWO = [lambda m, s: m, lambda m, s: s]


def fit(name, f, start):
    """The largest f of ln(median) and ln(dispersion)."""
    p = stationary(f, start)
    show(name, p, -(hessian(f, p) ** -1), TWO)


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


def cloud(name, points, beyond, limit, start):
    """Intercept, slope and logarithm of the deviation."""

    def f(a, b, s):
        u = lambda x, y: (log(mpf(y)) - a - b * log(mpf(x))) / exp(s)
        return sum(log_density(u(*p)) - s for p in points) + sum(log(phi(-u(x, limit))) for x in beyond)

    p = stationary(f, start)
    print(name, "slope and deviation", nstr(p[1], 17), nstr(exp(p[2]), 17))
    own = [lambda a, b, s: (log(mpf(limit)) - a) / b, lambda a, b, s: s - log(b)]
    show(name, p, -(hessian(f, p) ** -1), own)


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
    print(name, nstr(all, 17), "outside", nstr(outside / all, 17), "closed form", nstr(closed, 17))


if __name__ == "__main__":
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
        cloud("cloud", list(zip(x, y)), beyond, 0.07, [mpf(-2), mpf(1), log(mpf(0.2))])
    curve = [(0.05, 0.02), (0.1, 0.008), (0.3, 0.001), (0.8, 1e-4), (2.0, 5e-6)]
    for median, dispersion in [(0.9, 0.45), (0.2, 0.3), (5.0, 0.6)]:
        frequency("frequency", curve, median, dispersion)
