//! A sign of life on standard error when the work takes long.

use std::io::IsTerminal;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Work that takes less shows nothing.
const PATIENCE: Duration = Duration::from_secs(2);

/// Shows itself after a while, on a terminal only, until it is dropped.
pub struct Progress {
    bar: ProgressBar,
    watch: Option<(Sender<()>, JoinHandle<()>)>,
}

impl Progress {
    /// Begins to wait; the work has this many parts, zero if nobody knows.
    pub fn start(what: String, parts: u64) -> Self {
        let bar = ProgressBar::hidden();
        if !std::io::stderr().is_terminal() {
            return Self { bar, watch: None };
        }
        let template = if parts > 0 {
            bar.set_length(parts);
            "{msg} {wide_bar:.cyan} {pos}/{len}, {elapsed}, {eta} left"
        } else {
            "{spinner} {msg}, {elapsed}"
        };
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        bar.set_message(what);
        let (done, waiting) = channel::<()>();
        let shown = bar.clone();
        let thread = std::thread::spawn(move || {
            if waiting.recv_timeout(PATIENCE) != Err(RecvTimeoutError::Timeout) {
                return;
            }
            shown.set_draw_target(ProgressDrawTarget::stderr());
            shown.enable_steady_tick(Duration::from_millis(120));
            // The sender is dropped when the work is done.
            let _ = waiting.recv();
            shown.finish_and_clear();
        });
        Self { bar, watch: Some((done, thread)) }
    }

    /// One part is done.
    pub fn advance(&self) {
        self.advance_by(1);
    }

    /// Says something else of the work.
    pub fn say(&self, what: String) {
        self.bar.set_message(what);
    }

    /// So many parts more are done.
    pub fn advance_by(&self, parts: u64) {
        self.bar.inc(parts);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((done, thread)) = self.watch.take() {
            drop(done);
            let _ = thread.join();
        }
    }
}
