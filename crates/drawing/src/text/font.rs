//! Glyphs of the embedded font, STIX Two (assets/fonts): outlines, advances, kerning.

use read_fonts::ps::cff::{CffFontRef, Subfont};
use read_fonts::ps::cs::CommandSink;
use read_fonts::tables::cmap::Cmap;
use read_fonts::tables::gpos::{Gpos, PairPos, PositionSubtables};
use read_fonts::tables::hmtx::Hmtx;
use read_fonts::types::GlyphId16;
use read_fonts::{FontRef, TableProvider};
use std::sync::LazyLock;

const ROMAN: usize = 0;
const ITALIC: usize = 1;
const SYMBOLS: usize = 2;

/// Number of embedded files.
pub const COUNT: usize = 3;

static FILES: [&[u8]; COUNT] = [
    include_bytes!("../../assets/fonts/stix-two-text-regular.otf"),
    include_bytes!("../../assets/fonts/stix-two-text-italic.otf"),
    include_bytes!("../../assets/fonts/stix-two-math-symbols.otf"),
];

static NAMES: [(&str, bool); COUNT] = [
    ("STIXTwoText-Regular", false),
    ("STIXTwoText-Italic", true),
    ("STIXTwoMath-Regular", false),
];

/// The tables of a file.
struct Face {
    characters: Cmap<'static>,
    advances: Hmtx<'static>,
    outlines: CffFontRef<'static>,
    subroutines: Subfont,
    positions: Option<Gpos<'static>>,
    per_em: u16,
}

impl Face {
    fn read(file: &'static [u8]) -> Option<Face> {
        let font = FontRef::new(file).ok()?;
        let per_em = font.head().ok()?.units_per_em();
        let table = font.cff().ok()?.offset_data().as_bytes();
        let outlines = CffFontRef::new_cff(table, 0, Some(per_em.into())).ok()?;
        Some(Face {
            characters: font.cmap().ok()?,
            advances: font.hmtx().ok()?,
            subroutines: outlines.subfont(0, &[]).ok()?,
            outlines,
            positions: font.gpos().ok(),
            per_em,
        })
    }
}

/// The three files are part of the program, so that a test, not the user, finds a damaged one.
static FACES: LazyLock<[Face; COUNT]> =
    LazyLock::new(|| FILES.map(|file| Face::read(file).expect("the embedded fonts are sound")));

/// The bytes of a file.
pub fn bytes(face: usize) -> &'static [u8] {
    FILES[face]
}

/// The PostScript name of a font, and whether it is italic.
pub fn name(face: usize) -> (&'static str, bool) {
    NAMES[face]
}

/// A glyph of one of the embedded files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Glyph {
    face: usize,
    id: GlyphId16,
}

impl Glyph {
    /// The glyph for a character; the font's empty box where it has none.
    pub fn of(c: char, italic: bool) -> Glyph {
        let text = if italic { ITALIC } else { ROMAN };
        for face in [text, SYMBOLS] {
            let id = FACES[face].characters.map_codepoint(c);
            if let Some(id) = id.and_then(|id| id.try_into().ok()) {
                return Glyph { face, id };
            }
        }
        let id = GlyphId16::NOTDEF;
        Glyph { face: text, id }
    }

    /// A name that no other glyph has.
    pub fn name(self) -> String {
        format!("{}{}", ["r", "i", "s"][self.face], self.id())
    }

    /// Number of its file.
    pub fn face(self) -> usize {
        self.face
    }

    /// Number in its file.
    pub fn id(self) -> u16 {
        self.id.to_u16()
    }

    /// Advance over the type size.
    pub fn advance(self) -> f64 {
        let advances = &FACES[self.face].advances;
        f64::from(advances.advance(self.id.into()).unwrap_or(0)) / self.per_em()
    }

    /// Units of the outline in the type size.
    pub fn per_em(self) -> f64 {
        f64::from(FACES[self.face].per_em)
    }

    /// Gives the outline to `pen`, y upwards, in units of the font, without hints.
    pub fn outline(self, pen: &mut impl CommandSink) {
        let face = &FACES[self.face];
        let (outlines, subroutines) = (&face.outlines, &face.subroutines);
        // A damaged outline would be a part of a glyph; a test reads them all.
        let _ = outlines.evaluate_charstring(subroutines, self.id.into(), &[], pen);
    }
}

/// The glyphs of a text with their places along the line, and the length of the whole, for type size 1.
pub fn set(text: &str, italic: bool) -> (Vec<(Glyph, f64)>, f64) {
    let mut glyphs: Vec<(Glyph, f64)> = Vec::new();
    let mut x = 0.0;
    for c in text.chars() {
        let glyph = Glyph::of(c, italic);
        if let Some((before, _)) = glyphs.last() {
            x += kerning(*before, glyph);
        }
        glyphs.push((glyph, x));
        x += glyph.advance();
    }
    (glyphs, x)
}

/// How much closer two neighbours are, relative to the type size.
fn kerning(left: Glyph, right: Glyph) -> f64 {
    if left.face != right.face {
        return 0.0;
    }
    pair(&FACES[left.face], left.id, right.id).unwrap_or(0.0) / left.per_em()
}

fn pair(face: &Face, left: GlyphId16, right: GlyphId16) -> Option<f64> {
    let lookups = face.positions.as_ref()?.lookup_list().ok()?.lookups();
    for lookup in lookups.iter().flatten() {
        let Ok(PositionSubtables::Pair(tables)) = lookup.subtables() else {
            continue;
        };
        for table in tables.iter().flatten() {
            if let Some(closer) = in_table(&table, left, right) {
                return Some(closer);
            }
        }
    }
    None
}

/// What a table says of two neighbours, if it has them; 0 if it only moves them another way.
fn in_table(table: &PairPos, left: GlyphId16, right: GlyphId16) -> Option<f64> {
    let advance = match table {
        PairPos::Format1(table) => {
            let covered = table.coverage().ok()?.get(left)?;
            let set = table.pair_sets().get(covered.into()).ok()?;
            set.find_pair_value_record(right)?
                .value_record1()
                .x_advance()
        }
        PairPos::Format2(table) => {
            table.coverage().ok()?.get(left)?;
            let classes = [
                table.class_def1().ok()?.get(left),
                table.class_def2().ok()?.get(right),
            ];
            let records = table.class1_records().get(classes[0].into()).ok()?;
            let record = records.class2_records().get(classes[1].into()).ok()?;
            record.value_record1().x_advance()
        }
    };
    Some(f64::from(advance.unwrap_or(0)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::outline::ToData;

    #[test]
    fn has_every_letter_the_figures_need() {
        let needed = "0123456789()[]=,./+−×≤≥√πΔαβγνωτρδηλμσφΩΣ·–′∞≈→ṙẋẍ";
        for c in needed.chars() {
            assert_ne!(Glyph::of(c, false).id, GlyphId16::NOTDEF, "{c}");
            assert_ne!(Glyph::of(c, true).id, GlyphId16::NOTDEF, "{c} italic");
        }
    }

    #[test]
    fn every_outline_can_be_read() {
        for face in FACES.iter() {
            for id in 0..face.outlines.num_glyphs() {
                let mut data = ToData(String::new());
                let (outlines, parts) = (&face.outlines, &face.subroutines);
                let read = outlines.evaluate_charstring(parts, id.into(), &[], &mut data);
                assert!(read.is_ok(), "{id}");
            }
        }
    }

    #[test]
    fn kerning_draws_a_pair_together() {
        let (_, pair) = set("AV", false);
        let (_, a) = set("A", false);
        let (_, v) = set("V", false);
        assert!(pair < a + v);
    }
}
