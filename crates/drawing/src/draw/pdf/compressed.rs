//! Compressed streams of a PDF file.

use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::io::Write;

/// Bytes compressed by zlib.
pub fn compressed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    // Writing to memory cannot fail.
    let _ = encoder.write_all(bytes);
    encoder.finish().unwrap_or_default()
}
