//! Formats that are known and not read, so that a message can say what a file is.

/// A format by its marks: phrases of the first lines, and a row of ten whole numbers or more, as these formats have one.
struct Foreign {
    name: &'static str,
    /// A phrase that the file must have; empty for none.
    needed: &'static str,
    /// Phrases, of which three or more are there.
    marks: &'static [&'static str],
    /// What its rows have.
    rows: &'static str,
}

const PAIRS: &str = "its rows have pairs of a time and an acceleration";
const SERIES: &str = "its rows have pairs of a time and an acceleration (V1), or accelerations, then velocities and displacements (V2)";

/// Those of CSMIP, whose header others have, too.
const CSMIP: &[&str] = &[
    "ACCELEROGRAM",
    "INSTR PERIOD",
    "SENSITIVITY",
    "CHAN",
    "STATION NO",
    "RMS ACCEL",
    "RECORD LENGTH",
    "UNCOR",
    "POINTS OF INSTRUMENT",
    "RESPONSE SPECTRA",
];

const KNOWN: [Foreign; 3] = [
    Foreign {
        name: "USC",
        needed: "",
        marks: &[
            "USC#",
            "USC #",
            "OF VOLUME I",
            "UNITS ARE SEC AND G/10",
            "RMS ACCLN",
            "INSTR PERIOD",
        ],
        rows: PAIRS,
    },
    Foreign {
        name: "RENADIC (the layout of CSMIP V1)",
        needed: "RENADIC",
        marks: CSMIP,
        rows: PAIRS,
    },
    Foreign {
        name: "CSMIP (CDMG) V1 or V2",
        needed: "",
        marks: CSMIP,
        rows: SERIES,
    },
];

/// Lines that are searched for marks, and for the row.
const LINES: [usize; 2] = [30, 80];

/// Fewest marks.
const FEWEST: usize = 3;

/// What a file looks like: the name of the format, three of its marks, and what its rows have.
#[derive(Debug, Clone, PartialEq)]
pub struct Looks {
    /// The name.
    pub name: &'static str,
    /// Phrases that are in the file.
    pub marks: Vec<&'static str>,
    /// What its rows have.
    pub rows: &'static str,
}

/// The known format that a file looks like.
pub(super) fn looks(lines: &[&str]) -> Option<Looks> {
    let is_whole = |line: &&str| {
        let fields: Vec<&str> = line.split_whitespace().collect();
        fields.len() >= 10 && fields.iter().all(|field| field.parse::<i64>().is_ok())
    };
    lines.iter().take(LINES[1]).find(|line| is_whole(line))?;
    let head: Vec<String> = lines
        .iter()
        .take(LINES[0])
        .map(|line| line.to_ascii_uppercase())
        .collect();
    let has = |mark: &str| head.iter().any(|line| line.contains(mark));
    KNOWN.iter().find_map(|own| {
        let marks: Vec<&str> = own.marks.iter().copied().filter(|mark| has(mark)).collect();
        (has(own.needed) && marks.len() >= FEWEST).then(|| Looks {
            name: own.name,
            marks: marks.into_iter().take(FEWEST).collect(),
            rows: own.rows,
        })
    })
}
