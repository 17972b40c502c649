use super::EnsembleMetrics;
use crate::PartResult;
use crate::solve::part_result::Solutions;
use slipgap_motion::solve::MetricTable;
use slipgap_study::{Study, parse};

fn study(text: &str) -> Study {
    let text = format!(r#"{{"problem": "bar-impact", {text}}}"#);
    parse("s", &text).unwrap_or_else(|e| panic!("{e}"))
}

/// The tables of a study whose first metric has these values, all others none; in parts of `size` cases.
fn tables(study: &Study, size: usize, value: impl Fn(u64) -> f64) -> [String; 2] {
    let mut ensembles = EnsembleMetrics::new(study).unwrap();
    for first in (0..study.raw_len()).step_by(size) {
        let to = (first + size as u64).min(study.raw_len());
        let (first, cases) = study.columns(first, to);
        let mut metrics = MetricTable::new(cases.len(), study.problem.metrics().len());
        for row in 0..cases.len() {
            metrics.set(row, [value(first + row as u64)].into_iter());
        }
        ensembles.add(&PartResult {
            first,
            cases,
            metrics,
            solutions: Solutions::new(),
            stored: Ok(()),
            from_store: 0,
        });
    }
    let (mut quantiles, mut two_samples) = (Vec::new(), Vec::new());
    ensembles.write_quantiles(&mut quantiles).unwrap();
    ensembles.write_two_samples(&mut two_samples).unwrap();
    [quantiles, two_samples].map(|bytes| String::from_utf8(bytes).unwrap())
}

/// The header and the rows of the first metric.
fn of_first(study: &Study, table: &str) -> Vec<String> {
    let first = &study.measures[study.columns[0]].name;
    let of_first = |line: &&str| line.starts_with(&format!("{first},"));
    let header = table.lines().take(1);
    header
        .chain(table.lines().filter(of_first))
        .map(String::from)
        .collect()
}

const REST: &str = r#""dt": 0.01, "duration": 1"#;

#[test]
fn the_tables_have_what_a_hand_computes() {
    // Cases are n x gap, the gap fastest; the first ensemble is 1, 2, 4, 8, empty, 5, the second 10 times the number.
    let study = study(&format!(
        r#""parameters": {{"gamma": 1, "n": [4, 8], "gap": [0, 0.1, 0.2, 0.3, 0.4, 0.5], {REST}}}, "ensemble": "gap""#
    ));
    let values = [1.0, 2.0, 4.0, 8.0, f64::NAN, 5.0];
    let value = |case: u64| match case {
        0..6 => values[case as usize],
        case => 10.0 * case as f64,
    };
    let [quantiles, two_samples] = tables(&study, 5, value);
    // Rising: 1 2 4 5 8 with places 0.2, 0.64, 1, 2, 3, 3.36 and 3.8. Mean 4, squares 9 + 4 + 0 + 1 + 16 = 30 over 4.
    // Five values have no interval of the median, six have their ends: 60 .. 110 with mean 85 and
    // 2 (25^2 + 15^2 + 5^2)/5 = 350.
    assert_eq!(
        of_first(&study, &quantiles),
        [
            "metric,n,cases,empty,min,q05,q16,q25,median,q75,q84,q95,max,mean,standard_deviation,median_low,median_high".to_owned(),
            format!("contact_duration,4,6,1,1.0,1.2,1.6400000000000001,2.0,4.0,5.0,6.08,7.3999999999999995,8.0,4.0,{},,", 7.5_f64.sqrt()),
            format!("contact_duration,8,6,0,60.0,62.5,68.0,72.5,85.0,97.5,102.0,107.5,110.0,85.0,{},60.0,110.0", 350.0_f64.sqrt()),
        ]
    );
    // No value of the first is above one of the second: D = 1, and of the C(11, 5) = 462 divisions two are as far.
    let rows = of_first(&study, &two_samples);
    assert_eq!(rows[0], "metric,parameter,value_1,value_2,n,n_1,n_2,D,p");
    let (names, p) = rows[1].rsplit_once(',').unwrap();
    assert_eq!(names, "contact_duration,n,4,8,,5,6,1.0");
    assert!((p.parse::<f64>().unwrap() - 2.0 / 462.0).abs() < 1e-17);
    // A metric without values has rows with counts alone.
    let empty = quantiles.lines().nth(3).unwrap();
    assert!(empty.ends_with(",4,6,6,,,,,,,,,,,,,"), "{empty}");
    // Parts of other sizes give the same bytes.
    assert_eq!(tables(&study, 12, value), [quantiles, two_samples]);
}

#[test]
fn ensembles_are_compared_where_all_else_is_equal() {
    let pairs = |text: &str| -> Vec<String> {
        let study = study(text);
        let [_, table] = tables(&study, 1000, |case| case as f64);
        let rows = of_first(&study, &table).into_iter().skip(1);
        let cells = |row: String| row.split(',').skip(1).map(String::from).collect::<Vec<_>>();
        let name = |row: String| {
            let cells = cells(row);
            cells[..cells.len() - 4].join(" ")
        };
        rows.map(name).collect()
    };
    let gap = r#""gap": [0, 0.1]"#;
    // Three values of gamma for each n, two of n for each gamma. dt follows from n and is no comparison of its own.
    let grid = format!(
        r#""parameters": {{"gamma": [3, 1, 2], "n": [4, 8], {gap}, "dt": "0.1/n", "duration": 1}}, "ensemble": "gap""#
    );
    assert_eq!(
        pairs(&grid),
        [
            // parameter, both values, gamma, n and dt where they are the same
            "gamma 1.0 2.0  4 0.025",
            "gamma 1.0 3.0  4 0.025",
            "gamma 2.0 3.0  4 0.025",
            "gamma 1.0 2.0  8 0.0125",
            "gamma 1.0 3.0  8 0.0125",
            "gamma 2.0 3.0  8 0.0125",
            "n 4.0 8.0 3.0  ",
            "n 4.0 8.0 1.0  ",
            "n 4.0 8.0 2.0  ",
        ]
    );
    // Parameters that advance together are compared once.
    let zipped = format!(
        r#""parameters": {{"gamma": [1, 2], "n": [4, 8], {gap}, {REST}}}, "zip": [["gamma", "n"]], "ensemble": "gap""#
    );
    assert_eq!(pairs(&zipped), ["gamma 1.0 2.0  "]);
    // Of more than ten values neighbours are compared, in the order of size.
    let many = format!(
        r#""parameters": {{"gamma": {{"linspace": [12, 1, 12]}}, "n": 4, {gap}, {REST}}}, "ensemble": "gap""#
    );
    let expected: Vec<String> = (1..12)
        .map(|i| format!("gamma {i}.0 {}.0 ", i + 1))
        .collect();
    assert_eq!(pairs(&many), expected);
    // Ten values are all compared, 10 9/2 pairs; of eleven the ten neighbours.
    for (count, expected) in [(10, 45), (11, 10)] {
        let text = many.replace("[12, 1, 12]", &format!("[{count}, 1, {count}]"));
        assert_eq!(pairs(&text).len(), expected);
    }
    // Two points of a design with each n: the design is the ensemble.
    let design = format!(
        r#""parameters": {{"gamma": {{"uniform": [1, 2]}}, "gap": {{"uniform": [0, 0.1]}}, "n": [4, 8], {REST}}},
           "design": {{"kind": "sobol", "n": 8}}, "ensemble": ["gap", "gamma"]"#
    );
    assert_eq!(pairs(&design), ["n 4 8 "]);
}

#[test]
fn laws_are_compared_although_each_has_its_own_parameter() {
    let text = r#"{"problem": "friction-oscillator", "blocks": [
        {"parameters": {"law": "displacement-control", "alpha": [0.1, 0.2], "dT": 0.5, "duration": 3, "x0": [8, 9]}},
        {"parameters": {"law": "velocity-control", "beta": 0.3, "dT": 0.5, "duration": 3, "x0": [8, 9]}}],
        "ensemble": "x0"}"#;
    let study = parse("s", text).unwrap_or_else(|e| panic!("{e}"));
    let [_, table] = tables(&study, 1000, |case| case as f64);
    let rows = of_first(&study, &table);
    let columns: Vec<&str> = rows[0].split(',').collect();
    let at = |name: &str| columns.iter().position(|column| *column == name).unwrap();
    let cells: Vec<Vec<&str>> = rows[1..]
        .iter()
        .map(|row| row.split(',').collect())
        .collect();
    let shown: Vec<[&str; 5]> = cells
        .iter()
        .map(|row| [row[1], row[2], row[3], row[at("alpha")], row[at("beta")]])
        .collect();
    assert_eq!(
        shown,
        [
            [
                "law",
                "displacement-control",
                "velocity-control",
                "0.1",
                "0.3"
            ],
            [
                "law",
                "displacement-control",
                "velocity-control",
                "0.2",
                "0.3"
            ],
            ["alpha", "0.1", "0.2", "", ""],
        ]
    );
}
