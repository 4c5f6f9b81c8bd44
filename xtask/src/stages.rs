//! What a command says of its work: the time of each stage, and the memory that it took.

use std::time::{Duration, Instant};

use phidl_boolean::ProgressMonitor;

use crate::progress::Progress;

/// Below this, the memory of a command is mostly the program itself.
const FEW_VERTICES: usize = 100_000;

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

    /// A monitor that shows the progress of a stage.
    pub(crate) fn monitor(&self) -> ProgressMonitor {
        let part = self.progress.part();
        ProgressMonitor::with_report(move |progress| part(progress.done, progress.total))
    }

    /// Runs a stage and keeps what it took.
    pub(crate) fn run<T>(&mut self, name: &'static str, work: impl FnOnce() -> T) -> T {
        self.progress.step(name);
        let start = Instant::now();
        let result = work();
        self.done.push(Stage { name, time: start.elapsed(), memory: peak_memory() });
        result
    }

    /// Prints the time of each stage and the peak of memory up to its end; per vertex, for this number of vertices.
    pub(crate) fn print(self, vertices: usize) {
        let Self { progress, mut done } = self;
        drop(progress);
        let time = done.iter().map(|stage| stage.time).sum();
        done.push(Stage { name: "total", time, memory: peak_memory() });
        for Stage { name, time, memory } in done {
            let memory = memory.map_or("memory unknown on this system".to_owned(), |bytes| told(bytes, vertices));
            println!("{name:<10} {:>9.3} s  {memory}", time.as_secs_f64());
        }
    }
}

/// A peak of memory in words; small work says nothing about the memory per vertex.
fn told(bytes: usize, vertices: usize) -> String {
    let peak = format!("{:>9.1} MB", bytes as f64 / 1e6);
    if vertices < FEW_VERTICES { peak } else { format!("{peak}, {:>4} bytes per vertex read", bytes / vertices) }
}

/// The most memory that the process has had (bytes), where the system tells.
fn peak_memory() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<usize>().ok().map(|kilobytes| kilobytes * 1024)
}
