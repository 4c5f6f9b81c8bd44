//! Says what is being done where it takes longer than a second.

use std::sync::mpsc::{Receiver, RecvError, RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use indicatif::ProgressBar;

/// Steps shorter than this are not worth a line.
const PATIENCE: Duration = Duration::from_secs(1);

/// What the watcher hears.
enum News {
    /// A step begins.
    Step(String),
    /// How many parts of the present step are done, of how many.
    Part(usize, usize),
    /// There are no more steps.
    End,
}

/// A spinner on the terminal that appears when one step takes longer than a second.
pub(crate) struct Progress {
    steps: Option<Sender<News>>,
    watcher: Option<JoinHandle<()>>,
}

impl Progress {
    pub(crate) fn new() -> Self {
        let (steps, heard) = channel();
        Self { steps: Some(steps), watcher: Some(std::thread::spawn(move || watch(&heard))) }
    }

    /// A new step begins; the one before is over.
    pub(crate) fn step(&self, what: impl std::fmt::Display) {
        if let Some(steps) = &self.steps {
            // The watcher only waits and draws; if it is gone, there is nothing to see.
            _ = steps.send(News::Step(what.to_string()));
        }
    }

    /// Takes how far the present step has come, from any thread.
    pub(crate) fn part(&self) -> impl Fn(usize, usize) + Send + Sync + use<> {
        let steps = self.steps.clone();
        move |done, total| {
            if let Some(steps) = &steps {
                _ = steps.send(News::Part(done, total));
            }
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(steps) = self.steps.take() {
            _ = steps.send(News::End);
        }
        if let Some(watcher) = self.watcher.take() {
            _ = watcher.join();
        }
    }
}

/// Shows every step that is not over within a second, until there are no more steps.
fn watch(news: &Receiver<News>) {
    let mut next = news.recv();
    while let Ok(News::Step(step)) = next {
        next = match quiet_until(news, Instant::now() + PATIENCE) {
            Err(RecvTimeoutError::Disconnected) => return,
            Err(RecvTimeoutError::Timeout) => {
                let spinner = ProgressBar::new_spinner();
                spinner.set_message(step.clone());
                spinner.enable_steady_tick(Duration::from_millis(100));
                let next = shown(news, &spinner, &step);
                spinner.finish_and_clear();
                next
            }
            Ok(step) => Ok(step),
        };
    }
}

/// The next step, if it comes in time.
fn quiet_until(news: &Receiver<News>, end: Instant) -> Result<News, RecvTimeoutError> {
    loop {
        match news.recv_timeout(end.saturating_duration_since(Instant::now()))? {
            News::Part(..) => {}
            other => return Ok(other),
        }
    }
}

/// The next step; until then, the parts of this one are shown.
fn shown(news: &Receiver<News>, spinner: &ProgressBar, step: &str) -> Result<News, RecvError> {
    loop {
        match news.recv()? {
            News::Part(done, total) => spinner.set_message(format!("{step} {} %", 100 * done / total.max(1))),
            other => return Ok(other),
        }
    }
}
