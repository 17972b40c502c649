//! The objects of a PDF file: catalog, page, fonts, images. Without dates and identifiers, so that equal pages are equal
//! files.

use super::compressed::compressed;
use super::fonts::Fonts;
use crate::DrawingError;
use pdf_writer::writers::ExtGraphicsState;
use pdf_writer::{Filter, Finish, Name, Pdf, Rect, Ref, TextStr};

/// An image on the page.
pub struct Picture {
    /// Its name on the page.
    pub name: String,
    size: (u32, u32),
    /// Red, green and blue of each pixel, compressed.
    bytes: Vec<u8>,
}

impl Picture {
    /// The image number `number`.
    pub fn new(number: usize, size: (u32, u32), bytes: &[u8]) -> Picture {
        Picture {
            name: format!("I{number}"),
            size,
            bytes: compressed(bytes),
        }
    }

    fn write(&self, pdf: &mut Pdf, at: Ref) {
        let mut image = pdf.image_xobject(at, &self.bytes);
        image.filter(Filter::FlateDecode);
        image
            .width(self.size.0 as i32)
            .height(self.size.1 as i32)
            .bits_per_component(8)
            .color_space()
            .device_rgb();
    }
}

/// The opacities of areas; each has a name on the page by its place here.
#[derive(Default)]
pub struct Opacities(Vec<f64>);

impl Opacities {
    /// The name of an opacity on the page.
    pub fn name(&mut self, alpha: f64) -> String {
        let known = self.0.iter().position(|known_alpha| *known_alpha == alpha);
        let index = known.unwrap_or_else(|| {
            self.0.push(alpha);
            self.0.len() - 1
        });
        opacity_name(index)
    }
}

fn opacity_name(index: usize) -> String {
    format!("G{index}")
}

/// The file of one page with its size in points.
pub fn file(
    size: [f64; 2],
    title: &str,
    content: &[u8],
    fonts: &Fonts,
    pictures: &[Picture],
    opacities: &Opacities,
) -> Result<Vec<u8>, DrawingError> {
    let [catalog, pages, page, drawing, info] = [1, 2, 3, 4, 5].map(Ref::new);
    let mut next = Ref::new(6);
    let mut pdf = Pdf::new();
    pdf.catalog(catalog)
        .pages(pages)
        .lang(TextStr("en"))
        .viewer_preferences()
        .display_doc_title(true);
    pdf.document_info(info).title(TextStr(title));
    pdf.pages(pages).kids([page]).count(1);
    pdf.stream(drawing, &compressed(content))
        .filter(Filter::FlateDecode);
    let fonts = fonts.write(&mut pdf, &mut next)?;
    let mut images = Vec::new();
    for picture in pictures {
        picture.write(&mut pdf, next);
        images.push((&picture.name, next));
        next = Ref::new(next.get() + 1);
    }
    let mut sheet = pdf.page(page);
    sheet
        .media_box(Rect::new(0.0, 0.0, size[0] as f32, size[1] as f32))
        .parent(pages)
        .contents(drawing);
    let mut resources = sheet.resources();
    let mut named = resources.fonts();
    for (name, at) in &fonts {
        named.pair(Name(name.as_bytes()), *at);
    }
    named.finish();
    let mut named = resources.x_objects();
    for (name, at) in images {
        named.pair(Name(name.as_bytes()), at);
    }
    named.finish();
    let mut named = resources.ext_g_states();
    for (index, alpha) in opacities.0.iter().enumerate() {
        named
            .insert(Name(opacity_name(index).as_bytes()))
            .start::<ExtGraphicsState>()
            .non_stroking_alpha(*alpha as f32);
    }
    named.finish();
    resources.finish();
    sheet.finish();
    Ok(pdf.finish())
}
