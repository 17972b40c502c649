//! The few strokes that figures are made of, handed to plotters in virtual units.

use super::sheet::{Anchor, Rect};
use super::style::{self, Marker, UNITS};
use super::text::{self, Run};
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind};
use plotters::element::{Circle, Drawable, PathElement, PointCollection, Polygon, Rectangle};
use plotters::style::{BLACK, Color, RGBColor, ShapeStyle, WHITE};
use plotters_backend::{
    BackendCoord, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontFamily, FontStyle,
    FontTransform,
};
use std::cell::RefCell;
use std::convert::Infallible;
use std::rc::Rc;

/// What a stroke comes to.
pub type Drawn<B> = Result<(), DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>>;

/// Draws on a plotters area; places and lengths in points.
pub struct Pen<B: DrawingBackend> {
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

/// A black line.
pub fn line(width: f64) -> ShapeStyle {
    BLACK.stroke_width(unit(width) as u32)
}

impl<B: DrawingBackend> Pen<B> {
    /// A pen on a backend.
    pub fn on(backend: &Rc<RefCell<B>>) -> Pen<B> {
        Pen {
            area: DrawingArea::from(backend),
        }
    }

    /// A frame.
    pub fn frame(&mut self, frame: &Rect) -> Drawn<B> {
        let corners = [
            at([frame.left, frame.top]),
            at([frame.right(), frame.bottom()]),
        ];
        self.area
            .draw(&Rectangle::new(corners, line(style::FRAME_LINE)))
    }

    /// A cell of a map between two corners in virtual units, so that neighbours share theirs.
    pub fn cell(&mut self, from: BackendCoord, to: BackendCoord, fraction: f64) -> Drawn<B> {
        let [r, g, b] = style::colour(fraction);
        self.area
            .draw(&Rectangle::new([from, to], RGBColor(r, g, b).filled()))
    }

    /// A filled area, in a colour of maps.
    pub fn area(&mut self, corners: &[[f64; 2]], fraction: f64) -> Drawn<B> {
        let [r, g, b] = style::colour(fraction);
        let corners: Vec<_> = corners.iter().copied().map(at).collect();
        self.area
            .draw(&Polygon::new(corners, RGBColor(r, g, b).filled()))
    }

    /// A filled rectangle with an outline.
    pub fn bar_of(&mut self, left: f64, top: f64, width: f64, height: f64, shade: f64) -> Drawn<B> {
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
    pub fn blank(&mut self, area: &Rect) -> Drawn<B> {
        let corners = [at([area.left, area.top]), at([area.right(), area.bottom()])];
        self.area.draw(&Rectangle::new(corners, WHITE.filled()))
    }

    /// A line through points.
    pub fn path(&mut self, points: &[[f64; 2]], width: f64) -> Drawn<B> {
        let points: Vec<_> = points.iter().copied().map(at).collect();
        self.area.draw(&PathElement::new(points, line(width)))
    }

    /// A marker, white inside.
    pub fn marker(&mut self, marker: Marker, [x, y]: [f64; 2]) -> Drawn<B> {
        let outline = line(style::MARKER_LINE);
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
            Marker::Cross => {
                let d = style::MARKER * 0.9;
                for slope in [-1.0, 1.0] {
                    let stroke = [[x - d, y - slope * d], [x + d, y + slope * d]];
                    self.path(&stroke, style::MARKER_LINE)?;
                }
                Ok(())
            }
            _ => {
                let corners = marker.corners().iter().map(|[dx, dy]| at([x + dx, y + dy]));
                let mut corners: Vec<_> = corners.collect();
                self.area
                    .draw(&Polygon::new(corners.clone(), WHITE.filled()))?;
                corners.extend(corners.first().copied());
                self.area.draw(&PathElement::new(corners, outline))
            }
        }
    }

    /// A line through points in the colour of a curve.
    pub fn curve(&mut self, points: &[[f64; 2]], width: f64, [r, g, b]: [u8; 3]) -> Drawn<B> {
        let points: Vec<_> = points.iter().copied().map(at).collect();
        let style = RGBColor(r, g, b).stroke_width(unit(width) as u32);
        self.area.draw(&PathElement::new(points, style))
    }

    /// A thin line with a filled head at both ends.
    pub fn arrow(&mut self, a: [f64; 2], b: [f64; 2]) -> Drawn<B> {
        self.path(&[a, b], style::EXACT_LINE)?;
        let length = libm::hypot(b[0] - a[0], b[1] - a[1]);
        let along = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
        let long = style::ARROW.min(0.45 * length);
        for (tip, turn) in [(a, 1.0), (b, -1.0)] {
            let foot = [0, 1].map(|k| tip[k] + turn * long * along[k]);
            let half = [-0.27 * long * along[1], 0.27 * long * along[0]];
            let sides = [1.0, -1.0].map(|s| at([foot[0] + s * half[0], foot[1] + s * half[1]]));
            let head = vec![at(tip), sides[0], sides[1]];
            self.area.draw(&Polygon::new(head, BLACK.filled()))?;
        }
        Ok(())
    }

    /// A line of markup; `upwards` turned to read from below.
    pub fn text(
        &mut self,
        markup: &str,
        size: f64,
        [x, y]: [f64; 2],
        anchor: Anchor,
        upwards: bool,
    ) -> Drawn<B> {
        let (runs, length) = text::set(markup, size);
        let start = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -length / 2.0,
            Anchor::End => -length,
        };
        for run in runs {
            let (along, above) = (start + run.x, run.rise);
            let place = if upwards {
                at([x - above, y - along])
            } else {
                at([x + along, y - above])
            };
            self.area.draw(&Lettering {
                place,
                run,
                upwards,
            })?;
        }
        Ok(())
    }
}

/// A run of text as an element of plotters.
struct Lettering {
    place: BackendCoord,
    run: Run,
    upwards: bool,
}

impl<'a> PointCollection<'a, BackendCoord> for &'a Lettering {
    type Point = &'a BackendCoord;
    type IntoIter = std::iter::Once<&'a BackendCoord>;

    fn point_iter(self) -> Self::IntoIter {
        std::iter::once(&self.place)
    }
}

impl<B: DrawingBackend> Drawable<B> for Lettering {
    fn draw<I: Iterator<Item = BackendCoord>>(
        &self,
        mut places: I,
        backend: &mut B,
        _: (u32, u32),
    ) -> Result<(), DrawingErrorKind<B::ErrorType>> {
        match places.next() {
            Some(place) => backend.draw_text(&self.run.text, self, place),
            None => Ok(()),
        }
    }
}

impl BackendTextStyle for Lettering {
    type FontError = Infallible;

    fn size(&self) -> f64 {
        self.run.size * UNITS
    }

    fn transform(&self) -> FontTransform {
        if self.upwards {
            FontTransform::Rotate270
        } else {
            FontTransform::None
        }
    }

    fn style(&self) -> FontStyle {
        if self.run.italic {
            FontStyle::Italic
        } else {
            FontStyle::Normal
        }
    }

    fn family(&self) -> FontFamily<'_> {
        FontFamily::Serif
    }

    // Our backends set text themselves and ask for neither of these.

    fn layout_box(&self, _: &str) -> Result<((i32, i32), (i32, i32)), Infallible> {
        Ok(((0, 0), (0, 0)))
    }

    fn draw<E, F: FnMut(i32, i32, plotters_backend::BackendColor) -> Result<(), E>>(
        &self,
        _: &str,
        _: BackendCoord,
        _: F,
    ) -> Result<Result<(), E>, Infallible> {
        Ok(Ok(()))
    }
}
