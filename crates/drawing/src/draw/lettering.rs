//! A run of text as an element of plotters.

use crate::style::UNITS;
use crate::text::Run;
use plotters::element::{Drawable, PointCollection};
use plotters_backend::{
    BackendCoord, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontFamily, FontStyle,
    FontTransform,
};
use std::convert::Infallible;

/// A run of text as an element of plotters.
pub struct Lettering {
    /// Beginning of its base line.
    pub place: BackendCoord,
    /// The run.
    pub run: Run,
    /// Whether it is turned to read from below.
    pub upwards: bool,
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
            Some(at) => backend.draw_text(&self.run.text, self, at),
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

    // Our backends set text themselves and use neither of these.

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
