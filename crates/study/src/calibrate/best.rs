//! The study of an alternative with its best values, ready to run.

use super::edit::{SHOWN, minimised, put_metrics};
use super::files::move_files;
use super::nodes::{blocks, items, list, put, put_remark, remove, take};
use super::{Alternative, print};
use crate::error::Error;
use crate::source::input::Input;
use crate::source::tree::{Node, Tree};
use crate::{MOST_CASES, Study};
use slipgap_problem::problem::numbers::parameter::{Value, shortest};
use std::path::Path;

impl Input {
    /// The text of the study of an alternative with these values of its parameters, for a file in `folder`, which exists. It has no
    /// `calibrate`, and no checks, reductions and ensembles, which are of several cases; figures that need other cases are left out.
    ///
    /// # Errors
    /// As of [`Input::study`].
    pub fn with_values(
        &self,
        study: &Study,
        alternative: &Alternative,
        values: &[(usize, f64)],
        folder: &Path,
        remark: &str,
    ) -> Result<String, Error> {
        let mut root = self.expanded()?.root;
        let metrics = minimised(&root);
        add_metric(&mut root, metrics.last());
        remove(
            &mut root,
            &["calibrate", "recommend", SHOWN[1], SHOWN[2], SHOWN[3]],
        );
        keep_block(&mut root, alternative.block);
        if let Some(block) = blocks(&mut root).first_mut() {
            fix(block, study, alternative, values);
        }
        move_files(&mut root, &self.folder, folder);
        put_remark(&mut root, remark);
        let figures = take(&mut root, SHOWN[0]);
        let decodes = |root: &Node| {
            let input = Input {
                folder: folder.to_owned(),
                ..Input::new(&self.file, &print::text(root))
            };
            input.study(MOST_CASES).is_ok()
        };
        if !decodes(&root) {
            // A metric is relative to a case of another alternative.
            put_metrics(&mut root, metrics);
        }
        let mut kept = Vec::new();
        for figure in items(figures) {
            let mut one = root.clone();
            put(&mut one, SHOWN[0], list(vec![figure.clone()]));
            if decodes(&one) {
                kept.push(figure);
            }
        }
        if !kept.is_empty() {
            put(&mut root, SHOWN[0], list(kept));
        }
        Ok(print::text(&root))
    }
}

/// Adds the minimised metric to those of the study.
fn add_metric(root: &mut Node, metric: Option<&Node>) {
    let Some(metric) = metric else {
        return;
    };
    let mut metrics = match take(root, "metrics") {
        Some(Node {
            tree: Tree::List(items),
            ..
        }) => items,
        one => one.into_iter().collect(),
    };
    let is_it = |node: &Node| match &node.tree {
        Tree::Object(members) => members
            .iter()
            .any(|member| matches!(&metric.tree, Tree::Text(text) if *text == member.key)),
        tree @ (Tree::List(_) | Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null) => {
            *tree == metric.tree
        }
    };
    if !metrics.iter().any(is_it) {
        metrics.push(metric.clone());
    }
    put(root, "metrics", list(metrics));
}

/// Keeps one block of several.
fn keep_block(root: &mut Node, block: usize) {
    if let Some(Tree::List(blocks)) = root.member("blocks").map(|node| &mut node.tree) {
        *blocks = blocks.get(block).cloned().into_iter().collect();
    }
}

/// Gives a block the values of an alternative in the place of its axes, and those of the free parameters.
fn fix(block: &mut Node, study: &Study, alternative: &Alternative, values: &[(usize, f64)]) {
    let table = study.problem.parameters();
    let tests = study
        .calibrate
        .as_ref()
        .and_then(|calibrate| calibrate.tests);
    let given = &study.blocks[alternative.block];
    let Some(raw) = alternative.raws.first() else {
        return;
    };
    let mut fixed: Vec<(String, Value)> = Vec::new();
    for (group, position) in given.groups.iter().zip(given.positions(*raw)) {
        if tests.is_some_and(|row| group.has(row)) {
            continue;
        }
        for axis in &group.axes {
            let free = values.iter().find(|(row, _)| *row == axis.parameter);
            let value = match free {
                Some((_, x)) => Value::Number(*x),
                None if axis.values.len() > 1 || given.design.is_some() => {
                    axis.values.at(position as usize)
                }
                None => continue,
            };
            fixed.push((table[axis.parameter].name.to_string(), value));
        }
    }
    if let Some(zip) = block.member("zip")
        && let Tree::List(groups) = &mut zip.tree
    {
        let names = |group: &Node| -> bool {
            let Tree::List(names) = &group.tree else {
                return false;
            };
            let is_fixed = |name: &Node| {
                fixed.iter().any(
                    |(parameter, _)| matches!(&name.tree, Tree::Text(text) if text == parameter),
                )
            };
            names.iter().any(is_fixed)
        };
        groups.retain(|group| !names(group));
    }
    remove(block, &["design"]);
    let Some(parameters) = block.member("parameters") else {
        return;
    };
    for (name, value) in fixed {
        put_nested(parameters, &name, node_of(value));
    }
}

/// Puts the value of a parameter, which may be in an object of its own, such as `right.L`.
fn put_nested(parameters: &mut Node, name: &str, value: Node) {
    if let Some((object, key)) = name.split_once('.')
        && let Some(inner) = parameters.member(object)
    {
        return put_nested(inner, key, value);
    }
    put(parameters, name, value);
}

fn node_of(value: Value) -> Node {
    let tree = match value {
        Value::Number(x) => Tree::Number(shortest(x)),
        Value::Whole(n) => Tree::Number(n.to_string()),
        Value::Name(name) => Tree::Text(name.to_owned()),
    };
    Node { at: 0, tree }
}
