//! The compressed parts of a page, unpacked without code of the program.

use flate2::read::DeflateDecoder;
use std::io::Read;

/// The content of packed scripts.
const BEGIN: &str = "<script type=\"text/plain\">";

/// The page with its figures and parts of HTML unpacked in their places, for tests of their content.
pub fn unpacked(page: &str) -> String {
    let mut whole = String::new();
    let mut rest = page;
    while let Some((before, after)) = rest.split_once(BEGIN) {
        let (text, after) = after.split_once("</script>").unwrap();
        whole += before;
        // The numbers of a table are not text.
        whole += std::str::from_utf8(&inflated(text)).unwrap_or_default();
        rest = after;
    }
    whole + rest
}

/// The packed scripts of a part of a page.
pub fn scripts(part: &str) -> Vec<Vec<u8>> {
    let texts = part
        .split(BEGIN)
        .skip(1)
        .map(|text| text.split_once("</script>").unwrap().0);
    texts.map(inflated).collect()
}

/// The bytes of DEFLATE as base64.
fn inflated(base64: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    DeflateDecoder::new(&*super::data::bytes(base64))
        .read_to_end(&mut bytes)
        .unwrap();
    bytes
}
