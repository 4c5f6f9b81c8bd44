//! What a command says of its work: the time of each stage, and the memory that it took.

use std::time::{Duration, Instant};

use crate::progress::Progress;

/// The stages of a command.
pub(crate) struct Stages {
    progress: Progress,
    done: Vec<(&'static str, Duration)>,
}

impl Stages {
    pub(crate) fn new() -> Self {
        Self { progress: Progress::new(), done: Vec::new() }
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
        match peak_memory() {
            Some(bytes) => println!(
                "memory     {:>9.1} MB at its peak, {} bytes per vertex read",
                bytes as f64 / 1e6,
                bytes / vertices.max(1)
            ),
            None => println!("memory       unknown on this system"),
        }
    }
}

/// The most memory that the process has had (bytes), where the system tells.
fn peak_memory() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<usize>().ok().map(|kilobytes| kilobytes * 1024)
}
