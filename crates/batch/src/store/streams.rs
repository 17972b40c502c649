//! Numbers as eight streams of bytes in the format of Snappy: the first bytes of all numbers, then the second ones, and so on, which is
//! Parquet's BYTE_STREAM_SPLIT.
//!
//! Neighbouring cases mostly have the same sign, exponent and leading digits: their streams are long runs of one byte. The other
//! streams are as if random, and a search for repetitions in them takes longer than to write them. So only runs are looked for, and
//! only in streams that seem to have them.

/// Bytes of a number.
const WIDTH: usize = 8;

/// Shortest run of one byte that is worth a copy, which takes 3 bytes and ends a literal.
const SHORTEST: usize = 12;

/// Smallest mean length of runs in a stream that is searched for them: finding more takes longer than writing them.
const MEAN: usize = 24;

/// Number of bytes of a sample of a stream.
const SAMPLE: usize = 256;

/// Longest copy in the format of Snappy.
const LONGEST_COPY: usize = 64;

/// Puts the streams of the numbers in `left`, which has as many bytes.
pub fn split(numbers: &[f64], mut left: &mut [u8]) {
    let len = numbers.len();
    let (blocks, rest) = numbers.as_chunks::<WIDTH>();
    let mut streams: [&mut [u8]; WIDTH] = std::array::from_fn(|_| {
        let (stream, others) = std::mem::take(&mut left).split_at_mut(len);
        left = others;
        stream
    });
    for (i, block) in blocks.iter().enumerate() {
        let rows = transposed(block.map(f64::to_bits));
        for (stream, row) in streams.iter_mut().zip(rows) {
            stream[WIDTH * i..][..WIDTH].copy_from_slice(&row.to_le_bytes());
        }
    }
    for (i, x) in (len - rest.len()..).zip(rest) {
        for (stream, byte) in streams.iter_mut().zip(x.to_le_bytes()) {
            stream[i] = byte;
        }
    }
}

/// The numbers of streams that [`split`] made.
pub fn joined(bytes: &[u8]) -> Vec<f64> {
    let len = bytes.len() / WIDTH;
    let streams: [&[u8]; WIDTH] = std::array::from_fn(|i| &bytes[i * len..][..len]);
    let blocks = streams.map(|stream| stream.as_chunks::<WIDTH>().0);
    let mut numbers = Vec::with_capacity(len);
    for i in 0..len / WIDTH {
        let rows = blocks.map(|blocks| u64::from_le_bytes(blocks[i]));
        numbers.extend(transposed(rows).map(f64::from_bits));
    }
    let rest = numbers.len()..len;
    numbers.extend(rest.map(|i| f64::from_le_bytes(streams.map(|stream| stream[i]))));
    numbers
}

/// The bytes of a matrix of 8 x 8, a row in a number, with rows and columns exchanged: blocks of 4, 2 and 1 change places.
#[inline(always)]
fn transposed(mut rows: [u64; WIDTH]) -> [u64; WIDTH] {
    for i in [0, 1, 2, 3] {
        exchange::<4>(&mut rows, i, 0x0000_0000_ffff_ffff);
    }
    for i in [0, 1, 4, 5] {
        exchange::<2>(&mut rows, i, 0x0000_ffff_0000_ffff);
    }
    for i in [0, 2, 4, 6] {
        exchange::<1>(&mut rows, i, 0x00ff_00ff_00ff_00ff);
    }
    rows
}

/// Exchanges the blocks above the diagonal with those below it, in row `i` and the one `D` below.
#[inline(always)]
fn exchange<const D: usize>(rows: &mut [u64; WIDTH], i: usize, mask: u64) {
    let (a, b) = (rows[i], rows[i + D]);
    rows[i] = (a & mask) | ((b & mask) << (8 * D));
    rows[i + D] = ((a >> (8 * D)) & mask) | (b & !mask);
}

/// The bytes in the format of Snappy. Those from `start` on are streams of this length.
pub fn packed(bytes: &[u8], start: usize, length: usize) -> Vec<u8> {
    let mut packed = Vec::with_capacity(bytes.len() + SAMPLE);
    push_varint(&mut packed, bytes.len());
    // Where the bytes begin that are not written yet.
    let mut from = 0;
    let streams = bytes[start..].chunks(length.max(1));
    for (begin, stream) in (start..).step_by(length.max(1)).zip(streams) {
        if !has_runs(stream) {
            continue;
        }
        let mut at = 0;
        while at < stream.len() {
            let run = run(&stream[at..]);
            if run >= SHORTEST {
                push_literal(&mut packed, &bytes[from..=begin + at]);
                push_repetition(&mut packed, run - 1);
                from = begin + at + run;
            }
            at += run;
        }
    }
    push_literal(&mut packed, &bytes[from..]);
    packed
}

/// Whether a byte is mostly that before it, in samples from the start and the middle.
fn has_runs(stream: &[u8]) -> bool {
    let (mut changes, mut count) = (0, 0);
    for start in [0, stream.len() / 2] {
        let sample = &stream[start..stream.len().min(start + SAMPLE)];
        changes += sample.windows(2).filter(|pair| pair[0] != pair[1]).count();
        count += sample.len();
    }
    changes * MEAN < count
}

/// How many bytes at the start are the same.
fn run(bytes: &[u8]) -> usize {
    let Some(first) = bytes.first() else {
        return 0;
    };
    let (words, rest) = bytes.as_chunks::<WIDTH>();
    for (i, word) in words.iter().enumerate() {
        let other = u64::from_le_bytes(*word) ^ u64::from_le_bytes([*first; WIDTH]);
        if other != 0 {
            return WIDTH * i + other.trailing_zeros() as usize / 8;
        }
    }
    let same = rest.iter().take_while(|byte| *byte == first);
    WIDTH * words.len() + same.count()
}

/// Appends bytes as they are.
fn push_literal(packed: &mut Vec<u8>, bytes: &[u8]) {
    let Some(last) = bytes.len().checked_sub(1) else {
        return;
    };
    match last {
        0..60 => packed.push((last as u8) << 2),
        _ => {
            let length = &last.to_le_bytes()[..4 - (last as u32).leading_zeros() as usize / 8];
            packed.push((59 + length.len() as u8) << 2);
            packed.extend_from_slice(length);
        }
    }
    packed.extend_from_slice(bytes);
}

/// Appends the last byte so many times more: copies from one byte before.
fn push_repetition(packed: &mut Vec<u8>, mut times: usize) {
    while times > 0 {
        let length = times.min(LONGEST_COPY);
        packed.extend_from_slice(&[(length as u8 - 1) << 2 | 2, 1, 0]);
        times -= length;
    }
}

/// Appends a number in groups of seven bits, the lowest first.
pub fn push_varint(bytes: &mut Vec<u8>, mut number: usize) {
    while number >= 0x80 {
        bytes.push(number as u8 | 0x80);
        number >>= 7;
    }
    bytes.push(number as u8);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The streams of the numbers, one byte at a time.
    fn streams(numbers: &[f64]) -> Vec<u8> {
        let stream = |byte: usize| numbers.iter().map(move |x| x.to_le_bytes()[byte]);
        (0..WIDTH).flat_map(stream).collect()
    }

    /// What a reader of the format makes of packed bytes.
    fn unpacked(packed: &[u8]) -> Vec<u8> {
        let (mut at, mut bytes) = (0, Vec::new());
        let mut take = |count: usize| {
            at += count;
            packed.get(at - count..at).map(<[u8]>::to_vec)
        };
        let (mut len, mut shift) = (0, 0);
        loop {
            let byte = usize::from(take(1).unwrap()[0]);
            len |= (byte & 0x7f) << shift;
            shift += 7;
            if byte < 0x80 {
                break;
            }
        }
        while let Some(tag) = take(1) {
            let (kind, count) = (tag[0] & 3, usize::from(tag[0] >> 2));
            if kind == 0 {
                let more = count.saturating_sub(59);
                let length = take(more).unwrap();
                let long = length
                    .iter()
                    .rev()
                    .fold(0, |sum, b| sum << 8 | usize::from(*b));
                let count = if more == 0 { count } else { long };
                bytes.extend(take(count + 1).unwrap());
            } else {
                assert_eq!((kind, take(2).unwrap()), (2, vec![1, 0]));
                let last = *bytes.last().unwrap();
                bytes.extend(std::iter::repeat_n(last, count + 1));
            }
        }
        assert_eq!(bytes.len(), len);
        bytes
    }

    #[test]
    fn numbers_are_the_same_after_unpacking() {
        let noise = |i: usize| (i as f64 * 0.618_033_988_749_894_9).fract();
        for len in [0, 1, 7, 8, 9, 300, 16_384, 40_000] {
            let smooth: Vec<f64> = (0..len).map(|i| 1.0 + i as f64 / 1e5 / 3.0).collect();
            let random = (0..len).map(|i| (noise(i) - 0.5) * 10_f64.powf(99.0 * noise(7 * i)));
            let whole = (0..len).map(|i| (i / 50) as f64).collect();
            for numbers in [smooth, random.collect(), whole, vec![-0.0; len]] {
                let mut bytes = vec![3; 3 + WIDTH * len];
                split(&numbers, &mut bytes[3..]);
                assert_eq!(bytes[3..], streams(&numbers));
                let bits =
                    |numbers: &[f64]| -> Vec<u64> { numbers.iter().map(|x| x.to_bits()).collect() };
                assert_eq!(bits(&joined(&bytes[3..])), bits(&numbers));
                let packed = packed(&bytes, 3, len);
                assert_eq!(unpacked(&packed), bytes);
                assert!(packed.len() <= bytes.len() + 16, "{}", packed.len());
            }
        }
    }

    #[test]
    fn smooth_numbers_take_less_than_six_bytes_and_equal_ones_almost_none() {
        let per_number = |numbers: &[f64]| {
            let mut bytes = vec![0; WIDTH * numbers.len()];
            split(numbers, &mut bytes);
            packed(&bytes, 0, numbers.len()).len() as f64 / numbers.len() as f64
        };
        let smooth: Vec<f64> = (0..16_384)
            .map(|i| (2.0 + f64::from(i) / 1e5).sqrt())
            .collect();
        assert!(
            (5.0..6.0).contains(&per_number(&smooth)),
            "{}",
            per_number(&smooth)
        );
        assert!(per_number(&[0.1; 16_384]) < 0.4);
    }
}
