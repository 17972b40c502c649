//! The fonts of a PDF file: of each embedded font the glyphs that the page shows, with their widths and characters.

use super::compressed::compressed;
use crate::DrawingError;
use crate::text::font::{self, Glyph};
use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Filter, Finish, Name, Pdf, Rect, Ref, Str};
use read_fonts::types::Tag;
use read_fonts::{FontRef, ReadError, TableProvider};
use subsetter::GlyphRemapper;

/// Objects that a font takes.
const OBJECTS: i32 = 5;

/// What codes of glyphs are: their numbers in the subset.
const IDENTITY: SystemInfo = SystemInfo {
    registry: Str(b"Adobe"),
    ordering: Str(b"Identity"),
    supplement: 0,
};

/// The subset of one font.
#[derive(Default)]
struct Subset {
    codes: GlyphRemapper,
    /// Glyphs with their characters, in the order of their codes; the first is the box for what a font does not have.
    glyphs: Vec<(Glyph, char)>,
}

/// The subsets of the embedded fonts.
#[derive(Default)]
pub struct Fonts([Subset; font::COUNT]);

impl Fonts {
    /// The name of a font on the page.
    pub fn name(&self, face: usize) -> String {
        format!("F{face}")
    }

    /// The code of a glyph, which shows a character.
    pub fn code(&mut self, glyph: Glyph, c: char) -> u16 {
        let subset = &mut self.0[glyph.face()];
        let code = subset.codes.remap(glyph.id());
        if usize::from(code) > subset.glyphs.len() {
            subset.glyphs.push((glyph, c));
        }
        code
    }

    /// Writes the fonts as objects from `next` on; gives the name and object of each.
    pub fn write(&self, pdf: &mut Pdf, next: &mut Ref) -> Result<Vec<(String, Ref)>, DrawingError> {
        let used = (0..font::COUNT).filter(|face| !self.0[*face].glyphs.is_empty());
        used.map(|face| {
            let first = *next;
            *next = Ref::new(first.get() + OBJECTS);
            self.0[face].write(face, pdf, first)?;
            Ok((self.name(face), first))
        })
        .collect()
    }
}

impl Subset {
    fn write(&self, face: usize, pdf: &mut Pdf, first: Ref) -> Result<(), DrawingError> {
        let fault = |what: String| DrawingError::Internal(format!("PDF: font {face}: {what}"));
        let [cid, descriptor, characters, program] =
            [1, 2, 3, 4].map(|k| Ref::new(first.get() + k));
        let (full, italic) = font::name(face);
        let name = format!("{}+{full}", self.tag());
        let base = format!("{name}-Identity-H");
        pdf.type0_font(first)
            .base_font(Name(base.as_bytes()))
            .encoding_predefined(Name(b"Identity-H"))
            .descendant_font(cid)
            .to_unicode(characters);

        let mut font = pdf.cid_font(cid);
        font.subtype(CidFontType::Type0)
            .base_font(Name(name.as_bytes()))
            .system_info(IDENTITY)
            .font_descriptor(descriptor)
            .default_width(0.0);
        let widths = self.glyphs.iter().map(|(glyph, _)| width(*glyph));
        font.widths().consecutive(1, widths);
        font.finish();

        let read = FontRef::new(font::bytes(face)).and_then(|font| Metrics::of(&font));
        let outlines = read.map_err(|error| fault(error.to_string()))?;
        let slant = if italic {
            FontFlags::ITALIC
        } else {
            FontFlags::empty()
        };
        pdf.font_descriptor(descriptor)
            .name(Name(name.as_bytes()))
            .flags(FontFlags::SYMBOLIC | FontFlags::SERIF | slant)
            .bbox(outlines.bounds)
            .italic_angle(outlines.italic_angle)
            .ascent(outlines.ascent)
            .descent(outlines.descent)
            .cap_height(outlines.capitals)
            .stem_v(80.0)
            .font_file3(program);

        let mut map = UnicodeCmap::<u16>::new(Name(b"Characters"), IDENTITY);
        for (code, (_, c)) in (1..).zip(&self.glyphs) {
            map.pair(code, *c);
        }
        pdf.cmap(characters, &compressed(map.finish().as_slice()))
            .filter(Filter::FlateDecode);

        let subset = subsetter::subset(font::bytes(face), 0, &self.codes)
            .map_err(|error| fault(error.to_string()))?;
        let table = FontRef::new(&subset)
            .and_then(|tables| tables.expect_data_for_tag(Tag::new(b"CFF ")))
            .map_err(|error| fault(error.to_string()))?;
        let outlines = compressed(table.as_bytes());
        let mut stream = pdf.stream(program, &outlines);
        stream.filter(Filter::FlateDecode);
        stream.pair(Name(b"Subtype"), Name(b"CIDFontType0C"));
        Ok(())
    }

    /// Six letters that distinguish the subsets of a font.
    fn tag(&self) -> String {
        let ids = self.glyphs.iter().map(|(glyph, _)| u64::from(glyph.id()));
        // FNV-1a.
        let mut hash = ids.fold(0xcbf2_9ce4_8422_2325_u64, |hash, id| {
            (hash ^ id).wrapping_mul(0x0100_0000_01b3)
        });
        let mut letter = || {
            let letter = char::from(b'A' + (hash % 26) as u8);
            hash /= 26;
            letter
        };
        (0..6).map(|_| letter()).collect()
    }
}

/// Lengths of a font in thousandths of the type size.
struct Metrics {
    bounds: Rect,
    ascent: f32,
    descent: f32,
    capitals: f32,
    /// In degrees, negative for letters that lean to the right.
    italic_angle: f32,
}

impl Metrics {
    fn of(font: &FontRef) -> Result<Metrics, ReadError> {
        let (head, os2) = (font.head()?, font.os2()?);
        let thousandths = 1000.0 / f32::from(head.units_per_em());
        let of = |units: i16| f32::from(units) * thousandths;
        let [left, bottom, right, top] =
            [head.x_min(), head.y_min(), head.x_max(), head.y_max()].map(of);
        let ascent = os2.s_typo_ascender();
        Ok(Metrics {
            bounds: Rect::new(left, bottom, right, top),
            ascent: of(ascent),
            descent: of(os2.s_typo_descender()),
            capitals: of(os2.s_cap_height().unwrap_or(ascent)),
            italic_angle: font.post()?.italic_angle().to_f32(),
        })
    }
}

/// The advance of a glyph in thousandths of the type size.
fn width(glyph: Glyph) -> f32 {
    (1000.0 * glyph.advance()) as f32
}
