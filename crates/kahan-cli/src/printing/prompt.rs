//! Who watches long work at a prompt: a bar or a spinner on standard error, where that is a
//! terminal, the machine's clock, and its processors.

use std::io::{IsTerminal, stderr};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use kahan_discover::{Progress, Watch};
use kahan_runtime::threads;

/// The user, who sees how far long work is, and what it found once it is done. The bar is removed
/// when this ends.
pub(crate) struct Prompt {
    bar: ProgressBar,
    since: Instant,
}

impl Prompt {
    /// A bar of steps of one sort, `claims`; the work says how many there are.
    pub(crate) fn of(what: &str) -> Self {
        Self::new(0, what)
    }

    /// A bar of so many steps of one sort: `claims`.
    pub(crate) fn new(steps: u64, what: &str) -> Self {
        Self::showing(|| {
            let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg} ({elapsed}, {eta} left)");
            let bar = ProgressBar::new(steps).with_message(what.to_owned());
            bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        })
    }

    /// A spinner, for work in stages whose end is not known.
    pub(crate) fn stages() -> Self {
        Self::showing(|| {
            let style = ProgressStyle::with_template("{spinner} {msg} ({elapsed})");
            let spinner = ProgressBar::new_spinner();
            spinner.enable_steady_tick(Duration::from_millis(120));
            spinner.with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()))
        })
    }

    fn showing(bar: impl FnOnce() -> ProgressBar) -> Self {
        let bar = if stderr().is_terminal() { bar() } else { ProgressBar::hidden() };
        Prompt { bar, since: Instant::now() }
    }

    /// The stage that begins.
    pub(crate) fn say(&self, stage: &str) {
        self.bar.set_message(stage.to_owned());
    }

    /// So many steps are done.
    pub(crate) fn advance(&self, steps: u64) {
        self.bar.inc(steps);
    }

    /// Removes the bar before this ends.
    pub(crate) fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

impl Drop for Prompt {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

impl Watch for Prompt {
    fn now(&self) -> Option<Duration> {
        Some(self.since.elapsed())
    }

    fn look(&self, progress: &Progress<'_>) -> ControlFlow<()> {
        // A bar counts one sort of things to its end; stages in between are no part of that.
        let is_bar = self.bar.length().is_some();
        if let (true, Some(of)) = (is_bar, progress.of) {
            self.bar.set_length(of);
            self.bar.set_position(progress.done);
        } else if !is_bar {
            self.say(&progress.to_string());
        }
        ControlFlow::Continue(())
    }

    fn threads(&self) -> usize {
        threads::available()
    }
}
