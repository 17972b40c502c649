"""Peak force of two long bars with stiffness damping that meet on a spring; the pier is fixed at the struck end.

The bars are continua: sigma = E (eps + a deps/dt), so that an end that moves with the velocity v presses with Z v,
Z(s) = EA/c_0 sqrt(1 + a s). The pier adds k m s/(m s^2 + k). Until the wave returns (T_I) the force is the inverse Laplace
transform of c/(s (s/k_I + 1/Z + 1/(Z + Z_pier))). Without the pier it depends on kappa = k_I a/F_1 = 4 gamma n tau only,
F_1 = EA/(2 c_0), tau = a/T_I. The study bridges-damping has these numbers as checks.
"""
from mpmath import invertlaplace, mp, mpf, sqrt

mp.dps = 20


def force(t, kappa, k_att=0, mass=0):
    """The force over F_1 c at the time t T_I, with tau = 0.01; k_att in EA/L and mass in masses of a bar."""
    a = mpf("0.01")  # in T_I
    k_i = kappa / a  # in F_1/T_I; EA/L is 4 F_1/T_I, the mass of a bar is F_1 T_I

    def transform(s):
        z = 2 * sqrt(1 + a * s)
        pier = 4 * k_att * mass * s / (mass * s * s + 4 * k_att) if k_att else 0
        return 1 / (s * (s / k_i + 1 / z + 1 / (z + pier)))

    return invertlaplace(transform, t, method="talbot", degree=24)


def peak(kappa, k_att=0, mass=0):
    """The largest force up to T_I: a scan over the logarithm of time, refined about its largest value."""
    low, high = -4.0, -0.001
    for _ in range(4):
        times = [low + (high - low) * i / 40 for i in range(41)]
        values = [force(mpf(10) ** x, kappa, k_att, mass) for x in times]
        at = max(range(41), key=lambda i: values[i])
        low, high = times[max(at - 1, 0)], times[min(at + 1, 40)]
    return values[at]


if __name__ == "__main__":
    for kappa in [0.4, 0.8, 1.2, 1.6, 3.2, 6.4, 12.8]:
        one = float(peak(kappa))
        short = float(peak(kappa, 0.5, 60 / 250))
        print(f"kappa {kappa}: two bars {one:.4f}, with the pier of the short bridge, k_att = 0.5: {short:.4f}")
