//! Pictures, compared pixel by pixel.

use std::fs;
use std::path::Path;

/// Most that a channel may differ, of 255. The numbers drawn are the same to the bit, but processors differ in how they
/// round the single-precision sums that blend a pixel, by one or two steps of a channel.
const CHANNEL: u8 = 2;
/// Pixels that may differ by more, where such a sum tips an edge over: fewer than a full stop covers.
const PIXELS: usize = 8;

/// How two pictures differ by more than the tolerance.
pub fn compare_pictures(old: &Picture, new: &Picture) -> Option<String> {
    if (old.width, old.height, old.channels) != (new.width, new.height, new.channels) {
        return Some(format!("{old} committed, {new} now"));
    }
    let far = |(a, b): (&[u8], &[u8])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > CHANNEL);
    let (a, b) = (old.data.chunks(old.channels), new.data.chunks(new.channels));
    let count = a.zip(b).filter(|&pair| far(pair)).count();
    (count > PIXELS)
        .then(|| format!("{count} pixels differ by more than {CHANNEL} of 255, {PIXELS} may"))
}

/// A picture as 8-bit samples.
pub struct Picture {
    width: u32,
    height: u32,
    channels: usize,
    data: Vec<u8>,
}

impl Picture {
    pub fn read(path: &Path) -> Picture {
        let file = std::io::BufReader::new(fs::File::open(path).unwrap());
        let mut decoder = png::Decoder::new(file);
        decoder.set_transformations(png::Transformations::normalize_to_color8());
        let mut reader = decoder.read_info().unwrap();
        let mut data = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut data).unwrap();
        data.truncate(info.buffer_size());
        Picture {
            width: info.width,
            height: info.height,
            channels: info.color_type.samples(),
            data,
        }
    }
}

impl std::fmt::Display for Picture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Picture {
            width,
            height,
            channels,
            ..
        } = self;
        write!(f, "{width} x {height} pixels of {channels} bytes")
    }
}

#[test]
fn a_full_stop_more_is_a_difference() {
    let picture = |grey: u8, dots: usize| Picture {
        width: 100,
        height: 50,
        channels: 3,
        data: [[0; 3], [grey; 3]]
            .iter()
            .zip([dots, 5000 - dots])
            .flat_map(|(pixel, count)| pixel.repeat(count))
            .collect(),
    };
    let plain = picture(255, 0);
    assert_eq!(compare_pictures(&plain, &picture(255 - CHANNEL, 0)), None);
    assert_eq!(compare_pictures(&plain, &picture(255, PIXELS)), None);
    assert!(compare_pictures(&plain, &picture(255, PIXELS + 1)).is_some());
    assert!(compare_pictures(&plain, &picture(254 - CHANNEL, 0)).is_some());
    let wider = Picture {
        width: 101,
        ..picture(255, 0)
    };
    assert!(compare_pictures(&plain, &wider).is_some());
}
