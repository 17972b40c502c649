//! One column of the results over another.

use crate::field::{field, fields, needed};
use crate::figure::checker::Checker;
use crate::figure::keys::{Takes, X_RANGE, X_SCALE, Y_RANGE, Y_SCALE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use crate::{ColumnRef, Scale};
use slipgap_problem::problem::Problem;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "scatter",
    needs: Needs::Nothing,
    meaning: "one column of the results over another, one dot for each case; more than 2000 dots become one image in SVG and PDF",
    keys: &fields![
        /// parameter or metric along the horizontal axis
        needed("x", Takes::Column),
        /// parameter or metric along the vertical axis
        needed("y", Takes::Column),
        /// parameter or metric shown by colour
        field("colour", Takes::Column),
        X_SCALE,
        Y_SCALE,
        /// scale of the colours; default linear
        field("colour_scale", Takes::Scale),
        X_RANGE,
        Y_RANGE,
    ],
    decode: |values, _| {
        Some(FigureKind::Scatter(Scatter {
            x: values.column("x")?,
            y: values.column("y")?,
            colour: values.column("colour"),
            scales: ["x_scale", "y_scale", "colour_scale"].map(|key| values.scale(key)),
        }))
    },
};

/// One column of the results over another, a dot for each case.
#[derive(Debug)]
pub struct Scatter {
    /// Along the horizontal axis.
    pub x: ColumnRef,
    /// Along the vertical axis.
    pub y: ColumnRef,
    /// Shown by the colour of the dots, if any.
    pub colour: Option<ColumnRef>,
    /// Scales of the two axes and of the colours.
    pub scales: [Scale; 3],
}

impl Scatter {
    /// The columns with their keys.
    fn columns(&self) -> [(&'static str, Option<ColumnRef>); 3] {
        [
            ("x", Some(self.x)),
            ("y", Some(self.y)),
            ("colour", self.colour),
        ]
    }
}

impl Decoded for Scatter {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some(([self.scales[0], self.scales[1]], 1))
    }

    fn check_cases(&self, checker: &mut Checker) {
        for ((key, column), scale) in self.columns().into_iter().zip(self.scales) {
            if let Some(ColumnRef::Parameter(row)) = column {
                checker.has_values(key, row);
                checker.suits_scale(key, row, scale);
                if key == "x" {
                    checker.range_shows_some(row);
                }
            }
        }
        if self.x == self.y {
            checker.fault("y", "must be a column other than x");
        }
        if self.colour.is_none() && checker.values.has("colour_scale") {
            checker.fault("colour_scale", "needs the key \"colour\"");
        }
    }

    fn columns(&self) -> Option<Vec<ColumnRef>> {
        let columns = Scatter::columns(self).into_iter();
        Some(columns.filter_map(|(_, column)| column).collect())
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        let columns = self.columns().into_iter().filter_map(|(_, column)| column);
        let metric = |column| match column {
            ColumnRef::Metric(row) => Some(row),
            ColumnRef::Parameter(_) => None,
        };
        columns.filter_map(metric).collect()
    }
}
