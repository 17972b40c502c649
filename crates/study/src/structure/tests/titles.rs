//! Titles of metrics.

#[test]
fn titles_have_the_units_of_the_study() {
    let study = crate::parse(
        "s",
        r#"{"problem": "structure", "parameters": {"dt": 0.01, "duration": 1}, "metrics": ["peak(m)", "energy_error"],
          "structure": {"units": "t, N, mm, s", "masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 1}],
            "start": {"m": {"u": 1}}}}"#,
    )
    .unwrap_or_else(|e| panic!("{e}"));
    let [peak, error] = &study.measures[..] else {
        panic!("{:?}", study.measures);
    };
    assert_eq!(
        [&*peak.symbol, &*peak.unit],
        ["peak displacement m (mm)", "mm"]
    );
    assert_eq!(peak.bare_symbol(), "peak displacement m");
    assert_eq!(peak.above("5"), "peak displacement m > 5 mm");
    assert_eq!([&*error.symbol, &*error.unit], ["energy error", "1"]);
    assert_eq!(error.above("5"), "energy error > 5");
}
