//! Motions of structures as recorded quantities: by time steps, many side by side, and exact.

use super::observer::Observer;
use super::recorded::{Energies, Recorded};
use crate::lane::Lane;
use crate::methods::Method;
use crate::problem::structure::channels::channel::{Number, Quantity};
use crate::solve::Unsolvable;
use crate::solve::structure::{Books, ContactStep, Prepared, State, Watch, Watched, run, settle};
use crate::system::structure::Structure;

/// Cases side by side.
pub const LANES: usize = 16;

/// Fewer cases side by side, as the motions of one structure often are.
pub const FEW: usize = 8;

/// What is recorded of a run.
#[derive(Debug, Clone, Copy)]
pub struct Recording<'a> {
    /// Number of steps N.
    pub last: u64,
    /// The quantities.
    pub numbers: &'a [Number],
    /// Whether the energy books are kept.
    pub energy: bool,
    /// Whether the contacts are watched for warnings, and every how many steps the energy is looked at.
    pub watch: Option<usize>,
}

/// A run: its quantities, its energies if the books are kept, and what its contacts show if they are watched; or why it failed.
pub type Run = Result<(Recorded, Option<Energies>, Option<Watched>), Unsolvable>;

/// The linear part of a structure with steps of `dt` by a method.
pub fn prepare(structure: &Structure, method: &Method, dt: f64) -> Result<Prepared, Unsolvable> {
    Prepared::by(method, structure, dt)
}

/// The motions of L structures with the same linear part by time steps.
pub fn steps<const L: usize>(
    structures: &[&Structure; L],
    prepared: &Prepared,
    recording: Recording,
) -> [Run; L] {
    steps_every(structures, prepared, recording, 1)
}

/// The same, with the quantities of every so many steps.
pub fn steps_every<const L: usize>(
    structures: &[&Structure; L],
    prepared: &Prepared,
    recording: Recording,
    every: usize,
) -> [Run; L] {
    let Recording {
        last,
        numbers,
        energy,
        watch: looks,
    } = recording;
    let count = last as usize / every + 1;
    let mut table = Table::new(numbers.len(), count);
    let mut books: Option<Books<L>> = None;
    let mut observer = match Observer::new(structures, numbers, prepared.dt(), last as usize) {
        Ok(observer) => observer,
        Err(why) => return why.map(Err),
    };
    let mut watch: Option<Watch<L>> = None;
    let ends = run(
        structures,
        prepared,
        last as usize,
        |step, state: &State<L>| {
            let row = table.row(numbers.iter().map(|number| value(state, *number)));
            if let Some(observer) = &mut observer {
                observer.fill(step, state, row);
            }
            if step.is_multiple_of(every) {
                table.keep();
            }
            match &mut books {
                Some(books) => books.add(state),
                None if energy && step == 0 => books = Some(Books::new(state)),
                None => {}
            }
            match (&mut watch, looks) {
                (Some(watch), _) => watch.add(state),
                (None, Some(looks)) => watch = Some(Watch::new(structures, state, looks)),
                (None, None) => {}
            }
        },
    );
    let energies = books.map(|books| [books.energy_error().0, books.relative_dissipation().0]);
    let mut series = table.series();
    let mut ends = ends.into_iter().enumerate();
    std::array::from_fn(|_| {
        let (l, end) = ends.next().unwrap_or((0, Ok(())));
        end?;
        let of_lane = |series: &mut [Vec<f64>; L]| std::mem::take(&mut series[l]);
        let taken = series.iter_mut().map(of_lane).collect();
        let recorded = Recorded::new(numbers, taken, count);
        let energies = energies.as_ref().map(|[error, dissipation]| Energies {
            error: error[l],
            dissipation: dissipation[l],
        });
        let watched = watch.as_ref().map(|watch| watch.of_lane(l));
        Ok((recorded, energies, watched))
    })
}

/// Quantities in all lanes at the steps, which become a list for each lane.
struct Table<const L: usize> {
    /// The last rows. All lanes of a number are next to one another: one store for each number and step.
    rows: Vec<Lane<L>>,
    /// Rows that are kept of them.
    kept: usize,
    /// Of each number, a list for each lane.
    series: Vec<[Vec<f64>; L]>,
}

/// Rows that are copied at a time: they fit in the fastest memory.
const BLOCK: usize = 16;

impl<const L: usize> Table<L> {
    /// For as many numbers, at as many steps.
    fn new(numbers: usize, count: usize) -> Self {
        let list = |_| std::array::from_fn(|_| Vec::with_capacity(count));
        Table {
            rows: vec![Lane::splat(0.0); numbers * BLOCK],
            kept: 0,
            series: (0..numbers).map(list).collect(),
        }
    }

    /// The row of a step, in the place of one that was not kept.
    #[inline(always)]
    fn row(&mut self, values: impl Iterator<Item = Lane<L>>) -> &mut [Lane<L>] {
        let (numbers, from) = (self.series.len(), self.kept * self.series.len());
        let row = &mut self.rows[from..from + numbers];
        for (at, value) in row.iter_mut().zip(values) {
            *at = value;
        }
        row
    }

    /// Keeps the row.
    #[inline(always)]
    fn keep(&mut self) {
        self.kept += 1;
        if self.kept == BLOCK {
            self.copy();
        }
    }

    /// Copies the rows that are kept into the lists.
    fn copy(&mut self) {
        let numbers = self.series.len();
        let kept = std::mem::take(&mut self.kept);
        for (number, lists) in self.series.iter_mut().enumerate() {
            for (l, list) in lists.iter_mut().enumerate() {
                let rows = self.rows.chunks_exact(numbers).take(kept);
                list.extend(rows.map(|row| row[number].0[l]));
            }
        }
    }

    /// Of each number, a list for each lane.
    fn series(mut self) -> Vec<[Vec<f64>; L]> {
        self.copy();
        self.series
    }
}

/// A quantity in all lanes.
#[inline(always)]
pub(super) fn value<const L: usize>(state: &State<L>, number: Number) -> Lane<L> {
    match number {
        Number::Displacement(node) => state.displacement(node),
        Number::Velocity(node) => state.velocity(node),
        Number::Acceleration(support) => state.support_acceleration(support),
        // The observer writes it.
        Number::Derived(_) | Number::Energy(_) => Lane::splat(0.0),
        Number::Contact(contact, quantity) => match quantity.of_direction() {
            None => of_contact(&state.contact(contact), quantity),
            Some(component) => {
                let of = |contact| of_contact(&state.contact(contact), component);
                of(contact).zip(of(contact + 1), libm::hypot)
            }
        },
    }
}

/// A quantity of a contact in all lanes.
#[inline(always)]
fn of_contact<const L: usize>(contact: &ContactStep<L>, quantity: Quantity) -> Lane<L> {
    match quantity {
        Quantity::Displacement | Quantity::Distance => contact.displacement,
        Quantity::Velocity | Quantity::Speed => contact.velocity,
        Quantity::Force | Quantity::Size => contact.force,
        Quantity::Slip | Quantity::SlipDistance => contact.slip,
        Quantity::Limit => contact.limit,
    }
}

/// The same structure with rigid laws: impacts without compliance, with the restitution of the law, which is 1 without damping, and
/// Coulomb friction with the limit of the law; of a coefficient that depends on velocity, the largest or the kinetic one. Links and
/// laws without a rigid form stay. Static loads find their equilibrium anew.
///
/// # Errors
/// The static loads have none.
pub fn rigid(structure: &Structure) -> Result<Structure, Unsolvable> {
    let mut rigid = structure.clone();
    for contact in &mut rigid.contacts {
        contact.law = contact.law.clone().rigid_form();
    }
    rigid.preload.forces.clear();
    rigid.preload.laws.clear();
    rigid.preload.planes.clear();
    if !structure.preload.load.is_empty() {
        rigid.displacement.fill(0.0);
        settle(&mut rigid)?;
    }
    Ok(rigid)
}

/// The relative difference of start and loads for `divergence`.
const DIFFERENCE: f64 = 1e-10;

/// The same structure with start and loads that are 1e-10 larger.
pub fn perturbed(structure: &Structure) -> Structure {
    let mut other = structure.clone();
    let larger = |x: &mut f64| *x *= 1.0 + DIFFERENCE;
    other.displacement.iter_mut().for_each(larger);
    other.velocity.iter_mut().for_each(larger);
    for support in &mut other.supports {
        let moved = support.gaps.iter_mut().chain(&mut support.carried);
        moved.for_each(larger);
    }
    if let Some(observed) = &mut other.observed {
        observed
            .ground
            .iter_mut()
            .for_each(|motion| larger(&mut motion.scale));
    }
    for load in &mut other.loads {
        load.pattern.iter_mut().for_each(|(_, x)| larger(x));
    }
    other
}

/// Steps from one look at the energy to the next: it takes about as long as a step.
pub const EVERY: usize = 16;
