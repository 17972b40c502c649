//! Lists one behind the other.

/// Lists, all entries in one block of memory.
#[derive(Debug, Clone)]
pub struct Lists<T> {
    starts: Vec<usize>,
    entries: Vec<T>,
}

impl<T: Clone> Lists<T> {
    /// The lists.
    pub fn new(lists: &[Vec<T>]) -> Self {
        let ends = lists.iter().scan(0, |end, list| {
            *end += list.len();
            Some(*end)
        });
        Lists {
            starts: std::iter::once(0).chain(ends).collect(),
            entries: lists.concat(),
        }
    }
}

impl<T> Lists<T> {
    /// List `i`.
    #[inline(always)]
    pub fn list(&self, i: usize) -> &[T] {
        &self.entries[self.starts[i]..self.starts[i + 1]]
    }

    /// The entries of all lists.
    pub fn entries(&self) -> &[T] {
        &self.entries
    }
}
