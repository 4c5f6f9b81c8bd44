//! Files as bytes.

use std::fs;
use std::io::Read;
use std::path::Path;

use crate::error::{IoError, Result};

/// The largest file that is read into memory (bytes).
const MOST_BYTES: u64 = 1 << 36;

/// Reads a regular file whole. Devices and pipes are refused: they need not end.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>> {
    let failed = |action| move |error| IoError::file(path, action, error);
    // Before it is opened: opening a pipe waits for its writer.
    let metadata = fs::metadata(path).map_err(failed("read it"))?;
    if metadata.is_dir() {
        return Err(IoError::file(path, "read it", std::io::ErrorKind::IsADirectory.into()));
    }
    if !metadata.is_file() {
        return Err(IoError::NotRegular { path: path.display().to_string().into() });
    }
    if metadata.len() > MOST_BYTES {
        let error = std::io::Error::new(std::io::ErrorKind::FileTooLarge, format!("it has {} bytes", metadata.len()));
        return Err(IoError::file(path, "read it", error));
    }
    let mut file = fs::File::open(path).map_err(failed("read it"))?;
    let mut bytes = Vec::new();
    let size = usize::try_from(metadata.len()).unwrap_or(0);
    bytes
        .try_reserve_exact(size)
        .map_err(|_| IoError::file(path, "read it", std::io::ErrorKind::OutOfMemory.into()))?;
    file.read_to_end(&mut bytes).map_err(failed("read it"))?;
    Ok(bytes)
}
