//! What the other verbs do with `s3://`.

use crate::server::{Port, SERVER};
use crate::{begin, differences, folder, objects, short};

/// A search of some seconds.
const SEARCHED: &str = r#"{ "problem": "friction-oscillator", "parameters": { "law": "displacement-control", "alpha": [0.1, 1],
    "dT": ["pi/10", "pi/20"], "duration": "8*pi", "x0": 12 }, "recommend": { "over": ["alpha", "dT"], "within": { "rms_error": 0.05 } } }"#;

const LEDGER: &str = r#"{ "paper": "A paper", "studies": "..", "claims": [
  { "id": "A1", "where": "section 1", "says": "Small alpha is good.", "quantity": "the error", "readings": [
    { "reading": "as printed", "study": "s", "figure": "f", "expect": [{ "metric": "rms_error", "along": "alpha", "trend": "rising" }],
      "holds": true }] }] }"#;

#[test]
#[ignore = "starts a server; make s3-test"]
fn verbs_that_write_files_write_objects_with_the_same_bytes() {
    let bench = begin("verbs");
    bench.file("s.json", short("f", 3));
    bench.file("searched.json", SEARCHED);
    bench.file("ledgers/a.json", LEDGER);
    let calls: [&[&str]; 6] = [
        &["run", "s.json", "--out", "OUT"],
        &["status", "s.json", "--out", "OUT"],
        &["report", "s.json", "--out", "OUT"],
        &["claims", "ledgers", "--out", "OUT"],
        &["recommend", "searched.json", "--out", "OUT"],
        &["animate", "s.json", "--out", "OUT/s/page.html"],
    ];
    for call in calls {
        let [there, here] = ["s3://verbs", "out"].map(|out| {
            let words: Vec<String> = call.iter().map(|word| word.replace("OUT", out)).collect();
            let args: Vec<&str> = words.iter().map(String::as_str).collect();
            SERVER.run(&bench, Port::Good, 0, &args).out
        });
        assert_eq!(there.replace("s3://verbs", "out"), here, "{call:?}");
        assert_eq!(
            differences(&objects(&bench, "verbs"), &folder(&bench, "out")),
            "",
            "{call:?}"
        );
    }
    // The study has changed: the report runs it again.
    bench.file("s.json", short("g", 4));
    for out in ["s3://verbs", "out"] {
        SERVER.run(&bench, Port::Good, 0, &["report", "s.json", "--out", out]);
    }
    assert_eq!(
        differences(&objects(&bench, "verbs"), &folder(&bench, "out")),
        ""
    );
    let sbatch = [
        "sbatch",
        "s.json",
        "--shards",
        "2",
        "--out",
        "s3://verbs/x y",
    ];
    let script = SERVER.run(&bench, Port::Good, 0, &sbatch).out;
    assert!(script.contains(" '--out' 's3://verbs/x y'"), "{script}");
}

#[test]
#[ignore = "starts a server; make s3-test"]
fn verbs_that_need_folders_say_so() {
    let bench = begin("folders");
    bench.file("s.json", short("f", 3));
    let said = |args: &[&str]| SERVER.run(&bench, Port::Good, 2, args).err;
    assert_eq!(
        said(&["compare", "s3://folders", "out"]),
        "slipgap: s3://folders: only folders are compared; copy the objects into one, for example by `aws s3 sync`\n"
    );
    let study = concat!(
        env!("SLIPGAP_ROOT"),
        "/studies/calibrate/calibrate-bearing.json"
    );
    assert_eq!(
        said(&["calibrate", study, "--out", "s3://folders"]),
        "slipgap: s3://folders/calibrate-bearing: calibrate writes studies that name files in folders; give a folder\n"
    );
    assert_eq!(objects(&bench, "folders").len(), 0);
}
