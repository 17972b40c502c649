//! The markup of titles and symbols: `*italic*`, `_subscript_`, `^superscript^`, a backslash before a
//! mark that is meant literally. Marks do not nest; a mark without its partner is literal too, and so is a backslash before
//! any other character.

pub use slipgap_notation::{capital, escape, in_unit, small, unit};

/// A piece of text set in one way.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Piece {
    /// The characters.
    pub text: String,
    /// How they are set.
    pub set: Set,
}

/// How a piece of text is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Set {
    /// Upright, on the line.
    Roman,
    /// Italic, on the line.
    Italic,
    /// Upright, small, below the line.
    Subscript,
    /// Upright, small, above the line.
    Superscript,
}

fn opened_by(mark: char) -> Option<Set> {
    match mark {
        '*' => Some(Set::Italic),
        '_' => Some(Set::Subscript),
        '^' => Some(Set::Superscript),
        _ => None,
    }
}

/// The pieces of a line of markup, in order; none is empty.
pub fn parse(markup: &str) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut roman = String::new();
    let mut rest = markup;
    while let Some(mark) = rest.chars().next() {
        let after = &rest[mark.len_utf8()..];
        if let Some(set) = opened_by(mark)
            && let Some((text, behind)) = until(after, mark)
        {
            push(&mut pieces, std::mem::take(&mut roman), Set::Roman);
            push(&mut pieces, text, set);
            rest = behind;
        } else {
            let (c, behind) = literal(rest);
            roman.push(c);
            rest = behind;
        }
    }
    push(&mut pieces, roman, Set::Roman);
    pieces
}

/// The characters alone, for readers of plain text; a power keeps its place, as in 10⁷.
pub fn plain(markup: &str) -> String {
    let text = |piece: Piece| match piece.set {
        Set::Superscript => raised(&piece.text).unwrap_or(piece.text),
        Set::Roman | Set::Italic | Set::Subscript => piece.text,
    };
    parse(markup).into_iter().map(text).collect()
}

/// A whole number in raised figures; `None` for another text.
fn raised(text: &str) -> Option<String> {
    const FIGURES: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let one = |c: char| match c {
        '−' | '-' => Some('⁻'),
        _ => Some(FIGURES[c.to_digit(10)? as usize]),
    };
    text.chars().map(one).collect()
}

fn push(pieces: &mut Vec<Piece>, text: String, set: Set) {
    if !text.is_empty() {
        pieces.push(Piece { text, set });
    }
}

/// The text up to the next `mark`, and what is behind it.
fn until(mut rest: &str, mark: char) -> Option<(String, &str)> {
    let mut text = String::new();
    while !rest.is_empty() {
        if let Some(behind) = rest.strip_prefix(mark) {
            return (!text.is_empty()).then_some((text, behind));
        }
        let (c, behind) = literal(rest);
        text.push(c);
        rest = behind;
    }
    None
}

/// The next character without its backslash, if it is one that [`escape`] escapes; `rest` is not empty.
fn literal(rest: &str) -> (char, &str) {
    let mut chars = rest.chars();
    let first = chars.next().unwrap_or(' ');
    let after = chars.as_str();
    if first == '\\'
        && let Some(second) = chars.next()
    {
        if second != '\\' && opened_by(second).is_none() {
            return (first, after);
        }
        return (second, chars.as_str());
    }
    (first, chars.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(markup: &str) -> String {
        let mut out = String::new();
        for piece in parse(markup) {
            let tag = match piece.set {
                Set::Roman => 'r',
                Set::Italic => 'i',
                Set::Subscript => 's',
                Set::Superscript => 'p',
            };
            out += &format!("{tag}({})", piece.text);
        }
        out
    }

    #[test]
    fn symbols_of_the_tables() {
        assert_eq!(shape("*X*_0_"), "i(X)s(0)");
        assert_eq!(shape("Δ*T*"), "r(Δ)i(T)");
        assert_eq!(shape("*ω*_n_*t*"), "i(ω)s(n)i(t)");
        assert_eq!(shape("10^−3^"), "r(10)p(−3)");
    }

    #[test]
    fn marks_without_partner_stand_for_themselves() {
        assert_eq!(shape("a_b"), "r(a_b)");
        assert_eq!(shape("2 * 3"), "r(2 * 3)");
        assert_eq!(shape("**"), "r(**)");
        assert_eq!(shape("rms\\_error\\_x"), "r(rms_error_x)");
        assert_eq!(shape("\\"), "r(\\)");
        assert_eq!(shape("C:\\temp \\alpha\\"), "r(C:\\temp \\alpha\\)");
        assert_eq!(shape("a\\\\b \\*c*"), "r(a\\b *c*)");
        assert_eq!(shape("*a\\*b*"), "i(a*b)");
        assert_eq!(shape(""), "");
    }

    #[test]
    fn a_power_stays_one_in_plain_text() {
        assert_eq!(plain("1.5 × 10^7^"), "1.5 × 10⁷");
        assert_eq!(plain("10^−12^ s^-1^"), "10⁻¹² s⁻¹");
        assert_eq!(plain("*r*^E^"), "rE");
    }

    #[test]
    fn escaped_text_comes_back() {
        for text in ["a_b_c", "x*y*", "\\^2^", "Fig. 5"] {
            assert_eq!(plain(&escape(text)), text);
        }
    }
}
