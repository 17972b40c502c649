//! Shorter paths of a figure: an eighth of a point is finer than a page shows.

use std::fmt::Write;

/// Units of the drawing in a unit of the paths: an eighth of a point.
const COARSER: f64 = 8.0;

/// Largest distance of a point that is left out from the line without it, in units of the paths.
const LEFT_OUT: f64 = 0.4;

/// The points of a line, and whether it returns to its start.
type Line = (Vec<[f64; 2]>, bool);

/// The SVG file with shorter paths. Elements are one a line, as the drawing writes them.
pub fn svg(svg: &str) -> String {
    let mut out = String::with_capacity(svg.len());
    for line in svg.lines() {
        match path(line) {
            Some(short) => out += &short,
            None => out += line,
        }
        out.push('\n');
    }
    out
}

/// A path of straight lines with fewer digits and points; `None` for every other element.
fn path(line: &str) -> Option<String> {
    let attributes = line.strip_prefix("<path fill=")?;
    let (attributes, data) = attributes.strip_suffix("\"/>")?.rsplit_once(" d=\"")?;
    let lines = lines(data)?;
    let attributes = match attributes.split_once("stroke-width=\"") {
        Some((before, after)) => {
            let (width, after) = after.split_once('"')?;
            let width = width.parse::<f64>().ok()? / COARSER;
            format!("{before}stroke-width=\"{width}\"{after}")
        }
        None => attributes.to_owned(),
    };
    let mut out = format!("<path transform=\"scale({COARSER})\" fill={attributes} d=\"");
    for (points, closed) in lines {
        write(&mut out, &simplified(&points), closed);
    }
    Some(out + "\"/>")
}

/// The lines of path data in coarse units; `None` if it has other commands than those of straight lines.
fn lines(data: &str) -> Option<Vec<Line>> {
    let mut lines: Vec<Line> = Vec::new();
    let mut at = [0.0, 0.0];
    let mut rest = data;
    while let Some(command) = rest.chars().next() {
        rest = &rest[command.len_utf8()..];
        let end = rest.find(|c: char| c.is_ascii_alphabetic());
        let (numbers, after) = rest.split_at(end.unwrap_or(rest.len()));
        rest = after;
        let numbers: Vec<f64> = { numbers.split_whitespace() }
            .map(|number| number.parse().ok())
            .collect::<Option<_>>()?;
        match (command, &numbers[..]) {
            ('M', [x, y]) => {
                at = [*x, *y];
                lines.push((Vec::new(), false));
            }
            ('l', [x, y]) => at = [at[0] + x, at[1] + y],
            ('h', [x]) => at[0] += x,
            ('v', [y]) => at[1] += y,
            ('z', []) => {
                lines.last_mut()?.1 = true;
                continue;
            }
            _ => return None,
        }
        let coarse = at.map(|x: f64| (x / COARSER).round());
        lines.last_mut()?.0.push(coarse);
    }
    Some(lines)
}

/// The points without those that are nearly on the line between the others (Douglas and Peucker).
fn simplified(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut kept = vec![false; points.len()];
    let last = points.len().saturating_sub(1);
    let mut parts = vec![[0, last]];
    while let Some([from, to]) = parts.pop() {
        if from >= points.len() {
            break;
        }
        [kept[from], kept[to]] = [true; 2];
        let between = from + 1..to;
        let far = |i: &usize| distance(points[*i], points[from], points[to]);
        let farthest = between.max_by(|i, j| far(i).total_cmp(&far(j)));
        if let Some(i) = farthest.filter(|i| far(i) > LEFT_OUT) {
            parts.extend([[from, i], [i, to]]);
        }
    }
    let kept = points.iter().zip(kept).filter(|(_, kept)| *kept);
    kept.map(|(point, _)| *point).collect()
}

/// Distance of a point from the line between two others.
fn distance(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    let [x, y] = [p[0] - a[0], p[1] - a[1]];
    let length = dx * dx + dy * dy;
    let along = if length > 0.0 {
        ((x * dx + y * dy) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    libm::hypot(x - along * dx, y - along * dy)
}

/// Adds a line with relative steps. A line of one point is kept, because it has round or square ends.
fn write(out: &mut String, points: &[[f64; 2]], closed: bool) {
    let Some([mut x, mut y]) = points.first().copied() else {
        return;
    };
    // Writing to a string cannot fail.
    let _ = write!(out, "M{x} {y}");
    if points.len() > 1 {
        out.push('l');
    }
    for (i, [next_x, next_y]) in points[1..].iter().copied().enumerate() {
        let gap = if i == 0 || next_x < x { "" } else { " " };
        let comma = if next_y < y { "" } else { " " };
        let _ = write!(out, "{gap}{}{comma}{}", next_x - x, next_y - y);
        [x, y] = [next_x, next_y];
    }
    if closed {
        out.push('z');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_has_coarser_units_and_the_same_shape() {
        let long = "<path fill=\"none\" stroke=\"#000000\" stroke-width=\"58\" d=\"M16 24l80 0l-8 -16M0 0h64v80h-64z\"/>";
        let short = "<path transform=\"scale(8)\" fill=\"none\" stroke=\"#000000\" stroke-width=\"7.25\" d=\"M2 3l10 0-1-2M0 0l8 0 0 10-8 0z\"/>";
        assert_eq!(svg(long), format!("{short}\n"));
    }

    #[test]
    fn other_elements_stay() {
        for line in [
            "<path id=\"r1\" d=\"M0 0C1 1 2 2 3 3\"/>",
            "<path fill=\"#fff\" d=\"M0 0C1 1 2 2 3 3\"/>",
            "<use href=\"#r1\" x=\"5\"/>",
            "<path fill=\"none\" d=\"l1 1\"/>",
        ] {
            assert_eq!(svg(line), format!("{line}\n"));
        }
    }

    #[test]
    fn a_point_is_left_out_only_if_it_is_near_the_line() {
        let sine = |i: u32| {
            [
                f64::from(i),
                (100.0 * libm::sin(0.05 * f64::from(i))).round(),
            ]
        };
        let points: Vec<[f64; 2]> = (0..1000).map(sine).collect();
        let kept = simplified(&points);
        assert!(kept.len() < 500, "{}", kept.len());
        assert_eq!([kept[0], kept[kept.len() - 1]], [points[0], points[999]]);
        for point in &points {
            let near = |pair: &[[f64; 2]]| distance(*point, pair[0], pair[1]) <= LEFT_OUT;
            assert!(kept.windows(2).any(near), "{point:?}");
        }
        assert_eq!(simplified(&[]), Vec::<[f64; 2]>::new());
        assert_eq!(simplified(&[[1.0, 2.0]]), [[1.0, 2.0]]);
    }
}
