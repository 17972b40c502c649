//! The fields of a line of a table.

/// The character that separates the fields of a line: a semicolon before a comma; none if blanks do.
pub(super) fn separator(line: &str) -> Option<char> {
    [';', ','].into_iter().find(|by| line.contains(*by))
}

/// The fields between separators, or between blanks. A separator within a field that is in quotes does not count.
pub(in crate::system) fn split(line: &str, by: Option<char>) -> Vec<&str> {
    let (mut in_quotes, mut begins) = (false, true);
    let fields = line.split(|c: char| {
        if in_quotes {
            in_quotes = c != '"';
            return false;
        }
        in_quotes = begins && c == '"';
        let ends = by.map_or(c.is_whitespace(), |by| c == by);
        begins = ends || begins && c.is_whitespace();
        ends
    });
    let fields = fields.map(str::trim);
    fields
        .filter(|field| by.is_some() || !field.is_empty())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_separator_in_quotes_is_part_of_its_field() {
        let of = |line| split(line, separator(line));
        assert_eq!(of("t, u ,,S"), ["t", "u", "", "S"]);
        assert_eq!(of("  t\t u  S"), ["t", "u", "S"]);
        assert_eq!(of("1,5; 2"), ["1,5", "2"]);
        assert_eq!(of("t, \"u, left\" ,S"), ["t", "\"u, left\"", "S"]);
        assert_eq!(of("t \"u left\" S"), ["t", "\"u left\"", "S"]);
        // A quote within a field is an inch.
        assert_eq!(of("u (\"),S (\")"), ["u (\")", "S (\")"]);
        assert_eq!(split("a\tb c\t", Some('\t')), ["a", "b c", ""]);
    }
}
