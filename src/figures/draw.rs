//! Draws a sheet over plotters, the same way for every backend.

use super::clip;
use super::sheet::{Anchor, Axis, Entry, FilledMap, Panel, Rect, Sheet, Words};
use super::style::{self, Marker, UNITS};
use super::text::{self, Run};
use crate::error::Error;
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

/// Draws `sheet` on a backend whose size is the sheet's in virtual units.
pub fn draw<B: DrawingBackend>(sheet: &Sheet, backend: &Rc<RefCell<B>>) -> Result<(), Error> {
    let mut pen = Pen {
        area: DrawingArea::from(backend),
    };
    pen.sheet(sheet)
        .map_err(|error| Error::Internal(format!("drawing: {error}")))
}

type Drawn<B> = Result<(), DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>>;

struct Pen<B: DrawingBackend> {
    area: DrawingArea<B, Shift>,
}

fn unit(length: f64) -> i32 {
    (length * UNITS).round() as i32
}

fn at([x, y]: [f64; 2]) -> BackendCoord {
    (unit(x), unit(y))
}

fn line(width: f64) -> ShapeStyle {
    BLACK.stroke_width(unit(width) as u32)
}

impl<B: DrawingBackend> Pen<B> {
    fn sheet(&mut self, sheet: &Sheet) -> Drawn<B> {
        for panel in &sheet.panels {
            self.panel(panel)?;
        }
        for entry in &sheet.legend {
            self.entry(entry)?;
        }
        sheet.heading.iter().try_for_each(|words| self.words(words))
    }

    fn panel(&mut self, panel: &Panel) -> Drawn<B> {
        if let Some(map) = &panel.map {
            self.map(panel, map)?;
        }
        if panel.zero {
            let [a, b] = panel.x.range.map(|x| panel.place([x, 0.0]));
            if let Some(visible) = clip::segment(a, b, &panel.frame) {
                self.path(&visible, style::ZERO_LINE)?;
            }
        }
        self.frame(&panel.frame)?;
        for tick in &panel.x.ticks {
            let x = panel.place([tick.at, 0.0])[0];
            let length = tick_length(&tick.label);
            let (top, bottom) = (panel.frame.top, panel.frame.bottom());
            self.path(&[[x, bottom], [x, bottom - length]], style::FRAME_LINE)?;
            self.path(&[[x, top], [x, top + length]], style::FRAME_LINE)?;
        }
        for tick in &panel.y.ticks {
            let y = panel.frame.bottom() - panel.frame.height * panel.y.fraction(tick.at);
            let length = tick_length(&tick.label);
            let (left, right) = (panel.frame.left, panel.frame.right());
            self.path(&[[left, y], [left + length, y]], style::FRAME_LINE)?;
            self.path(&[[right, y], [right - length, y]], style::FRAME_LINE)?;
        }
        self.curves(panel)?;
        for [a, b] in &panel.arrows {
            self.arrow(panel.place(*a), panel.place(*b))?;
        }
        self.lettering(panel)
    }

    fn frame(&mut self, frame: &Rect) -> Drawn<B> {
        let corners = [
            at([frame.left, frame.top]),
            at([frame.right(), frame.bottom()]),
        ];
        self.area
            .draw(&Rectangle::new(corners, line(style::FRAME_LINE)))
    }

    /// All lines first, then all markers, so that no line runs through a marker.
    fn curves(&mut self, panel: &Panel) -> Drawn<B> {
        for series in &panel.series {
            let points: Vec<_> = series.points.iter().map(|p| panel.place(*p)).collect();
            for visible in clip::inside(&points, &panel.frame) {
                for dash in clip::dashes(&visible, series.stroke.pattern()) {
                    self.path(&dash, series.width)?;
                }
            }
        }
        for series in &panel.series {
            let Some(marker) = series.marker else {
                continue;
            };
            for point in series.marked.iter().filter_map(|i| series.points.get(*i)) {
                let place = panel.place(*point);
                if panel.frame.contains(place) {
                    self.marker(marker, place)?;
                }
            }
        }
        Ok(())
    }

    fn lettering(&mut self, panel: &Panel) -> Drawn<B> {
        let (frame, size) = (&panel.frame, style::LABEL);
        if panel.x.numbered {
            let y = frame.bottom() + style::LABEL_GAP + style::CAP_HEIGHT * size;
            for tick in &panel.x.ticks {
                let x = panel.place([tick.at, 0.0])[0];
                self.text(&tick.label, size, [x, y], Anchor::Middle, false)?;
            }
        }
        let middle = frame.left + frame.width / 2.0;
        let y = frame.bottom() + below(&panel.x) - style::TITLE * 0.3;
        self.text(
            &panel.x.title,
            style::TITLE,
            [middle, y],
            Anchor::Middle,
            false,
        )?;
        for tick in panel.y.ticks.iter().filter(|_| panel.y.numbered) {
            let y = frame.bottom() - frame.height * panel.y.fraction(tick.at);
            let place = [
                frame.left - style::LABEL_GAP,
                y + style::CAP_HEIGHT * size / 2.0,
            ];
            self.text(&tick.label, size, place, Anchor::End, false)?;
        }
        let middle = frame.top + frame.height / 2.0;
        let x = frame.left - panel.margin + style::TITLE * 0.75;
        self.text(
            &panel.y.title,
            style::TITLE,
            [x, middle],
            Anchor::Middle,
            true,
        )?;
        let place = [frame.left, frame.top - style::LABEL_GAP];
        self.text(&panel.letter, style::TITLE, place, Anchor::Start, false)?;
        panel.notes.iter().try_for_each(|words| self.words(words))
    }

    fn map(&mut self, panel: &Panel, map: &FilledMap) -> Drawn<B> {
        let columns = map.x_edges.len().saturating_sub(1);
        for (i, value) in map.values.iter().enumerate() {
            let Some(value) = value else { continue };
            let (column, row) = (i % columns, i / columns);
            let corner =
                |dx, dy| at(panel.place([map.x_edges[column + dx], map.y_edges[row + dy]]));
            self.cell(corner(0, 1), corner(1, 0), map.colours.fraction(*value))?;
        }
        // The bar in so many steps that none is seen.
        const STEPS: i32 = 128;
        let (left, right) = (unit(map.bar.left), unit(map.bar.right()));
        let height =
            |k: i32| unit(map.bar.bottom() - map.bar.height * f64::from(k) / f64::from(STEPS));
        for k in 0..STEPS {
            let fraction = (f64::from(k) + 0.5) / f64::from(STEPS);
            self.cell((left, height(k + 1)), (right, height(k)), fraction)?;
        }
        self.frame(&map.bar)?;
        let size = style::LABEL;
        for tick in &map.colours.ticks {
            let y = map.bar.bottom() - map.bar.height * map.colours.fraction(tick.at);
            let edge = map.bar.right();
            let length = tick_length(&tick.label);
            self.path(&[[edge, y], [edge - length, y]], style::FRAME_LINE)?;
            let place = [edge + style::LABEL_GAP, y + style::CAP_HEIGHT * size / 2.0];
            self.text(&tick.label, size, place, Anchor::Start, false)?;
        }
        let place = [map.bar.right(), map.bar.top - style::LABEL_GAP - 1.0];
        self.text(&map.colours.title, style::TITLE, place, Anchor::End, false)
    }

    fn cell(&mut self, from: BackendCoord, to: BackendCoord, fraction: f64) -> Drawn<B> {
        let [r, g, b] = style::colour(fraction);
        self.area
            .draw(&Rectangle::new([from, to], RGBColor(r, g, b).filled()))
    }

    fn entry(&mut self, entry: &Entry) -> Drawn<B> {
        let [x, y] = entry.at;
        let sample = [[x, y], [x + style::SAMPLE, y]];
        for dash in clip::dashes(&sample, entry.stroke.pattern()) {
            self.path(&dash, entry.width)?;
        }
        if let Some(marker) = entry.marker {
            self.marker(marker, [x + style::SAMPLE / 2.0, y])?;
        }
        let place = [
            x + style::SAMPLE + style::SAMPLE_GAP,
            y + style::CAP_HEIGHT * style::LABEL / 2.0,
        ];
        self.text(&entry.label, style::LABEL, place, Anchor::Start, false)
    }

    fn path(&mut self, points: &[[f64; 2]], width: f64) -> Drawn<B> {
        let points: Vec<_> = points.iter().copied().map(at).collect();
        self.area.draw(&PathElement::new(points, line(width)))
    }

    /// A marker, white inside.
    fn marker(&mut self, marker: Marker, [x, y]: [f64; 2]) -> Drawn<B> {
        let outline = line(style::MARKER_LINE);
        match marker {
            Marker::Circle => {
                let radius = unit(style::MARKER);
                self.area
                    .draw(&Circle::new(at([x, y]), radius, WHITE.filled()))?;
                self.area.draw(&Circle::new(at([x, y]), radius, outline))
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

    /// A thin line with a filled head at both ends.
    fn arrow(&mut self, a: [f64; 2], b: [f64; 2]) -> Drawn<B> {
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

    fn words(&mut self, words: &Words) -> Drawn<B> {
        self.text(&words.text, words.size, words.at, words.anchor, false)
    }

    fn text(
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

fn tick_length(label: &str) -> f64 {
    if label.is_empty() {
        style::MINOR_TICK
    } else {
        style::MAJOR_TICK
    }
}

/// Room that the numbers and title of a horizontal axis take below its frame.
pub fn below(axis: &Axis) -> f64 {
    let numbers = if axis.numbered {
        style::LABEL_GAP + style::LABEL
    } else {
        0.0
    };
    let title = if axis.title.is_empty() {
        0.0
    } else {
        style::TITLE_GAP + style::TITLE
    };
    numbers + title
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
