//! One metric over two parameters.

use crate::field::{field, fields, needed};
use crate::figure::checker::Checker;
use crate::figure::choice::{Marks, Ridge};
use crate::figure::keys::{Takes, X, X_SCALE, Y_SCALE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use crate::figure::{limits, sampled, vary};
use crate::{ColumnRef, Scale};
use slipgap_problem::problem::Problem;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "map",
    needs: Needs::Nothing,
    meaning: "one metric over two parameters as filled contours; hatched where empty",
    keys: &fields![
        X,
        /// parameter along the vertical axis
        needed("y", Takes::NumericParameter),
        /// metric shown as shades
        needed("z", Takes::Metric),
        X_SCALE,
        Y_SCALE,
        /// scale of the shades; default linear
        field("z_scale", Takes::Scale),
        /// values at both ends of the colour bar, as in [0.001, 1]
        field("z_range", Takes::Range),
        /// points to mark: { "label": text, "at": [[x, y], ...] }
        field("marks", Takes::Marks),
        /// line through the y with the metric least, greatest or nearest to 1 at each x
        field("ridge", Takes::Ridge),
    ],
    decode: |values, _| {
        Some(FigureKind::Map(Map {
            x: values.row("x")?,
            y: values.row("y")?,
            z: values.row("z")?,
            scales: ["x_scale", "y_scale", "z_scale"].map(|key| values.scale(key)),
            z_range: values.range("z_range"),
            marks: values.marks("marks"),
            ridge: values.ridge("ridge"),
        }))
    },
};

/// One metric over two parameters, as filled contours with a colour bar.
#[derive(Debug)]
pub struct Map {
    /// Parameter along the horizontal axis.
    pub x: usize,
    /// Parameter along the vertical axis.
    pub y: usize,
    /// Row of the study's measures.
    pub z: usize,
    /// Scales of the two axes and of the colours.
    pub scales: [Scale; 3],
    /// Values at both ends of the colour bar, if the study gives them.
    pub z_range: Option<[f64; 2]>,
    /// Places to mark, if any.
    pub marks: Option<Marks>,
    /// What the line along it follows, if there is one.
    pub ridge: Option<Ridge>,
}

impl Decoded for Map {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        None
    }

    fn check_keys(&self, checker: &mut Checker) {
        limits::suits_scale(checker, "z_range", self.z_range, self.scales[2]);
    }

    fn check_cases(&self, checker: &mut Checker) {
        if sampled::refused(checker, KIND.name) {
            return;
        }
        let axes = [("x", self.x), ("y", self.y)];
        for ((key, row), scale) in axes.into_iter().zip(self.scales) {
            checker.has_values(key, row);
            checker.suits_scale(key, row, scale);
        }
        if self.x == self.y {
            checker.fault("y", "must be a parameter other than x");
        }
        vary::check(
            checker,
            &[self.x, self.y],
            "a map shows one case at each point",
            "",
        );
        for (key, row) in axes {
            checker.has_two_values(key, row, KIND.name);
        }
        for (i, at) in self.marks.iter().flat_map(|marks| &marks.at).enumerate() {
            for ((_, row), x) in axes.into_iter().zip(at) {
                checker.reaches(row, *x, i);
            }
        }
    }

    fn columns(&self) -> Option<Vec<ColumnRef>> {
        let [x, y] = [self.x, self.y].map(ColumnRef::Parameter);
        Some(vec![x, y, ColumnRef::Metric(self.z)])
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        vec![self.z]
    }
}

#[cfg(test)]
mod tests {
    use crate::parse;

    #[test]
    fn limits_of_the_shades_are_checked_like_those_of_axes() {
        let wrong = |keys: &str| {
            let study = format!(
                r#"{{"problem": "bar-impact", "parameters": {{"gamma": [1, 2], "n": 4, "dt": [0.01, 0.02], "duration": 1}},
                  "figures": [{{"name": "f", "kind": "map", "x": "gamma", "y": "dt", "z": "peak_force", {keys}}}]}}"#
            );
            let wrong = parse("s", &study).err().map(|e| e.to_string());
            wrong.unwrap_or_default()
        };
        assert_eq!(wrong(r#""z_range": [0, 1]"#), "");
        assert_eq!(wrong(r#""z_scale": "log", "z_range": ["1/8", 1]"#), "");
        for (keys, message) in [
            (
                r#""z_scale": "log", "z_range": [0, 1]"#,
                "figures[0].z_range[0]: must be > 0 on a log scale, got 0",
            ),
            (
                r#""z_range": [1, 1]"#,
                "figures[0].z_range: the first value must be less than the last, got 1 and 1",
            ),
            (
                r#""z_range": 1"#,
                "figures[0].z_range: must be a list of two numbers",
            ),
        ] {
            let told = wrong(keys);
            assert!(told.contains(message), "{keys}: {told}");
        }
    }
}
