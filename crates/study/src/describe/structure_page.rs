//! The reference page of studies of structures, whose parameters, channels and metrics have free names.

use super::reference::{code, list};
use crate::structure::keys;
use slipgap_solver::problem::structure::channels::channel::{
    OF_BASE, OF_ENERGY, OF_GROUND, OF_NODES, OF_SPRINGS, QUANTITIES,
};
use slipgap_solver::problem::structure::metrics::reduction::{REDUCTIONS, of_measured};
use slipgap_solver::problem::structure::parts::contacts::NAMES;
use slipgap_solver::problem::structure::tables::schema::{FIXED, MEANING, NAME};

/// Name of the page.
pub(super) const PAGE: &str = NAME;

/// docs/study-files-structure.md.
pub(super) fn reference() -> String {
    let laws: Vec<&str> = NAMES.iter().map(|law| law.0).collect();
    let keys = |title: &str, keys: &[(&str, &str)]| format!("{title}\n\n{}", list(keys));
    let sections = [
        format!(
            "# Study files: {NAME}\n\nFor those who write a study with `\"problem\": \"{NAME}\"`: {MEANING}. \
             [study-files.md](study-files.md) has the keys of all problems, [structures.md](structures.md) the equations, \
             [laws-and-methods.md](laws-and-methods.md) the laws, [parts.md](parts.md) parts to copy."
        ),
        keys(
            "Parameters have free names, but for these two and those of the method. Every number inside `structure` may be an \
             expression of them; `law`, `record` and the files of `matrices` may be the name of a parameter, whose values are names.",
            &FIXED,
        ),
        keys("## The keys of `structure`", keys::STRUCTURE),
        keys("A bar:", keys::BAR),
        keys("A spring:", keys::SPRING),
        keys("`rayleigh`:", keys::RAYLEIGH),
        keys("A model of `matrices`:", keys::MATRICES),
        keys("`reduce`, one of:", keys::REDUCE),
        keys(
            "`static` has forces by the names of nodes, bars or matrices in a direction, and:",
            keys::STATIC,
        ),
        keys("`start`, for each node or bar:", keys::START),
        "## Contacts".into(),
        format!("The laws are {}.", code(&laws)),
        keys("A contact has:", &keys::CONTACT),
        keys("`N` as a table:", keys::NORMAL_TABLE),
        keys("`N` of a weight:", keys::WEIGHT),
        keys("`N` by contacts and springs:", keys::PRESSING),
        "## Motions and loads".into(),
        keys(
            "A function of time has one of the first five keys. A load also has `at`, the node.",
            keys::FUNCTION,
        ),
        keys("`sine`:", keys::SINE),
        keys("`table`:", keys::TABLE),
        keys(
            "Files as an axis, under `record`, under `file` of `measured`, or as the value of a parameter that chooses one of these. The \
             files of several parameters of a block that are in no `zip` go together, those with the same text for `*`:",
            keys::FILES,
        ),
        keys("`synthetic`:", keys::SYNTHETIC),
        keys("`pulse`, one of:", keys::PULSE),
        keys("`ricker`:", keys::RICKER),
        keys("`cosine`:", keys::COSINE),
        keys("`scale_to`, one of the first three:", keys::SCALE_TO),
        keys("Its `spectrum`, one of these, or a table:", keys::SPECTRUM),
        keys("`EN 1998-1`:", keys::EN_1998),
        keys("`ASCE 7`:", keys::ASCE_7),
        keys("A table:", keys::TARGET_TABLE),
        keys(
            "A support has the keys of a function of time, its acceleration in x, or `x`, `y` and `z`, each with them, and:",
            keys::SUPPORT,
        ),
        keys("`displacement`:", keys::IMPOSED),
        keys("`displacement` of a file:", keys::IMPOSED_BY_FILE),
        "## Measurements".into(),
        keys(
            "The key `measured` of the study, beside `structure`:",
            keys::MEASURED,
        ),
        keys(
            "A column with its unit, for `time` and in `columns`:",
            keys::COLUMN,
        ),
        "## Channels".into(),
        keys(
            "Channels are the following, and sums and differences of one dimension, such as `g1.right - p2`. Figures draw them and \
             `error(CHANNEL)`, computed minus exact. `NODE.` and one of these; a support has u, v and a:",
            &OF_NODES,
        ),
        keys("`CONTACT.` and one of:", &QUANTITIES),
        keys("Springs and bars:", &OF_SPRINGS),
        keys(
            "The ground and the forces at it:",
            &[OF_GROUND, OF_BASE].concat(),
        ),
        keys(
            "Energies of the whole structure, of the motion relative to the ground or beside what supports carry; no exact motion has \
             them:",
            &OF_ENERGY,
        ),
        "## Metrics".into(),
        keys(
            "A study lists its metrics under `metrics`: reductions of a channel or of a contact, such as `peak(g1.right - p2)` or \
             `impacts(gap12)`, and measures of the ground, of several directions with the direction, such as `ground.y.pga`. In the \
             formulas c is computed.",
            &REDUCTIONS,
        ),
        keys(
            "`NAME(CHANNEL, measured)` compares with a column of `measured`, `loop_distance(CHANNEL, CHANNEL, measured)` with two. The \
             computed motion is taken at the measured times, straight between the steps. Some of the reductions above may have \
             `measured`; m is measured, W the energy of a cycle:",
            &of_measured(),
        ),
    ];
    sections.join("\n\n") + "\n"
}
