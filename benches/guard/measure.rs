//! Numbers that the table of `make peers` needs besides the times of whole runs.

use slipgap::lane::Lane;
use slipgap::study::read;
use slipgap::system::import::Matrix;
use slipgap::system::structure::Symmetric;
use slipgap::system::structure::sparse::factor::Factor;
use slipgap_contact::for_widest;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// Turns, of which the shortest counts: other programs only make one longer.
const TURNS: usize = 5;

/// Shortest seconds of some turns.
fn shortest(mut work: impl FnMut()) -> f64 {
    let mut turn = || {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    (0..TURNS).map(|_| turn()).fold(f64::INFINITY, f64::min)
}

/// Prints the seconds of all cases of a study in memory, on one thread and without files.
pub fn kernel(file: &str) {
    slipgap::batch::keep_memory();
    let study = read(Path::new(file)).expect("a study without faults");
    let (_, cases) = study.columns(0, study.raw_len());
    let rows: Vec<u32> = (0..cases.len() as u32).collect();
    println!(
        "{}",
        shortest(|| drop(black_box(study.problem.sweep(&cases, &rows))))
    );
}

/// Independent sums, enough for the units of the processor, and additions to each one.
const SUMS: usize = 8;
const ADDITIONS: usize = 1_000_000;

for_widest! {
    fn add(sums: &mut [Lane<8>; SUMS], term: Lane<8>) {
        let [mut a, mut b, mut c, mut d, mut e, mut f, mut g, mut h] = *sums;
        for _ in 0..ADDITIONS {
            (a, b, c, d) = (a + term, b + term, c + term, d + term);
            (e, f, g, h) = (e + term, f + term, g + term, h + term);
        }
        *sums = [a, b, c, d, e, f, g, h];
    }
}

for_widest! {
    fn sum(numbers: &[f64]) -> Lane<8> {
        let mut sums = [Lane::splat(0.0); SUMS];
        for rows in numbers.as_chunks::<64>().0 {
            for (sum, row) in sums.iter_mut().zip(rows.as_chunks::<8>().0) {
                *sum = *sum + Lane(*row);
            }
        }
        sums.into_iter().fold(Lane::splat(0.0), |a, b| a + b)
    }
}

/// Bytes that are read in a turn at least.
const READ: usize = 1 << 28;

/// Prints the largest rate of additions in 1/ns, and for each number of bytes the rate of reading that many again and again, in
/// bytes a ns: that of the smallest cache which they fit in.
pub fn rates(sizes: &[String]) {
    let mut sums = [Lane::splat(1.0); SUMS];
    let seconds = shortest(|| add(&mut sums, black_box(Lane::splat(1e-9))));
    println!("{}", (SUMS * 8 * ADDITIONS) as f64 / seconds / 1e9);
    black_box(sums);
    for size in sizes {
        let bytes: usize = size.parse().expect("a number of bytes");
        let numbers = vec![1.0; bytes / 8];
        let times = READ.div_ceil(bytes);
        let seconds = shortest(|| {
            for _ in 0..times {
                black_box(sum(black_box(&numbers)));
            }
        });
        println!("{}", (times * bytes) as f64 / seconds / 1e9);
    }
}

/// Prints for the files of M and K and a time step the entries of K below its diagonal, those of the factor of a step, and the
/// bytes of the factor.
pub fn factor(files: [&str; 2], dt: &str) {
    let matrix = |file: &str| {
        let bytes = std::fs::read(file).expect("a file");
        let matrix = Matrix::parse(&bytes).expect("a matrix");
        matrix.matrix.packed(|value| value != 0.0)
    };
    let [mass, stiffness] = files.map(matrix);
    let dt: f64 = dt.parse().expect("a number");
    let mut step = Symmetric::zeros(mass.size());
    step.add_matrix(&mass, 1.0 / (dt * dt));
    step.add_matrix(&stiffness, 0.25);
    let late = vec![false; mass.size()];
    let factor = Factor::new(step, &late).expect("a positive definite matrix");
    let below = stiffness.entries().filter(|((i, j), _)| i != j).count();
    println!("{below} {} {}", factor.entries(), factor.bytes());
}
