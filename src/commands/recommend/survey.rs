//! The survey in words: which laws and methods were searched on the fine grid, and the cheapest of each on the coarse one.

use crate::commands::terminal::table;
use crate::recommend::{MOST, MOST_OWN_STEP, Recommendation, Setting, Survey, Variant, Variants};

/// A variant in words.
fn words(variant: &Variant) -> String {
    let mut words = format!("{} with {}", variant.law.label(), variant.method.label());
    words.extend(variant.mass.map(|mass| format!(", {mass}")));
    words
}

/// What was searched.
pub fn notes(space: &dyn Variants, recommended: &Recommendation) -> Vec<String> {
    let Some(survey) = &recommended.survey else {
        return Vec::new();
    };
    let searched = recommended.searched.iter();
    let searched: Vec<String> = searched.map(|at| words(&space.variants()[*at])).collect();
    vec![
        format!(
            "all {} combinations of law and method were compared on a coarse grid up to the cost {}",
            space.variants().len(),
            survey.cost
        ),
        format!(
            "the {MOST} cheapest, the {MOST_OWN_STEP} cheapest with their own step only and those of the papers were searched on the fine grid: {}",
            searched.join("; ")
        ),
    ]
}

/// The cheapest of every law and of every method on the coarse grid.
pub fn tables(space: &dyn Variants, survey: &Survey) -> String {
    let law = |variant: &Variant| variant.law.clone();
    let method = |variant: &Variant| variant.method.clone();
    let mut text = best(space, survey, ["law", "method"], [law, method]);
    text += &best(space, survey, ["method", "law"], [method, law]);
    text
}

/// The cheapest of every setting in the first column, with that in the second.
fn best(
    space: &dyn Variants,
    survey: &Survey,
    titles: [&str; 2],
    of: [fn(&Variant) -> Setting; 2],
) -> String {
    let all = || space.variants().iter().zip(&survey.variants);
    let mut names: Vec<&str> = Vec::new();
    for (variant, _) in all() {
        let name = of[0](variant).name;
        if !names.contains(&name) {
            names.push(name);
        }
    }
    if names.len() < 2 {
        return String::new();
    }
    let mass = space.variants().iter().any(|v| v.mass.is_some());
    let mut header: Vec<String> = titles.map(str::to_owned).to_vec();
    header.extend(mass.then(|| "mass".to_owned()));
    header.push(space.space().cost_title().to_owned());
    let mut rows = vec![header];
    for name in names {
        let own = all().filter(|(variant, _)| of[0](variant).name == name);
        let costs = own.filter_map(|(variant, found)| Some((found.cost()?, variant)));
        let cells = match costs.min_by_key(|(cost, _)| *cost) {
            Some((cost, variant)) => {
                let mut cells: Vec<String> = of.map(|of| of(variant).label()).to_vec();
                cells.extend(variant.mass.map(str::to_owned));
                cells.push(cost.to_string());
                cells
            }
            None => {
                let mut cells = vec![name.to_owned(), "-".to_owned()];
                cells.extend(mass.then(|| "-".to_owned()));
                cells.push(format!("> {}", survey.cost));
                cells
            }
        };
        rows.push(cells);
    }
    format!(
        "The cheapest of each {} on a coarse grid:\n{}",
        titles[0],
        table(&rows)
    )
}
