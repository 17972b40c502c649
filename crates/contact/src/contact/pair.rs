//! Pairs of components.

/// Two components.
pub type Pair = [f64; 2];

/// Least step of a search along its direction.
const LEAST: f64 = 1e-3;

/// Most steps of a search, of which few are needed.
const STEPS: usize = 60;

/// Length of a pair.
pub fn length(a: Pair) -> f64 {
    match a {
        // The same bits as along an axis.
        [x, 0.0] | [0.0, x] => x.abs(),
        [x, y] => libm::hypot(x, y),
    }
}

/// Scalar product.
pub fn dot(a: Pair, b: Pair) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The pair of length 1; along the first axis for the pair 0.
pub(super) fn unit(a: Pair) -> Pair {
    match length(a) {
        0.0 => [1.0, 0.0],
        size => a.map(|x| x / size),
    }
}

pub(super) fn map(a: Pair, b: Pair, of: impl Fn(f64, f64) -> f64) -> Pair {
    [of(a[0], b[0]), of(a[1], b[1])]
}

/// The pair, not longer than the limit.
pub(super) fn cut(a: Pair, limit: f64) -> Pair {
    match length(a) {
        size if size > limit => a.map(|x| x * (limit / size)),
        _ => a,
    }
}

/// df_i/dx_j by rows, from differences over `width`.
pub(super) fn jacobian(of: impl Fn(Pair) -> Pair, at: Pair, width: f64) -> [Pair; 2] {
    let column = |j: usize| {
        let moved = |by: f64| {
            let mut x = at;
            x[j] += by;
            of(x)
        };
        map(moved(width), moved(-width), |a, b| (a - b) / (2.0 * width))
    };
    let [a, b] = [column(0), column(1)];
    [[a[0], b[0]], [a[1], b[1]]]
}

/// The direction of the smaller eigenvalue of the symmetric part, and both eigenvalues, the smaller one first.
pub(super) fn principal([[a, b], [c, d]]: [Pair; 2]) -> (Pair, Pair) {
    let (mean, half, shear) = (0.5 * (a + d), 0.5 * (a - d), 0.5 * (b + c));
    let radius = length([half, shear]);
    // Of the matrix less the larger eigenvalue, the longer column.
    let columns = [[half - radius, shear], [shear, -half - radius]];
    let longer = match length(columns[0]) > length(columns[1]) {
        true => columns[0],
        false => columns[1],
    };
    (unit(longer), [mean - radius, mean + radius])
}

/// The root of f near a start, by Newton's method with differences over `width`; steps that do not shorten f are halved.
pub(super) fn root(of: impl Fn(Pair) -> Pair, start: Pair, width: f64) -> Pair {
    let (mut x, mut rest) = (start, of(start));
    for _ in 0..STEPS {
        let size = length(rest);
        let [[a, b], [c, d]] = jacobian(&of, x, width);
        let determinant = a * d - b * c;
        if size == 0.0 || determinant == 0.0 || !determinant.is_finite() {
            break;
        }
        let step = [
            (b * rest[1] - d * rest[0]) / determinant,
            (c * rest[0] - a * rest[1]) / determinant,
        ];
        let mut part = 1.0;
        let next = loop {
            let next = map(x, step, |x, step| x + part * step);
            let there = of(next);
            if length(there) < size {
                break Some((next, there));
            }
            part *= 0.5;
            if part < LEAST {
                break None;
            }
        };
        match next {
            Some(next) => (x, rest) = next,
            None => break,
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn principal_directions_are_eigenvectors() {
        for matrix in [
            [[3.0, 0.0], [0.0, 1.0]],
            [[1.0, 0.0], [0.0, 3.0]],
            [[2.0, 0.5], [0.5, 1.0]],
            [[1.0, -0.7], [-0.7, 2.0]],
        ] {
            let (along, values) = principal(matrix);
            let across = [-along[1], along[0]];
            for (direction, value) in [along, across].into_iter().zip(values) {
                let image = matrix.map(|row| dot(row, direction));
                let rest = map(image, direction, |image, x| image - value * x);
                assert!(length(rest) < 1e-14, "{matrix:?} {direction:?} {value}");
            }
            assert!(values[0] <= values[1]);
        }
    }
}
