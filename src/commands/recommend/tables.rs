//! The tables of an answer: errors of the candidates, their metrics, and the parameters for a study.

use crate::commands::terminal::table;
use crate::error::Error;
use crate::problem::Case;
use crate::problem::numbers::parameter::{Value, real, shortest};
use crate::recommend::format::digits;
use crate::recommend::{
    Answer, Candidate, LEAST_HALVINGS, Outcome, Refined, Request, Robustness, SearchSpace, Target,
    refine, with_finer_step,
};

/// A row of the table: a candidate, and why it is shown.
pub struct Row<'a> {
    pub name: &'static str,
    pub candidate: &'a Candidate,
}

/// The metrics of a case by row of the problem's table.
type Metrics = Vec<Option<f64>>;

/// A warning if there is one, the largest errors of each candidate and its neighbours, then the default metrics of each candidate alone.
pub fn answer(space: &dyn SearchSpace, request: &Request, rows: &[Row]) -> Result<String, Error> {
    let mut metrics = Vec::new();
    let parameters = shown(space, rows);
    let mut errors = vec![errors_header(space, request, &parameters)];
    for row in rows {
        let (cells, own) = errors_row(space, request, row, &parameters)?;
        errors.push(cells);
        metrics.push((row.name.to_owned(), own));
    }
    errors.push(targets_row(request, parameters.len()));
    let mut text = String::new();
    if let Some(first) = rows.first() {
        let problem = space.problem();
        let case = &first.candidate.cases[0];
        let refined = refined(space, request, first.candidate);
        match problem.solve(&with_finer_step(problem, case, refined.factor), &[]) {
            Ok(finer) => {
                text += &finer_step_warning(request, first.candidate, refined, &finer.metrics);
                let name = format!("the same, step/{}", refined.factor);
                metrics.insert(1, (name, finer.metrics));
            }
            Err(why) => {
                let factor = refined.factor;
                text += &format!("The case has no solution with 1/{factor} of the step: {why}.\n");
            }
        }
    }
    text += &table(&errors);
    let own = match parameters.contains(&"x0") {
        false => "the case",
        true => "the case at x0, the release with its largest error,",
    };
    text += &format!(
        "Each error above is the largest one of the case and its neighbours. Only metrics with a target are limited. Metrics of {own} alone:\n"
    );
    text += &metrics_table(space, &metrics);
    Ok(text)
}

/// The last of the finer steps of a candidate that reaches its targets, and what they show; a usual one for other candidates.
fn refined(space: &dyn SearchSpace, request: &Request, candidate: &Candidate) -> Refined {
    let usual = Refined {
        outcome: Outcome::Unsettled,
        factor: 1 << LEAST_HALVINGS,
    };
    if candidate.worst > 1.0 {
        return usual;
    }
    let cases = &candidate.cases[..1];
    let refined = refine(space.problem(), &request.targets, cases, &mut 0);
    refined.first().copied().unwrap_or(usual)
}

/// Over how much of a range the answer misses its targets.
pub fn robustness(request: &Request, found: &Robustness) -> String {
    let target = &request.targets[found.target];
    let part = match (
        found.missed,
        100.0 * found.missed as f64 / found.count as f64,
    ) {
        (0, _) => "none".to_owned(),
        (_, part) if part < 1.0 => format!("{} %", digits(part)),
        (_, part) => format!("{part:.0} %"),
    };
    let [first, last] = found.ends.map(digits);
    format!(
        "Of {} {} from {first} to {last}, {part} miss the target; the largest {} is {}, {} times the target, at {} = {}.\n",
        found.count,
        found.title,
        target.name,
        digits(found.error),
        digits(found.error / target.limit),
        found.parameter,
        digits(found.at)
    )
}

/// The parameters that apply to a row.
fn shown(space: &dyn SearchSpace, rows: &[Row]) -> Vec<&'static str> {
    let mut parameters = space.table_parameters();
    let cases = rows.iter().map(|row| &row.candidate.cases[0]);
    parameters.retain(|name| cases.clone().any(|case| case.get(name).is_some()));
    parameters
}

fn errors_header(space: &dyn SearchSpace, request: &Request, parameters: &[&str]) -> Vec<String> {
    let mut header = vec![String::new()];
    header.extend(parameters.iter().map(|name| (*name).to_owned()));
    header.push(space.cost_title().into());
    header.extend(request.targets.iter().map(|target| target.name.to_owned()));
    header.push("energy gain".into());
    let loss = request.energy_loss.is_finite();
    header.extend(loss.then(|| "energy loss".to_owned()));
    header.push("worst/target".into());
    header
}

/// The errors of a candidate, and the metrics of its case.
fn errors_row(
    space: &dyn SearchSpace,
    request: &Request,
    row: &Row,
    parameters: &[&str],
) -> Result<(Vec<String>, Metrics), Error> {
    let candidate = row.candidate;
    let case = &candidate.cases[0];
    let mut cells = vec![row.name.to_owned()];
    let parameters = parameters.iter();
    cells.extend(parameters.map(|name| space.table_cell(case, name)));
    cells.push(candidate.cost.to_string());
    cells.extend(candidate.errors.iter().map(|error| digits(*error)));
    let (mut gain, mut loss) = (0.0, 0.0);
    let mut metrics: Vec<Metrics> = Vec::new();
    for case in &candidate.cases {
        let solution = space
            .problem()
            .solve(case, &[])
            .map_err(|why| Error::Internal(why.to_string()))?;
        let change = space.energy_change(case, &solution);
        (gain, loss) = (f64::max(gain, change.gain), f64::max(loss, change.loss));
        metrics.push(solution.metrics);
    }
    cells.push(digits(gain));
    cells.extend(request.energy_loss.is_finite().then(|| digits(loss)));
    cells.push(digits(candidate.worst));
    Ok((cells, metrics.swap_remove(0)))
}

fn targets_row(request: &Request, parameters: usize) -> Vec<String> {
    let mut cells = vec!["target".to_owned()];
    cells.extend(vec![String::new(); parameters + 1]);
    let limits = request.targets.iter().map(|target| target.limit);
    let energies = [request.energy_gain, request.energy_loss];
    let limits = limits.chain(energies.into_iter().filter(|limit| limit.is_finite()));
    let limits = limits.chain([1.0]);
    cells.extend(limits.map(|limit| format!("<= {}", shortest(limit))));
    cells
}

/// The default metrics, one column for each case.
fn metrics_table(space: &dyn SearchSpace, cases: &[(String, Metrics)]) -> String {
    let mut rows = vec![vec![String::new()]];
    rows[0].extend(cases.iter().map(|(name, _)| name.clone()));
    let metrics = space.problem().metrics().iter().enumerate();
    for (i, metric) in metrics.filter(|(_, metric)| metric.default) {
        let mut cells = vec![metric.name.to_string()];
        let values = cases.iter().map(|(_, metrics)| metrics[i]);
        cells.extend(values.map(|value| value.map_or("undefined".into(), digits)));
        rows.push(cells);
    }
    table(&rows)
}

/// A warning if the candidate reaches its targets and does not with finer steps.
fn finer_step_warning(
    request: &Request,
    candidate: &Candidate,
    refined: Refined,
    finer: &Metrics,
) -> String {
    if candidate.worst > 1.0 || candidate.converged {
        return String::new();
    }
    let factor = refined.factor;
    let missed = |target: &&Target| target.error(finer) > target.limit;
    let missed = request.targets.iter().filter(missed);
    let missed: Vec<String> = missed
        .map(|t| {
            let error = digits(t.error(finer));
            format!("{} {error} > {}", t.name, shortest(t.limit))
        })
        .collect();
    let why = match refined.outcome {
        Outcome::Misses => format!(
            "With 1/{factor} of the step it misses the target: {}",
            missed.join(", ")
        ),
        Outcome::Unsettled => {
            format!("With 1/{factor} of the step its metrics still change")
        }
        Outcome::Holds => {
            "With finer steps it misses the target under another of its conditions".into()
        }
    };
    format!("Warning: this answer is valid only for its own time step. {why}.\n")
}

/// The parameters of a study with this case. Those with a point in their names are members of an object.
pub fn study_parameters(space: &dyn SearchSpace, case: &Case) -> String {
    let mut members = Vec::new();
    let mut objects: Vec<(&str, Vec<String>)> = Vec::new();
    for name in space.study_parameters() {
        let Some(value) = case.get(name) else {
            continue;
        };
        let text = space.study_value(case, name);
        if text == "-" {
            continue;
        }
        let text = match value {
            Value::Name(_) => format!("\"{text}\""),
            Value::Number(_) | Value::Whole(_) if text.contains(['/', '*']) => {
                format!("\"{text}\"")
            }
            Value::Number(_) | Value::Whole(_) => text,
        };
        let Some((object, key)) = name.split_once('.') else {
            members.push(format!("\"{name}\": {text}"));
            continue;
        };
        let member = format!("\"{key}\": {text}");
        match objects.iter_mut().find(|(name, _)| *name == object) {
            Some((_, members)) => members.push(member),
            None => objects.push((object, vec![member])),
        }
    }
    let objects = objects.into_iter();
    members.extend(objects.map(|(name, of)| format!("\"{name}\": {{ {} }}", of.join(", "))));
    format!("\"parameters\": {{ {} }}", members.join(", "))
}

/// front.csv: all candidates of the answer.
pub fn front(space: &dyn SearchSpace, request: &Request, answer: &Answer) -> String {
    let errors = request
        .targets
        .iter()
        .map(|target| target.name.replace(' ', "_"));
    let parameters = space.table_parameters();
    let mut header: Vec<String> = parameters.iter().map(|name| (*name).to_owned()).collect();
    header.push("cost".into());
    header.extend(errors);
    header.push("worst".into());
    let mut text = header.join(",") + "\n";
    for candidate in &answer.front {
        let value = |name: &&str| {
            let value = candidate.cases[0].get(name);
            value.map_or(String::new(), Value::cell)
        };
        let mut cells: Vec<String> = parameters.iter().map(value).collect();
        cells.push(candidate.cost.to_string());
        let errors = candidate.errors.iter().chain([&candidate.worst]);
        cells.extend(errors.map(|x| real(*x)));
        text += &(cells.join(",") + "\n");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::history::History;
    use crate::problem::friction::FrictionOscillator;
    use crate::problem::table::cases::Cases;
    use crate::problem::table::schema::Schema;
    use crate::problem::{Problem, Solution, Violation};
    use crate::recommend::friction::Friction;
    use crate::recommend::{CostLevel, EnergyChange, Fixed, Stop, metric};
    use crate::solve::{MetricTable, Unsolvable};
    use std::sync::Arc;

    /// Smallest step with a solution.
    const SMALLEST: f64 = 0.05;

    /// The friction oscillator without solutions for small steps.
    #[derive(Debug)]
    struct NoSmallSteps;

    impl Problem for NoSmallSteps {
        fn schema(&self) -> &Arc<Schema> {
            FrictionOscillator.schema()
        }

        fn complete(&self, case: &mut Case) -> Vec<Violation> {
            FrictionOscillator.complete(case)
        }

        fn solve(&self, case: &Case, wanted: &[usize]) -> Result<Solution, Unsolvable> {
            match case.at(self.schema().step) {
                Some(step) if step < SMALLEST => Err(Unsolvable::OutOfRange),
                _ => FrictionOscillator.solve(case, wanted),
            }
        }

        fn sweep(&self, cases: &Cases, rows: &[u32]) -> MetricTable {
            FrictionOscillator.sweep(cases, rows)
        }

        fn exact(&self, case: &Case, times: &[f64]) -> Option<History> {
            FrictionOscillator.exact(case, times)
        }
    }

    struct Space(Friction, &'static dyn Problem);

    impl SearchSpace for Space {
        fn problem(&self) -> &'static dyn Problem {
            self.1
        }

        fn table_parameters(&self) -> Vec<&'static str> {
            self.0.table_parameters()
        }

        fn study_parameters(&self) -> Vec<&str> {
            self.0.study_parameters()
        }

        fn study_value(&self, case: &Case, name: &str) -> String {
            self.0.study_value(case, name)
        }

        fn notes(&self) -> Vec<String> {
            self.0.notes()
        }

        fn cost_title(&self) -> &'static str {
            self.0.cost_title()
        }

        fn costs(&self) -> Vec<u64> {
            self.0.costs()
        }

        fn level(&self, index: usize) -> CostLevel {
            self.0.level(index)
        }

        fn energy_change(&self, case: &Case, solution: &Solution) -> EnergyChange {
            self.0.energy_change(case, solution)
        }
    }

    #[test]
    fn a_case_without_a_solution_at_the_finer_step_has_no_column() {
        let fixed = Fixed {
            law: Some("velocity-control"),
            method: Some("average-acceleration"),
        };
        let friction = || Friction::new(fixed, 12.0);
        // pi/10, whose 16th part is below the limit.
        let level = friction().level(8);
        let case = level.cases[40].clone();
        let candidate = Candidate {
            cases: vec![case],
            cost: 80,
            errors: vec![0.01],
            worst: 0.5,
            converged: true,
        };
        let request = Request {
            targets: vec![Target {
                name: "rms_error",
                metric: metric(&FrictionOscillator, "rms_error"),
                ideal: 0.0,
                limit: 0.02,
            }],
            energy_gain: 0.05,
            energy_loss: f64::INFINITY,
            stop: Stop::default(),
        };
        let text = |problem: &'static dyn Problem| {
            let row = Row {
                name: "recommended",
                candidate: &candidate,
            };
            answer(&Space(friction(), problem), &request, &[row]).unwrap()
        };
        let (with, without) = (text(&FrictionOscillator), text(&NoSmallSteps));
        let (_, factor) = with.split_once("the same, step/").unwrap();
        let factor = factor.split_whitespace().next().unwrap();
        let sentence = format!(
            "The case has no solution with 1/{factor} of the step: the motion leaves the range of double precision.\n"
        );
        let rest = without.strip_prefix(&sentence).unwrap();
        assert!(!rest.contains("the same, step/"), "{rest}");
        // The other columns are the same.
        for (line, other) in rest.lines().zip(with.lines()) {
            let cells = |line: &str| {
                line.split_whitespace()
                    .map(str::to_owned)
                    .collect::<Vec<_>>()
            };
            assert!(cells(other).starts_with(&cells(line)), "{line}\n{other}");
        }
    }
}
