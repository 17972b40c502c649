"""How often 95 % intervals of samples contain what they estimate: the other rows of the table of coverage.py, by simulation.

clouds: five cases of each member, whose deviations have a common half; median and dispersion by the jackknife over the members.
frequencies: incremental, lognormal capacities with a dispersion of 0.4, H = x^-k. probability: Clopper and Pearson. band: of a
distribution function. distance: D_low to D_high of tests and 256 cases, of one distribution, and shifted by half a deviation. scatter: of
tests that are fitted alone (mean 0, scatter 1, errors of 0.5). sobol: the g-function with a = 0, 1, 9, 99, the percentile bootstrap over
n random base points, or those of a shifted Sobol' sequence.
"""
import numpy as np
from scipy.optimize import brentq
from scipy.stats import beta, binom, chi2, kstwo, norm, qmc, t as student

rng = np.random.default_rng(20261130)


def say(*words):
    print(*words, flush=True)


def share(inside):
    return round(100 * float(np.mean(inside)), 1)


def jackknife(value, without):
    """Whether ln true = 0 is inside ln value +- t times the standard error; `without` has the last axis of the members."""
    n = without.shape[-1]
    z = without - without.mean(-1, keepdims=True)
    error = np.sqrt((n - 1) / n * (z * z).sum(-1))
    return np.abs(value) <= student.ppf(0.975, n - 1) * error


def of_cloud(sums, limit):
    n, x, y, xx, xy, yy = sums
    mx, my = x / n, y / n
    sxx, sxy, syy = xx - n * mx * mx, xy - n * mx * my, yy - n * my * my
    slope = sxy / sxx
    deviation = np.sqrt(np.maximum(syy - slope * sxy, 0) / (n - 2))
    return mx + (limit - my) / slope, np.log(deviation / slope)


for n in (12, 20, 40):
    x = rng.normal(0, 0.6, (4000, n, 1)) + np.linspace(-1, 1, 5)
    error = (rng.standard_normal((4000, n, 1)) + rng.standard_normal((4000, n, 5))) * 0.4 / 2**0.5
    y = x + error
    each = np.stack([np.full(x.shape[:2], 5.0), x.sum(-1), y.sum(-1), (x * x).sum(-1), (x * y).sum(-1), (y * y).sum(-1)])
    whole = each.sum(-1)
    median, dispersion = of_cloud(whole, 0.5)
    medians, dispersions = of_cloud(whole[:, :, None] - each, 0.5)
    median, medians = median - 0.5, medians - 0.5
    dispersion, dispersions = dispersion - np.log(0.4), dispersions - np.log(0.4)
    say(n, "clouds", share(jackknife(median, medians)), share(jackknife(dispersion, dispersions)))
    z = 0.4 * rng.standard_normal((20000, n))
    others = (n - 1, (z.sum(-1, keepdims=True) - z) / (n - 1))
    squares = (z * z).sum(-1, keepdims=True) - z * z - others[0] * others[1] ** 2
    for k in (1, 2, 3):
        frequency = lambda m, v: -k * m + k * k * v / 2 - k * k * 0.16 / 2
        whole = frequency(z.mean(-1), z.var(-1, ddof=1))
        say(n, "frequencies, k", k, share(jackknife(whole, frequency(others[1], squares / (n - 2)))))
    for p in (0.05, 0.2, 0.5):
        c = np.arange(n + 1)
        low, high = beta.ppf(0.025, c, n - c + 1), beta.ppf(0.975, c + 1, n - c)
        inside = (np.nan_to_num(low) <= p) & (p <= np.where(c == n, 1, high))
        say(n, "probability", p, round(100 * binom.pmf(c, n, p)[inside].sum(), 1))
    u = np.sort(rng.random((20000, n)))
    steps = np.arange(n)
    distance = np.maximum(u - steps / n, (steps + 1) / n - u).max(-1)
    say(n, "band", share(distance <= kstwo.ppf(0.95, n)))

# The true distance of two normal distributions half a deviation apart is 2 Phi(1/4) - 1.
for n in (12, 20, 40):
    for shift in (0.0, 0.5):
        true, inside = 2 * norm.cdf(shift / 2) - 1, []
        for _ in range(1000):
            tests, cases = rng.standard_normal(n) + shift, rng.standard_normal(256)
            order = np.argsort(np.r_[tests, cases])
            steps = np.r_[np.full(n, 1 / n), np.full(256, -1 / 256)]
            found = np.abs(np.cumsum(steps[order])).max()
            drawn = np.c_[rng.multinomial(n, np.full(n, 1 / n), 400), rng.multinomial(256, np.full(256, 1 / 256), 400)] - 1
            errors = np.abs(np.cumsum((drawn * steps)[:, order], -1)).max(-1)
            inside.append(abs(found - true) <= np.quantile(errors, 0.95))
        say(n, "distance", shift, share(inside))

# Paule and Mandel, Viechtbauer, Knapp and Hartung.
for n in (3, 5, 10):
    of_mean, of_scatter = [], []
    for _ in range(3000):
        y = rng.standard_normal(n) * 1.25**0.5
        def excess(squared, target):
            w = np.full(n, 1 / (squared + 0.25))
            return (w * (y - y.mean()) ** 2).sum() - target
        root = lambda target: 0.0 if excess(0, target) <= 0 else brentq(excess, 0, 1e6, args=(target,))
        squared = root(n - 1)
        factor = max(1.0, (excess(squared, 0)) / (n - 1))
        half = student.ppf(0.975, n - 1) * np.sqrt(factor * (squared + 0.25) / n)
        of_mean.append(abs(y.mean()) <= half)
        of_scatter.append(root(chi2.ppf(0.975, n - 1)) <= 1 <= root(chi2.ppf(0.025, n - 1)))
    say(n, "scatter: mean", share(of_mean), "scatter", share(of_scatter))

a = np.array([0.0, 1, 9, 99])
parts = 1 / 3 / (1 + a) ** 2
variance = np.prod(1 + parts) - 1
first = parts / variance
total = parts * np.prod(1 + parts) / (1 + parts) / variance
g = lambda u: np.prod((np.abs(4 * u - 2) + a) / (1 + a), -1)
for kind in ("random", "sobol"):
    for n in (64, 512):
        inside = np.zeros((2, 4))
        trials = 1000
        for _ in range(trials):
            # A shift modulo 1, not a scramble, as the product has it.
            points = rng.random((n, 8)) if kind == "random" else (qmc.Sobol(8, scramble=False).random(n) + rng.random(8)) % 1
            A, B = points[:, :4], points[:, 4:]
            fa, fb = g(A), g(B)
            columns = [fa + fb, fa * fa + fb * fb]
            mean = (fa + fb).mean() / 2
            fa, fb = fa - mean, fb - mean
            columns = [fa + fb, fa * fa + fb * fb]
            for i in range(4):
                mixed = A.copy()
                mixed[:, i] = B[:, i]
                f = g(mixed) - mean
                columns += [fb * (f - fa), (fa - f) ** 2]
            sums = rng.multinomial(n, np.full(n, 1 / n), 400) @ np.stack(columns, -1) / n
            spread = sums[:, 1] / 2 - (sums[:, 0] / 2) ** 2
            for i in range(4):
                for j, true in ((0, first[i]), (1, total[i])):
                    low, high = np.quantile(sums[:, 2 + 2 * i + j] / spread / (1 + j), [0.025, 0.975])
                    inside[j, i] += low <= true <= high
        say("sobol", kind, n, "first", [share(x / trials) for x in inside[0]], "total", [share(x / trials) for x in inside[1]])
