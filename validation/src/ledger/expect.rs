//! The expectations of a reading.

use super::over::over;
use super::{Demand, Expect};
use slipgap_problem::problem::numbers::parameter::{Range, shortest};
use slipgap_study::Filter;
use slipgap_study::faults::Faults;
use slipgap_study::object::Object;
use slipgap_study::reduced;
use slipgap_study::scope::Scope;
use slipgap_study::tree::Node;
use slipgap_study::value::{name, number};

const EXPECT: [&str; 15] = [
    "metric", "profile", "later", "where", "over", "min", "max", "share", "along", "trend",
    "least_at", "times", "away", "flights", "//",
];

/// Longest free motion before a later event, in the problem's unit of time.
const LONGEST: f64 = 100.0;

/// Decodes one expectation; `columns` are the metrics that the study has.
pub(super) fn expect(
    node: &Node,
    path: &str,
    scope: &Scope,
    columns: &[usize],
    faults: &mut Faults,
) -> Option<Expect> {
    let before = faults.count();
    let object = Object::of_keys(node, path, &EXPECT, faults)?;
    let filter = match object.get("where") {
        Some(node) => scope.filter(node, &object.path("where"), faults),
        None => Some(Filter::default()),
    };
    let subject = match ["metric", "profile", "later"].map(|key| object.get(key)) {
        [Some(node), None, None] => {
            let metrics = scope.metrics();
            let row = name(node, &object.path("metric"), "metric", &metrics, faults)?;
            let reduced = scope.measures[row].reduction.is_some();
            if !columns.contains(&row) && !reduced {
                faults.add(
                    node.at,
                    &object.path("metric"),
                    "the study does not compute this metric",
                );
            }
            Subject::Metric(row)
        }
        [None, Some(node), None] => {
            let path = object.path("profile");
            Subject::Profile(name(node, &path, "profile", &scope.profiles(), faults)?)
        }
        [None, None, Some(node)] => {
            let path = object.path("later");
            Subject::Later(name(node, &path, "later event", &scope.later(), faults)?)
        }
        [None, None, None]
        | [Some(_), Some(_), _]
        | [Some(_), _, Some(_)]
        | [_, Some(_), Some(_)] => {
            object.fault("needs a \"metric\", a \"profile\" or a \"later\"", faults);
            return None;
        }
    };
    let over = match (object.get("over"), &subject) {
        (Some(node), Subject::Metric(row)) => {
            let path = object.path("over");
            let over = over(node, &path, filter.as_ref()?, scope, faults)?;
            let reduction = scope.measures[*row].reduction.as_ref();
            let hidden = reduction.and_then(|reduction| {
                let mut rows = over.filter.0.iter().map(|(row, _)| *row);
                rows.find_map(|row| {
                    reduced::hidden(reduction, row, scope.cases(&over.filter), scope)
                })
            });
            if let Some(message) = hidden {
                faults.add(node.at, &path, message);
                return None;
            }
            Some(over)
        }
        (Some(node), Subject::Profile(_) | Subject::Later(_)) => {
            let message = "needs a \"metric\"; a profile and a later event have no \"over\"";
            faults.add(node.at, &object.path("over"), message);
            return None;
        }
        (None, _) => None,
    };
    let mut limit = |key: &str| {
        let node = object.get(key)?;
        number(node, &object.path(key), Range::Any, faults)
    };
    let (min, max, away) = (limit("min"), limit("max"), limit("away"));
    if let (Some(min), Some(max)) = (min, max)
        && min > max
    {
        let message = format!("must be >= min = {}, got {}", shortest(min), shortest(max));
        let at = object.get("max").map_or(node.at, |node| node.at);
        faults.add(at, &object.path("max"), message);
    }
    let share = object.get("share").and_then(|node| {
        let path = object.path("share");
        let share = number(node, &path, Range::Positive, faults)?;
        if share > 1.0 {
            faults.must_be(node, &path, "at most 1");
        } else if !matches!(subject, Subject::Metric(_)) || object.get("along").is_some() {
            faults.add(
                node.at,
                &path,
                "is for a \"metric\" with \"min\" or \"max\"",
            );
        }
        Some(share)
    });
    let along = object.get("along").and_then(|node| {
        name(
            node,
            &object.path("along"),
            "parameter",
            &scope.parameters(),
            faults,
        )
    });
    let demand = match subject {
        Subject::Profile(profile) => {
            let times = object.items("times", faults, |node, path, faults| {
                number(node, path, Range::NotNegative, faults)
            });
            let (Some(away), Some(max), false) = (away, max, times.is_empty()) else {
                object.fault("a profile needs \"times\", \"away\" and \"max\"", faults);
                return None;
            };
            Demand::AwayFromFronts {
                profile,
                times,
                away,
                max,
            }
        }
        Subject::Later(later) => {
            let flights = object.items("flights", faults, |node, path, faults| {
                let flight = number(node, path, Range::Positive, faults)?;
                if flight > LONGEST {
                    faults.must_be(node, path, &format!("at most {LONGEST}"));
                }
                Some(flight)
            });
            if flights.is_empty() || (min, max) == (None, None) {
                let message = "\"later\" needs \"flights\" with \"min\", \"max\" or both";
                object.fault(message, faults);
                return None;
            }
            Demand::LaterEvent {
                later,
                flights,
                min,
                max,
            }
        }
        Subject::Metric(metric) => match along {
            Some(along) => sequence(&object, metric, along, filter.as_ref()?, scope, faults)?,
            None if min.is_some() || max.is_some() => Demand::Within {
                metric,
                min,
                max,
                share,
            },
            None => {
                object.fault("needs \"min\", \"max\" or both, or \"along\"", faults);
                return None;
            }
        },
    };
    (faults.count() == before).then_some(Expect {
        filter: filter?,
        over,
        demand,
    })
}

/// The quantity of an expectation, by its row.
enum Subject {
    Metric(usize),
    Profile(usize),
    Later(usize),
}

/// A demand along a parameter. Each of its values must have one case.
fn sequence(
    object: &Object,
    metric: usize,
    along: usize,
    filter: &Filter,
    scope: &Scope,
    faults: &mut Faults,
) -> Option<Demand> {
    let reduction = scope.measures[metric].reduction.as_ref();
    if let Some(message) =
        reduction.and_then(|r| reduced::hidden(r, along, scope.cases(filter), scope))
    {
        object.fault(message, faults);
        return None;
    }
    let cases = reduced::one_of_each(reduction, scope.cases(filter)).count();
    if cases != scope.levels(filter, along).len() || cases < 2 {
        let name = &scope.problem.parameters()[along].name;
        let message = format!("\"along\" needs one case for each {name}, but {cases} are chosen");
        object.fault(message, faults);
        return None;
    }
    match (object.get("trend"), object.get("least_at")) {
        (Some(node), None) => {
            let trends = ["rising", "falling"];
            let row = name(node, &object.path("trend"), "trend", &trends, faults)?;
            Some(Demand::Trend {
                metric,
                along,
                rising: row == 0,
            })
        }
        (None, Some(_)) => {
            let range = object.items("least_at", faults, |node, path, faults| {
                number(node, path, Range::Any, faults)
            });
            match range[..] {
                [a, b] if a <= b => Some(Demand::LeastAt {
                    metric,
                    along,
                    range: [a, b],
                }),
                _ => {
                    object.fault("\"least_at\" needs [from, to]", faults);
                    None
                }
            }
        }
        (None, None) | (Some(_), Some(_)) => {
            object.fault("\"along\" needs a \"trend\" or \"least_at\"", faults);
            None
        }
    }
}
