//! The modes of a structure as coordinates: unit masses, K diagonal, C diagonal for damping by modes or by M and K.

mod condense;
mod refine;

use super::flexible::Flexible;
use super::model::{Bounds, MANY, MOST_MODES, Model};
use super::modes::Modes;
use super::pressed::Pressed;
use crate::contact::ClippedLine;
use crate::exact::events::EventsFault;
use crate::exact::events::numerics::matrix::Matrix;
use crate::exact::events::numerics::row::{LANES, Row, dot, sum};
use crate::exact::events::numerics::signals;
use crate::exact::events::numerics::sparse::Rows;
use crate::system::structure::{Contact, Structure, StructureLaw, Symmetric};
use condense::{Condensed, entries};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use std::borrow::Cow;

/// Damping between two modes over that of both is round-off below this.
const COUPLED: f64 = 1e-11;

/// Squares of frequencies below this part of the largest are those of rigid bodies.
const RIGID_BODY: f64 = 1e-10;

/// Most iterations of the eigensolver for each mode; it needs about two.
const ITERATIONS: usize = 100;

impl<'a> Model<'a> {
    /// Prepares a structure.
    pub fn new(structure: &'a Structure) -> Result<Model<'a>, EventsFault> {
        match uses_modes(structure) {
            true => model(structure),
            false => Ok(Model::of_nodes(structure)),
        }
    }
}

impl Modes {
    /// w^2 of a mode: x^T K x over x^T M x.
    fn square(&self, structure: &Structure, mode: usize) -> f64 {
        let x: Vec<f64> = self.shapes.iter().map(|shape| shape[mode]).collect();
        let masses = structure.nodes.iter().zip(&x);
        let mass: f64 = masses.map(|(node, x)| node.mass * x * x).sum();
        refine::form(structure.stiffness.entries(), &x)
            / (mass + refine::form(structure.coupled_mass.entries(), &x))
    }

    /// With modes without motion at the end.
    fn padded(mut self, count: usize) -> Modes {
        for shape in &mut self.shapes {
            shape.resize(count, 0.0);
        }
        self
    }
}

/// A structure in coordinates of its modes.
pub fn model(structure: &Structure) -> Result<Model<'_>, EventsFault> {
    if structure.len() > MOST_MODES {
        return Err(EventsFault::TooManyModes { most: MOST_MODES });
    }
    let condensed = Condensed::new(structure)?;
    if condensed.kept.is_empty() {
        return Err(EventsFault::Mass);
    }
    let mass = structure.mass().block(&condensed.kept).full();
    let not_positive = EventsFault::Mass;
    let lower = match structure.coupled_mass.is_empty() {
        true => DMatrix::from_diagonal(&mass.diagonal().map(f64::sqrt)),
        false => mass
            .clone()
            .cholesky()
            .ok_or(not_positive.clone())?
            .unpack(),
    };
    let shared = |i: usize| {
        let flexible = condensed.flexible.as_ref();
        let has_two = structure.contacts[i].law.static_ratio() > 1.0;
        flexible.is_some_and(|flexible| has_two && flexible.is_shared(i))
    };
    if let Some(contact) = (0..structure.contacts.len()).find(|i| shared(*i)) {
        let contact = structure.contacts[contact].name.clone();
        return Err(EventsFault::SharedJump { contact });
    }
    let standard = scaled(&lower, &condensed.stiffness).ok_or(not_positive.clone())?;
    // Numbers that are not finite would not end.
    let eigen = SymmetricEigen::try_new(standard, f64::EPSILON, ITERATIONS * condensed.kept.len())
        .ok_or(not_positive.clone())?;
    let n = condensed.kept.len();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|i, j| eigen.eigenvalues[*i].total_cmp(&eigen.eigenvalues[*j]));
    let mut shapes = DMatrix::zeros(n, n);
    for (column, i) in order.iter().enumerate() {
        shapes.set_column(column, &eigen.eigenvectors.column(*i));
    }
    if !lower.tr_solve_lower_triangular_mut(&mut shapes) {
        return Err(not_positive);
    }
    let modes = condensed.modes(structure, &shapes);
    let mut squares: Vec<f64> = (0..n).map(|mode| modes.square(structure, mode)).collect();
    let fastest = squares.iter().fold(0.0, |most: f64, w2| most.max(w2.abs()));
    for w2 in &mut squares {
        // Round-off of a mode of a rigid body is below 0, a negative stiffness is further below.
        if *w2 < 0.0 && *w2 > -RIGID_BODY * fastest {
            *w2 = 0.0;
        }
    }
    // Modes without motion, so that loops over vectors of modes have no rest.
    let count = n.next_multiple_of(LANES);
    squares.resize(count, 0.0);
    let shapes = shapes.resize_horizontally(count, 0.0);
    let damping = damping(structure, &condensed, &shapes, &squares);
    let columns: Vec<Row> = condensed
        .columns
        .iter()
        .map(|b| Row::Dense(project(&shapes, b)))
        .collect();
    let start = [&structure.displacement, &structure.velocity].map(|x| {
        let kept = DVector::from_iterator(n, condensed.kept.iter().map(|node| x[*node]));
        project(&shapes, &product(&mass, &kept))
    });
    if condensed.flexible.is_some() && !structure.supports.is_empty() {
        return Err(EventsFault::MasslessSupports);
    }
    // Springs at nodes without mass are refused.
    let pressed = Pressed::of(structure, |along| {
        let mut row = DVector::zeros(n);
        for (node, factor) in along {
            if let Some(place) = condensed.places[*node] {
                row[place] += factor;
            }
        }
        Row::Dense(project(&shapes, &row))
    });
    let couplings = columns
        .iter()
        .flat_map(|a| columns.iter().map(|b| a.form(&vec![1.0; count], b).abs()));
    let largest_damping = match &damping {
        Matrix::Diagonal(diagonal) => diagonal.iter().copied().fold(0.0, f64::max),
        Matrix::Dense(rows) => rows
            .chunks(count)
            .map(|row| row.iter().map(|x| x.abs()).sum())
            .fold(0.0, f64::max),
        Matrix::Sparse(_) => 0.0,
    };
    Ok(Model {
        bounds: Bounds::Modes {
            largest: [fastest, largest_damping],
            couplings: couplings.collect(),
        },
        inverse_masses: vec![1.0; count],
        stiffness: Matrix::Diagonal(squares),
        damping,
        contacts: Cow::Owned(laws(structure, condensed.flexible.as_ref())),
        columns,
        patterns: condensed
            .patterns
            .iter()
            .map(|p| Row::Dense(project(&shapes, p)))
            .collect(),
        start,
        modes: Some(modes.padded(count)),
        flexible: condensed.flexible,
        pressed,
        points: signals::points(structure),
        fastest_load: signals::fastest(structure),
        structure,
    })
}

/// Whether damping couples no modes of a structure with lumped masses: C M^-1 K is symmetric. Two vectors without any symmetry
/// show it.
pub fn is_classical(structure: &Structure) -> bool {
    let masses = structure.nodes.iter().map(|node| node.mass);
    let mut products = [Vec::new(), Vec::new()];
    let vectors = [0.618_033_988_749_894_9, 0.414_213_562_373_095_1].map(|step| {
        (1..=structure.len())
            .map(|i| (i as f64 * step).fract() - 0.4)
            .collect::<Vec<f64>>()
    });
    for (x, product) in vectors.iter().zip(&mut products) {
        let mut stiffness = vec![0.0; x.len()];
        structure.stiffness.add_product(x, &mut stiffness);
        let accelerations: Vec<f64> = stiffness
            .iter()
            .zip(masses.clone())
            .map(|(k, m)| k / m)
            .collect();
        *product = vec![0.0; x.len()];
        structure.damping.add_product(&accelerations, product);
    }
    let [left, right] = [
        dot(&vectors[0], &products[1]),
        dot(&vectors[1], &products[0]),
    ];
    let size = sum(&vectors[0], &products[1], |a, b| (a * b).abs());
    (left - right).abs() <= COUPLED * size
}

/// L^-1 K L^-T, symmetric; `None` if L is singular.
fn scaled(lower: &DMatrix<f64>, stiffness: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let mut half = stiffness.clone();
    lower.solve_lower_triangular_mut(&mut half).then_some(())?;
    let mut whole = half.transpose();
    lower.solve_lower_triangular_mut(&mut whole).then_some(())?;
    let n = whole.nrows();
    Some(DMatrix::from_fn(n, n, |i, j| {
        0.5 * (whole[(i, j)] + whole[(j, i)])
    }))
}

/// The columns of a matrix.
fn columns(matrix: &DMatrix<f64>) -> impl Iterator<Item = &[f64]> {
    matrix.as_slice().chunks_exact(matrix.nrows().max(1))
}

/// The products of all shapes with a vector.
fn project(shapes: &DMatrix<f64>, x: &DVector<f64>) -> Vec<f64> {
    columns(shapes)
        .map(|shape| dot(shape, x.as_slice()))
        .collect()
}

/// A symmetric matrix times a vector.
fn product(matrix: &DMatrix<f64>, x: &DVector<f64>) -> DVector<f64> {
    DVector::from_iterator(
        x.len(),
        columns(matrix).map(|column| dot(column, x.as_slice())),
    )
}

/// C between modes.
fn damping(
    structure: &Structure,
    condensed: &Condensed,
    shapes: &DMatrix<f64>,
    squares: &[f64],
) -> Matrix {
    let n = squares.len();
    if structure.damping.entries().all(|(_, value)| value == 0.0) {
        return Matrix::Sparse(Rows::new(&Symmetric::zeros(n)));
    }
    let rows = entries(&structure.damping, &condensed.places);
    let mut products = DMatrix::zeros(shapes.nrows(), n);
    for (shape, mut product) in shapes.column_iter().zip(products.column_iter_mut()) {
        for (i, j, value) in &rows {
            product[*i] += value * shape[*j];
        }
    }
    let mut modal = vec![0.0; n * n];
    for (i, shape) in columns(shapes).enumerate() {
        for (j, product) in columns(&products).enumerate().take(i + 1) {
            let value = dot(shape, product);
            (modal[i * n + j], modal[j * n + i]) = (value, value);
        }
    }
    let largest = (0..n).map(|i| modal[i * n + i]).fold(0.0, f64::max);
    let coupled = (0..n).any(|i| (0..i).any(|j| modal[i * n + j].abs() > COUPLED * largest));
    match coupled {
        true => Matrix::Dense(modal),
        false => Matrix::Diagonal((0..n).map(|i| modal[i * n + i].max(0.0)).collect()),
    }
}

/// The contacts with the laws that they have in series with nodes without mass: there, no contact is rigid, and none has impacts.
fn laws(structure: &Structure, flexible: Option<&Flexible>) -> Vec<Contact> {
    let mut contacts = structure.contacts.clone();
    for i in flexible.iter().flat_map(|flexible| &flexible.contacts) {
        let contact = &mut contacts[*i];
        let stiffness = f64::INFINITY;
        let line = match contact.law.line() {
            Some(ClippedLine::Stop { .. }) => ClippedLine::Spring { stiffness },
            Some(ClippedLine::Coulomb) => ClippedLine::Elastic { stiffness },
            _ => continue,
        };
        contact.law = StructureLaw::new(line, contact.law.limit().cloned());
    }
    contacts
}

/// Whether the coordinates of a structure are its modes. Damping that couples modes costs more than all products between nodes, so
/// that large structures with it, but lumped masses, stay with their nodes.
pub fn uses_modes(structure: &Structure) -> bool {
    let lumped =
        structure.coupled_mass.is_empty() && structure.nodes.iter().all(|node| node.mass > 0.0);
    !lumped || (MANY..=MOST_MODES).contains(&structure.len()) && is_classical(structure)
}
