//! Texts and tables that are either in the program or built while it runs.

use std::borrow::Cow;

/// A text that is either in the program or built while it runs.
pub type Text = Cow<'static, str>;

/// A table that is either in the program or built while it runs.
pub type Table<T> = Cow<'static, [T]>;

/// The text itself, for constants; only texts of the program are allowed there.
pub(super) const fn text(text: &Text) -> &str {
    match text {
        Cow::Borrowed(text) => text,
        Cow::Owned(_) => "",
    }
}
