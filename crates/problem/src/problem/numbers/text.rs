//! Texts and tables that are either in the program or built while it runs.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// A text that is either in the program or built while it runs.
pub type Text = Cow<'static, str>;

/// A table that is either in the program or built while it runs.
pub type Table<T> = Cow<'static, [T]>;

/// The text itself, for constants; only texts of the program are allowed there.
pub(crate) const fn text(text: &Text) -> &str {
    match text {
        Cow::Borrowed(text) => text,
        Cow::Owned(_) => "",
    }
}

/// A text that lives as long as the program. Equal texts share their memory, so that reading a study again takes no more.
pub fn interned(text: &str) -> &'static str {
    static TEXTS: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());
    let mut texts = TEXTS.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = texts.get(text) {
        return known;
    }
    let text: &'static str = Box::leak(text.into());
    texts.insert(text);
    text
}
