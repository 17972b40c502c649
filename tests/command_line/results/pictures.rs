//! Pictures for a journal: PDF files read by another program, and the resolution of PNG files.

use crate::{Bench, TWO, friction};
use hayro_syntax::Pdf;
use hayro_syntax::content::ops::TypedInstruction;
use hayro_syntax::object::{Array, Dict, Name, Object, Stream};
use std::collections::HashMap;
use std::fs;

const LAW: &str = r#", "figures": [{ "name": "law", "kind": "law", "width": 90 },
    { "name": "r", "kind": "history", "width": 190, "title": "Two widths" }]"#;

/// The characters of the codes of a font, from its ToUnicode map.
fn characters(font: &Dict) -> HashMap<u16, String> {
    let stream = font.get::<Stream>("ToUnicode").expect("a map");
    let map = String::from_utf8(stream.decoded().unwrap().to_vec()).unwrap();
    let hex = |word: &str| u16::from_str_radix(word, 16).unwrap();
    let pairs = map.lines().filter_map(|line| {
        let (code, text) = line
            .strip_prefix('<')?
            .strip_suffix('>')?
            .split_once("> <")?;
        let units: Vec<u16> = (0..text.len() / 4)
            .map(|k| hex(&text[4 * k..4 * k + 4]))
            .collect();
        Some((hex(code), String::from_utf16(&units).unwrap()))
    });
    // The first pair is the range of all codes.
    pairs.skip(1).collect()
}

/// The text of the only page, in the order of drawing, with embedded fonts.
fn text(bytes: Vec<u8>) -> (String, (f32, f32)) {
    let pdf = Pdf::new(bytes).unwrap();
    let [page] = &pdf.pages()[..] else {
        panic!("{} pages", pdf.pages().len());
    };
    let mut out = String::new();
    let mut codes = HashMap::new();
    let mut operations = page.typed_operations();
    while let Some(operation) = operations.next() {
        if let TypedInstruction::TextFont(font) = operation {
            let font = page.resources().get_font(font.0).expect("a font");
            embedded(&font);
            codes = characters(&font);
        } else if let TypedInstruction::ShowTexts(shown) = operation {
            for item in shown.0.iter::<Object>() {
                if let Object::String(string) = item {
                    let (pairs, rest) = string.as_bytes().as_chunks::<2>();
                    assert!(rest.is_empty());
                    for pair in pairs {
                        out += &codes[&u16::from_be_bytes(*pair)];
                    }
                }
            }
        } else if let TypedInstruction::Fallback(operator) = operation {
            panic!("{operator:?}");
        }
    }
    (out, page.base_dimensions())
}

/// Asserts that some but not all outlines of a font are in the file.
fn embedded(font: &Dict) {
    let descendants = font.get::<Array>("DescendantFonts").unwrap();
    let under = descendants.iter::<Dict>().next().unwrap();
    let descriptor = under.get::<Dict>("FontDescriptor").unwrap();
    let program = descriptor
        .get::<Stream>("FontFile3")
        .expect("an embedded font");
    let kind = program.dict().get::<Name>("Subtype").unwrap();
    assert_eq!(kind.as_str(), "CIDFontType0C");
    // Version 1 of the Compact Font Format. The complete fonts have at least 60 000 bytes.
    let program = program.decoded().unwrap();
    assert!(
        program.starts_with(&[1, 0]) && program.len() < 10_000,
        "{}",
        program.len()
    );
}

#[test]
fn a_pdf_has_the_given_width_and_embedded_fonts() {
    let bench = Bench::new();
    bench.file("s.json", friction(TWO, LAW));
    bench.expect(0, &["run", "s.json", "--out", "a"]);
    bench.expect(0, &["run", "s.json", "--out", "b"]);
    for (name, width, words) in [
        (
            "law",
            90.0,
            &["rigid (Coulomb)", "r/Δ", "S/νN", "rE/Δ = α", "−1"][..],
        ),
        (
            "r",
            190.0,
            &[
                "Two widths",
                "Dimensionless time T = ωnt",
                "X − Xexact",
                "α = 0.1",
                "8π",
            ],
        ),
    ] {
        let read = |out: &str| fs::read(bench.path(&format!("{out}/s/{name}.pdf"))).unwrap();
        assert!(read("a") == read("b"), "{name}.pdf differs");
        let (text, (across, _)) = text(read("a"));
        assert!((across - width * 72.0 / 25.4).abs() < 0.001, "{across}");
        for word in words {
            assert!(text.contains(word), "{name}: {word} in {text}");
        }
    }
}

#[test]
fn dots_of_many_cases_are_one_image_with_the_given_resolution() {
    let bench = Bench::new();
    let cloud = r#", "design": { "kind": "sobol", "n": 2100 },
        "figures": [{ "name": "c", "kind": "scatter", "x": "dT", "y": "rms_error", "width": 100 }]"#;
    let sampled =
        r#""law": "velocity-control", "beta": 1, "duration": 3, "dT": { "uniform": [0.1, 0.5] }"#;
    bench.file("s.json", friction(sampled, cloud));
    bench.expect(0, &["run", "s.json", "--dpi", "72"]);
    let pdf = Pdf::new(fs::read(bench.path("figures/s/c.pdf")).unwrap()).unwrap();
    let image = pdf.pages()[0]
        .resources()
        .get_x_object(&Name::new(b"I0").unwrap())
        .unwrap();
    let length = |key: &str| image.dict().get::<u32>(key).unwrap();
    // One pixel per point: nearly as wide as the sheet, and as high as the panel of 190.
    assert!((200..283).contains(&length("Width")), "{}", length("Width"));
    assert!(
        (190..=191).contains(&length("Height")),
        "{}",
        length("Height")
    );
    let bytes = image.decoded().unwrap();
    assert_eq!(
        bytes.len(),
        (3 * length("Width") * length("Height")) as usize
    );
}

#[test]
fn pixels_per_inch() {
    let bench = Bench::new();
    bench.file("s.json", friction(TWO, LAW));
    let size = |out: &str| {
        let file = fs::File::open(bench.path(&format!("{out}/s/law.png"))).unwrap();
        let reader = png::Decoder::new(std::io::BufReader::new(file))
            .read_info()
            .unwrap();
        (reader.info().width, reader.info().pixel_dims.unwrap().xppu)
    };
    // 90 mm, and 39.3701 inches per metre.
    bench.expect(0, &["run", "s.json", "--out", "usual"]);
    assert_eq!(size("usual"), (680, 7559));
    bench.expect(0, &["run", "s.json", "--out", "fine", "--dpi", "600"]);
    assert_eq!(size("fine"), (2126, 23622));
    for wrong in ["71", "1201", "0", "-300", "300.5", "many"] {
        let done = bench.expect(2, &["run", "s.json", &format!("--dpi={wrong}")]);
        assert!(done.err.contains("'--dpi <N>'"), "{done:?}");
    }
}
