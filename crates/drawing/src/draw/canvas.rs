//! The elements of figures, drawn with plotters in virtual units.

use super::lettering::Lettering;
use crate::layout::clip;
use crate::layout::sheet::{Anchor, Panel, Rect};
use crate::style::{self, Marker, UNITS};
use crate::text;
use plotters::coord::{CoordTranslate, Shift};
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind};
use plotters::element::{Circle, PathElement, Polygon, Rectangle};
use plotters::style::{BLACK, Color, RGBColor, ShapeStyle, WHITE};
use plotters_backend::{BackendCoord, DrawingBackend};
use std::cell::RefCell;
use std::rc::Rc;

/// The result of drawing on a backend.
pub type DrawResult<B> = Result<(), DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>>;

/// Draws on a plotters area; places and lengths in points.
pub struct Canvas<B: DrawingBackend> {
    pub(super) area: DrawingArea<B, Shift>,
}

/// A length in virtual units.
pub fn unit(length: f64) -> i32 {
    (length * UNITS).round() as i32
}

/// A place in virtual units.
pub fn at([x, y]: [f64; 2]) -> BackendCoord {
    (unit(x), unit(y))
}

/// Filled with the colour of maps at this place on their scale.
pub fn shade(fraction: f64) -> ShapeStyle {
    let [r, g, b] = style::colour(fraction);
    RGBColor(r, g, b).filled()
}

/// Filled with white.
pub fn blank() -> ShapeStyle {
    WHITE.filled()
}

/// A black line.
pub fn line(width: f64) -> ShapeStyle {
    BLACK.stroke_width(unit(width) as u32)
}

/// The coordinates of a panel: from values along its axes to virtual units of the sheet.
pub struct PanelCoordinates<'p>(&'p Panel);

impl CoordTranslate for PanelCoordinates<'_> {
    type From = (f64, f64);

    fn translate(&self, (x, y): &(f64, f64)) -> BackendCoord {
        at(self.0.place([*x, *y]))
    }
}

impl<B: DrawingBackend> Canvas<B> {
    /// A canvas on a backend.
    pub fn on(backend: &Rc<RefCell<B>>) -> Canvas<B> {
        Canvas {
            area: DrawingArea::from(backend),
        }
    }

    /// The same drawing, in the units of the axes of a panel.
    pub fn in_units_of<'p>(&self, panel: &'p Panel) -> DrawingArea<B, PanelCoordinates<'p>> {
        self.area.apply_coord_spec(PanelCoordinates(panel))
    }

    /// A frame.
    pub fn frame(&mut self, frame: &Rect) -> DrawResult<B> {
        let corners = [
            at([frame.left, frame.top]),
            at([frame.right(), frame.bottom()]),
        ];
        self.area
            .draw(&Rectangle::new(corners, line(style::FRAME_LINE)))
    }

    /// A cell of a map between two corners in virtual units, so that neighbours share theirs.
    pub fn cell(&mut self, from: BackendCoord, to: BackendCoord, fraction: f64) -> DrawResult<B> {
        self.area.draw(&Rectangle::new([from, to], shade(fraction)))
    }

    /// A filled area, in a colour of maps.
    pub fn area(&mut self, corners: &[[f64; 2]], fraction: f64) -> DrawResult<B> {
        let corners: Vec<_> = corners.iter().copied().map(at).collect();
        self.area.draw(&Polygon::new(corners, shade(fraction)))
    }

    /// A filled rectangle with an outline.
    pub fn bar_of(
        &mut self,
        left: f64,
        top: f64,
        width: f64,
        height: f64,
        shade: f64,
    ) -> DrawResult<B> {
        let rect = Rect {
            left,
            top,
            width,
            height,
        };
        self.cell(at([left, top]), at([rect.right(), rect.bottom()]), shade)?;
        self.frame(&rect)
    }

    /// A white rectangle.
    pub fn blank(&mut self, area: &Rect) -> DrawResult<B> {
        let corners = [at([area.left, area.top]), at([area.right(), area.bottom()])];
        self.area.draw(&Rectangle::new(corners, blank()))
    }

    /// Rising lines over a rectangle; those of neighbours join.
    pub fn hatch(&mut self, area: &Rect) -> DrawResult<B> {
        // A line has x + y = k HATCH.
        let sum = |x: f64, y: f64| (x + y) / style::HATCH;
        let first = sum(area.left, area.top).ceil() as i64;
        let last = sum(area.right(), area.bottom()).floor() as i64;
        for k in first..=last {
            let sum = k as f64 * style::HATCH;
            let [from, to] = [area.left, area.right()].map(|x| [x, sum - x]);
            if let Some(line) = clip::segment(from, to, area) {
                self.path(&line, style::HATCH_LINE)?;
            }
        }
        Ok(())
    }

    /// A line through points.
    pub fn path(&mut self, points: &[[f64; 2]], width: f64) -> DrawResult<B> {
        let points: Vec<_> = points.iter().copied().map(at).collect();
        self.area.draw(&PathElement::new(points, line(width)))
    }

    /// A point of a curve without a line.
    pub fn dot(&mut self, centre: [f64; 2], [r, g, b]: [u8; 3]) -> DrawResult<B> {
        let fill = RGBColor(r, g, b).filled();
        self.area
            .draw(&Circle::new(at(centre), unit(style::DOT), fill))
    }

    /// A marker, white inside, with an outline in the colour of its curve.
    pub fn marker(&mut self, marker: Marker, [x, y]: [f64; 2], colour: [u8; 3]) -> DrawResult<B> {
        let [r, g, b] = colour;
        let outline = RGBColor(r, g, b).stroke_width(unit(style::MARKER_LINE) as u32);
        match marker {
            Marker::Circle => {
                let radius = unit(style::MARKER);
                self.area
                    .draw(&Circle::new(at([x, y]), radius, WHITE.filled()))?;
                self.area.draw(&Circle::new(at([x, y]), radius, outline))
            }
            Marker::Dark | Marker::Light => {
                let half = style::MARKER * 1.1;
                self.bar_of(x - half, y - half, 2.0 * half, 2.0 * half, marker.shade())
            }
            Marker::Hatched => {
                let half = [style::SAMPLE / 2.0, style::CAP_HEIGHT * style::LABEL / 2.0];
                let area = Rect {
                    left: x - half[0],
                    top: y - half[1],
                    width: 2.0 * half[0],
                    height: 2.0 * half[1],
                };
                self.hatch(&area)?;
                self.frame(&area)
            }
            Marker::Cross => {
                let d = style::MARKER * 0.9;
                for slope in [-1.0, 1.0] {
                    let stroke = [[x - d, y - slope * d], [x + d, y + slope * d]];
                    self.curve(&stroke, style::MARKER_LINE, colour)?;
                }
                Ok(())
            }
            Marker::Triangle | Marker::Square | Marker::Diamond | Marker::InvertedTriangle => {
                let placed = marker.corners().iter().map(|[dx, dy]| at([x + dx, y + dy]));
                let mut corners: Vec<_> = placed.collect();
                self.area
                    .draw(&Polygon::new(corners.clone(), WHITE.filled()))?;
                corners.extend(corners.first().copied());
                self.area.draw(&PathElement::new(corners, outline))
            }
        }
    }

    /// A line through points in the colour of a curve.
    pub fn curve(&mut self, points: &[[f64; 2]], width: f64, [r, g, b]: [u8; 3]) -> DrawResult<B> {
        let points: Vec<_> = points.iter().copied().map(at).collect();
        let style = RGBColor(r, g, b).stroke_width(unit(width) as u32);
        self.area.draw(&PathElement::new(points, style))
    }

    /// A rectangle with an outline, filled with a grey.
    pub fn box_of(&mut self, rect: &Rect, grey: u8) -> DrawResult<B> {
        let corners = [at([rect.left, rect.top]), at([rect.right(), rect.bottom()])];
        let fill = RGBColor(grey, grey, grey).filled();
        self.area.draw(&Rectangle::new(corners, fill))?;
        self.frame(rect)
    }

    /// A thin line with a filled head at both ends.
    pub fn arrow(&mut self, a: [f64; 2], b: [f64; 2]) -> DrawResult<B> {
        self.path(&[a, b], style::EXACT_LINE)?;
        self.head(a, b)?;
        self.head(b, a)
    }

    /// The head of an arrow at its end `tip`, from the other end.
    pub fn head(&mut self, tip: [f64; 2], other: [f64; 2]) -> DrawResult<B> {
        let length = libm::hypot(other[0] - tip[0], other[1] - tip[1]);
        let along = [0, 1].map(|k| (other[k] - tip[k]) / length);
        let long = style::ARROW.min(0.45 * length);
        let foot = [0, 1].map(|k| tip[k] + long * along[k]);
        let half = [-0.27 * long * along[1], 0.27 * long * along[0]];
        let sides = [1.0, -1.0].map(|s| at([foot[0] + s * half[0], foot[1] + s * half[1]]));
        let head = vec![at(tip), sides[0], sides[1]];
        self.area.draw(&Polygon::new(head, BLACK.filled()))
    }

    /// A line of markup; `upwards` turned to read from below.
    pub fn text(
        &mut self,
        markup: &str,
        size: f64,
        [x, y]: [f64; 2],
        anchor: Anchor,
        upwards: bool,
    ) -> DrawResult<B> {
        let (runs, length) = text::set(markup, size);
        let start = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -length / 2.0,
            Anchor::End => -length,
        };
        for run in runs {
            let (along, above) = (start + run.x, run.rise);
            let corner = if upwards {
                at([x - above, y - along])
            } else {
                at([x + along, y - above])
            };
            self.area.draw(&Lettering {
                place: corner,
                run,
                upwards,
            })?;
        }
        Ok(())
    }
}
