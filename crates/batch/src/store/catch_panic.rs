//! Catches panics of the Parquet library, which panics on some damaged files.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

thread_local! {
    /// Whether this thread expects a panic, so that no message is written.
    static EXPECTED: Cell<bool> = const { Cell::new(false) };
}

/// The result of `work`; `None`, without a message, if it panics.
pub fn catch_panic<T>(work: impl FnOnce() -> T) -> Option<T> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let default = take_hook();
        set_hook(Box::new(move |panic| {
            if !EXPECTED.get() {
                default(panic);
            }
        }));
    });
    // Calls may be nested.
    let outer = EXPECTED.replace(true);
    let result = catch_unwind(AssertUnwindSafe(work)).ok();
    EXPECTED.set(outer);
    result
}
