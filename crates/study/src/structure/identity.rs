//! A hash of a structure, for the keys of stores.

use crate::source::tree::{Member, Node, Tree};
use sha2::{Digest, Sha256};
use slipgap_problem::problem::structure::given::motion_set::Set;

/// The names of records and matrices, each once, and a hash of the names and their bytes.
#[derive(Default)]
pub(in crate::structure) struct Records {
    names: Vec<String>,
    digest: Sha256,
}

impl Records {
    /// Adds the bytes of a name that is new.
    pub fn add(&mut self, name: &str, bytes: &[u8]) {
        if self.names.iter().any(|known| known == name) {
            return;
        }
        self.names.push(name.to_owned());
        self.digest.update(name.as_bytes());
        self.digest.update([0]);
        self.digest.update((bytes.len() as u64).to_le_bytes());
        self.digest.update(bytes);
    }
}

/// A hash of what the structure says, without places and remarks, and behind a point one of the names and bytes of its records. What
/// `measured` says belongs to it, with the range of the delays, which decides the points that are compared.
pub(super) fn identity(
    (structure, programs): (&Node, Option<&Node>),
    (measured, set): (Option<(&Node, [f64; 2])>, Option<&Set>),
    records: &Records,
) -> String {
    let hex = |bytes: &[u8]| -> String { bytes.iter().map(|byte| format!("{byte:02x}")).collect() };
    let mut written = written(structure);
    if let Some(programs) = programs {
        written += &self::written(programs);
    }
    if let Some((node, delays)) = measured {
        written += &self::written(node);
        written += &format!("{delays:?}");
    }
    // The factor of a set depends on the parameters of all its motions.
    if let Some(set) = set {
        written += &format!("{:?}", set.members);
    }
    let structure = Sha256::digest(written);
    let records = records.digest.clone().finalize();
    format!("{}.{}", hex(&structure), hex(&records))
}

/// A value as JSON without blanks and remarks.
fn written(node: &Node) -> String {
    let joined = |parts: Vec<String>| parts.join(",");
    match &node.tree {
        Tree::Object(members) => {
            let real = members.iter().filter(|member| member.key != "//");
            let one = |member: &Member| format!("{:?}:{}", member.key, written(&member.node));
            format!("{{{}}}", joined(real.map(one).collect()))
        }
        Tree::List(items) => format!("[{}]", joined(items.iter().map(written).collect())),
        Tree::Text(text) => format!("{text:?}"),
        Tree::Number(number) => number.clone(),
        Tree::Bool(truth) => truth.to_string(),
        Tree::Null => "null".to_owned(),
    }
}
