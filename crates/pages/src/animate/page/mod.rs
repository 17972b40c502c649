//! The page: its texts, its data and its program.

use super::film::short_numbers::digits;
use super::film::{Film, scene, thin, trace};
use super::unit;
use crate::report::text::{POLICY, escape};
use serde_json::{Value, json};
use slipgap_problem::problem::numbers::unit::Dimension;
use slipgap_problem::problem::structure::GroundMotion;
use slipgap_study::Study;
use slipgap_study::error::Error;

/// Largest size of a page in bytes.
pub const MOST_BYTES: usize = 3_000_000;

/// Bytes of it for the films.
const OF_FILMS: usize = 2_600_000;

/// Most frames of a film.
const FRAMES: usize = 6000;

/// Largest displacement on the page, in points of the picture, if parts have room.
const AMPLITUDE: f64 = 30.0;

const HTML: &str = include_str!("page.html");
const CSS: &str = include_str!("page.css");
/// In this order.
const PROGRAM: [&str; 3] = [
    include_str!("data.js"),
    include_str!("draw.js"),
    include_str!("page.js"),
];

/// The page with these films. `name` is that of the study, `head` what all films have in common.
pub fn page(
    study: &Study,
    (name, head): (&str, &str),
    films: &[Film],
    ground: Option<&GroundMotion>,
) -> Result<String, Error> {
    let title = match study.title.is_empty() {
        true => name.to_owned(),
        false => study.title.clone(),
    };
    let largest = films.iter().map(Film::largest).fold(0.0, f64::max);
    let most = if largest > 0.0 {
        AMPLITUDE / largest
    } else {
        1.0
    };
    let factor = films
        .iter()
        .map(|film| film.clear_factor(most))
        .fold(most, f64::min);
    let bounds = films.iter().map(|film| film.scene.bounds()).reduce(|a, b| {
        [
            a[0].min(b[0]),
            a[1].min(b[1]),
            a[2].max(b[2]),
            a[3].max(b[3]),
        ]
    });
    let duration = films
        .iter()
        .map(|film| film.dt * film.last as f64)
        .fold(0.0, f64::max);
    let size = |dimension| unit(study, dimension);
    let data = |most: usize| {
        json!({
            "head": head,
            "duration": duration,
            "units": {
                "time": size(Dimension::Time),
                "length": size(Dimension::Length),
                "force": size(Dimension::Force),
                "acceleration": size(Dimension::Acceleration),
            },
            "symbols": symbols(study),
            "factor": digits(factor, 6),
            "reach": digits(factor * largest, 4),
            "bounds": bounds.map(|rect| scene::points(&rect)),
            "ground": ground.map(|motion| ground_data(motion, duration)).or_else(|| support_data(films.first()?)),
            "films": films.iter().map(|film| film.data(largest, most)).collect::<Vec<_>>(),
        })
    };
    let mut frames = FRAMES;
    let mut text = embedded(&data(frames));
    while text.len() > OF_FILMS && frames > 50 {
        frames = (frames / 2).min(frames * OF_FILMS / text.len());
        text = embedded(&data(frames));
    }
    let title = escape(&title);
    let mut page = String::new();
    let mut rest = HTML;
    // In the order of the page, so that no text of a study is taken for a mark.
    for (mark, text) in [
        ("{policy}", POLICY),
        ("{title}", &*title),
        ("{css}", CSS),
        ("{title}", &*title),
        ("{data}", &*text),
        ("{program}", &*PROGRAM.concat()),
    ] {
        let (before, after) = rest.split_once(mark).unwrap_or((rest, ""));
        page.extend([before, text]);
        rest = after;
    }
    page += rest;
    match page.len() <= MOST_BYTES {
        true => Ok(page),
        false => {
            let what = format!(
                "the animation would have {} bytes, more than {MOST_BYTES}: the structure has too many parts and contacts",
                page.len()
            );
            Err(Error::Usage(what))
        }
    }
}

/// JSON that may stand in a script: a study's names end no element.
fn embedded(data: &Value) -> String {
    data.to_string()
        .replace('<', "\\u003c")
        .replace('\u{2028}', "\\u2028")
        .replace('\u{2029}', "\\u2029")
}

/// The names of time and displacement in the problem.
fn symbols(study: &Study) -> Value {
    match (study.problem.name(), study.problem.schema().described) {
        (_, true) => json!({"time": "t", "length": "displacements", "force": "S"}),
        ("bar-impact", _) => json!({"time": "t", "length": "displacements", "force": "F"}),
        _ => json!({"time": "T = ω t", "length": "displacements over Δ = νN/k", "force": "S/νN"}),
    }
}

/// The acceleration of the ground up to the end.
fn ground_data(ground: &GroundMotion, duration: f64) -> Value {
    /// Parts of the duration in which times are rounded.
    const PARTS: f64 = 100_000.0;
    let table = &ground.acceleration;
    let points = table.times().iter().zip(table.values());
    let mut steps: Vec<u64> = Vec::new();
    let mut values: Vec<f64> = Vec::new();
    for (t, a) in points.filter(|(t, _)| (0.0..=duration).contains(*t)) {
        let step = (t / duration * PARTS).round() as u64;
        // Two points at a jump, or nearer than the screen shows.
        if steps.last().is_none_or(|last| step > *last) {
            steps.push(step);
            values.push(*a);
        }
    }
    let peak = values
        .iter()
        .zip(&steps)
        .fold((0.0, 0.0), |best: (f64, f64), (a, step)| {
            match a.abs() > best.1.abs() {
                true => (*step as f64 / PARTS * duration, *a),
                false => best,
            }
        });
    json!({
        "name": "ground",
        "half": duration / PARTS,
        "curve": trace::curve(&steps, &values),
        "peak": [digits(peak.0, 5), digits(peak.1, 4)],
    })
}

/// The acceleration of the first support.
fn support_data(film: &Film) -> Option<Value> {
    let (name, values) = film.support.as_ref()?;
    let largest = thin::extremes(values)
        .into_iter()
        .filter(|i| *i < values.len())
        .max_by(|a, b| values[*a].abs().total_cmp(&values[*b].abs()))?;
    let time = film.dt * largest as f64;
    Some(json!({
        "name": format!("support {name}"),
        "half": 0.5 * film.dt,
        "curve": trace::of_steps(values),
        "peak": [digits(time, 5), digits(values[largest], 4)],
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::animate::film::contact_history::Contact;
    use std::borrow::Cow;

    /// Steps of a long motion, and numbers of its displacements and contacts.
    const LONG: [usize; 3] = [60_000, 150, 40];

    /// A displacement with many frequencies and a jump.
    fn motion(seed: usize) -> Vec<f64> {
        let seed = seed as f64;
        let value = |i: usize| {
            let t = i as f64 * 1e-3;
            let slow = libm::sin((1.0 + 0.013 * seed) * t);
            let fast = 0.2 * libm::sin((9.0 + 0.7 * seed) * t + seed);
            slow + fast + 0.05 * libm::sin(131.0 * t + seed)
        };
        (0..LONG[0]).map(value).collect()
    }

    /// Bursts of force, each of a few steps.
    fn force(seed: usize) -> Vec<f64> {
        let mut force = vec![0.0; LONG[0]];
        for burst in 0..200 {
            let start = (burst * 297 + 31 * seed) % (LONG[0] - 10);
            for (i, s) in force[start..start + 5].iter_mut().enumerate() {
                *s = -((1 + burst % 17) as f64) * [0.3, 0.8, 1.0, 0.7, 0.2][i];
            }
        }
        force
    }

    fn sums(list: &Value) -> Vec<i64> {
        let mut sum = 0;
        let numbers = list.as_array().into_iter().flatten();
        numbers
            .map(|x| {
                sum += x.as_i64().unwrap_or_default();
                sum
            })
            .collect()
    }

    #[test]
    fn a_long_motion_of_many_parts_keeps_its_extremes_and_touches() {
        let text = r#"{"problem": "structure", "parameters": {"dt": 0.001, "duration": 60},
            "structure": {"masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 1}], "start": {"m": {"v": 1}}}}"#;
        let study = slipgap_study::parse("s.json", text).unwrap();
        let film = |from: usize| Film {
            dt: 1e-3,
            last: LONG[0] as u64 - 1,
            steps: (0..LONG[0] as u64).collect(),
            moves: (0..LONG[1]).map(|i| Cow::Owned(motion(from + i))).collect(),
            places: LONG[1],
            contacts: (0..LONG[2])
                .map(|i| Contact::impact(&format!("c{i}"), Cow::Owned(force(from + i))))
                .collect(),
            ..Film::default()
        };
        let films = [film(0), film(1)];
        let page = page(&study, ("s", ""), &films, None).unwrap();
        assert!(
            page.len() <= MOST_BYTES && page.len() > MOST_BYTES / 2,
            "{}",
            page.len()
        );
        let begin = r#"<script id="data" type="application/json">"#;
        let text = page
            .split_once(begin)
            .unwrap()
            .1
            .split_once("</script>")
            .unwrap()
            .0;
        let data: Value = serde_json::from_str(text).unwrap();
        let largest = films.iter().map(Film::largest).fold(0.0, f64::max);
        for (film, shown) in films.iter().zip(data["films"].as_array().unwrap()) {
            let unit = shown["unit"].as_f64().unwrap();
            for (values, list) in film.moves.iter().zip(shown["moves"].as_array().unwrap()) {
                let list = sums(list);
                let ends =
                    [list.iter().min(), list.iter().max()].map(|x| *x.unwrap() as f64 * unit);
                for (index, end) in thin::extremes(values).into_iter().zip(ends) {
                    // Half a step of the rounding.
                    assert!((values[index] - end).abs() <= 0.51 * unit && unit < 5e-4 * largest);
                }
            }
            for (contact, contact_json) in film
                .contacts
                .iter()
                .zip(shown["contacts"].as_array().unwrap())
            {
                let spans: Vec<i64> = contact
                    .spans()
                    .iter()
                    .flat_map(|[first, last]| [2 * *first as i64 - 1, 2 * *last as i64 + 1])
                    .collect();
                assert!(spans.len() >= 300);
                assert_eq!(sums(&contact_json["spans"]), spans);
                assert_eq!(
                    contact_json["peak"],
                    json!([2 * contact.peak().0, contact.peak().1])
                );
            }
        }
    }
}
