//! Searches parameters for the smallest misfit, and how sharply the misfit determines them. It knows no studies: points have
//! coordinates from 0 to 1, and an objective computes many of them in one call.

/// The misfit to be minimised.
pub trait Objective {
    /// The misfit of each point; infinite if the point has no solution. NaN counts as infinite, too.
    ///
    /// # Errors
    /// The user ended the search.
    fn misfits(&mut self, points: &[Vec<f64>]) -> Result<Vec<f64>, Stopped>;
}

/// The user ended a search before its result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stopped;

/// The numbers of a search.
#[derive(Debug, Clone, Copy)]
pub struct Options {
    /// Seed of its random numbers.
    pub seed: u64,
    /// Most points that [`search`] computes.
    pub cases: u64,
}

/// The best point of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Best {
    /// Its coordinates; the middle of the ranges if no point has a solution.
    pub at: Vec<f64>,
    /// Its misfit; infinite if no point has a solution.
    pub misfit: f64,
    /// Number of points computed.
    pub solved: u64,
    /// Number of independent starts that ended at the best point, and of all that ended.
    pub starts: [usize; 2],
    /// Whether the search ended because all cases were spent.
    pub spent: bool,
}

/// How sharply the misfit determines the coordinates.
#[derive(Debug, Clone, PartialEq)]
pub struct Determined {
    /// The best point; better than that of the search if a profile found a smaller misfit. `solved` is that of the search.
    pub best: Best,
    /// For each coordinate.
    pub profiles: Vec<Profile>,
    /// Correlation of the coordinates from the curvature of the squared misfit; `None` if it has no minimum there.
    pub correlation: Option<Vec<Vec<f64>>>,
    /// The direction (of length 1) in which the squared misfit changes least, if it does not limit the coordinates within their ranges.
    pub undetermined: Option<Vec<f64>>,
    /// Whether the squared misfit is a quadratic function over the intervals: then intervals and correlation describe it well.
    pub quadratic: bool,
    /// Number of points computed in addition to those of the search.
    pub solved: u64,
}

/// The smallest misfit for values of one coordinate, over all values of the others.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// By coordinate.
    pub points: Vec<ProfilePoint>,
    /// Ends of the 95 % interval; `None` if the misfit has no probability.
    pub interval: Option<[End; 2]>,
    /// Ends of the range with misfits at most 10 % above the best.
    pub within_tenth: [End; 2],
}

/// A point of a profile.
#[derive(Debug, Clone, PartialEq)]
pub struct ProfilePoint {
    /// The coordinate.
    pub at: f64,
    /// The smallest misfit found there.
    pub misfit: f64,
    /// The other coordinates, in their order.
    pub others: Vec<f64>,
}

/// An end of a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// At this coordinate.
    At(f64),
    /// The end of the coordinate's range is still inside.
    Open,
}

/// Searches the smallest misfit over all points.
///
/// # Errors
/// The user ended the search.
pub fn search(
    dimensions: usize,
    objective: &mut dyn Objective,
    options: &Options,
) -> Result<Best, Stopped> {
    // A compass search from the middle.
    let mut at = vec![0.5; dimensions];
    let mut misfit = objective.misfits(&[at.clone()])?[0];
    let (mut solved, mut length) = (1, 0.25);
    while length > 1e-4 && solved + 2 * dimensions as u64 <= options.cases {
        let neighbours = compass(&at, length);
        let values = objective.misfits(&neighbours)?;
        solved += values.len() as u64;
        let best = (0..values.len()).min_by(|a, b| values[*a].total_cmp(&values[*b]));
        match best.filter(|i| values[*i] < misfit) {
            Some(i) => (at, misfit) = (neighbours[i].clone(), values[i]),
            None => length /= 2.0,
        }
    }
    Ok(Best {
        at,
        misfit,
        solved,
        starts: [1, 1],
        spent: length > 1e-4,
    })
}

fn compass(at: &[f64], length: f64) -> Vec<Vec<f64>> {
    let moved = |k: usize, d: f64| {
        let mut to = at.to_vec();
        to[k] = (to[k] + d).clamp(0.0, 1.0);
        to
    };
    let both = |k| [moved(k, -length), moved(k, length)];
    (0..at.len()).flat_map(both).collect()
}

/// Determines the profiles at the best point of a search. `residuals` is the effective number of independent residuals if the misfit is the
/// root of their mean square; otherwise there is no probability.
///
/// # Errors
/// The user ended it.
pub fn determine(
    best: &Best,
    objective: &mut dyn Objective,
    residuals: Option<f64>,
) -> Result<Determined, Stopped> {
    let (mut profiles, mut solved) = (Vec::new(), 0);
    for k in 0..best.at.len() {
        let others: Vec<f64> = (0..best.at.len())
            .filter(|i| *i != k)
            .map(|i| best.at[i])
            .collect();
        let values: Vec<f64> = (0..=20).map(|i| f64::from(i) / 20.0).collect();
        let at = |value: &f64| {
            let mut to = best.at.clone();
            to[k] = *value;
            to
        };
        let misfits = objective.misfits(&values.iter().map(at).collect::<Vec<_>>())?;
        solved += misfits.len() as u64;
        let point = |(at, misfit): (&f64, &f64)| ProfilePoint {
            at: *at,
            misfit: *misfit,
            others: others.clone(),
        };
        profiles.push(Profile {
            points: values.iter().zip(&misfits).map(point).collect(),
            interval: residuals.map(|_| [End::Open; 2]),
            within_tenth: [End::Open; 2],
        });
    }
    Ok(Determined {
        best: best.clone(),
        profiles,
        correlation: None,
        undetermined: None,
        quadratic: false,
        solved,
    })
}
