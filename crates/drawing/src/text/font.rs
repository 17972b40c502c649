//! Glyphs of the embedded font, STIX Two (assets/fonts): outlines, advances, kerning.

use std::sync::LazyLock;
use ttf_parser::gpos::{PairAdjustment, PositioningSubtable};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

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

/// The three files are part of the program, so that a test, not the user, finds a damaged one.
static FACES: LazyLock<[Face<'static>; COUNT]> =
    LazyLock::new(|| FILES.map(|file| Face::parse(file, 0).expect("the embedded fonts are sound")));

/// The bytes of a file.
pub fn bytes(face: usize) -> &'static [u8] {
    FILES[face]
}

/// A file as a font.
pub fn face(face: usize) -> &'static Face<'static> {
    &FACES[face]
}

/// The PostScript name of a font, and whether it is italic.
pub fn name(face: usize) -> (&'static str, bool) {
    NAMES[face]
}

/// A glyph of one of the embedded files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Glyph {
    face: usize,
    id: GlyphId,
}

impl Glyph {
    /// The glyph for a character; the font's empty box where it has none.
    pub fn of(c: char, italic: bool) -> Glyph {
        let text = if italic { ITALIC } else { ROMAN };
        for face in [text, SYMBOLS] {
            if let Some(id) = FACES[face].glyph_index(c) {
                return Glyph { face, id };
            }
        }
        let id = GlyphId(0);
        Glyph { face: text, id }
    }

    /// A name that no other glyph has.
    pub fn name(self) -> String {
        format!("{}{}", ["r", "i", "s"][self.face], self.id.0)
    }

    /// Number of its file.
    pub fn face(self) -> usize {
        self.face
    }

    /// Number in its file.
    pub fn id(self) -> u16 {
        self.id.0
    }

    /// Advance over the type size.
    pub fn advance(self) -> f64 {
        f64::from(FACES[self.face].glyph_hor_advance(self.id).unwrap_or(0)) / self.per_em()
    }

    /// Units of the outline in the type size.
    pub fn per_em(self) -> f64 {
        f64::from(FACES[self.face].units_per_em())
    }

    /// Gives the outline to `builder`, y upwards, in units of the font.
    pub fn outline(self, builder: &mut dyn OutlineBuilder) {
        // A glyph without outline is a space.
        let _ = FACES[self.face].outline_glyph(self.id, builder);
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

fn pair(face: &Face, left: GlyphId, right: GlyphId) -> Option<f64> {
    for lookup in face.tables().gpos?.lookups {
        for subtable in lookup.subtables.into_iter::<PositioningSubtable>() {
            let PositioningSubtable::Pair(table) = subtable else {
                continue;
            };
            let Some(covered) = table.coverage().get(left) else {
                continue;
            };
            let values = match table {
                PairAdjustment::Format1 { sets, .. } => {
                    sets.get(covered).and_then(|set| set.get(right))
                }
                PairAdjustment::Format2 {
                    classes, matrix, ..
                } => matrix.get((classes.0.get(left), classes.1.get(right))),
            };
            if let Some((first, _)) = values {
                return Some(f64::from(first.x_advance));
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn has_every_letter_the_figures_need() {
        let needed = "0123456789()[]=,./+−×≤≥√πΔαβγνωτρδηλμσφΩΣ·–′∞≈→ṙẋẍ";
        for c in needed.chars() {
            assert_ne!(Glyph::of(c, false).id, GlyphId(0), "{c}");
            assert_ne!(Glyph::of(c, true).id, GlyphId(0), "{c} italic");
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
