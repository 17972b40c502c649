//! The decoded values of one figure by their keys.

use super::choice::{Fit, Marks, Ridge};
use crate::faults::join;
use crate::tree::{Node, Tree};
use crate::{ColumnRef, Filter, Scale};

/// The decoded value of one key.
pub(crate) enum DecodedValue {
    Text(String),
    Filter(Filter),
    Rows(Vec<usize>),
    Column(ColumnRef),
    Numbers(Vec<f64>),
    Width(f64),
    Range([f64; 2]),
    Scale(Scale),
    Ridge(Ridge),
    Fit(Fit),
    Marks(Marks),
    Switch(bool),
}

/// The decoded values of one figure, by key.
pub(crate) struct Values<'a> {
    pub node: &'a Node,
    pub path: &'a str,
    pub taken: Vec<(&'static str, &'a Node, DecodedValue)>,
}

impl Values<'_> {
    pub fn text(&self, key: &str) -> Option<String> {
        match self.get(key)? {
            DecodedValue::Text(text) => Some(text.clone()),
            _ => None,
        }
    }

    pub fn rows(&self, key: &str) -> Option<Vec<usize>> {
        match self.get(key)? {
            DecodedValue::Rows(rows) => Some(rows.clone()),
            _ => None,
        }
    }

    pub fn row(&self, key: &str) -> Option<usize> {
        self.rows(key)?.first().copied()
    }

    pub fn column(&self, key: &str) -> Option<ColumnRef> {
        match self.get(key)? {
            DecodedValue::Column(column) => Some(*column),
            _ => None,
        }
    }

    pub fn scale(&self, key: &str) -> Scale {
        self.scale_or(key, Scale::Linear)
    }

    pub fn scale_or(&self, key: &str, left_out: Scale) -> Scale {
        match self.get(key) {
            Some(DecodedValue::Scale(scale)) => *scale,
            _ => left_out,
        }
    }

    pub fn ridge(&self, key: &str) -> Option<Ridge> {
        match self.get(key)? {
            DecodedValue::Ridge(ridge) => Some(*ridge),
            _ => None,
        }
    }

    pub fn fit(&self, key: &str) -> Fit {
        match self.get(key) {
            Some(DecodedValue::Fit(fit)) => *fit,
            _ => Fit::default(),
        }
    }

    pub fn marks(&self, key: &str) -> Option<Marks> {
        match self.get(key)? {
            DecodedValue::Marks(marks) => Some(marks.clone()),
            _ => None,
        }
    }

    pub fn switch(&self, key: &str) -> bool {
        self.given_switch(key) == Some(true)
    }

    /// `None` if the key is not given, or has another meaning for the kind.
    pub fn given_switch(&self, key: &str) -> Option<bool> {
        match self.get(key)? {
            DecodedValue::Switch(on) => Some(*on),
            _ => None,
        }
    }

    /// Times or ratios; none if the key is not given.
    pub fn numbers(&self, key: &str) -> Vec<f64> {
        match self.get(key) {
            Some(DecodedValue::Numbers(numbers)) => numbers.clone(),
            _ => Vec::new(),
        }
    }

    pub fn width(&self, key: &str) -> Option<f64> {
        match self.get(key)? {
            DecodedValue::Width(width) => Some(*width),
            _ => None,
        }
    }

    pub fn range(&self, key: &str) -> Option<[f64; 2]> {
        match self.get(key)? {
            DecodedValue::Range(range) => Some(*range),
            _ => None,
        }
    }

    pub fn filter(&self) -> Filter {
        match self.get("where") {
            Some(DecodedValue::Filter(filter)) => filter.clone(),
            _ => Filter::default(),
        }
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
