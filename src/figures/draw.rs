//! Draws a sheet over plotters, the same way for every backend.

use super::clip;
use super::cloud::{self, Image};
use super::envelope;
use super::layout::below;
use super::pen::{Drawn, Pen, at, unit};
use super::sheet::{Anchor, Entry, FilledMap, Panel, Rect, Sheet, Words};
use super::style;
use super::tags;
use super::text;
use crate::error::Error;
use plotters_backend::{BackendCoord, DrawingBackend};
use std::cell::RefCell;
use std::rc::Rc;

/// Draws `sheet` on a backend whose size is the sheet's in virtual units; images have `dpi` pixels an inch.
pub fn draw<B: DrawingBackend>(
    sheet: &Sheet,
    backend: &Rc<RefCell<B>>,
    dpi: u32,
) -> Result<(), Error> {
    let images = sheet.panels.iter().map(|panel| cloud::image(panel, dpi));
    let images: Vec<Option<Image>> = images.collect::<Result<_, _>>()?;
    let mut pen = Pen::on(backend);
    pen.sheet(sheet, &images)
        .map_err(|error| Error::Internal(format!("drawing: {error}")))
}

impl<B: DrawingBackend> Pen<B> {
    fn sheet(&mut self, sheet: &Sheet, images: &[Option<Image>]) -> Drawn<B> {
        for (panel, image) in sheet.panels.iter().zip(images) {
            self.panel(panel, image.as_ref())?;
        }
        for entry in &sheet.legend {
            self.entry(entry)?;
        }
        let mut words = sheet.heading.iter().chain(&sheet.small_print);
        words.try_for_each(|words| self.words(words))
    }

    fn panel(&mut self, panel: &Panel, image: Option<&Image>) -> Drawn<B> {
        // White between its dots, so below all else.
        if let Some(image) = image {
            self.image(image)?;
        }
        if let Some(map) = &panel.map {
            self.map(panel, map)?;
        }
        for bar in &panel.bars {
            let [[left, bottom], [right, top]] =
                [[bar.x[0], bar.y[0]], [bar.x[1], bar.y[1]]].map(|p| panel.place(p));
            self.bar_of(left, top, right - left, bottom - top, bar.shade)?;
        }
        self.fills(panel)?;
        if panel.zero {
            let [a, b] = panel.x.range.map(|x| panel.place([x, 0.0]));
            if let Some(visible) = clip::segment(a, b, &panel.frame) {
                self.path(&visible, style::ZERO_LINE)?;
            }
        }
        self.dots(panel)?;
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
        self.tags(panel)?;
        for [a, b] in &panel.arrows {
            self.arrow(panel.place(*a), panel.place(*b))?;
        }
        self.lettering(panel)
    }

    /// All lines first, then all markers, so that no line runs through a marker.
    fn curves(&mut self, panel: &Panel) -> Drawn<B> {
        for (k, series) in panel.series.iter().enumerate() {
            let points: Vec<_> = series.points.iter().map(|p| panel.place(*p)).collect();
            let parts = envelope::drawn(&panel.envelopes, k, &points);
            let visible = |part: &Vec<_>| clip::inside(part, &panel.frame);
            for visible in parts.iter().flat_map(visible) {
                for dash in clip::dashes(&visible, series.stroke.pattern()) {
                    self.curve(&dash, series.width, series.stroke.colour())?;
                }
            }
        }
        self.edges(panel)?;
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

    /// The numbers on contour lines, each on white.
    fn tags(&mut self, panel: &Panel) -> Drawn<B> {
        for words in panel.map.iter().flat_map(|map| &map.tags) {
            let height = style::CAP_HEIGHT * words.size;
            let under = Rect {
                left: words.at[0],
                top: words.at[1] - height,
                width: text::width(&words.text, words.size),
                height,
            };
            self.blank(&under.inflated(tags::RIM))?;
            self.words(words)?;
        }
        Ok(())
    }

    fn bands(&mut self, panel: &Panel, map: &FilledMap) -> Drawn<B> {
        let count = map.levels.len() + 1;
        let frame = &panel.frame;
        let corners = [
            at([frame.left, frame.top]),
            at([frame.right(), frame.bottom()]),
        ];
        self.cell(corners[0], corners[1], style::band(0, count))?;
        for (band, points) in &map.areas {
            let within = |p: &[f64; 2]| {
                let [x, y] = panel.place(*p);
                [
                    x.clamp(frame.left, frame.right()),
                    y.clamp(frame.top, frame.bottom()),
                ]
            };
            let corners: Vec<_> = points.iter().map(within).collect();
            self.area(&corners, style::band(*band, count))?;
        }
        for corners in &map.blank {
            let [[left, bottom], [right, top]] = corners.map(|p| panel.place(p));
            self.blank(&Rect {
                left,
                top,
                width: right - left,
                height: bottom - top,
            })?;
        }
        Ok(())
    }

    fn map(&mut self, panel: &Panel, map: &FilledMap) -> Drawn<B> {
        if !map.levels.is_empty() {
            self.bands(panel, map)?;
        }
        let mut shades: Vec<Vec<[BackendCoord; 2]>> = vec![Vec::new(); SHADES];
        for cell in &map.cells {
            let fraction = map.colours.fraction(cell.value);
            if !fraction.is_finite() {
                continue;
            }
            let from = at(panel.place([cell.x[0], cell.y[1]]));
            let to = at(panel.place([cell.x[1], cell.y[0]]));
            let shade = &mut shades[((fraction * SHADES as f64) as usize).min(SHADES - 1)];
            match shade.last_mut() {
                // One with its left neighbour of the same shade.
                Some([start, end]) if *end == (from.0, to.1) && start.1 == from.1 => *end = to,
                _ => shade.push([from, to]),
            }
        }
        for (k, cells) in shades.iter().enumerate() {
            for [from, to] in cells {
                self.cell(*from, *to, middle(k))?;
            }
        }
        map.bar.iter().try_for_each(|bar| self.bar(bar, map))
    }

    fn bar(&mut self, bar: &Rect, map: &FilledMap) -> Drawn<B> {
        let colours = &map.colours;
        let (left, right) = (unit(bar.left), unit(bar.right()));
        let height = |fraction: f64| unit(bar.bottom() - bar.height * fraction.clamp(0.0, 1.0));
        if map.levels.is_empty() {
            let edge = |k: usize| height(k as f64 / SHADES as f64);
            for k in 0..SHADES {
                self.cell((left, edge(k + 1)), (right, edge(k)), middle(k))?;
            }
        } else {
            let mut edges = vec![height(0.0)];
            edges.extend(
                map.levels
                    .iter()
                    .map(|level| height(colours.fraction(*level))),
            );
            edges.push(height(1.0));
            let count = edges.len() - 1;
            for k in 0..count {
                self.cell(
                    (left, edges[k + 1]),
                    (right, edges[k]),
                    style::band(k, count),
                )?;
            }
        }
        self.frame(bar)?;
        let size = style::LABEL;
        for tick in &colours.ticks {
            let y = bar.bottom() - bar.height * colours.fraction(tick.at);
            let edge = bar.right();
            let length = tick_length(&tick.label);
            self.path(&[[edge, y], [edge - length, y]], style::FRAME_LINE)?;
            let place = [edge + style::LABEL_GAP, y + style::CAP_HEIGHT * size / 2.0];
            self.text(&tick.label, size, place, Anchor::Start, false)?;
        }
        let place = [bar.right(), bar.top - style::LABEL_GAP - 1.0];
        self.text(&colours.title, style::TITLE, place, Anchor::End, false)
    }

    fn words(&mut self, words: &Words) -> Drawn<B> {
        self.text(&words.text, words.size, words.at, words.anchor, false)
    }

    fn entry(&mut self, entry: &Entry) -> Drawn<B> {
        let [x, y] = entry.at;
        let sample = [[x, y], [x + style::SAMPLE, y]];
        // Places that are only marked have no line.
        for dash in clip::dashes(&sample, entry.stroke.pattern()) {
            if entry.width > 0.0 {
                self.curve(&dash, entry.width, entry.stroke.colour())?;
            }
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
}

/// Shades of a map: so many that no step is seen in the colour bar.
const SHADES: usize = 128;

/// The middle of shade `k` on the scale of colours.
fn middle(k: usize) -> f64 {
    (k as f64 + 0.5) / SHADES as f64
}

fn tick_length(label: &str) -> f64 {
    if label.is_empty() {
        style::MINOR_TICK
    } else {
        style::MAJOR_TICK
    }
}
