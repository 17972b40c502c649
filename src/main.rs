//! The `slipgap` command line: verbs in, exit codes out.

mod commands;

use clap::{Args, Parser, Subcommand};
use commands::asked::Jobs;
use commands::run::{Format, Manner};
use commands::sources::Source;
use slipgap::error::Error;
use slipgap::figures::style;
use slipgap::problem::Problem;
use slipgap::study::Setting;
use std::path::PathBuf;
use std::process::ExitCode;

/// Parameter studies of friction and impact models in time-history analysis.
#[derive(Parser)]
#[command(version, after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
}

const EXIT_CODES: &str = "Exit codes: 0 good; 1 internal or I/O; 2 usage or study; 3 a case could not be solved; \
5 a check is not met, a verdict other than recorded, results that differ or a target out of reach; 130 interrupted.";

#[derive(Subcommand)]
enum Verb {
    /// Write a small commented study to studies/NAME.json, to start from
    Init(Init),
    /// Run studies: results.csv and figures into a folder for each
    Run(Run),
    /// Run studies and test their checks; writes nothing
    Check(Check),
    /// Show studies, their axes, cases and steps, without running them
    List(Studies),
    /// Show a case of a study: its parameters, steps, work and time
    Explain(Explain),
    /// Compare two folders of results, metric by metric, and show the largest differences first
    Compare(Compare),
    /// Write one page about studies: figures, tables to sort and filter, checks, claims; it needs no other file
    Report(Report),
    /// Judge the statements of the papers by studies, print the verdicts and write claims.md
    Claims(Claims),
    /// Find the cheapest parameters that reach a target, with the run that proves it and the alternatives
    #[command(subcommand)]
    Recommend(commands::asked::Asked),
    /// Print the JSON schema of study files
    Schema(Schema),
}

#[derive(Args)]
struct Studies {
    /// Study files, or folders that are read with their sub-folders; `-` is standard input, its results go to folder stdin
    #[arg(value_name = "STUDY|FOLDER", default_value = "studies")]
    studies: Vec<PathBuf>,
    /// Most raw combinations of a study
    #[arg(long, value_name = "CASES", default_value_t = slipgap::study::MOST_CASES)]
    limit: u64,
    #[command(flatten)]
    settings: Settings,
}

impl Studies {
    fn read(&self) -> Result<Vec<Source>, Error> {
        commands::sources::read(&self.studies, &self.settings.set, self.limit)
    }
}

#[derive(Args)]
struct Settings {
    /// Set a parameter in every block that gives it, or in all blocks if none does; VALUE is JSON, a name or an
    /// expression, as in dT=pi/10 or 'alpha=[0.1, 1]'; may be given several times
    #[arg(long, value_name = "NAME=VALUE", value_parser = Setting::new)]
    set: Vec<Setting>,
}

#[derive(Args)]
struct Run {
    #[command(flatten)]
    studies: Studies,
    /// Folder for the results; one folder for each study is made in it
    #[arg(long, value_name = "DIR", default_value = "figures")]
    out: PathBuf,
    /// Write the history of every case too, as histories/CASE.csv; every case is computed anew
    #[arg(long)]
    histories: bool,
    /// End at the first case that cannot be solved
    #[arg(long)]
    fail_fast: bool,
    /// What to write; by default results.csv for up to 10^5 cases, and always the store
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// Pixels an inch of the PNG files, and of images in SVG and PDF files, 72 to 1200
    #[arg(long, value_name = "N", default_value_t = style::DPI, value_parser = clap::value_parser!(u32).range(72..=1200))]
    dpi: u32,
    #[command(flatten)]
    jobs: Jobs,
}

#[derive(Args)]
struct Report {
    #[command(flatten)]
    studies: Studies,
    /// Folder for report.html, with the stores of the studies
    #[arg(long, value_name = "DIR", default_value = "figures")]
    out: PathBuf,
    #[command(flatten)]
    jobs: Jobs,
}

#[derive(Args)]
struct Check {
    #[command(flatten)]
    studies: Studies,
    #[command(flatten)]
    jobs: Jobs,
}

#[derive(Args)]
struct Init {
    /// Name of the study, without ending
    #[arg(value_parser = commands::init::name)]
    name: String,
    /// Problem whose cases it runs
    #[arg(long, value_parser = commands::init::problem)]
    problem: &'static dyn Problem,
}

#[derive(Args)]
struct Explain {
    /// Study file; `-` is standard input
    study: PathBuf,
    /// Number of the case, from 0
    #[arg(default_value_t = 0)]
    case: u64,
    #[command(flatten)]
    settings: Settings,
}

#[derive(Args)]
struct Compare {
    /// Results of a study, or a folder of several
    first: PathBuf,
    /// What they are compared with
    second: PathBuf,
    /// Largest difference that is none, relative to the larger of two values
    #[arg(long, value_name = "RELATIVE", default_value_t = 0.0, value_parser = tolerance)]
    tolerance: f64,
}

fn tolerance(text: &str) -> Result<f64, String> {
    let number = text
        .parse::<f64>()
        .ok()
        .filter(|x| *x >= 0.0 && x.is_finite());
    number.ok_or_else(|| "must be a number >= 0".into())
}

#[derive(Args)]
struct Schema {
    /// The page about study files in its place, docs/study-files.md
    #[arg(long)]
    markdown: bool,
}

#[derive(Args)]
struct Claims {
    /// Ledgers of claims, or folders of them
    #[arg(value_name = "LEDGER|FOLDER", default_value = "claims")]
    ledgers: Vec<PathBuf>,
    /// Folder for claims.md, beside the studies' results
    #[arg(long, value_name = "DIR", default_value = "figures")]
    out: PathBuf,
    #[command(flatten)]
    jobs: Jobs,
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    // A fault of this program ends like any other error: one message, exit code 1.
    let done = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| carry_out(cli)))
        .unwrap_or_else(|_| Err(Error::Internal("this is a fault of slipgap itself".into())));
    ExitCode::from(done.unwrap_or_else(|error| {
        commands::tell(&error);
        error.exit_code()
    }))
}

fn carry_out(cli: Cli) -> Result<u8, Error> {
    commands::end_on_interrupt()?;
    match cli.verb {
        Verb::Run(run) => {
            let studies = run.studies.read()?;
            let manner = Manner {
                histories: run.histories,
                fail_fast: run.fail_fast,
                format: run.format,
                dpi: run.dpi,
            };
            commands::pool(run.jobs.jobs)?
                .install(|| commands::run::run(&studies, &run.out, &manner))
        }
        Verb::Check(check) => {
            let studies = check.studies.read()?;
            commands::pool(check.jobs.jobs)?.install(|| commands::check::check(&studies))
        }
        Verb::Report(report) => {
            let studies = report.studies.read()?;
            commands::pool(report.jobs.jobs)?
                .install(|| commands::report::report(&studies, &report.out))
        }
        Verb::List(list) => commands::list::list(&list.read()?),
        Verb::Init(init) => commands::init::init(&init.name, init.problem),
        Verb::Explain(of) => {
            if of.study.is_dir() {
                let what = format!("{} is a folder; name one study", of.study.display());
                return Err(Error::Usage(what));
            }
            let sources = commands::sources::read(&[of.study], &of.settings.set, u64::MAX)?;
            let source = sources.first();
            source.map_or(Ok(0), |source| commands::explain::explain(source, of.case))
        }
        Verb::Compare(with) => {
            commands::compare::compare(&with.first, &with.second, with.tolerance)
        }
        Verb::Claims(claims) => commands::pool(claims.jobs.jobs)?
            .install(|| commands::claims::claims(&claims.ledgers, &claims.out)),
        Verb::Recommend(asked) => {
            let meant = asked.meant()?;
            commands::pool(meant.common.jobs.jobs)?
                .install(|| commands::recommend::recommend(&meant))
        }
        Verb::Schema(schema) => commands::say(&match schema.markdown {
            true => slipgap::study::reference(),
            false => slipgap::study::schema(),
        }),
    }
}
