//! Files are written here, and only here.
//!
//! A file is written under a temporary name in its own folder, brought to the disk, and renamed: a reader of the name finds
//! the old file or the whole new one, and a full disk leaves nothing behind. Writing in place would be simpler, and would
//! lose the old mask at the first error. `tempfile` makes and renames the temporary file; what it does not know is here:
//!
//! - **Rights.** A file that is replaced keeps its mode, and its owner as far as the process may set it.
//! - **Links.** A symbolic link is followed, also to a file that does not exist yet. In a folder of results
//!   ([`write_in`]), a link that leads out of the folder is refused.
//! - **Special files.** Devices, pipes and sockets are refused, never replaced.
//! - **Leftovers.** A process that is killed leaves its temporary file. Each is locked while it is written, so the next
//!   process that writes into the folder knows which are left over, and removes them.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{LazyLock, Mutex, PoisonError};

use tempfile::NamedTempFile;

use crate::error::{IoError, Result};

/// Bytes are handed to the system in portions of this size.
const PORTION: usize = 1 << 20;

/// Names of temporary files begin and end like this.
const TEMPORARY: (&str, &str) = (".phidl-", ".part");

/// Links that lead to links are followed this often.
const MOST_LINKS: usize = 40;

/// A temporary file can be removed between its creation and its lock; it is made again this often.
const MOST_TRIES: usize = 10;

/// A file that exists under its name from [`AtomicFile::commit`] on, and not before.
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
    /// [`IoError::File`] if nothing can be written in the folder; [`IoError::NotRegular`] for devices, pipes and sockets.
    pub fn create(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        Self::replacing(Target::of(path)?, path)
    }

    /// Begins to write a file of a folder. A symbolic link is followed if it leads to a file in the folder.
    ///
    /// # Errors
    /// As for [`AtomicFile::create`]; [`IoError::OutsideFolder`] for a name or link that leads out of the folder.
    pub fn create_in(folder: impl AsRef<Path>, name: &str) -> Result<Self> {
        let folder = folder.as_ref();
        let path = folder.join(name);
        let outside = || IoError::OutsideFolder { path: shown(&path), folder: shown(folder) };
        if path.file_name().is_none_or(|last| last != name) {
            return Err(outside());
        }
        let target = Target::of(&path)?;
        let real = |folder: &Path| fs::canonicalize(folder).map_err(|error| IoError::file(&path, "create it", error));
        if !real(folder_of(&target.path))?.starts_with(real(folder)?) {
            return Err(outside());
        }
        Self::replacing(target, &path)
    }

    fn replacing(target: Target, path: &Path) -> Result<Self> {
        let failed = |error| IoError::file(path, "create it", error);
        let folder = folder_of(&target.path);
        let file = locked_temporary_in(folder).map_err(failed)?;
        remove_leftovers_once(folder);
        if let Some(old) = &target.old {
            keep_rights(file.as_file(), old).map_err(failed)?;
        }
        Ok(Self { target: target.path, file: BufWriter::with_capacity(PORTION, file), bytes: 0 })
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
        if let Ok(folder) = File::open(folder_of(&target)) {
            let _ = folder.sync_all();
        }
        Ok(bytes)
    }
}

/// Writes a whole file at once; see [`AtomicFile::create`].
///
/// # Errors
/// [`IoError::File`], [`IoError::NotRegular`].
pub fn write(path: impl AsRef<Path>, bytes: &[u8]) -> Result<u64> {
    let mut file = AtomicFile::create(path)?;
    file.put(bytes)?;
    file.commit()
}

/// Writes a whole file of a folder at once; see [`AtomicFile::create_in`].
///
/// # Errors
/// [`IoError::File`], [`IoError::NotRegular`], [`IoError::OutsideFolder`].
pub fn write_in(folder: impl AsRef<Path>, name: &str, bytes: &[u8]) -> Result<u64> {
    let mut file = AtomicFile::create_in(folder, name)?;
    file.put(bytes)?;
    file.commit()
}

/// Where a path leads, links followed.
struct Target {
    path: PathBuf,
    /// The file that is replaced.
    old: Option<fs::Metadata>,
}

impl Target {
    fn of(path: &Path) -> Result<Self> {
        let failed = |error| IoError::file(path, "write it", error);
        let mut target = path.to_owned();
        for _ in 0..MOST_LINKS {
            let metadata = match fs::symlink_metadata(&target) {
                Ok(metadata) => metadata,
                Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Self { path: target, old: None }),
                Err(error) => return Err(failed(error)),
            };
            if metadata.is_symlink() {
                // A relative link counts from the folder that it stands in.
                target = folder_of(&target).join(fs::read_link(&target).map_err(failed)?);
            } else if metadata.is_dir() {
                return Err(failed(ErrorKind::IsADirectory.into()));
            } else if metadata.is_file() {
                return Ok(Self { path: target, old: Some(metadata) });
            } else {
                return Err(IoError::NotRegular { path: shown(path) });
            }
        }
        Err(failed(std::io::Error::other("its links lead in a circle")))
    }
}

fn shown(path: &Path) -> Box<str> {
    path.display().to_string().into()
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// Gives a new file the mode and owner of the file that it replaces.
fn keep_rights(file: &File, old: &fs::Metadata) -> std::io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        // Only a privileged process may give files away; the mode matters more, and is set after it.
        let _ = std::os::unix::fs::fchown(file, Some(old.uid()), Some(old.gid()));
    }
    file.set_permissions(old.permissions())
}

/// A temporary file that this process has locked.
fn locked_temporary_in(folder: &Path) -> std::io::Result<NamedTempFile> {
    for _ in 0..MOST_TRIES {
        let file = temporary_in(folder)?;
        // Where files cannot be locked, leftovers are not found either.
        let locked = file.as_file().try_lock().is_ok();
        if !locked || file.path().exists() {
            return Ok(file);
        }
    }
    Err(std::io::Error::other("other processes remove the temporary file"))
}

/// A temporary file with the permissions of any new file, where the default is to hide it from others.
fn temporary_in(folder: &Path) -> std::io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(TEMPORARY.0).suffix(TEMPORARY.1);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    // The error without the name of the temporary file, which says nothing.
    builder.tempfile_in(folder).map_err(|error| std::io::Error::from(error.kind()))
}

/// Removes what killed processes left in a folder, at the first write into it. A batch of files lists its folder once.
fn remove_leftovers_once(folder: &Path) {
    static SEEN: LazyLock<Mutex<BTreeSet<PathBuf>>> = LazyLock::new(Mutex::default);
    let folder = fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned());
    if SEEN.lock().unwrap_or_else(PoisonError::into_inner).insert(folder.clone()) {
        remove_leftovers(&folder);
    }
}

/// Removes the temporary files of a folder that no process writes. Failing to do so is no reason not to write.
fn remove_leftovers(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name();
        let ours = name.to_str().is_some_and(|name| name.starts_with(TEMPORARY.0) && name.ends_with(TEMPORARY.1));
        if !ours || !entry.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        if File::open(entry.path()).is_ok_and(|file| file.try_lock().is_ok()) {
            let _ = fs::remove_file(entry.path());
        }
    }
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

    #[test]
    fn what_a_killed_process_left_is_removed_and_what_is_being_written_is_not() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(".phidl-left.part"), b"half").unwrap();
        fs::write(folder.path().join(".phidl-other"), b"").unwrap();
        let first = AtomicFile::create(folder.path().join("a")).unwrap();
        remove_leftovers(folder.path());
        let second = AtomicFile::create(folder.path().join("b")).unwrap();
        first.commit().unwrap();
        second.commit().unwrap();
        let mut names = names_in(folder.path());
        names.sort_unstable();
        assert_eq!(names, [".phidl-other", "a", "b"]);
    }

    #[cfg(unix)]
    mod unix {
        use std::os::unix::fs::{PermissionsExt, symlink};
        use std::os::unix::net::UnixListener;

        use super::*;

        fn mode(path: &Path) -> u32 {
            fs::metadata(path).unwrap().permissions().mode() & 0o777
        }

        #[test]
        fn a_new_file_has_the_rights_of_any_new_file_and_an_old_one_keeps_its_rights() {
            let folder = tempfile::tempdir().unwrap();
            let (ours, ordinary) = (folder.path().join("ours"), folder.path().join("ordinary"));
            write(&ours, b"").unwrap();
            fs::write(&ordinary, b"").unwrap();
            assert_eq!(mode(&ours), mode(&ordinary));
            for rights in [0o600, 0o664, 0o444] {
                fs::set_permissions(&ours, fs::Permissions::from_mode(rights)).unwrap();
                write(&ours, b"new").unwrap();
                assert_eq!((mode(&ours), fs::read(&ours).unwrap()), (rights, b"new".to_vec()));
            }
        }

        #[test]
        fn a_symbolic_link_is_followed_also_to_a_file_that_is_not_there() {
            let folder = tempfile::tempdir().unwrap();
            let [real, link, relative] = ["real", "link", "relative"].map(|name| folder.path().join(name));
            symlink(&real, &link).unwrap();
            symlink("link", &relative).unwrap();
            for bytes in [b"first", b"later"] {
                write(&relative, bytes).unwrap();
                assert_eq!(fs::read(&real).unwrap(), bytes);
            }
            assert!([&link, &relative].iter().all(|link| fs::symlink_metadata(link).unwrap().is_symlink()));
            let circle = folder.path().join("circle");
            symlink("circle", &circle).unwrap();
            assert!(write(&circle, b"").is_err());
        }

        #[test]
        fn in_a_folder_of_results_links_and_names_that_lead_out_are_refused() {
            let folder = tempfile::tempdir().unwrap();
            let results = folder.path().join("results");
            fs::create_dir(&results).unwrap();
            fs::write(folder.path().join("victim"), b"old").unwrap();
            for (name, target) in [("out", "../victim"), ("new", "../new"), ("inside", "there")] {
                symlink(target, results.join(name)).unwrap();
            }
            for name in ["out", "new", "../victim", "", ".", "..", "a/b"] {
                let error = write_in(&results, name, b"new").unwrap_err();
                assert!(matches!(error, IoError::OutsideFolder { .. }), "{name}: {error}");
            }
            write_in(&results, "inside", b"new").unwrap();
            assert_eq!(fs::read(results.join("there")).unwrap(), b"new");
            assert_eq!(fs::read(folder.path().join("victim")).unwrap(), b"old");
            assert!(!folder.path().join("new").exists());
        }

        #[test]
        fn special_files_are_refused() {
            let folder = tempfile::tempdir().unwrap();
            let socket = folder.path().join("socket");
            let _listener = UnixListener::bind(&socket).unwrap();
            for path in [socket.as_path(), Path::new("/dev/null")] {
                let error = write(path, b"new").unwrap_err();
                assert!(matches!(error, IoError::NotRegular { .. }), "{error}");
                assert!(matches!(crate::input::read(path), Err(IoError::NotRegular { .. })));
            }
        }
    }
}
