//! What a command may run into.

use std::io;
use std::path::PathBuf;

use crate::IoError;

/// Why a command failed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CliError {
    /// A generator refused its parameters, or none has this name.
    #[error("{}", .0.report())]
    Draw(#[from] phidl_core::Error),
    /// A file could not be written.
    #[error("{}", .0.report())]
    Write(#[from] IoError),
    /// A file or folder could not be used.
    #[error("{}: {error}", .path.display())]
    Path {
        /// The file or folder.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// A text is no JSON, or not the JSON that is expected.
    #[error("{what}: {error}")]
    Json {
        /// What was read.
        what: String,
        /// What is wrong with it.
        error: serde_json::Error,
    },
    /// Flags that do not go together, or name nothing.
    #[error("{0}")]
    Usage(String),
    /// The output was closed.
    #[error("cannot print: {0}")]
    Print(io::Error),
}

impl CliError {
    /// Whether the reader of a pipe has closed it, which is no failure.
    #[must_use]
    pub fn is_broken_pipe(&self) -> bool {
        matches!(self, Self::Print(error) if error.kind() == io::ErrorKind::BrokenPipe)
    }

    pub(super) fn path(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |error| Self::Path { path, error }
    }

    pub(super) fn json(what: impl Into<String>) -> impl FnOnce(serde_json::Error) -> Self {
        let what = what.into();
        move |error| Self::Json { what, error }
    }
}
