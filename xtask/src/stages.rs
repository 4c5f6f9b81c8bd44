//! What a command says of its work: the time of each stage, and the memory that it took.

use std::time::{Duration, Instant};

use phidl_boolean::Watch;

use crate::progress::Progress;

/// Below this, the memory of a command is mostly the program itself.
const FEW_VERTICES: usize = 100_000;

/// The stages of a command.
pub(crate) struct Stages {
    progress: Progress,
    done: Vec<(&'static str, Duration)>,
}

impl Stages {
    pub(crate) fn new() -> Self {
        Self { progress: Progress::new(), done: Vec::new() }
    }

    /// A watch that shows how far a stage has come.
    pub(crate) fn watch(&self) -> Watch {
        let part = self.progress.part();
        Watch::with_report(move |progress| part(progress.done, progress.total))
    }

    /// Runs a stage and keeps its time.
    pub(crate) fn run<T>(&mut self, name: &'static str, work: impl FnOnce() -> T) -> T {
        self.progress.step(name);
        let start = Instant::now();
        let result = work();
        self.done.push((name, start.elapsed()));
        result
    }

    /// Prints the time of each stage and the peak of memory; per vertex, for so many vertices.
    pub(crate) fn print(self, vertices: usize) {
        let Self { progress, done } = self;
        drop(progress);
        let total: Duration = done.iter().map(|(_, time)| *time).sum();
        for (name, time) in done.into_iter().chain([("total", total)]) {
            println!("{name:<10} {:>9.3} s", time.as_secs_f64());
        }
        println!(
            "memory     {}",
            peak_memory().map_or("  unknown on this system".to_owned(), |peak| told(peak, vertices))
        );
    }
}

/// A peak of memory in words; small work says nothing about the memory per vertex.
fn told(bytes: usize, vertices: usize) -> String {
    let peak = format!("{:>9.1} MB at its peak", bytes as f64 / 1e6);
    if vertices < FEW_VERTICES { peak } else { format!("{peak}, {} bytes per vertex read", bytes / vertices) }
}

/// The most memory that the process has had (bytes), where the system tells.
fn peak_memory() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<usize>().ok().map(|kilobytes| kilobytes * 1024)
}
