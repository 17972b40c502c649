//! The file in which the program finds the commit that it is built from. The compiler reads this file for the program alone, so that
//! a new commit compiles `src/main.rs` anew and no library. Tests read the folder of the repository from here, too.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let root = root(PathBuf::from(env::var("CARGO_MANIFEST_DIR")?));
    println!(
        "cargo::rerun-if-changed={}",
        root.join("build.rs").display()
    );
    println!("cargo::rustc-env=SLIPGAP_ROOT={}", root.display());
    // A package has no repository of its own, but may be unpacked inside one.
    let package = root.join(".cargo_vcs_info.json");
    let log = if package.is_file() {
        println!("cargo::rerun-if-changed={}", package.display());
        written(&packaged(&fs::read_to_string(package)?))?
    } else {
        match log_of_head(&root) {
            Some(log) => log,
            None => written("")?,
        }
    };
    println!("cargo::rustc-env=SLIPGAP_LOG_OF_HEAD={}", log.display());
    Ok(())
}

/// The folder of this file. The package of the tests, in a folder of it, has the same build script.
fn root(package: PathBuf) -> PathBuf {
    match package.parent() {
        Some(above) if !package.join("build.rs").is_file() => above.to_owned(),
        _ => package,
    }
}

/// The log of git's HEAD, if the folder is the root of a repository: its last line has the commit before and the present one.
fn log_of_head(root: &Path) -> Option<PathBuf> {
    let git = root.join(".git");
    let (folder, seen) = if git.is_dir() {
        (git.clone(), git.join("config"))
    } else {
        // In a further work tree, a line names the folder.
        let text = fs::read_to_string(&git).ok()?;
        let folder = root.join(text.strip_prefix("gitdir:")?.trim());
        (folder, git)
    };
    let log = folder.join("logs").join("HEAD");
    // Without the repository, the log is sought again.
    println!("cargo::rerun-if-changed={}", seen.display());
    log.is_file().then_some(log)
}

/// A line as in the log of HEAD, with the commit that cargo has noted in a package.
fn packaged(noted: &str) -> String {
    let rest = noted.split("\"sha1\"").nth(1).unwrap_or_default();
    let commit = rest.split('"').nth(1).unwrap_or_default();
    format!("- {commit}")
}

/// A file of this text.
fn written(text: &str) -> Result<PathBuf, Box<dyn Error>> {
    let path = PathBuf::from(env::var("OUT_DIR")?).join("head");
    fs::write(&path, text)?;
    Ok(path)
}
