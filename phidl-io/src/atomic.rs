//! The one place that writes files.
//!
//! A file is written under a temporary name in its own folder, brought to the disk, and renamed: whoever opens the name
//! finds the old file or the whole new one, and a full disk leaves no stump behind. Writing in place would be simpler,
//! and would lose the old mask at the first error.

use std::fs;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::error::{IoError, Result};

/// Bytes are handed to the system in portions of this size.
const PORTION: usize = 1 << 20;

/// A file that comes into being when [`AtomicFile::commit`] is called, and not before.
///
/// Dropped without that, it leaves nothing behind.
#[derive(Debug)]
pub struct AtomicFile {
    target: PathBuf,
    file: BufWriter<NamedTempFile>,
    bytes: u64,
}

impl AtomicFile {
    /// Begins to write a file. The folder must exist; a symbolic link is followed.
    ///
    /// # Errors
    /// [`IoError::File`] if nothing can be written in the folder.
    pub fn create(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        if target.is_dir() {
            let error = std::io::Error::from(std::io::ErrorKind::IsADirectory);
            return Err(IoError::file(path, "write it", error));
        }
        let file = temporary_in(folder_of(&target)).map_err(|e| IoError::file(path, "create it", e))?;
        Ok(Self { target, file: BufWriter::with_capacity(PORTION, file), bytes: 0 })
    }

    /// Appends some bytes.
    ///
    /// # Errors
    /// [`IoError::File`] if the disk is full or fails.
    pub fn put(&mut self, bytes: &[u8]) -> Result<()> {
        self.bytes += bytes.len() as u64;
        self.file.write_all(bytes).map_err(|e| IoError::file(&self.target, "write it", e))
    }

    /// Brings everything to the disk and gives the file its name. Returns its length in bytes.
    ///
    /// # Errors
    /// [`IoError::File`] if the disk is full or fails, or the name cannot be taken. The old file is still there then.
    pub fn commit(self) -> Result<u64> {
        let Self { target, file, bytes } = self;
        let file = file.into_inner().map_err(|e| IoError::file(&target, "write it", e.into_error()))?;
        file.as_file().sync_all().map_err(|e| IoError::file(&target, "bring it to the disk", e))?;
        file.persist(&target).map_err(|e| IoError::file(&target, "give it its name", e.error))?;
        // The name itself is on the disk only when the folder is. Some file systems cannot do that; the data is safe.
        if let Ok(folder) = fs::File::open(folder_of(&target)) {
            let _ = folder.sync_all();
        }
        Ok(bytes)
    }
}

/// Writes a whole file at once; see [`AtomicFile`].
///
/// # Errors
/// [`IoError::File`].
pub fn write(path: impl AsRef<Path>, bytes: &[u8]) -> Result<u64> {
    let mut file = AtomicFile::create(path)?;
    file.put(bytes)?;
    file.commit()
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// A temporary file with the permissions of any new file, where the default is to hide it from others.
fn temporary_in(folder: &Path) -> std::io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".phidl-").suffix(".part");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names_in(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect()
    }

    #[test]
    fn the_old_file_stays_until_the_new_one_is_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.gds");
        write(&path, b"old").unwrap();
        let mut file = AtomicFile::create(&path).unwrap();
        file.put(b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"old");
        drop(file);
        assert_eq!(names_in(folder.path()), ["a.gds"]);
        let mut file = AtomicFile::create(&path).unwrap();
        file.put(b"newer").unwrap();
        assert_eq!(file.commit().unwrap(), 5);
        assert_eq!(fs::read(&path).unwrap(), b"newer");
        assert_eq!(names_in(folder.path()), ["a.gds"]);
    }

    #[test]
    fn a_folder_that_is_missing_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("missing").join("a.gds");
        let error = write(&path, b"").unwrap_err();
        assert!(error.to_string().contains("missing"), "{error}");
        assert!(write(folder.path(), b"").is_err());
    }

    #[cfg(unix)]
    #[test]
    fn others_may_read_the_file_as_any_other_new_file() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (ours, plain) = (folder.path().join("ours"), folder.path().join("plain"));
        write(&ours, b"").unwrap();
        fs::write(&plain, b"").unwrap();
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode();
        assert_eq!(mode(&ours), mode(&plain));
    }

    #[cfg(unix)]
    #[test]
    fn a_symbolic_link_is_followed() {
        let folder = tempfile::tempdir().unwrap();
        let (real, link) = (folder.path().join("real"), folder.path().join("link"));
        write(&real, b"old").unwrap();
        std::os::unix::fs::symlink(&real, &link).unwrap();
        write(&link, b"new").unwrap();
        assert_eq!(fs::read(&real).unwrap(), b"new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    }
}
