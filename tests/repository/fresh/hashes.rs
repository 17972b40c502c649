//! The hashes of the results that are not committed: large tables, and pictures that no page shows. Of a picture it is that of the SVG
//! file, whose bytes are the same on every processor; those of the PNG file are not, nor those of an image in an SVG file, which is left
//! out.

use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The list in figures/, in the form of `sha256sum`.
pub const FILE: &str = "hashes.txt";

/// The list: hash by path.
pub fn read() -> BTreeMap<String, String> {
    let text = fs::read_to_string(crate::root().join("figures").join(FILE)).unwrap();
    let lines = text.lines().map(|line| {
        let (hash, name) = line
            .split_once("  ")
            .unwrap_or_else(|| panic!("{FILE}: {line}"));
        (name.to_owned(), hash.to_owned())
    });
    lines.collect()
}

/// The file whose hash is kept for a table or picture.
pub fn hashed_name(name: &str) -> String {
    match name.strip_suffix(".png") {
        Some(stem) => format!("{stem}.svg"),
        None => name.to_owned(),
    }
}

/// The SHA-256 of a file, in hexadecimal digits. Of an SVG file without the images in it.
pub fn hash(file: &Path) -> String {
    let content = fs::read(file).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let bytes = match file.extension().is_some_and(|ending| ending == "svg") {
        true => without_images(&String::from_utf8(content).unwrap()).into_bytes(),
        false => content,
    };
    let digits = Sha256::digest(bytes);
    digits.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A text without the data of images, which end with the quotation mark of their attribute.
fn without_images(svg: &str) -> String {
    let mut pieces = svg.split(";base64,");
    let first = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(first, |text, piece| {
        let (_, rest) = piece.split_once('"').unwrap();
        text + ";base64,\"" + rest
    })
}

#[test]
#[ignore = "writes figures/hashes.txt; run by `make hashes`"]
fn rewrite() {
    let (committed, results) = (crate::committed(), crate::results());
    let outputs = crate::outputs(&results);
    let others = outputs.iter().filter(|name| !committed.contains(*name));
    let pairs = others.map(|name| {
        let name = hashed_name(name);
        (hash(&results.join(&name)), name)
    });
    // By path, as `read` has them.
    let hashes: BTreeMap<String, String> = pairs.map(|(hash, name)| (name, hash)).collect();
    let lines = hashes
        .iter()
        .map(|(name, hash)| format!("{hash}  {name}\n"));
    let text: String = lines.collect();
    fs::write(crate::root().join("figures").join(FILE), text).unwrap();
}

#[test]
fn a_hash_is_that_of_sha256sum() {
    // The example "abc" of FIPS 180-4.
    let file = std::env::temp_dir().join(format!("slipgap-hash-{}", std::process::id()));
    fs::write(&file, "abc").unwrap();
    assert_eq!(
        hash(&file),
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
    );
    fs::remove_file(file).unwrap();
}

#[test]
fn an_image_is_left_out_of_the_hash() {
    let picture = |data: &str| format!("<a/><image href=\"data:image/png;base64,{data}\"/><b/>");
    assert_eq!(without_images(&picture("AAAB")), picture(""));
    assert_eq!(without_images("<a/>"), "<a/>");
}
