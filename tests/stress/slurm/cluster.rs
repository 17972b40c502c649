//! A cluster of four virtual nodes on this machine, with all files in one folder. It needs neither root nor systemd.

use std::fs::{self, File};
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

const CONFIGURATION: &str = include_str!("slurm.conf.in");

const NODES: [&str; 4] = ["n1", "n2", "n3", "n4"];

/// Programs that the test needs.
const PROGRAMS: [&str; 11] = [
    "munged",
    "slurmctld",
    "slurmd",
    "sbatch",
    "squeue",
    "scontrol",
    "scancel",
    "sinfo",
    "bash",
    "hostname",
    "id",
];

/// Longest time for anything that takes seconds.
const LIMIT: Duration = Duration::from_secs(120);

/// The path of a program. Daemons are in folders that may not be on the path of a user.
fn program(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders = std::env::split_paths(&path).chain(["/usr/sbin".into(), "/sbin".into()]);
    let mut paths = folders.map(|folder| folder.join(name));
    paths.find(|path| path.is_file())
}

/// Waits until `done` gives a value. After the limit the test fails with what `show` gives.
#[track_caller]
pub(crate) fn wait<T>(mut done: impl FnMut() -> Option<T>, show: impl Fn() -> String) -> T {
    let start = Instant::now();
    loop {
        if let Some(value) = done() {
            return value;
        }
        assert!(start.elapsed() < LIMIT, "takes too long:\n{}", show());
        sleep(Duration::from_millis(100));
    }
}

/// The running daemons. They end when this is dropped.
pub(crate) struct Cluster {
    folder: PathBuf,
    daemons: Vec<Child>,
}

impl Cluster {
    /// Starts the daemons in a new folder; `None` with a reason if this machine cannot have them.
    pub(crate) fn start(folder: &Path) -> Result<Cluster, String> {
        if let Some(missing) = PROGRAMS.iter().find(|name| program(name).is_none()) {
            return Err(format!("{missing} is not installed"));
        }
        fs::create_dir_all(folder.join("munge")).unwrap();
        fs::create_dir_all(folder.join("state")).unwrap();
        configure(folder);
        let mut cluster = Cluster {
            folder: folder.to_owned(),
            daemons: Vec::new(),
        };
        cluster.start_munge()?;
        let configuration = folder.join("slurm.conf").display().to_string();
        cluster.daemon("slurmctld", &["-D", "-f", &configuration]);
        for node in NODES {
            fs::create_dir_all(folder.join(format!("spool-{node}"))).unwrap();
            cluster.daemon("slurmd", &["-D", "-f", &configuration, "-N", node]);
        }
        let begun = Instant::now();
        loop {
            let idle = cluster.out(
                "sinfo",
                &["--noheader", "-p", "main", "-t", "idle", "-o", "%D"],
            );
            if idle.trim() == "4" {
                return Ok(cluster);
            }
            if begun.elapsed() > Duration::from_secs(30) {
                return Err(format!("the nodes do not come up:\n{}", cluster.logs()));
            }
            sleep(Duration::from_millis(100));
        }
    }

    /// Starts the daemon that signs the messages of the others.
    fn start_munge(&mut self) -> Result<(), String> {
        let file = |name: &str| self.folder.join("munge").join(name).display().to_string();
        // Only this cluster accepts it, and it ends with the test.
        fs::write(file("key"), file("key").repeat(64)).unwrap();
        protect(Path::new(&file("key")));
        let options = [
            format!("--key-file={}", file("key")),
            format!("--socket={}", file("socket")),
            format!("--pid-file={}", file("pid")),
            format!("--log-file={}", file("log")),
            format!("--seed-file={}", file("seed")),
        ];
        let socket = PathBuf::from(file("socket"));
        let mut words: Vec<&str> = options.iter().map(String::as_str).collect();
        // Folders of temporary files may be writable for all.
        words.extend(["--force", "--foreground"]);
        self.daemon("munged", &words);
        let begun = Instant::now();
        while !socket.exists() {
            if begun.elapsed() > Duration::from_secs(20) {
                return Err(format!("munged does not start:\n{}", self.logs()));
            }
            sleep(Duration::from_millis(50));
        }
        Ok(())
    }

    fn daemon(&mut self, name: &str, words: &[&str]) {
        let log = |end: &str| {
            let name = format!("{name}-{}.{end}", self.daemons.len());
            File::create(self.folder.join(name)).unwrap()
        };
        let (out, err) = (log("out"), log("err"));
        let mut command = self.command(name);
        command
            .args(words)
            .stdin(Stdio::null())
            .stdout(out)
            .stderr(err);
        self.daemons.push(command.spawn().unwrap());
    }

    /// A command of the cluster, in its folder.
    pub(crate) fn command(&self, name: &str) -> Command {
        let mut command = Command::new(program(name).unwrap());
        command
            .current_dir(&self.folder)
            .env("SLURM_CONF", self.folder.join("slurm.conf"));
        command
    }

    /// The output of a command.
    pub(crate) fn out(&self, name: &str, words: &[&str]) -> String {
        let done = self.command(name).args(words).output().unwrap();
        String::from_utf8_lossy(&done.stdout).into_owned()
    }

    /// Runs a command, which must succeed.
    #[track_caller]
    pub(crate) fn run(&self, name: &str, words: &[&str]) -> String {
        let done = self.command(name).args(words).output().unwrap();
        assert!(done.status.success(), "{name} {words:?}: {done:?}");
        String::from_utf8_lossy(&done.stdout).into_owned()
    }

    /// What the cluster says about a job or a task.
    pub(crate) fn show(&self, job: &str) -> String {
        self.out("scontrol", &["show", "job", job])
    }

    /// The jobs and the last lines of the daemons, for a failed test.
    pub(crate) fn logs(&self) -> String {
        let mut text = self.out("squeue", &[]);
        for entry in fs::read_dir(&self.folder).into_iter().flatten().flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            if [".log", ".err", ".out"]
                .iter()
                .any(|end| name.ends_with(end))
            {
                let log = fs::read_to_string(entry.path()).unwrap_or_default();
                let lines: Vec<&str> = log.lines().collect();
                text += &format!("--- {name}\n");
                text += &lines[lines.len().saturating_sub(15)..].join("\n");
                text += "\n";
            }
        }
        text
    }
}

impl Drop for Cluster {
    fn drop(&mut self) {
        // The tasks are processes of their own.
        let jobs = self.out("squeue", &["--noheader", "-o", "%A"]);
        for job in jobs.lines() {
            self.out("scancel", &["--signal=KILL", "--full", job.trim()]);
            self.out("scancel", &[job.trim()]);
        }
        if !jobs.is_empty() {
            sleep(Duration::from_secs(1));
        }
        for daemon in self.daemons.iter_mut().rev() {
            let _ = daemon.kill();
            let _ = daemon.wait();
        }
    }
}

/// Writes the configuration, with free ports.
fn configure(folder: &Path) {
    let output = |name: &str, word: &str| {
        let output = Command::new(program(name).unwrap())
            .arg(word)
            .output()
            .unwrap();
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    };
    let (host, user) = (output("hostname", "-s"), output("id", "-un"));
    let listeners: Vec<TcpListener> = (0..=NODES.len())
        .map(|_| TcpListener::bind("0.0.0.0:0").unwrap())
        .collect();
    let ports: Vec<u16> = listeners
        .iter()
        .map(|l| l.local_addr().unwrap().port())
        .collect();
    let node = |(name, port): (&&str, &u16)| {
        format!(
            "NodeName={name} NodeHostname={host} Port={port} CPUs=1 RealMemory=100 State=UNKNOWN"
        )
    };
    let nodes: Vec<String> = NODES.iter().zip(&ports[1..]).map(node).collect();
    let text = CONFIGURATION
        .replace("@BASE@", &folder.display().to_string())
        .replace("@HOST@", &host)
        .replace("@USER@", &user)
        .replace("@PORT@", &ports[0].to_string())
        .replace("@NODES@", &nodes.join("\n"));
    fs::write(folder.join("slurm.conf"), text).unwrap();
}

/// Makes a file readable for its owner only.
fn protect(file: &Path) {
    use std::os::unix::fs::PermissionsExt;
    fs::set_permissions(file, fs::Permissions::from_mode(0o600)).unwrap();
}
