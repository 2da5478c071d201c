//! Shows the progress of long work on standard error, if it is a terminal.

use std::io::{IsTerminal, stderr, stdout};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use kahan_discover::report::MOST_READABLE;
use kahan_discover::{Finding, Progress, Watch};
use kahan_runtime::threads;

/// A progress bar or spinner that also shows findings. Dropping the value removes the bar.
pub(crate) struct ProgressDisplay {
    bar: ProgressBar,
    since: Instant,
    end: Option<Instant>,
    done: AtomicU64,
}

impl ProgressDisplay {
    /// Makes a bar for work that reports its number of steps.
    pub(crate) fn of(what: &str) -> Self {
        Self::new(0, what)
    }

    /// Makes a bar of `steps` steps, called `what`.
    pub(crate) fn new(steps: u64, what: &str) -> Self {
        Self::showing(true, || bar(steps, what))
    }

    /// Makes a bar that counts steps of orbits. It is hidden if rows are printed on a terminal,
    /// where it would disturb them.
    pub(crate) fn beside_rows(in_file: bool, steps: u64) -> Self {
        Self::showing(in_file || !stdout().is_terminal(), || bar(steps, "steps"))
    }

    /// Makes a spinner, for work whose number of steps is unknown.
    pub(crate) fn stages() -> Self {
        Self::showing(true, || {
            let spinner = ProgressBar::new_spinner();
            spinner.enable_steady_tick(Duration::from_millis(120));
            styled(spinner, "{spinner} {msg} ({elapsed})")
        })
    }

    fn showing(has_room: bool, bar: impl FnOnce() -> ProgressBar) -> Self {
        let bar = if has_room && stderr().is_terminal() { bar() } else { ProgressBar::hidden() };
        ProgressDisplay { bar, since: Instant::now(), end: None, done: AtomicU64::new(0) }
    }

    pub(crate) fn within(self, seconds: f64) -> Self {
        // A time limit is at most 3·10⁹ seconds, so that `end` can be represented.
        let allowed = Duration::try_from_secs_f64(seconds.min(3e9)).unwrap_or_default();
        ProgressDisplay { end: Some(self.since + allowed), ..self }
    }

    pub(crate) fn is_over(&self) -> bool {
        self.end.is_some_and(|end| Instant::now() >= end)
    }

    pub(crate) fn show_stage(&self, stage: &str) {
        self.bar.set_message(stage.to_owned());
    }

    pub(crate) fn show_steps(&self, steps: u64) {
        let done = self.done.fetch_add(steps, Ordering::Relaxed) + steps;
        self.bar.set_position(done);
    }
}

fn bar(steps: u64, what: &str) -> ProgressBar {
    let bar = ProgressBar::new(steps).with_message(what.to_owned());
    styled(bar, "{bar:40} {pos}/{len} {msg} ({elapsed}, {eta} left)")
}

fn styled(bar: ProgressBar, template: &str) -> ProgressBar {
    bar.with_style(ProgressStyle::with_template(template).expect("the template names parts of a bar"))
}

impl Watch for ProgressDisplay {
    fn now(&self) -> Option<Duration> {
        Some(self.since.elapsed())
    }

    fn look(&self, progress: &Progress<'_>) -> ControlFlow<()> {
        if self.is_over() {
            return ControlFlow::Break(());
        }
        match (self.bar.length(), progress.of) {
            (Some(length), Some(of)) => {
                let done = self.done.load(Ordering::Relaxed);
                self.bar.set_length(length.max(done + of));
                self.bar.set_position(done + progress.done);
            }
            (Some(_), None) => {}
            (None, _) => self.show_stage(&progress.to_string()),
        }
        ControlFlow::Continue(())
    }

    /// Prints a finding above the bar. A long finding is abbreviated.
    fn found(&self, finding: &Finding) {
        let Finding { kind, name, text } = finding;
        let shown = match text.len() {
            0..=MOST_READABLE => text.clone(),
            len => format!("{} {name} of {len} characters", kind.keyword()),
        };
        self.bar.println(format!("{:.1} s: {shown}", self.since.elapsed().as_secs_f64()));
    }

    fn threads(&self) -> usize {
        threads::available()
    }
}
