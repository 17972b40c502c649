//! One version and one date everywhere: Cargo.toml, CITATION.cff, the changelog, and the entry to copy in docs/answers.md.

use std::fs;

fn text(path: &str) -> String {
    let path = format!("{}/{path}", env!("SLIPGAP_ROOT"));
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// The value of a key of CITATION.cff, at the top level.
fn cited(citation: &str, key: &str) -> String {
    let of_line = |line: &str| Some(line.strip_prefix(key)?.strip_prefix(": ")?.to_owned());
    let value = citation.lines().find_map(of_line);
    value.unwrap_or_else(|| panic!("CITATION.cff has no {key}"))
}

#[test]
fn the_citation_has_this_version_its_date_and_the_entry_of_the_page() {
    let citation = text("CITATION.cff");
    let [title, version, date] =
        ["title", "version", "date-released"].map(|key| cited(&citation, key));
    assert_eq!(version, env!("CARGO_PKG_VERSION"));
    let released = text("CHANGELOG.md")
        .lines()
        .find_map(|line| Some(line.strip_prefix(&format!("## [{version}] - "))?.to_owned()));
    assert_eq!(released.as_deref(), Some(date.as_str()));
    let authors = citation.split("authors:\n  - name: ").nth(1).unwrap();
    let author = authors.lines().next().unwrap();
    let year = &date[..4];
    let entry = format!(
        "@software{{slipgap, title = {{{title}}}, author = {{{{{author}}}}}, year = {{{year}}}, version = {{{version}}}}}\n"
    );
    assert!(text("docs/answers.md").contains(&entry), "{entry}");
}
