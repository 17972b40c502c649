//! The decoded values of one figure by their keys.

use super::choice::{Each, Fit, Marks, Ridge};
use crate::faults::join;
use crate::tree::{Node, Tree};
use crate::{ColumnRef, Filter, Scale};

/// The decoded value of one key.
pub(crate) enum DecodedValue {
    Text(String),
    Filter(Filter),
    Rows(Vec<usize>),
    Columns(Vec<ColumnRef>),
    Numbers(Vec<f64>),
    Width(f64),
    Range([f64; 2]),
    Scale(Scale),
    Ridge(Ridge),
    Fit(Fit),
    Each(Each),
    Marks(Marks),
    Points(Vec<[f64; 2]>),
    Switch(bool),
}

/// The decoded values of one figure, by key.
pub(crate) struct Values<'a> {
    pub node: &'a Node,
    pub path: &'a str,
    pub taken: Vec<(&'static str, &'a Node, DecodedValue)>,
}

/// The value of a key as a variant of [`DecodedValue`]; `None` if the key is not given, or has another meaning for the kind.
macro_rules! taken {
    ($values:expr, $key:expr, $kind:ident) => {
        match $values.get($key) {
            Some(DecodedValue::$kind(value)) => Some(Clone::clone(value)),
            _ => None,
        }
    };
}

impl Values<'_> {
    pub fn text(&self, key: &str) -> Option<String> {
        taken!(self, key, Text)
    }

    pub fn rows(&self, key: &str) -> Option<Vec<usize>> {
        taken!(self, key, Rows)
    }

    pub fn row(&self, key: &str) -> Option<usize> {
        self.rows(key)?.first().copied()
    }

    pub fn column(&self, key: &str) -> Option<ColumnRef> {
        self.columns(key).first().copied()
    }

    /// Columns of the results; none if the key is not given.
    pub fn columns(&self, key: &str) -> Vec<ColumnRef> {
        taken!(self, key, Columns).unwrap_or_default()
    }

    pub fn scale(&self, key: &str) -> Scale {
        self.scale_or(key, Scale::Linear)
    }

    pub fn scale_or(&self, key: &str, left_out: Scale) -> Scale {
        taken!(self, key, Scale).unwrap_or(left_out)
    }

    pub fn ridge(&self, key: &str) -> Option<Ridge> {
        taken!(self, key, Ridge)
    }

    pub fn fit(&self, key: &str) -> Fit {
        taken!(self, key, Fit).unwrap_or_default()
    }

    pub fn each(&self, key: &str) -> Each {
        taken!(self, key, Each).unwrap_or_default()
    }

    pub fn marks(&self, key: &str) -> Option<Marks> {
        taken!(self, key, Marks)
    }

    /// Points; none if the key is not given.
    pub fn points(&self, key: &str) -> Vec<[f64; 2]> {
        taken!(self, key, Points).unwrap_or_default()
    }

    pub fn switch(&self, key: &str) -> bool {
        self.given_switch(key) == Some(true)
    }

    pub fn given_switch(&self, key: &str) -> Option<bool> {
        taken!(self, key, Switch)
    }

    /// Times or ratios; none if the key is not given.
    pub fn numbers(&self, key: &str) -> Vec<f64> {
        taken!(self, key, Numbers).unwrap_or_default()
    }

    pub fn width(&self, key: &str) -> Option<f64> {
        taken!(self, key, Width)
    }

    pub fn range(&self, key: &str) -> Option<[f64; 2]> {
        taken!(self, key, Range)
    }

    pub fn filter(&self) -> Filter {
        taken!(self, "where", Filter).unwrap_or_default()
    }

    fn get(&self, key: &str) -> Option<&DecodedValue> {
        let found = self.taken.iter().find(|taken| taken.0 == key);
        found.map(|taken| &taken.2)
    }

    /// Whether the figure has `key`.
    pub fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }

    /// The offset of the value of `key`; of the figure, if the key is not given.
    pub fn at(&self, key: &str) -> usize {
        let found = self.taken.iter().find(|taken| taken.0 == key);
        found.map_or(self.node.at, |taken| taken.1.at)
    }

    /// The offset and path of item `i` of the value of `key`, which may be given without a list.
    pub fn item(&self, key: &str, i: usize) -> (usize, String) {
        let path = join(self.path, key);
        let found = self.taken.iter().find(|taken| taken.0 == key);
        match found.map(|taken| &taken.1.tree) {
            Some(Tree::List(items)) if i < items.len() => (items[i].at, format!("{path}[{i}]")),
            _ => (self.at(key), path),
        }
    }
}
