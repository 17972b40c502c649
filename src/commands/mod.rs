//! The verbs of the command line, one file or folder each.

pub mod check;
pub mod claims;
pub mod compare;
pub mod explain;
pub mod init;
pub mod list;
pub mod merge;
pub mod recommend;
pub mod report;
pub mod run;
pub mod sbatch;
pub mod shard;
pub mod sources;
pub mod terminal;

use clap::Args;
use slipgap::batch::output::atomic::stop_writing;
use slipgap::error::Error;
use terminal::note;

/// Exit code if a case could not be solved.
pub const UNSOLVED: u8 = 3;
/// Exit code if a check is not met.
pub const NOT_MET: u8 = 5;
/// Exit code after Ctrl-C.
const INTERRUPTED: i32 = 130;

/// Reads a whole number from `least` to `most`, or the reason why a text is none.
pub fn whole<T: TryFrom<u64>>(
    least: u64,
    most: u64,
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync + 'static {
    move |text| {
        let number = text.parse::<u64>().ok();
        let number = number.filter(|n| (least..=most).contains(n));
        number
            .and_then(|n| T::try_from(n).ok())
            .ok_or_else(|| match most {
                u64::MAX => format!("must be a whole number >= {least}"),
                _ => format!("must be a whole number from {least} to {most}"),
            })
    }
}

/// The number of threads of a verb.
#[derive(Args)]
pub struct Jobs {
    /// Number of threads, at most 1024; if left out, one for each core
    #[arg(long, value_name = "N", value_parser = whole::<u16>(1, 1024))]
    pub jobs: Option<u16>,
}

impl Jobs {
    /// The threads of a run.
    pub fn thread_pool(&self) -> Result<rayon::ThreadPool, Error> {
        rayon::ThreadPoolBuilder::new()
            .num_threads(self.jobs.map_or(0, usize::from))
            .build()
            .map_err(|e| Error::Internal(format!("cannot start threads: {e}")))
    }
}

/// Makes Ctrl-C end the program at once, without incomplete files.
pub fn exit_on_interrupt() -> Result<(), Error> {
    ctrlc::set_handler(|| {
        let _guard = stop_writing();
        note("slipgap: interrupted; all files are complete and finished parts are kept; run the same command again to continue");
        std::process::exit(INTERRUPTED);
    })
    .map_err(|e| Error::Internal(format!("cannot listen for Ctrl-C: {e}")))
}
