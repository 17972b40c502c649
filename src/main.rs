//! The `slipgap` program: its arguments and its exit code.

mod commands;

use clap::{Args, Parser, Subcommand};
use commands::recommend::RecommendArgs;
use commands::run::Format;
use commands::sbatch::{SbatchArgs, TimeLimit};
use commands::sources::Source;
use commands::{Jobs, whole};
use slipgap::batch::Shard;
use slipgap::error::Error;
use slipgap::figures::style;
use slipgap::run::OutputOptions;
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

const EXIT_CODES: &str = "Exit codes: 0 success; 1 internal error or I/O error; 2 mistake on the command line or in a study; 3 a case could not be solved; \
4 parts of a merge are missing; 5 a check is not met, a verdict differs from the recorded one, results differ, or no case reaches the target; 130 interrupted.";

#[derive(Subcommand)]
enum Verb {
    /// Write a small study with remarks to studies/NAME.json, as a start
    Init(Init),
    /// Run studies; write results.csv and figures to one folder for each study
    Run(Run),
    /// Write the results of studies whose cases `run --shard` has computed; compute none
    Merge(Merge),
    /// Print a script that submits the shards of a study to Slurm as an array, and then the merge
    Sbatch(Sbatch),
    /// Run studies and test their checks; write no files
    Check(Check),
    /// Show studies with their axes, cases and steps; compute nothing
    List(Studies),
    /// Show one case of a study: parameters, steps, cost and estimated time
    Explain(Explain),
    /// Compare two folders of results and show the differences of each metric, the largest first
    Compare(Compare),
    /// Write one page about studies, with figures, checks, claims, and tables to sort and filter; the page needs no other file
    Report(Report),
    /// Test the statements of the papers and of the literature by studies, print the verdicts and write claims.md
    Claims(Claims),
    /// Find the cheapest parameters that reach a target; show the errors and the alternatives
    #[command(subcommand)]
    Recommend(RecommendArgs),
    /// Print the JSON schema of study files
    Schema(Schema),
}

#[derive(Args)]
struct Studies {
    /// Study files, or folders with all sub-folders; `-` reads standard input, and its results go to the folder stdin
    #[arg(value_name = "STUDY|FOLDER", default_value = commands::sources::STUDIES)]
    studies: Vec<PathBuf>,
    /// Largest number of raw combinations in a study
    #[arg(long, value_name = "CASES", default_value_t = slipgap::study::MOST_CASES, value_parser = whole::<u64>(0, u64::MAX))]
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
    /// Set a parameter for this command: in every block that gives it, or in all blocks if none does; VALUE is JSON, a
    /// name or an expression, as in dT=pi/10 or 'alpha=[0.1, 1]'; may be given several times
    #[arg(long, value_name = "NAME=VALUE", value_parser = Setting::new)]
    set: Vec<Setting>,
}

#[derive(Args)]
struct Run {
    #[command(flatten)]
    studies: Studies,
    /// Folder for the results; each study has its own folder in it
    #[arg(long, value_name = "DIR", default_value = "figures")]
    out: PathBuf,
    /// Also write the history of every case to histories/CASE.csv; all cases are computed again
    #[arg(long)]
    histories: bool,
    /// Stop at the first case that cannot be solved
    #[arg(long)]
    fail_fast: bool,
    /// Format of the results; by default the store, and results.csv for up to 10^5 cases
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// Pixels an inch of the PNG files, and of images in SVG and PDF files, 72 to 1200
    #[arg(long, value_name = "N", default_value_t = style::DPI, value_parser = whole::<u32>(72, 1200))]
    dpi: u32,
    /// Only compute the parts of shard I of N into the store in DIR: every N-th part, beginning with part I; `merge` writes the
    /// results
    #[arg(long, value_name = "I/N", conflicts_with_all = ["histories", "fail_fast", "format", "dpi"])]
    shard: Option<Shard>,
    #[command(flatten)]
    jobs: Jobs,
}

#[derive(Args)]
struct Merge {
    #[command(flatten)]
    studies: Studies,
    /// Folder of the results, in which the shards have their stores
    #[arg(long, value_name = "DIR", default_value = "figures")]
    out: PathBuf,
    /// Number of shards; if parts are missing, the message then names the shards to run again
    #[arg(long, value_name = "N", value_parser = whole::<u64>(1, u64::MAX))]
    shards: Option<u64>,
    /// Format of the results; by default the store, and results.csv for up to 10^5 cases
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// Pixels an inch of the PNG files, and of images in SVG and PDF files, 72 to 1200
    #[arg(long, value_name = "N", default_value_t = style::DPI, value_parser = whole::<u32>(72, 1200))]
    dpi: u32,
    #[command(flatten)]
    jobs: Jobs,
}

#[derive(Args)]
struct Sbatch {
    /// Study file, or a folder with all sub-folders
    #[arg(value_name = "STUDY|FOLDER")]
    study: PathBuf,
    /// Number of shards, each a task of the array
    #[arg(long, value_name = "N", value_parser = whole::<u32>(1, u64::from(u32::MAX)))]
    shards: u32,
    /// Folder for the results, which all nodes must see
    #[arg(long, value_name = "DIR", default_value = "figures")]
    out: PathBuf,
    /// Time limit of a task and of the merge; if left out, that of the partition
    #[arg(long, value_name = "HH:MM:SS")]
    time: Option<TimeLimit>,
    /// Partition of the cluster; if left out, its default
    #[arg(long, value_name = "NAME", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    partition: Option<String>,
    /// Let each task put itself into the queue again a minute before its time is over
    #[arg(long)]
    requeue: bool,
    /// Largest number of raw combinations in a study
    #[arg(long, value_name = "CASES", default_value_t = slipgap::study::MOST_CASES, value_parser = whole::<u64>(0, u64::MAX))]
    limit: u64,
    #[command(flatten)]
    settings: Settings,
}

#[derive(Args)]
struct Report {
    #[command(flatten)]
    studies: Studies,
    /// Folder for report.html and the results of the studies
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
    /// Name of the study, without .json
    #[arg(value_parser = commands::init::name)]
    name: String,
    /// Problem of the study
    #[arg(long, value_parser = commands::init::problem)]
    problem: &'static str,
}

#[derive(Args)]
struct Explain {
    /// Study file; `-` is standard input
    study: PathBuf,
    /// Number of the case, from 0
    #[arg(default_value_t = 0, value_parser = whole::<u64>(0, u64::MAX))]
    case: u64,
    #[command(flatten)]
    settings: Settings,
}

#[derive(Args)]
struct Compare {
    /// Results of a study, or a folder of several
    first: PathBuf,
    /// Results to compare with
    second: PathBuf,
    /// Largest difference to ignore, relative to the larger of the two values
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
    /// Print the page docs/study-files.md instead of the schema
    #[arg(long)]
    markdown: bool,
}

#[derive(Args)]
struct Claims {
    /// Ledgers of claims, or folders of them
    #[arg(value_name = "LEDGER|FOLDER", default_value = "claims")]
    ledgers: Vec<PathBuf>,
    /// Folder for claims.md; links in it lead to results of the studies in the same folder
    #[arg(long, value_name = "DIR", default_value = "figures")]
    out: PathBuf,
    #[command(flatten)]
    jobs: Jobs,
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    // A panic ends as any other error does: one message, exit code 1.
    let result = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| execute(cli)))
        .unwrap_or_else(|_| {
            Err(Error::Internal(
                "internal error of slipgap; please report it".into(),
            ))
        });
    ExitCode::from(result.unwrap_or_else(|error| {
        commands::terminal::report_error(&error);
        error.exit_code()
    }))
}

fn execute(cli: Cli) -> Result<u8, Error> {
    commands::exit_on_interrupt()?;
    match cli.verb {
        Verb::Run(run) => {
            let studies = run.studies.read()?;
            if let Some(shard) = run.shard {
                let pool = run.jobs.thread_pool()?;
                return pool.install(|| commands::shard::run(&studies, &run.out, shard));
            }
            let output = OutputOptions {
                histories: run.histories,
                fail_fast: run.fail_fast,
                table: run.format.map(Format::has_table),
                dpi: run.dpi,
            };
            let pool = run.jobs.thread_pool()?;
            pool.install(|| commands::run::run(&studies, &run.out, &output))
        }
        Verb::Merge(merge) => {
            let studies = merge.studies.read()?;
            let output = OutputOptions {
                table: merge.format.map(Format::has_table),
                dpi: merge.dpi,
                ..OutputOptions::default()
            };
            let pool = merge.jobs.thread_pool()?;
            pool.install(|| commands::merge::merge(&studies, &merge.out, merge.shards, &output))
        }
        Verb::Sbatch(args) => {
            let sbatch = SbatchArgs {
                study: args.study,
                out: args.out,
                limit: args.limit,
                shards: args.shards,
                time: args.time,
                partition: args.partition,
                requeue: args.requeue,
            };
            commands::sbatch::sbatch(&sbatch, &args.settings.set)
        }
        Verb::Check(check) => {
            let studies = check.studies.read()?;
            let pool = check.jobs.thread_pool()?;
            pool.install(|| commands::check::check(&studies))
        }
        Verb::Report(report) => {
            let studies = report.studies.read()?;
            let pool = report.jobs.thread_pool()?;
            pool.install(|| commands::report::report(&studies, &report.out))
        }
        Verb::List(list) => commands::list::list(&list.read()?),
        Verb::Init(init) => commands::init::init(&init.name, init.problem),
        Verb::Explain(args) => {
            if args.study.is_dir() {
                let what = format!("{} is a folder; name one study", args.study.display());
                return Err(Error::Usage(what));
            }
            let sources = commands::sources::read(&[args.study], &args.settings.set, u64::MAX)?;
            let source = sources.first();
            source.map_or(Ok(0), |source| {
                commands::explain::explain(source, args.case)
            })
        }
        Verb::Compare(args) => {
            commands::compare::compare(&args.first, &args.second, args.tolerance)
        }
        Verb::Claims(claims) => {
            let pool = claims.jobs.thread_pool()?;
            pool.install(|| commands::claims::claims(&claims.ledgers, &claims.out))
        }
        Verb::Recommend(args) => {
            let task = args.search_task()?;
            let pool = task.common.jobs.thread_pool()?;
            pool.install(|| commands::recommend::recommend(&task))
        }
        Verb::Schema(schema) => commands::terminal::print(&match schema.markdown {
            true => slipgap::study::reference(),
            false => slipgap::study::schema(),
        }),
    }
}
