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

impl<T: Copy> Lists<T> {
    /// The entries (list, entry), of which each list has this number, in their order. `empty` is a value that is not used.
    pub fn sorted(counts: &[usize], empty: T, entries: impl Iterator<Item = (usize, T)>) -> Self {
        let mut starts = vec![0; counts.len() + 1];
        for (i, count) in counts.iter().enumerate() {
            starts[i + 1] = starts[i] + count;
        }
        let mut next = starts.clone();
        let mut sorted = vec![empty; starts[counts.len()]];
        for (list, entry) in entries {
            sorted[next[list]] = entry;
            next[list] += 1;
        }
        Lists {
            starts,
            entries: sorted,
        }
    }
}

impl<T> Lists<T> {
    /// Where each list starts among the entries, and where the last one ends.
    pub fn starts(&self) -> &[usize] {
        &self.starts
    }

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
