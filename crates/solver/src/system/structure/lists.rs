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

    /// Number of lists.
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Whether there is no list.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// All lists, one after the other.
    #[inline(always)]
    pub fn iter(&self) -> impl Iterator<Item = &[T]> + '_ {
        self.starts
            .windows(2)
            .map(|ends| &self.entries[ends[0]..ends[1]])
    }

    /// The entries of all lists.
    pub fn entries(&self) -> &[T] {
        &self.entries
    }
}
