//! Whether slipgap may be given on under MIT or Apache-2.0 with everything that is built into it.

use serde_json::Value;
use spdx::{Expression, LicenseReq};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;

/// The licences that `deny.toml` allows.
fn allowed() -> Vec<String> {
    let path = Path::new(env!("SLIPGAP_ROOT")).join("deny.toml");
    let text = std::fs::read_to_string(path).unwrap();
    let rest = text.split("\nallow = [").nth(1).unwrap();
    let list = rest.split("\n]").next().unwrap();
    list.split('"')
        .skip(1)
        .step_by(2)
        .map(String::from)
        .collect()
}

/// Crates for every platform are judged, not only those built here, so cargo may have to fetch some.
#[test]
#[ignore = "may need the network for crates of other platforms; run by `make licences`"]
fn every_dependency_has_a_licence_that_fits() {
    let metadata = metadata();
    let shipped = shipped(&metadata);
    assert!(shipped.len() > 10, "only {shipped:?} in the graph");
    let misfits: Vec<String> = packages(&metadata)
        .filter(|package| shipped.contains(text(&package["id"])))
        .filter_map(|package| {
            let (name, version) = (text(&package["name"]), text(&package["version"]));
            let why = misfit(package["license"].as_str())?;
            Some(format!("{name} {version}: {why}"))
        })
        .collect();
    assert!(misfits.is_empty(), "{}", misfits.join("\n"));
}

#[test]
fn an_expression_fits_where_one_of_its_choices_does() {
    for fits in [
        "MIT",
        "MIT OR GPL-3.0-only",
        "(MIT OR Apache-2.0) AND Unicode-3.0",
        "Apache-2.0 WITH LLVM-exception",
        "MIT/Apache-2.0",
    ] {
        assert_eq!(misfit(Some(fits)), None, "{fits}");
    }
    for unfit in [
        "GPL-3.0-only",
        "MIT AND LGPL-2.1-or-later",
        "GPL-2.0-only WITH Classpath-exception-2.0",
        "my own",
        "",
    ] {
        assert!(misfit(Some(unfit)).is_some(), "{unfit}");
    }
    assert!(misfit(None).is_some());
}

#[test]
fn the_fonts_carry_their_licence() {
    let folder = Path::new(env!("SLIPGAP_ROOT")).join("crates/drawing/assets/fonts");
    let licence = std::fs::read_to_string(folder.join("OFL.txt")).unwrap();
    assert!(licence.contains("SIL OPEN FONT LICENSE Version 1.1"));
    assert!(licence.starts_with("Copyright"));
}

/// What is wrong with a licence expression, if anything.
fn misfit(expression: Option<&str>) -> Option<String> {
    let Some(expression) = expression else {
        return Some("states no licence".into());
    };
    // Older crates write `MIT/Apache-2.0` for a choice.
    let parsed = match Expression::parse_mode(expression, spdx::ParseMode::LAX) {
        Ok(parsed) => parsed,
        Err(error) => return Some(format!("`{expression}`: {}", error.reason)),
    };
    let list = allowed();
    let allowed = |licence: &LicenseReq| list.contains(&licence.to_string());
    (!parsed.evaluate(allowed)).then(|| format!("`{expression}` is not on the list of deny.toml"))
}

fn metadata() -> Value {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--locked"])
        .arg("--all-features")
        .current_dir(env!("SLIPGAP_ROOT"))
        .output()
        .unwrap_or_else(|e| panic!("cannot start {}: {e}", env!("CARGO")));
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "cargo metadata failed: {said}");
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Ids of the crates of the workspace, and of the packages that they need to be built or to run, tests aside.
fn shipped(metadata: &Value) -> BTreeSet<&str> {
    let nodes: BTreeMap<&str, &Value> = list(&metadata["resolve"]["nodes"])
        .map(|node| (text(&node["id"]), node))
        .collect();
    let mut found = BTreeSet::new();
    let mut open: Vec<&str> = list(&metadata["workspace_members"]).map(text).collect();
    while let Some(id) = open.pop() {
        if found.insert(id) {
            let needed = list(&nodes[id]["deps"])
                .filter(|dep| list(&dep["dep_kinds"]).any(|kind| kind["kind"] != "dev"));
            open.extend(needed.map(|dep| text(&dep["pkg"])));
        }
    }
    found
}

fn packages(metadata: &Value) -> impl Iterator<Item = &Value> {
    list(&metadata["packages"])
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().unwrap().iter()
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap()
}
