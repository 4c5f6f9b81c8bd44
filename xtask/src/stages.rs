//! What a command says of its work: the time of each stage, and the memory that it took.

use std::time::{Duration, Instant};

use crate::progress::Progress;

/// The stages of a command.
pub(crate) struct Stages {
    progress: Progress,
    done: Vec<Stage>,
}

struct Stage {
    name: &'static str,
    time: Duration,
    /// The most memory that the process has had up to its end (bytes), where the system tells.
    memory: Option<usize>,
}

impl Stages {
    pub(crate) fn new() -> Self {
        // What the process has before any work is no memory of the work.
        let start = Stage { name: "start", time: Duration::ZERO, memory: peak_memory() };
        Self { progress: Progress::new(), done: vec![start] }
    }

    /// Runs a stage and keeps what it took.
    pub(crate) fn run<T>(&mut self, name: &'static str, work: impl FnOnce() -> T) -> T {
        self.progress.step(name);
        let start = Instant::now();
        let result = work();
        self.done.push(Stage { name, time: start.elapsed(), memory: peak_memory() });
        result
    }

    /// Prints the time of each stage and the peak of memory up to its end; per vertex, for so many vertices.
    pub(crate) fn print(self, vertices: usize) {
        let Self { progress, mut done } = self;
        drop(progress);
        let time = done.iter().map(|stage| stage.time).sum();
        done.push(Stage { name: "total", time, memory: peak_memory() });
        for Stage { name, time, memory } in done {
            let memory = memory.map_or_else(
                || "memory unknown on this system".to_owned(),
                |bytes| format!("{:>9.1} MB, {:>4} bytes per vertex read", bytes as f64 / 1e6, bytes / vertices.max(1)),
            );
            println!("{name:<10} {:>9.3} s  {memory}", time.as_secs_f64());
        }
    }
}

/// The most memory that the process has had (bytes), where the system tells.
fn peak_memory() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<usize>().ok().map(|kilobytes| kilobytes * 1024)
}
