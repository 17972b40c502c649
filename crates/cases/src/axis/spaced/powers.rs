//! Powers of one number, to the bit those of `libm::pow`: its logarithm, half of the work, is computed once. The arithmetic is that of
//! e_pow.c of FDLIBM (Sun Microsystems 2004), which `libm` has from FreeBSD.

use std::f64::consts::LN_2;

/// A number and its logarithm.
#[derive(Debug, Clone, Copy)]
pub struct Powers {
    base: f64,
    /// log2 of the base in two parts; `None` for a base that `libm::pow` treats apart.
    log: Option<[f64; 2]>,
}

impl Powers {
    /// Powers of this number.
    pub fn of(base: f64) -> Powers {
        let plain = base.is_normal() && base > 0.0 && base != 1.0;
        let log = plain.then(|| log2(base));
        Powers { base, log }
    }

    /// The power with this exponent, between 0 and 1.
    #[inline(always)]
    pub fn at(&self, y: f64) -> f64 {
        match self.log {
            // The root of the standard library is correctly rounded.
            Some(_) if y == 0.5 => self.base.sqrt(),
            Some(log) => power(log, y),
            None => libm::pow(self.base, y),
        }
    }
}

/// The number without the lower 32 of its bits.
#[inline(always)]
fn upper(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & (u64::MAX << 32))
}

/// log2 of a normal number > 0 in two parts.
fn log2(x: f64) -> [f64; 2] {
    // log(m)/s - 2 in s = (m - c)/(m + c), c = 1 or 1.5.
    const SERIES: [f64; 6] = [
        5.999_999_999_999_946e-1,
        4.285_714_285_785_502e-1,
        3.333_333_298_183_774_4e-1,
        2.727_281_238_085_34e-1,
        2.306_607_457_755_617_5e-1,
        2.069_750_178_003_384_2e-1,
    ];
    // 2/(3 log(2)), and in two parts; log2(1.5) in two parts.
    const FACTOR: f64 = 9.617_966_939_259_756e-1;
    const FACTORS: [f64; 2] = [9.617_967_009_544_373e-1, -7.028_461_650_952_758e-9];
    const LOG_1_5: [f64; 2] = [5.849_624_872_207_642e-1, 1.350_039_202_129_749e-8];

    let fraction = (x.to_bits() >> 32) as u32 & 0xf_ffff;
    let (by_1_5, below_2) = (
        fraction > 0x3_988e && fraction < 0xb_b67a,
        fraction >= 0xb_b67a,
    );
    let n = (x.to_bits() >> 52) as i64 - 0x3ff + i64::from(below_2);
    let m = f64::from_bits(x.to_bits().wrapping_sub((n << 52) as u64));
    let (c, log_c) = if by_1_5 {
        (1.5, LOG_1_5)
    } else {
        (1.0, [0.0; 2])
    };
    let (u, v) = (m - c, 1.0 / (m + c));
    let s = u * v;
    let s_upper = upper(s);
    let half = (m.to_bits() >> 33) as u32 | 0x2000_0000;
    let bits = half + 0x8_0000 + (u32::from(by_1_5) << 18);
    let sum = f64::from_bits(u64::from(bits) << 32);
    let s_lower = v * ((u - s_upper * sum) - s_upper * (m - (sum - c)));
    let s2 = s * s;
    let [a, b, c, d, e, f] = SERIES;
    let series = s2 * s2 * (a + s2 * (b + s2 * (c + s2 * (d + s2 * (e + s2 * f)))));
    let rest = series + s_lower * (s_upper + s);
    let s2 = s_upper * s_upper;
    let t = upper(3.0 + s2 + rest);
    let t_lower = rest - ((t - 3.0) - s2);
    let (u, v) = (s_upper * t, s_lower * t + t_lower * s);
    let p = upper(u + v);
    let p_lower = v - (p - u);
    let z = FACTORS[0] * p;
    let z_lower = FACTORS[1] * p + p_lower * FACTOR + log_c[1];
    let n = n as f64;
    let log = upper(((z + z_lower) + log_c[0]) + n);
    [log, z_lower - (((log - n) - log_c[0]) - z)]
}

/// 2^(y log), 0 < `y` < 1, for a normal result.
#[inline(always)]
fn power([log, log_lower]: [f64; 2], y: f64) -> f64 {
    const SERIES: [f64; 5] = [
        1.666_666_666_666_660_2e-1,
        -2.777_777_777_701_559_3e-3,
        6.613_756_321_437_934e-5,
        -1.653_390_220_546_525_2e-6,
        4.138_136_797_057_238_4e-8,
    ];
    // log(2) in two parts.
    const LOGS_2: [f64; 2] = [6.931_471_824_645_996e-1, -1.904_654_299_957_768e-9];

    let y_upper = upper(y);
    let lower = (y - y_upper) * log + y * log_lower;
    let product = y_upper * log;
    let z = upper(lower + product);
    // The nearest whole number.
    let n = if z.abs() > 0.5 {
        (z + 0.5_f64.copysign(z)) as i32
    } else {
        0
    };
    let product = product - f64::from(n);
    let t = upper(lower + product);
    let u = t * LOGS_2[0];
    let v = (lower - (t - product)) * LN_2 + t * LOGS_2[1];
    let z = u + v;
    let w = v - (z - u);
    let t = z * z;
    let [a, b, c, d, e] = SERIES;
    let t = z - t * (a + t * (b + t * (c + t * (d + t * e))));
    let r = (z * t) / (t - 2.0) - (w + z * w);
    let z = 1.0 - (r - z);
    f64::from_bits(z.to_bits().wrapping_add((i64::from(n) << 52) as u64))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_have_the_bits_of_the_library() {
        // Bases at the ends of the intervals of the logarithm, near 1, and very small and large ones.
        let ends = [1.0, 1.224_744, 1.224_746, 1.5, 1.732_049, 1.732_053, 2.0];
        let near = ends
            .iter()
            .flat_map(|x: &f64| [x.next_down(), *x, x.next_up()]);
        let bases: Vec<f64> = near.chain([0.7, 3.0, 10.0, 1e3, 12345.678]).collect();
        let scales = [
            1.0,
            1e-300,
            1e-5,
            1e5,
            1e300,
            f64::MIN_POSITIVE,
            0.0,
            f64::INFINITY,
        ];
        for base in scales
            .iter()
            .flat_map(|scale| bases.iter().map(move |x| x * scale))
        {
            let powers = Powers::of(base);
            for steps in [2.0, 3.0, 7.0, 64.0, 1000.0, 999_999.0] {
                for i in (1..steps as u64).step_by((steps as usize / 100).max(1)) {
                    let y = i as f64 / steps;
                    let (found, expected) = (powers.at(y), libm::pow(base, y));
                    assert_eq!(found.to_bits(), expected.to_bits(), "{base:e}^{y}");
                }
            }
        }
    }
}
