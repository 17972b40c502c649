//! The layout of a sheet: frames, legend, heading.

pub mod axis;
pub mod clip;
pub mod cloud;
pub mod coincide;
pub mod envelope;
pub mod inset;
pub mod legend;
pub mod limits;
pub mod points;
mod rect;
mod series;
pub mod sheet;
pub mod slope;
pub mod ticks;

use crate::{style, text};
pub use axis::{TITLE_LINE, below, foot, horizontal_title};

use axis::Axis;
use legend::Key;
use sheet::{Anchor, Panel, PlacedText, Rect, Shape, Sheet};

/// Height of the caption over each frame.
pub const CAPTION_LINE: f64 = style::TITLE + style::LABEL_GAP;

/// The lines of the title of a vertical axis of this length.
pub fn vertical_title(title: &str, length: f64) -> Vec<String> {
    // It may reach over the captions at both ends.
    text::wrap(title, style::TITLE, length + CAPTION_LINE)
}

/// Least width of each of several panels side by side that share a vertical axis.
const SHARED: f64 = 130.0;
/// Least width of each of several panels side by side that have separate vertical axes.
const OWN: f64 = 160.0;

/// How many of up to `columns` panels that share a vertical axis fit side by side; all if no width is given.
pub fn side_by_side(columns: usize, width: Option<f64>) -> usize {
    match width {
        Some(width) => columns.min((width / SHARED) as usize).max(1),
        None => columns,
    }
}

/// Whether panels with separate vertical axes fit side by side; they do if no width is given.
pub fn own_axes(columns: usize, width: Option<f64>) -> bool {
    width.is_none_or(|width| width / columns as f64 >= OWN)
}

/// Frames of a grid of panels over the width of a sheet, each row with its height.
pub struct Grid {
    /// Width of the numbers and title left of the first frame of a row.
    pub margin: f64,
    /// Width of each frame.
    pub width: f64,
    /// Frames, row by row.
    pub frames: Vec<Vec<Rect>>,
}

/// Lays out rows of the given heights in `columns`, with space for the numbers of the vertical axes `y`, and `right`
/// points right of the last frame.
pub fn grid(sheet_width: f64, columns: usize, heights: &[f64], y: &[Axis], right: f64) -> Grid {
    let labels = y
        .iter()
        .flat_map(|axis| &axis.ticks)
        .map(|tick| &tick.label);
    // A power is over the numbers, and may reach over most of the gap beside them.
    let gaps = style::TITLE_GAP - 2.0;
    let powers = y
        .iter()
        .map(|axis| text::width(&axis.power_label(), style::LABEL) - gaps);
    let numbers = labels
        .map(|label| text::width(label, style::LABEL))
        .chain(powers)
        .fold(0.0, f64::max);
    // Titles longer than their panel take several lines.
    let lines_of = |(i, height): (usize, &f64)| match y.get(i).or(y.last()) {
        Some(axis) => vertical_title(&axis.title, *height).len(),
        None => 1,
    };
    let lines = heights.iter().enumerate().map(lines_of).max().unwrap_or(1);
    let titles = style::TITLE + lines.saturating_sub(1) as f64 * TITLE_LINE;
    let margin = titles + style::TITLE_GAP + numbers + style::LABEL_GAP;
    // Wide enough for the last number of one axis and the first of the next.
    let between = 18.0;
    let columns_wide = columns as f64;
    let free = sheet_width - 2.0 * style::EDGE - margin - right - (columns_wide - 1.0) * between;
    // Whole points, so that the frames of a sheet have the same pixels.
    let width = (free / columns_wide).floor();
    let mut top = style::EDGE;
    let mut frames = Vec::new();
    for &height in heights {
        top += CAPTION_LINE;
        let row = (0..columns).map(|k| Rect {
            left: (style::EDGE + margin).round() + k as f64 * (width + between),
            top,
            width,
            height,
        });
        frames.push(row.collect());
        top += height + 4.0;
    }
    Grid {
        margin,
        width,
        frames,
    }
}

/// Lays out rows of the given heights with a column for each of the vertical axes `y`, each with space for its numbers.
pub fn columns(sheet_width: f64, heights: &[f64], y: &[Axis]) -> Vec<Grid> {
    let share = (sheet_width / y.len() as f64).floor();
    let column = |k: usize| {
        // Space for the longest numbers in every column, so that frames have equal widths.
        let mut grid = grid(share, 1, heights, y, 6.0);
        for frame in grid.frames.iter_mut().flatten() {
            frame.left += k as f64 * share;
        }
        grid
    };
    (0..y.len()).map(column).collect()
}

/// Finishes a sheet whose panels start at the top: places legends and heading, and sets the height.
///
/// `keys` has the legend of the first panel, of the second and so on; panels without one may be left out.
pub fn finish(sheet: &mut Sheet, mut keys: Vec<Vec<Key>>, heading: Option<&str>) {
    limits::keep_numbers_whole(sheet);
    legend::mark_single_points(&mut sheet.panels, &mut keys);
    // Without captions, no space for them.
    let has_power = |axis: &Axis| axis.numbered && axis.power != 0;
    let bare =
        |panel: &Panel| panel.caption.is_empty() && panel.map.is_none() && !has_power(&panel.y);
    if sheet.panels.iter().all(bare) {
        move_down(sheet, style::LABEL_GAP - CAPTION_LINE);
    }
    sheet.legend = match legend::within(&sheet.panels, &keys) {
        Some(entries) => entries,
        None => {
            let (entries, by) = legend::over(sheet, &keys);
            move_down(sheet, by);
            entries
        }
    };
    // Titles of colour bars in several lines.
    let bars = sheet
        .panels
        .iter()
        .filter_map(bar_title)
        .map(|lines| lines.len());
    let lines = bars.max().unwrap_or(1).saturating_sub(1);
    move_down(sheet, lines as f64 * TITLE_LINE);
    head(sheet, heading);
    let bottoms = sheet
        .panels
        .iter()
        .map(|p| p.frame.bottom() + foot(&p.x, p.frame.width));
    sheet.height = (bottoms.fold(0.0, f64::max) + style::EDGE).ceil();
    coincide::find(sheet);
}

/// The lines of the title over a colour bar, which may reach to the left over the frame.
pub fn bar_title(panel: &Panel) -> Option<Vec<String>> {
    let map = panel.map.as_ref()?;
    let room = map.bar?.right() - panel.frame.left;
    Some(text::wrap(&map.colours.title, style::TITLE, room))
}

/// Places the heading over what is on a sheet; how far all moves down for it.
pub fn head(sheet: &mut Sheet, heading: Option<&str>) -> f64 {
    let mut moved = 0.0;
    if let Some(heading) = heading {
        let lines = text::wrap(heading, style::TITLE, sheet.width - 2.0 * style::EDGE);
        for (i, text) in lines.into_iter().enumerate() {
            moved += move_down(sheet, style::TITLE + if i == 0 { 6.0 } else { 3.0 });
            sheet.heading.push(PlacedText {
                at: [
                    sheet.width / 2.0,
                    style::EDGE + style::TITLE + i as f64 * (style::TITLE + 3.0),
                ],
                anchor: Anchor::Middle,
                text,
                size: style::TITLE,
            });
        }
    }
    moved
}

/// Adds small text under a finished sheet, in as many lines as needed.
pub fn small_print(sheet: &mut Sheet, markup: &str) {
    let free = sheet.width - 2.0 * style::EDGE;
    for text in text::wrap(markup, style::LABEL, free) {
        sheet.height += style::LEADING;
        sheet.small_print.push(PlacedText {
            at: [style::EDGE, sheet.height - style::EDGE],
            anchor: Anchor::Start,
            text,
            size: style::LABEL,
        });
    }
}

/// Moves what is on a sheet down by whole points; by how many.
fn move_down(sheet: &mut Sheet, by: f64) -> f64 {
    let by = by.ceil();
    for panel in &mut sheet.panels {
        move_panel(panel, by);
    }
    for entry in &mut sheet.legend {
        entry.at[1] += by;
    }
    for words in &mut sheet.picture.words {
        words.at[1] += by;
    }
    for shape in &mut sheet.picture.shapes {
        match shape {
            Shape::Line(points, _) => points.iter_mut().for_each(|point| point[1] += by),
            Shape::Box(rect, _) => rect.top += by,
            Shape::Arrow(ends) | Shape::DoubleArrow(ends) => {
                ends.iter_mut().for_each(|end| end[1] += by);
            }
        }
    }
    by
}

fn move_panel(panel: &mut Panel, by: f64) {
    panel.frame.top += by;
    for words in &mut panel.notes {
        words.at[1] += by;
    }
    if let Some(map) = &mut panel.map {
        for words in &mut map.labels {
            words.at[1] += by;
        }
        if let Some(bar) = &mut map.bar {
            bar.top += by;
        }
    }
    if let Some(inset) = &mut panel.inset {
        move_panel(inset, by);
    }
}

/// Adds to the caption of the first panel that only `some` of `all` curves are shown, if they are fewer.
pub fn left_out(sheet: &mut Sheet, some: usize, count: usize) {
    if let (true, Some(first)) = (some < count, sheet.panels.first_mut()) {
        let space = if first.caption.is_empty() { "" } else { "  " };
        first.caption += &format!("{space}the first {some} of {count} curves");
    }
}

/// Letters for panels, `(a)`, `(b)`, ..., before the caption; none for a single panel.
pub fn letter_panels(panels: &mut [Panel]) {
    if panels.len() < 2 {
        return;
    }
    for (i, panel) in panels.iter_mut().enumerate() {
        let letter = char::from(b'a' + (i % 26) as u8);
        let said = std::mem::take(&mut panel.caption);
        let space = if said.is_empty() { "" } else { "  " };
        panel.caption = format!("({letter}){space}{said}");
    }
}
