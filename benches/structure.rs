//! The speed of steps of structures with many contacts: three girders on piers with two gaps and three bearings, one case at a time
//! and in lanes that share the factor of Khat. The time of a step grows with the number of nodes only.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use slipgap::contact::ClippedLine;
use slipgap::solve::structure::{Books, Prepared, State, run};
use slipgap::system::structure::{
    Contact, Limit, Load, Node, Signal, Structure, StructureLaw, Symmetric, Table,
};
use std::f64::consts::PI;
use std::hint::black_box;
use std::sync::Arc;

const STEPS: usize = 4000;
const DT: f64 = 0.001;

/// Girders of `n` elements with impact springs of `gamma` times the stiffness of an element, on a ground of `scale` times the signal.
fn girders(n: usize, gamma: f64, scale: f64, ground: &Arc<Signal>) -> Structure {
    let size = 3 * (n + 2);
    let (mut k, mut c) = (Symmetric::zeros(size), Symmetric::zeros(size));
    let mut nodes = Vec::new();
    let element = 1.5e8 * n as f64 / 40.0;
    for period in [1.0, 0.7, 1.2] {
        let (pier, omega) = (nodes.len(), 2.0 * PI / period);
        k.add_spring([None, Some(pier)], 600.0 * omega * omega);
        c.add_spring([None, Some(pier)], 2.0 * 0.05 * omega * 600.0);
        k.add_spring([Some(pier), Some(pier + 1)], 2e6);
        let mut add = |mass| {
            let name = nodes.len().to_string();
            nodes.push(Node {
                name,
                mass,
                direction: Default::default(),
            });
        };
        add(100.0);
        for i in 0..=n {
            add(500.0 / n as f64 * if i == 0 || i == n { 0.5 } else { 1.0 });
        }
        for i in pier + 1..=pier + n {
            k.add_spring([Some(i), Some(i + 1)], element);
            c.add_spring([Some(i), Some(i + 1)], 1.5e-4 * element);
        }
    }
    let [pier, left, right] = [0, 1, n + 1].map(|node| move |girder| Some(girder * (n + 2) + node));
    let contact = |between, gap, law| Contact {
        name: "contact".to_string(),
        along: slipgap_system::system::structure::between(between),
        gap,
        law,
    };
    let impact = |i| {
        let stiffness = gamma * element;
        let law = StructureLaw::new(ClippedLine::Spring { stiffness }, None);
        contact([right(i), left(i + 1)], 0.02, law)
    };
    let bearing = |i, j| {
        let limit = Limit::constant(245.0);
        let stiffness = 245.0 / 0.0005;
        contact(
            [i, j],
            0.0,
            StructureLaw::new(ClippedLine::Elastic { stiffness }, limit),
        )
    };
    let masses = nodes.iter().map(|node| node.mass).enumerate();
    let pattern = masses.map(|(i, mass)| (i, -mass * scale)).collect();
    let mut structure = Structure::new(nodes);
    structure.loads = vec![Load {
        pattern,
        signal: ground.clone(),
    }];
    structure.stiffness = k;
    structure.damping = c;
    structure.contacts = vec![
        impact(0),
        impact(1),
        bearing(pier(1), right(0)),
        bearing(pier(2), right(1)),
        bearing(None, right(2)),
    ];
    structure
}

/// Sines of many frequencies, with values up to some 3 m/s2.
fn ground() -> Arc<Signal> {
    let times: Vec<f64> = (0..=2000).map(|i| f64::from(i) * 0.01).collect();
    let wave = |t: f64, k: f64| libm::sin(2.0 * PI * (0.2 + 0.15 * k) * t + k * k);
    let value = |t: &f64| (0..40).map(|k| 0.3 * wave(*t, f64::from(k))).sum();
    let values = times.iter().map(value).collect();
    Arc::new(Signal::Table(
        Table::new(times, values).expect("times that rise"),
    ))
}

fn steps<const L: usize>(
    prepared: &Prepared,
    cases: &[Structure; L],
    visit: impl FnMut(usize, &State<L>),
) {
    let cases = std::array::from_fn(|l| &cases[l]);
    let done = run::<L>(&cases, prepared, STEPS, visit);
    assert!(done.iter().all(Result::is_ok));
}

/// L cases with different springs and scales.
fn lanes<const L: usize>(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group(format!("girders in {L} lanes"));
    group.sample_size(10);
    group.throughput(Throughput::Elements((STEPS * L) as u64));
    let ground = ground();
    for n in [1, 10, 20, 40] {
        let case = |l| {
            let part = l as f64 / L as f64;
            girders(n, 0.25 + 3.0 * part, 0.5 + part, &ground)
        };
        let cases: [Structure; L] = std::array::from_fn(case);
        let prepared = Prepared::new(&cases[0], DT).expect("a positive definite matrix");
        group.bench_function(BenchmarkId::new("steps", 3 * (n + 2)), |bencher| {
            bencher.iter(|| {
                let look = |_: usize, state: &State<L>| {
                    black_box(state.contact(0));
                };
                steps(&prepared, &cases, look);
            });
        });
        group.bench_function(
            BenchmarkId::new("steps and books", 3 * (n + 2)),
            |bencher| {
                bencher.iter(|| {
                    let mut books: Option<Books<L>> = None;
                    let add = |_: usize, state: &State<L>| match &mut books {
                        Some(books) => books.add(state),
                        None => books = Some(Books::new(state)),
                    };
                    steps(&prepared, &cases, add);
                    black_box(books);
                });
            },
        );
    }
    group.finish();
}

criterion_group!(benches, lanes::<1>, lanes::<8>, lanes::<16>);
criterion_main!(benches);
