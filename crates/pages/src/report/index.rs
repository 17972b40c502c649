//! The index of a page about several studies: a search, tags, and the studies by problem and tag.

use super::text::escape;
use super::{Detail, Section};
use std::io::{self, Write};

/// The studies by problem, in order of appearance.
pub struct Index<'a> {
    sections: &'a [Section<'a>],
    groups: Vec<Group<'a>>,
    /// Each tag of two studies or more, and how many studies have it; rising.
    tags: Vec<(&'a str, usize)>,
}

/// The studies of a problem.
pub struct Group<'a> {
    problem: &'a str,
    /// Tag and studies; a study that shares no tag has the tag "".
    parts: Vec<(&'a str, Vec<usize>)>,
}

/// The tags of a study: its folders, and its name up to the first `-`. The study `claims/impact-once` has the tags `claims` and `impact`.
fn tags(name: &str) -> impl Iterator<Item = &str> {
    let (folders, file) = name.rsplit_once('/').unwrap_or(("", name));
    let first_word = file.split_once('-').map(|(word, _)| word);
    let word = first_word.filter(|word| folders.split('/').all(|folder| folder != *word));
    folders.split('/').chain(word).filter(|tag| !tag.is_empty())
}

impl<'a> Index<'a> {
    /// The index of studies.
    pub fn new(sections: &'a [Section<'a>]) -> Index<'a> {
        let mut tags_of_two: Vec<(&str, usize)> = Vec::new();
        for tag in sections.iter().flat_map(|section| tags(section.name)) {
            match tags_of_two.iter_mut().find(|known| known.0 == tag) {
                Some((_, count)) => *count += 1,
                None => tags_of_two.push((tag, 1)),
            }
        }
        tags_of_two.retain(|(_, count)| *count > 1);
        tags_of_two.sort_unstable();
        let shared = |tag: &&str| tags_of_two.iter().any(|known| known.0 == *tag);
        let mut groups: Vec<Group> = Vec::new();
        for (index, section) in sections.iter().enumerate() {
            let problem = section.study.problem.name();
            let tag = tags(section.name).find(shared).unwrap_or_default();
            let group = entry(
                &mut groups,
                |group| group.problem == problem,
                || Group {
                    problem,
                    parts: Vec::new(),
                },
            );
            entry(&mut group.parts, |part| part.0 == tag, || (tag, Vec::new()))
                .1
                .push(index);
        }
        Index {
            sections,
            groups,
            tags: tags_of_two,
        }
    }

    /// The groups.
    pub fn groups(&self) -> &[Group<'a>] {
        &self.groups
    }

    /// Writes the search, the tags and the list.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        out.write_all(
            b"<nav aria-label=\"Studies\">\n<h2>Studies</h2>\n<div class=\"bar\">\
              <label>Search <input type=\"search\" spellcheck=\"false\" placeholder=\"friction peak force\"></label>\
              <output aria-live=\"polite\"></output></div>\n",
        )?;
        if !self.tags.is_empty() {
            out.write_all(b"<div class=\"tags\" role=\"group\" aria-label=\"Tags\">")?;
            for (tag, count) in &self.tags {
                let tag = escape(tag);
                write!(
                    out,
                    "<button type=\"button\" aria-pressed=\"false\" data-tag=\"{tag}\">{tag} {count}</button>"
                )?;
            }
            out.write_all(b"</div>\n")?;
        }
        for group in &self.groups {
            writeln!(out, "<div class=\"group\"><h3>{}</h3>", group.problem)?;
            for (tag, places) in &group.parts {
                let tag = match *tag {
                    "" => "other",
                    tag => tag,
                };
                writeln!(out, "<div class=\"group\"><h4>{}</h4><ul>", escape(tag))?;
                for index in places {
                    self.write_entry(out, *index)?;
                }
                out.write_all(b"</ul></div>\n")?;
            }
            out.write_all(b"</div>\n")?;
        }
        out.write_all(b"</nav>\n")
    }

    fn write_entry(&self, out: &mut impl Write, index: usize) -> io::Result<()> {
        let section = &self.sections[index];
        let tags: Vec<&str> = tags(section.name).collect();
        let cases = section.results.cases();
        let failed = match section.checks.failed() {
            0 => String::new(),
            1 => ", <b class=\"fails\">1 check not met</b>".to_owned(),
            failed => format!(", <b class=\"fails\">{failed} checks not met</b>"),
        };
        writeln!(
            out,
            "<li data-tags=\"{}\"><a href=\"#study-{index}\">{}</a> <span class=\"facts\">{}, {cases} {}{failed}</span></li>",
            escape(&tags.join(" ")),
            escape(section.title()),
            escape(section.name),
            if cases == 1 { "case" } else { "cases" },
        )
    }
}

/// The first entry that `is` finds, or a new one at the end.
fn entry<T>(list: &mut Vec<T>, is: impl Fn(&T) -> bool, new: impl FnOnce() -> T) -> &mut T {
    let position = list.iter().position(is).unwrap_or_else(|| {
        list.push(new());
        list.len() - 1
    });
    &mut list[position]
}

impl Group<'_> {
    /// Writes the heading of the studies; their parts follow, and the end of an element.
    pub fn begin(&self, out: &mut impl Write, detail: Detail) -> io::Result<()> {
        match detail {
            Detail::Whole => out.write_all(b"<div class=\"group\">\n"),
            Detail::Overview => writeln!(out, "<div class=\"group\">\n<h2>{}</h2>", self.problem),
        }
    }

    /// The places of the studies in the order of the index.
    pub fn places(&self) -> impl Iterator<Item = usize> {
        self.parts
            .iter()
            .flat_map(|(_, places)| places.iter().copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_are_folders_and_the_first_word() {
        let of = |name: &'static str| tags(name).collect::<Vec<_>>();
        assert_eq!(of("claims/impact-once"), ["claims", "impact"]);
        assert_eq!(of("a/b/c"), ["a", "b"]);
        assert_eq!(of("bridges-friction-step"), ["bridges"]);
        assert_eq!(of("bridges/bridges-friction-step"), ["bridges"]);
        assert!(of("alone").is_empty());
    }
}
