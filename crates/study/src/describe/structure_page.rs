//! The reference page of studies of structures, whose parameters, channels and metrics have free names.

use super::reference::{code, list, object};
use crate::source::field::{Field, Keys};
use crate::structure::keys::{self, PULSE};
use slipgap_problem::problem::structure::channels::channel::{
    OF_BASE, OF_ENERGY, OF_GROUND, OF_NODES, OF_SPRINGS, QUANTITIES,
};
use slipgap_problem::problem::structure::metrics::against_measured::of_measured;
use slipgap_problem::problem::structure::metrics::reduction::REDUCTIONS;
use slipgap_problem::problem::structure::parts::contact_law::NAMES;
use slipgap_problem::problem::structure::tables::schema::{FIXED, MEANING, NAME};

/// Name of the page.
pub(super) const PAGE: &str = NAME;

/// Keys without a meaning if an object before has described them, as `object` writes a key that is its meaning.
fn once<'a>(
    keys: &[(&'a str, &'a str)],
    described: &mut Vec<(&'a str, &'a str)>,
) -> Vec<(&'a str, &'a str)> {
    let before = described.clone();
    described.extend(keys);
    let short = |key: &(&'a str, &'a str)| match before.contains(key) {
        true => (key.0, key.0),
        false => *key,
    };
    keys.iter().map(short).collect()
}

/// docs/study-files-structure.md.
pub(super) fn reference() -> String {
    let laws: Vec<&str> = NAMES.iter().map(|law| law.0).collect();
    let keys = |title: &str, keys: &[(&str, &str)]| format!("{title}\n\n{}", list(keys));
    let table = |title: &str, table: &Keys| keys(title, &table.rows());
    let objects = |title: &str, rows: &[(&str, &Keys)]| {
        let mut described = Vec::new();
        let items = rows
            .iter()
            .map(|(name, keys)| object(name, &once(&keys.rows(), &mut described)));
        format!("{title}\n\n{}", items.collect::<Vec<_>>().join("\n"))
    };
    let forms = PULSE
        .fields()
        .map(|form| (format!("`{}`", form.name), form));
    let forms: Vec<(String, &Field)> = forms.collect();
    let numbers = forms.iter();
    let numbers = numbers.filter_map(|(name, form)| Some((&**name, form.kind.keys()?)));
    let of_ground = Keys::new(&[keys::OF_GROUND]);
    let mut in_functions = vec![
        ("`sine`", &keys::SINE),
        ("`table`", &keys::TABLE),
        ("`synthetic`", &keys::SYNTHETIC),
        ("`pulse`, one of", &*PULSE),
    ];
    in_functions.extend(numbers);
    in_functions.extend([
        ("`scale_to`, one of the first four, and", &keys::SCALE_TO),
        ("its `spectrum`, one of", &keys::SPECTRUM),
        ("`EN 1998-1`", &keys::EN_1998),
        ("`ASCE 7`", &keys::ASCE_7),
        ("or a `spectrum` as a table", &keys::TARGET_TABLE),
        ("`ground` has, besides `x`, `y` and `z`", &of_ground),
        ("its `set`", &keys::SET),
    ]);
    let sections = [
        format!(
            "# Study files: {NAME}\n\n`\"problem\": \"{NAME}\"`: {MEANING}. Also: [keys of all problems](study-files.md), [equations](structures.md), \
             [laws](laws-and-methods.md), [examples](parts.md)."
        ),
        keys(
            "Parameters have free names, except these two and those of the method. Numbers in `structure` may be expressions of \
             parameters; `law`, `record` and files of `matrices` may name a parameter.",
            &FIXED,
        ),
        table("## The keys of `structure`", &keys::STRUCTURE),
        table("A bar:", &keys::BAR),
        table("A spring:", &keys::SPRING),
        table("A model of `matrices`:", &keys::MATRICES),
        objects(
            "Smaller objects:",
            &[
                ("`rayleigh`", &keys::RAYLEIGH),
                ("`reduce`, one of", &keys::REDUCE),
                (
                    "`static`: forces by nodes, bars, or matrices in a direction, and",
                    &keys::STATIC,
                ),
                ("`start`, of a node or bar", &keys::START),
            ],
        ),
        "## Contacts".into(),
        format!("The laws are {}.", code(&laws)),
        table("A contact has:", &keys::CONTACT),
        objects(
            "`N` may be one of:",
            &[
                ("a table", &keys::NORMAL_TABLE),
                ("a weight", &keys::WEIGHT),
                ("the force of contacts and springs", &keys::PRESSING),
            ],
        ),
        "## Motions and loads".into(),
        table(
            "A function of time has one of the first five keys. A load also has `at`, the node.",
            &keys::FUNCTION,
        ),
        objects("The objects in it:", &in_functions),
        keys(
            "The rules of a `set`, as the codes are generally quoted:",
            &keys::RULES.map(|rule| (rule.name, rule.meaning)),
        ),
        table(
            "Files as an axis, under `record`, `file` of `measured`, or their parameter; those with the same text for `*` go together:",
            &keys::FILES,
        ),
        table(
            "`choose`: the `n` records whose logarithms have the least squared errors of mean and standard deviation, by a greedy \
             search (Baker and Lee 2018). Spectra stay in the user's cache. Its keys:",
            &keys::CHOOSE,
        ),
        table(
            "A support has the keys of a function of time, its acceleration in x, or `x`, `y` and `z`, each with them, and:",
            &Keys::new(keys::OF_SUPPORT),
        ),
        objects(
            "Its `displacement` is one of:",
            &[
                ("points", &keys::IMPOSED),
                ("a file", &keys::IMPOSED_BY_FILE),
                ("a sine", &keys::IMPOSED_SINE),
            ],
        ),
        "## Measurements".into(),
        table(
            "The key `measured` of the study, beside `structure` ([calibrate.md](calibrate.md)):",
            &keys::MEASURED,
        ),
        objects(
            "With a unit:",
            &[("a column, for `time` and in `columns`", &keys::COLUMN)],
        ),
        "## Channels".into(),
        keys(
            "Channels are the following, and sums and differences of one dimension, such as `g1.right - p2` or `2*p1 - 0.5*p2`. Figures \
             draw them and `error(CHANNEL)`, computed minus exact. `NODE.` and one of these; a support has u, v and a:",
            &OF_NODES,
        ),
        keys("`CONTACT.` and one of:", &QUANTITIES),
        keys("Springs, bars and members:", &OF_SPRINGS),
        keys(
            "The ground and the forces at it; a base moment is one of the `forces` of `matrices`:",
            &[OF_GROUND, OF_BASE].concat(),
        ),
        keys(
            "Energies of the whole structure, of u relative to the ground, or of w of [supports](structures.md#the-equations); with a support of \
             a given displacement of the absolute motion, with K of supports at 0. The exact motion has none:",
            &OF_ENERGY,
        ),
        "Figures write channels in words with the unit, as in \"Displacement of g1.right relative to p2, m\", or as `names` of the study has them."
            .into(),
        "## Metrics".into(),
        keys(
            "`metrics` lists reductions of a channel or of a contact, such as `peak(g1.right - p2)` or `impacts(gap12)`, and measures of \
             the ground, with several directions as `ground.y.pga`. c is computed, e exact (`contacts_reference`), g the exact motion of \
             the softened laws. A window, as in `peak(a, from=10, to=2*T)`, has the steps from `from` to `to`, of which either may be \
             left out; energies, the ground and divergence have none. `residual(a3 - a2)/3.2` is a \
             residual drift, `sqrt(peak(a.x)^2 + peak(a.y)^2)` the SRSS of two peaks.",
            &REDUCTIONS,
        ),
        keys(
            "`NAME(CHANNEL, measured)` compares with a column of `measured`, `loop_distance(CHANNEL, CHANNEL, measured)` with two, at the \
             measured times, straight between the steps. So may these; m is measured, W the energy of a cycle:",
            &of_measured(),
        ),
    ];
    sections.join("\n\n") + "\n"
}
