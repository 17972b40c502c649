//! How figures write the names of laws, methods and masses.

/// A name of studies, and its words.
const WORDS: &[(&str, &str)] = &[
    ("impact", "impact"),
    ("impact-spring", "impact spring"),
    ("kelvin-voigt", "Kelvin–Voigt"),
    ("hertz", "Hertz"),
    ("hertz-damp", "damped Hertz"),
    ("hunt-crossley", "Hunt–Crossley"),
    ("ye", "Ye et al."),
    ("jankowski", "Jankowski"),
    ("rigid", "rigid"),
    ("gap-yield", "gap that yields"),
    ("hyperbolic-gap", "hyperbolic gap"),
    ("impact-yield", "impact that yields"),
    ("displacement-control", "displacement control"),
    ("velocity-control", "velocity control"),
    ("coulomb", "Coulomb"),
    ("tanh", "tanh"),
    ("stribeck", "Stribeck"),
    ("stribeck-hyperbolic", "hyperbolic Stribeck"),
    ("bouc-wen", "Bouc–Wen"),
    ("dahl", "Dahl"),
    ("lugre", "LuGre"),
    ("pendulum", "friction pendulum"),
    ("bilinear", "bilinear"),
    ("restrainer", "restrainer"),
    ("viscous", "viscous"),
    ("multilinear", "multilinear"),
    ("imk-bilinear", "bilinear IMK"),
    ("imk-peak-oriented", "peak-oriented IMK"),
    ("imk-pinching", "pinching IMK"),
    ("average-acceleration", "average acceleration"),
    ("linear-acceleration", "linear acceleration"),
    ("central-difference", "central difference"),
    ("newmark", "Newmark"),
    ("hht", "HHT"),
    ("generalized-alpha", "generalised α"),
    ("bathe", "Bathe"),
    ("moreau-jean", "Moreau–Jean"),
    ("contact-stabilized-newmark", "contact-stabilised Newmark"),
    ("massless-contact", "massless contact node"),
];

/// The words for a name; other names as they are.
pub fn of(name: &str) -> &str {
    let mut known = WORDS.iter();
    known.find(|known| known.0 == name).map_or(name, |k| k.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipgap_contact::contact::LAWS;
    use slipgap_system::methods::METHODS;
    use std::collections::BTreeSet;

    #[test]
    fn laws_and_methods_have_words() {
        let laws = LAWS.iter().map(|law| law.offer.name);
        let methods = METHODS.iter().map(|method| method.name);
        let names = BTreeSet::from_iter(laws.chain(methods).chain(["massless-contact"]));
        assert_eq!(BTreeSet::from_iter(WORDS.iter().map(|row| row.0)), names);
        let words = BTreeSet::from_iter(WORDS.iter().map(|row| row.1));
        assert_eq!(words.len(), WORDS.len());
        assert_eq!(of("kelvin-voigt"), "Kelvin–Voigt");
        assert_eq!(of("records/one.AT2"), "records/one.AT2");
    }
}
