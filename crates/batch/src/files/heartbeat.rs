//! The sign that a process computes parts: a small file in the store that it writes again every few seconds, so that other
//! machines see it, too. No result depends on it. It is removed at the end, and a killed process leaves it.

use super::atomic::{remove_when_interrupted, writing};
use super::place::is_object;
use crate::chunks::shard::Shard;
use serde_json::{Value, json};
use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, SystemTime};

/// Time before the first sign, so that short runs write none.
const FIRST: Duration = Duration::from_millis(500);

/// Time between two signs, after some that come sooner.
const EVERY: Duration = Duration::from_secs(5);

/// Age after which a process surely does not run: several signs, the delay of a network, and clocks that differ.
pub const DEAD: Duration = Duration::from_secs(30);

/// Beginning of the names. pandas and pyarrow skip files whose names begin with a point.
const NAME: &str = ".running";

/// Length of a file, always the same: a sign is written over the one before it.
const LENGTH: usize = 120;

/// What a process has computed so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Computed {
    /// The time that it took.
    pub seconds: f64,
    /// Number of cases.
    pub cases: u64,
    /// Their steps times modes.
    pub work: f64,
}

/// A sign of a process that computes or was killed.
#[derive(Debug)]
pub struct Sign {
    /// The shard that it computes; `None` for a whole run.
    pub shard: Option<Shard>,
    /// When it was last written.
    pub written: SystemTime,
    /// What was computed until then; `None` if the file is half written.
    pub computed: Option<Computed>,
}

/// Gives signs until it is dropped.
#[derive(Debug)]
pub struct Heartbeat {
    thread: Option<(Sender<()>, JoinHandle<()>)>,
}

impl Heartbeat {
    /// Gives signs in a store, for a shard or a whole run, from a thread of its own.
    pub fn start(
        store: &Path,
        shard: Option<Shard>,
        computed: impl Fn() -> Computed + Send + 'static,
    ) -> Heartbeat {
        // An object would be a request each time.
        if is_object(store) {
            return Heartbeat { thread: None };
        }
        let path = store.join(name(shard));
        let (sender, receiver) = channel();
        let beat = move || {
            let ends = |wait| receiver.recv_timeout(wait) != Err(RecvTimeoutError::Timeout);
            if ends(FIRST) || create(&path, &computed()).is_err() {
                return;
            }
            // A sign that cannot be written is no reason to stop a run, which itself reports a full disk.
            let mut wait = 2 * FIRST;
            while !ends(wait) && write(&path, &computed()).is_ok() {
                wait = (2 * wait).min(EVERY);
            }
            let _ = fs::remove_file(&path);
            remove_when_interrupted(&path, false);
        };
        let thread = Builder::new().name("heartbeat".into()).spawn(beat);
        Heartbeat {
            thread: thread.ok().map(|thread| (sender, thread)),
        }
    }
}

impl Drop for Heartbeat {
    fn drop(&mut self) {
        if let Some((sender, thread)) = self.thread.take() {
            drop(sender);
            let _ = thread.join();
        }
    }
}

/// The signs in a store. Other processes may write and remove them meanwhile.
pub fn signs(store: &Path) -> Vec<Sign> {
    let entries = fs::read_dir(store).into_iter().flatten().flatten();
    entries.filter_map(|entry| sign(&entry.path())).collect()
}

/// Removes all signs from a store, after all its parts are there.
pub fn remove_signs(store: &Path) {
    for entry in fs::read_dir(store).into_iter().flatten().flatten() {
        if parse_name(&entry.path()).is_some() {
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn sign(path: &Path) -> Option<Sign> {
    let shard = parse_name(path)?;
    fs::symlink_metadata(path)
        .ok()
        .filter(fs::Metadata::is_file)?;
    // A client of NFS asks the server when it opens a file, not when it lists one. A file of any length may have the name.
    let mut text = Vec::new();
    let file = File::open(path).ok()?;
    file.take(LENGTH as u64 + 1).read_to_end(&mut text).ok()?;
    let written = fs::metadata(path).and_then(|file| file.modified());
    Some(Sign {
        shard,
        written: written.ok()?,
        computed: parse(&text),
    })
}

fn name(shard: Option<Shard>) -> String {
    match shard {
        None => NAME.into(),
        Some(shard) => format!("{NAME}-{}", shard.to_string().replace('/', "-of-")),
    }
}

/// The shard in a name, `Some(None)` for a whole run; `None` for another name.
fn parse_name(path: &Path) -> Option<Option<Shard>> {
    let rest = path.file_name()?.to_str()?.strip_prefix(NAME)?;
    if rest.is_empty() {
        return Some(None);
    }
    let shard = rest.strip_prefix('-')?.replace("-of-", "/");
    Some(Some(shard.parse().ok()?))
}

/// Replaces the sign of an earlier process.
fn create(path: &PathBuf, computed: &Computed) -> io::Result<()> {
    let _writing = writing(path);
    let _ = fs::remove_file(path);
    let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
    remove_when_interrupted(path, true);
    file.write_all(&line(computed))
}

/// Writes a sign over the last one, if it is there. The file is closed each time, upon which a client of NFS sends it.
fn write(path: &Path, computed: &Computed) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).open(path)?;
    file.write_all(&line(computed))
}

fn line(computed: &Computed) -> Vec<u8> {
    let Computed {
        seconds,
        cases,
        work,
    } = computed;
    let text = json!({ "seconds": seconds, "cases": cases, "work": work }).to_string();
    format!("{text:<width$}\n", width = LENGTH - 1).into_bytes()
}

fn parse(text: &[u8]) -> Option<Computed> {
    let values: Value = serde_json::from_slice(text).ok()?;
    Some(Computed {
        seconds: values["seconds"].as_f64()?,
        cases: values["cases"].as_u64()?,
        work: values["work"].as_f64()?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::thread::sleep;

    const COMPUTED: Computed = Computed {
        seconds: 12.5,
        cases: 3,
        work: 1e300 / 3.0,
    };

    #[test]
    fn a_sign_is_there_while_the_heartbeat_is_and_no_longer() {
        let folder = tempfile::tempdir().unwrap();
        let shard: Shard = "3/16".parse().unwrap();
        let path = folder.path().join(".running-3-of-16");
        // Of a killed process.
        fs::write(&path, "{").unwrap();
        let [old] = &signs(folder.path())[..] else {
            panic!("one sign");
        };
        assert_eq!((old.shard, old.computed), (Some(shard), None));
        let heart = Heartbeat::start(folder.path(), Some(shard), || COMPUTED);
        sleep(FIRST * 2);
        let [new] = &signs(folder.path())[..] else {
            panic!("one sign");
        };
        assert_eq!((new.shard, new.computed), (Some(shard), Some(COMPUTED)));
        assert!(new.written.elapsed().unwrap() < DEAD);
        drop(heart);
        assert!(!path.exists());
        // A short run writes nothing.
        drop(Heartbeat::start(folder.path(), None, || COMPUTED));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
        // A run does not need it.
        drop(Heartbeat::start(&path, None, || COMPUTED));
    }

    #[test]
    fn a_sign_is_written_over_the_last_one_unless_it_was_removed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name(None));
        let short = Computed {
            work: 0.0,
            ..COMPUTED
        };
        create(&path, &COMPUTED).unwrap();
        write(&path, &short).unwrap();
        assert_eq!(fs::metadata(&path).unwrap().len(), LENGTH as u64);
        assert_eq!(signs(folder.path())[0].computed, Some(short));
        // The longest numbers.
        let longest = Computed {
            seconds: f64::MIN_POSITIVE,
            cases: u64::MAX,
            work: f64::MAX,
        };
        assert_eq!(line(&longest).len(), LENGTH);
        remove_signs(folder.path());
        assert!(write(&path, &short).is_err() && !path.exists());
    }

    #[test]
    fn other_names_are_no_signs() {
        let shard = |name: &str| parse_name(Path::new(name)).map(|s| s.map(|s| s.to_string()));
        assert_eq!(shard(".running"), Some(None));
        assert_eq!(shard("a/.running-7-of-16"), Some(Some("7/16".into())));
        for other in [".runnin", ".running-", ".running-0-of-3", ".running7-of-16"] {
            assert_eq!(shard(other), None);
        }
    }
}
