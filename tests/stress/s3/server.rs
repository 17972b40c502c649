//! An S3 server on this machine, and a client that is not slipgap's.

use crate::{Bench, Done};
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::sync::LazyLock;

/// What stands before the name of a script of this test.
const SCRIPTS: &str = concat!(env!("SLIPGAP_ROOT"), "/tests/stress/s3");

/// Which port of the server a command uses.
#[derive(Clone, Copy)]
pub(crate) enum Port {
    Good = 0,
    /// Requests fail often, for a moment.
    Failing = 1,
    /// Each answer is a page of HTML.
    Page = 2,
    /// Parts are received and not kept.
    Forgetful = 3,
    /// Parts are listed and not given.
    Ungiving = 4,
    /// Parts are listed, and a page of HTML is given for them.
    Paging = 5,
    /// A list has no end.
    Repeating = 6,
    /// Who removes a part loses those that were received: another run removes them.
    Robbing = 7,
    /// Nobody answers.
    Silent = 8,
}

/// The server of all tests. It ends with its standard input, which is with this process.
pub(crate) static SERVER: LazyLock<Server> = LazyLock::new(Server::start);

pub(crate) struct Server {
    _process: Child,
    ports: Vec<String>,
}

/// Python with moto, as `make s3-test` installs it.
fn python() -> Command {
    Command::new(std::env::var("SLIPGAP_PYTHON").expect("make s3-test sets it"))
}

impl Server {
    fn start() -> Server {
        let mut command = python();
        command.arg(format!("{SCRIPTS}/server.py"));
        let pipes = command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut process = pipes.spawn().unwrap();
        let mut line = String::new();
        let out = process.stdout.take().unwrap();
        BufReader::new(out).read_line(&mut line).unwrap();
        let ports: Vec<String> = line.split_whitespace().map(String::from).collect();
        assert_eq!(ports.len(), 9, "{line}");
        Server {
            _process: process,
            ports,
        }
    }

    /// The variables that a user sets.
    fn set(&self, command: &mut Command, port: Port) {
        let variables = std::env::vars_os().map(|(name, _)| name);
        for name in variables.filter(|name| name.to_string_lossy().starts_with("AWS_")) {
            command.env_remove(name);
        }
        let url = format!("http://127.0.0.1:{}", self.ports[port as usize]);
        command
            .env("AWS_ENDPOINT_URL", url)
            .env("AWS_ALLOW_HTTP", "true")
            .env("AWS_DEFAULT_REGION", "us-east-1")
            .env("AWS_ACCESS_KEY_ID", "test")
            .env("AWS_SECRET_ACCESS_KEY", "test");
    }

    /// slipgap, to be run in the folder.
    pub(crate) fn slipgap(&self, bench: &Bench, port: Port, args: &[&str]) -> Command {
        let mut command = bench.command();
        self.set(&mut command, port);
        command.args(args).env("TMPDIR", bench.path("temporary"));
        std::fs::create_dir_all(bench.path("temporary")).unwrap();
        command
    }

    /// Runs slipgap, which must end with this code and leave no temporary file.
    #[track_caller]
    pub(crate) fn run(&self, bench: &Bench, port: Port, code: i32, args: &[&str]) -> Done {
        let done: Done = self.slipgap(bench, port, args).output().unwrap().into();
        assert_eq!(done.code, Some(code), "{args:?}: {done:?}");
        assert_eq!(bench.tree("temporary").len(), 0, "{args:?}");
        // A path that some code did not know as an object.
        assert!(!bench.path("s3:").exists(), "{args:?}");
        done
    }

    /// The output of the client that is not slipgap's.
    #[track_caller]
    pub(crate) fn client(&self, bench: &Bench, args: &[&str]) -> String {
        let mut command = python();
        self.set(&mut command, Port::Good);
        command.arg(format!("{SCRIPTS}/bucket.py")).args(args);
        let output = command.current_dir(bench.path("")).output().unwrap();
        let done: Done = output.into();
        assert_eq!(done.code, Some(0), "{args:?}: {done:?}");
        done.out
    }
}
