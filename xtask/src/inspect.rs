//! `cargo xtask inspect`: a layout file in numbers.

use anyhow::anyhow;
use phidl_io::layout::{self, Inspection, ReadOptions};

use crate::flags::InspectFlags;

/// Problems that are printed without `--problems`.
const FEW: usize = 20;

/// A file that is not as `--strict` asks.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub(crate) struct Strict(pub(crate) String);

/// Counts in a file, and prints what is there.
pub(crate) fn run(flags: &InspectFlags) -> anyhow::Result<()> {
    let options = ReadOptions { cellname: flags.cell.clone(), ..ReadOptions::default() };
    let found = layout::inspect(&flags.file, &options, !flags.no_merged).map_err(|error| anyhow!(error.report()))?;
    if flags.json {
        println!("{}", serde_json::to_string_pretty(&found.to_json())?);
    } else {
        println!("{found}");
        print_problems(&found, flags.problems);
    }
    let problems = found.problems.len() + found.unlisted_problems;
    if flags.strict && problems > 0 {
        return Err(Strict(format!("{}: the file has {problems} problems", flags.file.display())).into());
    }
    Ok(())
}

fn print_problems(found: &Inspection, all: bool) {
    let listed = if all { found.problems.len() } else { found.problems.len().min(FEW) };
    for problem in &found.problems[..listed] {
        println!("problem    {problem}");
    }
    let more = found.problems.len() - listed + found.unlisted_problems;
    if more > 0 {
        println!("problem    {more} more");
    }
}
