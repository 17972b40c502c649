//! What `--version` prints: the version, and the commit where it is known.

use std::sync::LazyLock;

/// `0.2.0 (6ae660d6)`, or the version alone.
pub static VERSION: LazyLock<String> = LazyLock::new(|| {
    let version = env!("CARGO_PKG_VERSION");
    let commit = COMMIT
        .as_ref()
        .and_then(|digits| str::from_utf8(digits).ok());
    commit.map_or_else(
        || version.to_owned(),
        |commit| format!("{version} ({commit})"),
    )
});

/// Found while the program is compiled: the log itself, which has names of people, is not in the program.
const COMMIT: Option<[u8; 8]> = commit(include_bytes!(env!("SLIPGAP_LOG_OF_HEAD")));

/// The first digits of the second commit in the last line of a log of git's HEAD.
const fn commit(log: &[u8]) -> Option<[u8; 8]> {
    let mut start = log.len().saturating_sub(1);
    while start > 0 && log[start - 1] != b'\n' {
        start -= 1;
    }
    while start < log.len() && log[start] != b' ' {
        start += 1;
    }
    let mut digits = [0; 8];
    let mut index = 0;
    while index < digits.len() {
        let at = start + 1 + index;
        if at >= log.len() || !log[at].is_ascii_hexdigit() {
            return None;
        }
        digits[index] = log[at];
        index += 1;
    }
    Some(digits)
}

#[cfg(test)]
mod tests {
    use super::commit;

    #[test]
    fn the_commit_is_the_second_of_the_last_line() {
        let before = "0000000000000000000000000000000000000000";
        let [first, second] = ["6ae660d6d7b8", "dfa19e44ffff"];
        let one = format!("{before} {first} A B <a@b> 1764115200 +0000\tclone: from x\n");
        assert_eq!(commit(one.as_bytes()), Some(*b"6ae660d6"));
        let two = format!("{one}{first} {second} A B <a@b> 1764115201 +0000\tcommit: deadbeef\n");
        assert_eq!(commit(two.as_bytes()), Some(*b"dfa19e44"));
        assert_eq!(commit(b"- 6ae660d6d7b8"), Some(*b"6ae660d6"));
    }

    #[test]
    fn without_a_commit_there_is_none() {
        for log in ["", "\n", "- ", "0000", "- 6ae660", "a word and more"] {
            assert_eq!(commit(log.as_bytes()), None, "{log:?}");
        }
    }
}
