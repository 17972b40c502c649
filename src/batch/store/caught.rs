//! A panic as an answer: for a library that panics on what a file holds.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

thread_local! {
    /// Whether a panic of this thread is expected, and so says nothing.
    static EXPECTED: Cell<bool> = const { Cell::new(false) };
}

/// What `work` gives; `None`, without a word, where it panics.
pub fn caught<T>(work: impl FnOnce() -> T) -> Option<T> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let former = take_hook();
        set_hook(Box::new(move |panic| {
            if !EXPECTED.get() {
                former(panic);
            }
        }));
    });
    // Within another such call it stays expected.
    let outer = EXPECTED.replace(true);
    let done = catch_unwind(AssertUnwindSafe(work)).ok();
    EXPECTED.set(outer);
    done
}
