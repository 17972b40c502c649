//! Spectra of files that were computed before, by the hash of their content: a folder of thousands of records is computed once.

use sha2::{Digest, Sha256};
use slipgap_system::CODE_KEY;
use std::fs;
use std::path::PathBuf;

/// A folder of spectra; none without a place for it.
pub(super) struct Cache(Option<PathBuf>);

/// Length of the hash at the end of a file.
const HASH: usize = 32;

impl Cache {
    /// The folder of the user: `slipgap/spectra` in XDG_CACHE_HOME, LOCALAPPDATA, or .cache of the home folder.
    pub fn of_user() -> Cache {
        let folder = |name: &str| {
            let found = std::env::var_os(name).map(PathBuf::from);
            found.filter(|path| path.is_absolute())
        };
        let given = folder("XDG_CACHE_HOME").or_else(|| folder("LOCALAPPDATA"));
        let base = given.or_else(|| folder("HOME").map(|home| home.join(".cache")));
        Cache(base.map(|base| base.join("slipgap").join("spectra")))
    }

    /// A folder.
    #[cfg(test)]
    pub fn at(folder: &std::path::Path) -> Cache {
        Cache(Some(folder.to_owned()))
    }

    /// What identifies the spectrum of a content at these numbers: both, and the code that computes it.
    pub fn key(content: &[u8], numbers: impl Iterator<Item = f64>) -> String {
        let mut digest = Sha256::new();
        digest.update(CODE_KEY);
        for number in numbers {
            digest.update(number.to_le_bytes());
        }
        digest.update(content);
        let hash = digest.finalize();
        hash.iter().map(|byte| format!("{byte:02x}")).collect()
    }

    /// The numbers of a key, if they are known and complete.
    pub fn read(&self, key: &str, count: usize) -> Option<Vec<f64>> {
        let path = self.0.as_ref()?.join(key);
        // A pipe would wait for a writer, and a device may have no end.
        let length = (8 * count + HASH) as u64;
        fs::metadata(&path)
            .ok()
            .filter(|found| found.is_file() && found.len() == length)?;
        let bytes = fs::read(path).ok()?;
        let (numbers, hash) = bytes.split_at_checked(8 * count)?;
        if Sha256::digest(numbers)[..] != *hash {
            return None;
        }
        let chunks = numbers.chunks_exact(8);
        let numbers = chunks.map(|bytes| bytes.try_into().map(f64::from_le_bytes).ok());
        numbers.collect()
    }

    /// Keeps the numbers of a key. A folder that cannot be written is no fault: they are computed again.
    pub fn write(&self, key: &str, numbers: &[f64]) {
        let Some(folder) = &self.0 else {
            return;
        };
        let mut bytes = Vec::with_capacity(8 * numbers.len() + HASH);
        numbers.iter().for_each(|x| bytes.extend(x.to_le_bytes()));
        let hash = Sha256::digest(&bytes);
        bytes.extend(hash);
        // Complete under its name: processes that write it at the same time write the same bytes.
        let partial = folder.join(format!("{key}.{}", std::process::id()));
        let written = fs::create_dir_all(folder)
            .and_then(|()| fs::write(&partial, bytes))
            .and_then(|()| fs::rename(&partial, folder.join(key)));
        if written.is_err() {
            let _ = fs::remove_file(partial);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_complete_numbers_are_read() {
        let folder = std::env::temp_dir().join(format!("slipgap-cache-{}", std::process::id()));
        let cache = Cache::at(&folder);
        let key = Cache::key(b"content", [0.5, 0.05].into_iter());
        assert_ne!(key, Cache::key(b"content", [0.5, 0.02].into_iter()));
        assert_ne!(key, Cache::key(b"contents", [0.5, 0.05].into_iter()));
        assert_eq!(cache.read(&key, 2), None);
        let numbers = [1.0 / 3.0, -7.5];
        cache.write(&key, &numbers);
        assert_eq!(cache.read(&key, 2), Some(numbers.to_vec()));
        assert_eq!(cache.read(&key, 1), None);
        // Another process has left no partial file, and a spoiled one is not believed.
        let files = fs::read_dir(&folder).unwrap().count();
        assert_eq!(files, 1);
        let mut bytes = fs::read(folder.join(&key)).unwrap();
        bytes[3] ^= 1;
        fs::write(folder.join(&key), bytes).unwrap();
        assert_eq!(cache.read(&key, 2), None);
        fs::remove_file(folder.join(&key)).unwrap();
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink("/dev/zero", folder.join(&key)).unwrap();
            assert_eq!(cache.read(&key, 2), None);
        }
        fs::remove_dir_all(folder).unwrap();
        assert_eq!(Cache(None).read(&key, 2), None);
    }
}
