//! Links between pages lead to files that are there, and every page is in the summary of the site. `make site` tests the built pages,
//! also the places inside them.

use std::fs;
use std::path::Path;

/// The targets of the links of a page that are files of the repository, without places inside them.
fn targets(page: &str) -> Vec<String> {
    let path = Path::new(env!("SLIPGAP_ROOT")).join(page);
    let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{page}: {e}"));
    // What is inside code is no link.
    let prose = text
        .split("```")
        .step_by(2)
        .flat_map(|part| part.split('`').step_by(2));
    let links = prose.flat_map(|part| part.split("](").skip(1));
    let targets = links.filter_map(|rest| rest.split([')', '#', ' ']).next());
    let is_file = |target: &&str| !target.is_empty() && !target.contains(':');
    targets.filter(is_file).map(String::from).collect()
}

#[test]
fn links_of_pages_lead_to_files() {
    let root = Path::new(env!("SLIPGAP_ROOT"));
    let more = ["CHANGELOG.md", "SECURITY.md", "studies/records/README.md"];
    let mut count = 0;
    for page in super::PAGES.iter().chain(&more) {
        let folder = root.join(page).parent().unwrap().to_owned();
        for target in targets(page) {
            assert!(folder.join(&target).exists(), "{page} links to {target}");
            count += 1;
        }
    }
    assert!(count > 200, "{count}");
}

#[test]
fn every_page_is_in_the_summary_of_the_site() {
    let summary = targets("site/SUMMARY.md");
    for page in super::PAGES {
        assert!(summary.iter().any(|listed| listed == page), "{page}");
    }
}
