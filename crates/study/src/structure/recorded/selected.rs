//! How many motions of the folders of `choose` have their spectrum, for those who wait: a folder of thousands takes minutes once.

use std::sync::atomic::{AtomicUsize, Ordering};

static DONE: AtomicUsize = AtomicUsize::new(0);
static OF: AtomicUsize = AtomicUsize::new(0);

/// The motions of this process with a spectrum, and all from which records are chosen; none in most studies.
pub fn choosing() -> Option<[usize; 2]> {
    let [done, of] = [&DONE, &OF].map(|count| count.load(Ordering::Relaxed));
    (done < of).then_some([done, of])
}

/// Motions more, from which records are chosen.
pub(super) fn begin(motions: usize) {
    OF.fetch_add(motions, Ordering::Relaxed);
}

/// One of them has its spectrum.
pub(super) fn step() {
    DONE.fetch_add(1, Ordering::Relaxed);
}
