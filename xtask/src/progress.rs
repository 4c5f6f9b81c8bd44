//! Says what is being done where it takes longer than a second.

use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget};

/// Steps shorter than this are not worth a line.
const PATIENCE: Duration = Duration::from_secs(1);

/// A spinner on the terminal that appears when one step takes longer than a second.
pub(crate) struct Progress {
    steps: Option<Sender<String>>,
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
            _ = steps.send(what.to_string());
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.steps.take();
        if let Some(watcher) = self.watcher.take() {
            _ = watcher.join();
        }
    }
}

/// Shows every step that is not over within a second, until there are no more steps.
fn watch(steps: &Receiver<String>) {
    let mut next = steps.recv();
    while let Ok(step) = next {
        next = match steps.recv_timeout(PATIENCE) {
            Ok(step) => Ok(step),
            Err(RecvTimeoutError::Disconnected) => return,
            Err(RecvTimeoutError::Timeout) => {
                let spinner = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
                spinner.set_message(step);
                spinner.enable_steady_tick(Duration::from_millis(100));
                let next = steps.recv();
                spinner.finish_and_clear();
                next
            }
        };
    }
}
