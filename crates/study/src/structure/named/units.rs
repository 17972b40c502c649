//! The units of the parameters that a structure contains as they are, such as that of a gap.

use crate::source::tree::{Node, Tree};
use slipgap_problem::problem::structure::parts::contact_law::NUMBERS;
use slipgap_problem::problem::structure::tables::schema::{FIXED, Named};

/// The units of numbers of parts that are no contacts, by the list of the part and the key.
const OF_PARTS: [(&str, &str, &str); 10] = [
    ("springs", "k", "force/length"),
    ("springs", "c", "force/velocity"),
    ("springs", "mass", "mass"),
    ("springs", "period", "time"),
    ("bars", "L", "length"),
    ("bars", "EA", "force"),
    ("bars", "mass", "mass"),
    ("start", "u", "length"),
    ("start", "v", "length/time"),
    ("contacts", "gap", "length"),
];

/// Gives the parameters the units that follow from the parts that contain them; none if the study has no units, or if parts of several
/// units contain one.
pub(in crate::structure) fn add(structure: &Node, units: &str, parameters: &mut [Named]) {
    let names: Vec<&str> = units.split(',').map(str::trim).collect();
    let [mass, force, length, time] = names[..] else {
        return;
    };
    let mut uses = Vec::new();
    for part in structure.object().into_iter().flatten() {
        visit(&part.node, &part.key, "", &mut uses);
    }
    for named in parameters
        .iter_mut()
        .filter(|named| named.choices.is_none())
    {
        let of_fixed = FIXED.iter().any(|fixed| fixed.0 == named.name);
        let mut of = uses.iter().filter(|(name, _)| *name == named.name);
        let first = match of_fixed {
            true => Some("time"),
            false => of.next().and_then(|(_, unit)| *unit),
        };
        let is_one = of_fixed || of.all(|(_, unit)| *unit == first);
        named.unit = first.filter(|_| is_one).and_then(|unit| {
            Some(match unit {
                "mass" => mass.to_owned(),
                "force" => force.to_owned(),
                "length" => length.to_owned(),
                "time" => time.to_owned(),
                "force/length" => format!("{force}/{length}"),
                "force/velocity" => format!("{force} {time}/{length}"),
                "length/time" => format!("{length}/{time}"),
                "time/length" => format!("{time}/{length}"),
                _ => return None,
            })
        });
    }
}

/// Adds the texts below a node, each with the unit of its place, if it is known.
fn visit<'a>(
    node: &'a Node,
    part: &str,
    key: &str,
    uses: &mut Vec<(&'a str, Option<&'static str>)>,
) {
    match &node.tree {
        Tree::Object(members) => {
            // Stiffnesses of rotations have another unit.
            let is_rotation =
                |text: &str| [".rx", ".ry", ".rz"].iter().any(|end| text.contains(end));
            let ends = ["between", "along"].iter().filter_map(|key| node.get(key));
            let rotates = ends.into_iter().any(|ends| {
                let names = ends.list().into_iter().flatten().filter_map(Node::text);
                let keys = ends.object().into_iter().flatten();
                names
                    .chain(keys.map(|member| &*member.key))
                    .any(is_rotation)
            });
            let known = |key: &str| !rotates && !is_rotation(key);
            for member in members {
                let part = if known(&member.key) { part } else { "" };
                visit(&member.node, part, &member.key, uses);
            }
        }
        Tree::List(items) => items.iter().for_each(|item| visit(item, part, key, uses)),
        Tree::Text(text) => uses.push((text.trim(), unit(part, key))),
        Tree::Number(_) | Tree::Bool(_) | Tree::Null => {}
    }
}

/// The unit of a number of a part.
fn unit(part: &str, key: &str) -> Option<&'static str> {
    if part == "masses" {
        return Some("mass");
    }
    let mut of_parts = OF_PARTS.iter();
    let known = of_parts.find(|known| (known.0, known.1) == (part, key));
    let mut numbers = NUMBERS.iter().filter(|_| part == "contacts");
    known
        .map(|known| known.2)
        .or_else(|| Some(numbers.find(|number| number.key == key)?.unit))
}

#[cfg(test)]
mod tests {
    /// Name, unit and title of the parameters of a study.
    fn titles(names: &str) -> Vec<String> {
        let text = format!(
            r#"{{"problem": "structure", {names} "parameters": {{"m": 2, "gap": 0.1, "k": 5, "rate": 3, "both": 1, "part": 2, "dt": 0.001, "duration": 1}},
              "structure": {{"units": "t, kN, m, s", "masses": {{"a|b": "m"}},
              "springs": [{{"between": ["ground", "a"], "k": "both", "c": "rate"}}, {{"between": ["ground", "b"], "k": "2*part"}},
                {{"between": ["a", "b"], "k": 1, "c": "both"}}],
              "contacts": {{"stop": {{"law": "impact", "between": ["a", "b"], "gap": "gap", "k": "k"}}}}}}, "metrics": ["peak(a)"]}}"#
        );
        let study = crate::parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
        let own = study.problem.parameters().iter().take(8);
        own.map(|parameter| parameter.title()).collect()
    }

    #[test]
    fn parameters_have_the_units_of_the_parts_that_contain_them() {
        assert_eq!(
            titles(""),
            [
                "*m*, t",
                "gap, m",
                "*k*, kN/m",
                "rate, kN·s/m",
                "both",
                "part",
                "Δ*t*, s",
                "*t*_end_, s"
            ]
        );
        // The study's own name and unit, or none.
        let named = titles(r#""names": {"gap": ["width", "mm"], "k": ["stiffness"]},"#);
        assert_eq!(named[1..3], ["Width, mm", "Stiffness"]);
    }
}
