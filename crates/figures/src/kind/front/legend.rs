//! The legends of a front: many entries for each of its panels, beside the panel, or in columns over it.

use slipgap_drawing::layout::CAPTION_LINE;
use slipgap_drawing::layout::legend::{Key, rows};
use slipgap_drawing::layout::sheet::{Entry, Panel};
use slipgap_drawing::style;

/// Least width of a frame beside its legend.
const FRAME: f64 = 150.0;

/// Distance of a legend from its panel, and of its columns.
const GAP: f64 = 12.0;

/// How the legends are arranged; all panels in the same way.
pub struct Arrangement {
    /// Columns over a panel; `None` for legends beside the panels.
    over: Option<usize>,
    /// Width of a column.
    width: f64,
}

impl Arrangement {
    /// The arrangement that fits a sheet of this width.
    pub fn of(keys: &[Vec<Key>], width: f64) -> Arrangement {
        let longest = keys.iter().flatten().map(Key::length).fold(0.0, f64::max);
        let column = longest + GAP;
        // The numbers and title of a vertical axis need about 50 points.
        let beside = width - 50.0 - column >= FRAME;
        let columns = ((width - 2.0 * style::EDGE + GAP) / column) as usize;
        Arrangement {
            over: (!beside).then_some(columns.max(1)),
            width: column,
        }
    }

    /// Width right of the frames.
    pub fn right(&self) -> f64 {
        if self.over.is_none() { self.width } else { 4.0 }
    }

    /// Height of a legend over its panel; 0 for one beside it.
    pub fn height_over(&self, keys: &[Key]) -> f64 {
        self.over.map_or(0.0, |columns| {
            keys.len().div_ceil(columns) as f64 * style::LEADING
        })
    }

    /// Height of a legend beside its panel; 0 for one over it.
    pub fn height_beside(&self, keys: &[Key]) -> f64 {
        match self.over {
            Some(_) => 0.0,
            None => keys.len() as f64 * style::LEADING,
        }
    }

    /// The entries of the panels at their places.
    pub fn entries(&self, keys: &[Vec<Key>], panels: &[Panel]) -> Vec<Entry> {
        let of_panel = |(keys, panel): (&Vec<Key>, &Panel)| {
            let frame = &panel.frame;
            match self.over {
                None => rows(keys, [frame.right() + GAP, frame.top], 1, self.width),
                Some(columns) => {
                    let caption = match panel.caption.is_empty() {
                        true => style::LABEL_GAP,
                        false => CAPTION_LINE,
                    };
                    let top = frame.top - caption - self.height_over(keys);
                    rows(keys, [style::EDGE, top], columns, self.width)
                }
            }
        };
        keys.iter().zip(panels).flat_map(of_panel).collect()
    }
}
