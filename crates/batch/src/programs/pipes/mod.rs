//! The input and the outputs of a program, which never hold up the product: whoever waits for a line does so until an instant.

// Both are tested where both can be compiled.
#[cfg(unix)]
mod poll;
#[cfg(any(not(unix), test))]
mod threads;

#[cfg(all(unix, test))]
mod tests;

#[cfg(unix)]
pub(super) use poll::Pipes;
#[cfg(not(unix))]
pub(super) use threads::Pipes;

/// Why a program gave no line.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Silent {
    /// Its time is over.
    Late,
    /// Its output has ended.
    Ended,
}

/// Most bytes of a line: 100 channels over 10^6 steps are 2e9.
const LONGEST: usize = u32::MAX as usize;

/// Most bytes of a line of standard error, which is only quoted.
const LONGEST_ERROR: usize = 1 << 16;
