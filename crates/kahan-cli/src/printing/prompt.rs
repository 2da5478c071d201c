//! A progress bar or a spinner on standard error, where that is a terminal; nothing elsewhere.

use std::io::{IsTerminal, stderr};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// Progress of long work with a known end.
pub(crate) struct Prompt(ProgressBar);

impl Prompt {
    /// A bar of so many steps of one sort: `claims`.
    pub(crate) fn new(steps: u64, what: &str) -> Self {
        if !stderr().is_terminal() {
            return Prompt(ProgressBar::hidden());
        }
        let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg} ({elapsed}, {eta} left)");
        let bar = ProgressBar::new(steps).with_message(what.to_owned());
        Prompt(bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())))
    }

    /// A spinner, for work in stages whose end is not known.
    pub(crate) fn stages() -> Self {
        if !stderr().is_terminal() {
            return Prompt(ProgressBar::hidden());
        }
        let style = ProgressStyle::with_template("{spinner} {msg} ({elapsed})");
        let spinner = ProgressBar::new_spinner();
        spinner.enable_steady_tick(Duration::from_millis(120));
        Prompt(spinner.with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner())))
    }

    /// The stage that begins.
    pub(crate) fn say(&self, stage: &str) {
        self.0.set_message(stage.to_owned());
    }

    /// So many steps are done.
    pub(crate) fn advance(&self, steps: u64) {
        self.0.inc(steps);
    }

    /// Removes the bar.
    pub(crate) fn finish(&self) {
        self.0.finish_and_clear();
    }
}
