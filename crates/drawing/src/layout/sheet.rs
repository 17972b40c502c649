//! A figure as data, before it is drawn. Lengths are points, y downwards.

use crate::layout::axis::Axis;
use crate::layout::cloud::Cloud;
use crate::style::{Marker, Stroke};
use crate::text;

pub use crate::layout::rect::Rect;
pub use crate::layout::series::{Band, Bar, Envelope, Gap, MEASURED, Series};

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
    /// Curves, in the order of the legend; that of drawing is another.
    pub series: Vec<Series>,
    /// Where a curve is not drawn, because it coincides with others.
    pub gaps: Vec<Gap>,
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

impl Sheet {
    /// All panels, then all insets.
    pub fn panels_and_insets(&self) -> impl Iterator<Item = &Panel> {
        let insets = self
            .panels
            .iter()
            .filter_map(|panel| panel.inset.as_deref());
        self.panels.iter().chain(insets)
    }
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
            gaps: Vec::new(),
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

    /// The place on the sheet of a point in the axes' units; not finite for a point without one.
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            self.frame.left + self.frame.width * self.x.fraction(x),
            self.frame.bottom() - self.frame.height * self.y.fraction(y),
        ]
    }
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

impl PlacedText {
    /// The rectangle round it.
    pub fn area(&self) -> Rect {
        let width = text::width(&self.text, self.size);
        let before = match self.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5,
            Anchor::End => 1.0,
        };
        Rect {
            left: self.at[0] - before * width,
            top: self.at[1] - 0.8 * self.size,
            width,
            height: self.size,
        }
    }
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
