//! Other tools, from PyPI, in a virtual environment that is made when it is first needed.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, ensure};

/// The tools, in the releases that figures and agreement are stated for.
///
/// PHIDL needs the last four for some of its shapes, and does not ask for them.
const PEERS: [&str; 8] = [
    "klayout==0.30.12",
    "gdstk==1.0.2",
    "gdspy==1.6.13",
    "phidl==1.7.2",
    "scipy==1.17.1",
    "rectpack==0.2.2",
    "freetype-py==2.5.1",
    "scikit-image==0.26.0",
];

/// A Python that has the tools.
pub(crate) struct Python {
    program: PathBuf,
}

impl Python {
    /// The environment of the peers in a folder, as by [`Python::with`].
    pub(crate) fn with_peers(folder: &Path) -> anyhow::Result<Option<Self>> {
        Self::with(folder, &PEERS)
    }

    /// The environment in a folder; made and filled if it is not there. `None` if there is no Python, or no way to the
    /// packages: then there is nothing to compare with, and a line says so.
    pub(crate) fn with(folder: &Path, packages: &[&str]) -> anyhow::Result<Option<Self>> {
        let program = folder.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
        let mark = folder.join("installed");
        let wanted = packages.join("\n");
        if std::fs::read_to_string(&mark).is_ok_and(|installed| installed == wanted) {
            return Ok(Some(Self { program }));
        }
        println!("installing {} into {}", packages.join(", "), folder.display());
        let made = Command::new("python3").args(["-m", "venv"]).arg(folder).status();
        if !made.is_ok_and(|status| status.success()) {
            println!("skipped: there is no python3 that can make a virtual environment");
            return Ok(None);
        }
        let filled = Command::new(&program).args(["-m", "pip", "install", "--quiet"]).args(packages).status();
        if !filled.is_ok_and(|status| status.success()) {
            println!("skipped: the packages cannot be installed");
            return Ok(None);
        }
        std::fs::write(&mark, wanted).with_context(|| mark.display().to_string())?;
        Ok(Some(Self { program }))
    }

    /// What a script prints; what it complains about goes to the terminal.
    pub(crate) fn run(&self, script: &Path, arguments: &[&str]) -> anyhow::Result<String> {
        let output = Command::new(&self.program)
            .arg(script)
            .args(arguments)
            .stderr(std::process::Stdio::inherit())
            .output()
            .with_context(|| self.program.display().to_string())?;
        let printed = String::from_utf8(output.stdout).with_context(|| script.display().to_string())?;
        ensure!(output.status.success(), "{} ended with {}\n{printed}", script.display(), output.status);
        Ok(printed)
    }
}
