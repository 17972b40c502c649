//! A figure as data, before it is drawn. Lengths are points, y downwards.

use crate::layout::axis::Axis;
use crate::layout::cloud::Cloud;
use crate::style::{self, Marker, Stroke};

/// A rectangle on the sheet.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rect {
    /// Left edge.
    pub left: f64,
    /// Upper edge.
    pub top: f64,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}

impl Rect {
    /// Right edge.
    pub fn right(&self) -> f64 {
        self.left + self.width
    }

    /// Lower edge.
    pub fn bottom(&self) -> f64 {
        self.top + self.height
    }

    /// The same rectangle, larger by `by` on all sides.
    pub fn inflated(&self, by: f64) -> Rect {
        Rect {
            left: self.left - by,
            top: self.top - by,
            width: self.width + 2.0 * by,
            height: self.height + 2.0 * by,
        }
    }

    /// Whether a point lies inside or on an edge.
    pub fn contains(&self, [x, y]: [f64; 2]) -> bool {
        x >= self.left && x <= self.right() && y >= self.top && y <= self.bottom()
    }
}

/// A figure.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sheet {
    /// Its title in plain text, for screen readers.
    pub title: String,
    /// Its curves in plain text.
    pub description: String,
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
    /// Lines of text over the panels.
    pub heading: Vec<PlacedText>,
    /// Lines of text under the panels.
    pub small_print: Vec<PlacedText>,
    /// Panels, from upper left to lower right.
    pub panels: Vec<Panel>,
    /// What is drawn without axes.
    pub picture: Picture,
    /// The legend, once for the whole sheet: inside a panel if it covers nothing there, or else above the panels.
    pub legend: Vec<Entry>,
}

/// Shapes and words without axes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Picture {
    /// Shapes, drawn in this order.
    pub shapes: Vec<Shape>,
    /// Words over the shapes.
    pub words: Vec<PlacedText>,
}

/// A shape on the sheet.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A line through points, of this width.
    Line(Vec<[f64; 2]>, f64),
    /// A rectangle with an outline, filled with this grey: 0 is black, 255 white.
    Box(Rect, u8),
    /// A line with a head at its second end.
    Arrow([[f64; 2]; 2]),
    /// A line with a head at both ends.
    DoubleArrow([[f64; 2]; 2]),
}

/// A frame with its contents.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// The frame.
    pub frame: Rect,
    /// Width of the numbers and title of the vertical axis left of the frame.
    pub margin: f64,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Curves, drawn in this order.
    pub series: Vec<Series>,
    /// Bands instead of parts of curves, filled in this order.
    pub envelopes: Vec<Envelope>,
    /// Areas between two lines below the curves, filled in this order.
    pub bands: Vec<Band>,
    /// Bars below the curves.
    pub bars: Vec<Bar>,
    /// A filled map below the curves.
    pub map: Option<FilledMap>,
    /// Dots below the curves.
    pub cloud: Option<Cloud>,
    /// Whether the line y = 0 is drawn.
    pub zero: bool,
    /// Text over the frame, in markup; empty for none.
    pub caption: String,
    /// Text inside the frame.
    pub notes: Vec<PlacedText>,
    /// Dimension lines with an arrow at both ends, in the axes' units.
    pub arrows: Vec<[[f64; 2]; 2]>,
    /// A part of the panel, enlarged, in a frame inside of this one.
    pub inset: Option<Box<Panel>>,
}

impl Panel {
    /// An empty panel.
    pub fn new(frame: Rect, margin: f64, x: Axis, y: Axis) -> Panel {
        Panel {
            frame,
            margin,
            x,
            y,
            series: Vec::new(),
            envelopes: Vec::new(),
            bands: Vec::new(),
            bars: Vec::new(),
            map: None,
            cloud: None,
            zero: false,
            caption: String::new(),
            notes: Vec::new(),
            arrows: Vec::new(),
            inset: None,
        }
    }

    /// Whether the line y = 0 is drawn and is not an edge of the frame.
    pub fn shows_zero(&self) -> bool {
        self.zero && self.y.range[0] < 0.0 && self.y.range[1] > 0.0
    }

    /// The place on the sheet of a point in the axes' units; not finite for a point without one.
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            self.frame.left + self.frame.width * self.x.fraction(x),
            self.frame.bottom() - self.frame.height * self.y.fraction(y),
        ]
    }
}

/// The label of a measured curve.
pub const MEASURED: &str = "measured";

/// A curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Label in the legend, in markup.
    pub label: String,
    /// Points in the axes' units; one that is not finite leaves a gap.
    pub points: Vec<[f64; 2]>,
    /// Pattern of the line.
    pub stroke: Stroke,
    /// Width of the line.
    pub width: f64,
    /// Marker at the points `marked`.
    pub marker: Option<Marker>,
    /// Indices of the points with a marker.
    pub marked: Vec<usize>,
}

impl Series {
    /// The line of an exact solution.
    pub fn exact(points: Vec<[f64; 2]>) -> Series {
        Series {
            label: "exact".into(),
            points,
            stroke: Stroke::Solid,
            width: style::EXACT_LINE,
            marker: None,
            marked: Vec::new(),
        }
    }

    /// The line of what was measured.
    pub fn measured(points: Vec<[f64; 2]>) -> Series {
        Series {
            label: MEASURED.into(),
            points,
            stroke: Stroke::Grey,
            width: style::MEASURED_LINE,
            marker: None,
            marked: Vec::new(),
        }
    }

    /// A thin line without an entry in the legend.
    pub fn rule(points: [[f64; 2]; 2]) -> Series {
        Series {
            label: String::new(),
            points: points.to_vec(),
            stroke: Stroke::Solid,
            width: style::ZERO_LINE,
            marker: None,
            marked: Vec::new(),
        }
    }
}

/// The band between the envelopes of a part of a curve, in points of the curve by rising index. Both edges go from the
/// first to the last point of the part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Envelope {
    /// Which of the panel's curves.
    pub series: usize,
    /// The upper edge.
    pub upper: Vec<usize>,
    /// The lower edge.
    pub lower: Vec<usize>,
}

/// An area between two lines through points in the axes' units, all of them finite.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// The upper line, from left to right.
    pub upper: Vec<[f64; 2]>,
    /// The lower line, from left to right.
    pub lower: Vec<[f64; 2]>,
    /// Pattern of both lines.
    pub stroke: Stroke,
}

/// A bar between two corners in the axes' units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    /// Its sides, rising.
    pub x: [f64; 2],
    /// Its lower and upper end.
    pub y: [f64; 2],
    /// Its fraction of the scale of colours.
    pub shade: f64,
}

/// A line of the legend.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// Left end of the piece of line, at the height of the line.
    pub at: [f64; 2],
    /// Label in markup.
    pub label: String,
    /// Pattern of the line.
    pub stroke: Stroke,
    /// Width of the line.
    pub width: f64,
    /// Marker on the piece of line.
    pub marker: Option<Marker>,
}

impl Entry {
    /// Whether it continues the label of the entry before it, without a line or marker.
    pub fn continues(&self) -> bool {
        self.width == 0.0 && self.marker.is_none()
    }
}

/// Text at a place on the sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedText {
    /// The place: the end or middle of the base line, as `anchor` says.
    pub at: [f64; 2],
    /// Which part of the text is there.
    pub anchor: Anchor,
    /// The text in markup.
    pub text: String,
    /// Type size.
    pub size: f64,
}

/// Which part of a line of text is at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Its beginning.
    Start,
    /// Its middle.
    Middle,
    /// Its end.
    End,
}

/// A quantity over two axes as filled cells or bands.
#[derive(Debug, Clone, PartialEq)]
pub struct FilledMap {
    /// The cells; the panel is white where there is none.
    pub cells: Vec<Cell>,
    /// Levels between bands of colour, rising; none for cells.
    pub levels: Vec<f64>,
    /// Areas painted one over the other, over the lowest band, each with the number of its band.
    pub areas: Vec<(usize, Vec<[f64; 2]>)>,
    /// Rectangles without values, as two corners: white.
    pub blank: Vec<[[f64; 2]; 2]>,
    /// Rectangles of cases with an empty value, as two corners: hatched.
    pub hatched: Vec<[[f64; 2]; 2]>,
    /// Numbers on the lines between bands, with their places on the sheet.
    pub labels: Vec<PlacedText>,
    /// Range and ticks of the colours.
    pub colours: Axis,
    /// Frame of the colour bar, in one of the panels that share the colours.
    pub bar: Option<Rect>,
}

impl FilledMap {
    /// A map of cells.
    pub fn of_cells(cells: Vec<Cell>, colours: Axis, bar: Option<Rect>) -> FilledMap {
        FilledMap {
            cells,
            levels: Vec::new(),
            areas: Vec::new(),
            blank: Vec::new(),
            hatched: Vec::new(),
            labels: Vec::new(),
            colours,
            bar,
        }
    }
}

/// A cell of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cell {
    /// Its edges along x, rising.
    pub x: [f64; 2],
    /// Its edges along y, rising.
    pub y: [f64; 2],
    /// The value that its colour shows.
    pub value: f64,
}
