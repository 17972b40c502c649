//! Programs of others as methods: the key `programs`.

pub(crate) mod described;
pub(crate) mod textbook;

use super::reading::given::{Choices, given, interned_choices, members, texts, under};
use super::reading::reader::Reader;
use crate::source::faults::{Faults, join, quoted};
use crate::source::field::{ANY, Field, Keys, Kind, field, fields, needed};
use crate::source::object::Object;
use crate::source::tree::{Member, Node, Tree};
use crate::value::{number, text};
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::interned;
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::programs::{Program, Programs, methods};
use slipgap_problem::problem::structure::tables::schema::Named;
use slipgap_system::methods::METHODS;
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// The key of a study.
pub(crate) const KEY: Field = field("programs", Kind::Named(&Kind::Object(&PROGRAM)))
    .means("programs of others, by their names, which are values of `method`, as in {\"opensees\": {\"command\": [\"python3\", \"opensees_case.py\"]}}; they are started only with --allow-programs");

/// A program.
const PROGRAM: Keys = Keys::new(&fields![
    /// the program and its arguments, started without a shell in the folder of the study
    needed("command", Kind::List(&Kind::Text, [1, ANY])),
    /// files in the folder of the study on which its answers depend: results of other ones do not count
    field("files", Kind::List(&Kind::Text, [0, ANY])),
    /// numbers of its own, such as tolerances: values, expressions or parameters of the study; a list of a parameter that only programs have is no axis for other methods
    field("parameters", Kind::Named(&Kind::Number(Range::Any))),
    /// seconds for a case; 60 if left out
    field("timeout", Kind::Number(Range::Positive)),
    /// seconds for its first line; 60 if left out
    field("start_timeout", Kind::Number(Range::Positive)),
    /// whether dt is only the spacing of its answers, since it chooses its own steps; false if left out
    field("adaptive", Kind::Any),
]);

/// Seconds for a case and for the first line, if the study gives none.
const SECONDS: f64 = 60.0;

/// Largest file on which answers depend.
const LARGEST: u64 = 64 << 20;

fn listed(root: &Node) -> &[Member] {
    root.get(KEY.name).map_or(&[], members)
}

/// The names of the programs of a study.
pub(crate) fn names(root: &Node) -> Vec<&str> {
    let programs = listed(root).iter().filter(|member| member.key != "//");
    programs.map(|member| &*member.key).collect()
}

/// The methods of a study with programs; `None` for one without.
pub(in crate::structure) fn choices(root: &Node) -> Option<Choices> {
    let names = names(root);
    (!names.is_empty()).then(|| interned_choices(methods(names.into_iter())))
}

/// The programs of a study. `parameters` that only they have apply to them alone.
pub(in crate::structure) fn programs(
    root: &Object,
    reader: &Reader,
    parameters: &mut [Named],
    faults: &mut Faults,
) -> Programs {
    let of_structure = reader.used.take();
    let (list, used) = list(root, reader, faults);
    for (row, names) in restricted(reader, &used) {
        if !of_structure.contains(&row) {
            parameters[row].programs = names;
        }
    }
    let rows = used.iter().flat_map(|(_, rows)| rows).copied();
    reader.used.replace(rows.chain(of_structure).collect());
    Programs::new(list, reader.folder.study.clone(), String::new())
}

/// The name of a program with the rows of the parameters that its numbers contain.
type Used = (&'static str, BTreeSet<usize>);

/// The programs of a study, and what each uses.
fn list(root: &Object, reader: &Reader, faults: &mut Faults) -> (Vec<Program>, Vec<Used>) {
    let node = root.get(KEY.name);
    let object = node.and_then(|node| Object::of_any_keys(node, KEY.name, faults));
    let (mut list, mut used) = (Vec::new(), Vec::new());
    for (object, member) in object
        .iter()
        .flat_map(|object| object.members.iter().map(move |member| (object, member)))
    {
        let path = object.path(&member.key);
        if let Some(message) = name_fault(&member.key) {
            faults.add(member.at, &path, message);
        }
        list.extend(program(member, &path, reader, faults));
        used.push((interned(&member.key), reader.used.take()));
    }
    (list, used)
}

/// The rows that only numbers of programs contain, with the names of these programs.
fn restricted(reader: &Reader, used: &[Used]) -> Vec<(usize, &'static [&'static str])> {
    let elsewhere = used_elsewhere(reader);
    let rows: BTreeSet<usize> = used.iter().flat_map(|(_, rows)| rows).copied().collect();
    let alone = rows.into_iter().filter(|row| !elsewhere.contains(row));
    let with_names = alone.map(|row| {
        let having = used.iter().filter(|(_, rows)| rows.contains(&row));
        (row, interned_names(having.map(|(name, _)| *name).collect()))
    });
    with_names.collect()
}

/// Why a program cannot have this name.
fn name_fault(name: &str) -> Option<String> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    let is_name = name.chars().all(plain) && name.starts_with(|c: char| c.is_ascii_alphabetic());
    match METHODS.iter().any(|method| method.name == name) {
        true => Some(format!("{} is a method of slipgap; choose another name", quoted(name))),
        false => (!is_name).then(|| {
            format!(
                "{} cannot name a program; a name is letters, digits, _ and -, beginning with a letter",
                quoted(name)
            )
        }),
    }
}

fn program(member: &Member, path: &str, reader: &Reader, faults: &mut Faults) -> Option<Program> {
    let before = faults.count();
    let object = Object::open(&member.node, path, &PROGRAM, faults)?;
    object.given("command", faults)?;
    let command = object.items("command", faults, text);
    if command.is_empty() && faults.count() == before {
        let (node, path) = object.given("command", faults)?;
        faults.must_be(node, &path, "a list of the program and its arguments");
    }
    let files = object.items("files", faults, |node, path, faults| {
        let name = text(node, path, faults)?;
        match reader.folder.bytes(&name, LARGEST) {
            Ok(bytes) => reader.keep(&name, &bytes),
            Err(why) => faults.add(node.at, path, format!("{}: {why}", quoted(&name))),
        }
        Some(())
    });
    drop(files);
    let mut numbers = Vec::new();
    if let Some((node, path)) = object.given("parameters", faults)
        && let Some(given) = Object::of_any_keys(node, &path, faults)
    {
        for member in &given.members {
            let path = join(&path, &member.key);
            let amount = reader.amount(&member.node, &path, Range::Any, faults);
            numbers.extend(amount.map(|amount| (member.key.clone(), amount)));
        }
    }
    let timeouts = ["timeout", "start_timeout"].map(|key| match object.given(key, faults) {
        Some((node, path)) => number(node, &path, Range::Positive, faults).unwrap_or(SECONDS),
        None => SECONDS,
    });
    let adaptive = match object.given("adaptive", faults) {
        None => false,
        Some((node, path)) => match node.tree {
            Tree::Bool(adaptive) => adaptive,
            Tree::Object(_) | Tree::List(_) | Tree::Text(_) | Tree::Number(_) | Tree::Null => {
                faults.must_be(node, &path, "true or false");
                false
            }
        },
    };
    (faults.count() == before).then(|| Program {
        name: interned(&member.key),
        command,
        folder: reader.folder.path.to_owned(),
        numbers,
        timeouts,
        adaptive,
    })
}

/// Rows of the parameters that expressions of other parameters or conditions contain.
fn used_elsewhere(reader: &Reader) -> BTreeSet<usize> {
    let given = given(reader.root);
    let values = given.iter().flat_map(|(member, _)| texts(&member.node));
    let formulas = values.filter_map(|text| Formula::number(text, reader.table).ok());
    let mut conditions = Vec::new();
    under(reader.root, "when", &mut conditions);
    let listed = conditions.into_iter();
    let conditions = listed.filter_map(|text| Formula::condition(text, reader.table).ok());
    let uses = formulas.chain(conditions);
    uses.flat_map(|formula| formula.uses().to_vec()).collect()
}

/// Names that live as long as the program, once for equal lists.
fn interned_names(names: Vec<&'static str>) -> &'static [&'static str] {
    static LISTS: Mutex<BTreeSet<&'static [&'static str]>> = Mutex::new(BTreeSet::new());
    let mut lists = LISTS.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = lists.get(&names[..]) {
        return known;
    }
    let list: &'static [&'static str] = Box::leak(names.into_boxed_slice());
    lists.insert(list);
    list
}
