//! Time limits of long computations, and reports to a [`Watch`].

use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::time::Duration;

use kahan_algebra::system::Claim;

use crate::watch::{Finding, Progress, Watch};

/// The least time between two calls of [`Watch::look`] within a stage.
const BETWEEN_LOOKS: Duration = Duration::from_millis(200);

/// A computation that a [`Watch`] observes. Each finding is reported once. Once the watch has ended
/// the computation, it is not called again.
pub struct WatchedSearch<'a> {
    watch: &'a dyn Watch,
    stage: RefCell<String>,
    count: Cell<(u64, Option<u64>)>,
    looked: Cell<Option<Duration>>,
    is_ended: Cell<bool>,
    told: RefCell<BTreeSet<String>>,
}

impl<'a> WatchedSearch<'a> {
    /// Starts a computation that has no findings yet.
    #[must_use]
    pub fn new(watch: &'a dyn Watch) -> Self {
        WatchedSearch {
            watch,
            stage: RefCell::default(),
            count: Cell::default(),
            looked: Cell::default(),
            is_ended: Cell::default(),
            told: RefCell::default(),
        }
    }

    /// Reports progress to the watch. Calls [`Watch::look`] at the start of a stage, and then a few
    /// times a second. If the watch has no clock, every report calls [`Watch::look`].
    pub fn show(&self, progress: &Progress<'_>) {
        self.count.set((progress.done, progress.of));
        let begins = *self.stage.borrow() != progress.what;
        if begins {
            progress.what.clone_into(&mut self.stage.borrow_mut());
        }
        let now = self.now();
        if begins || now.is_none() || self.is_time_to_look(now) {
            self.look(now);
        }
    }

    /// Reports a proved claim once. [`Watch::look`] is then called, which may end the computation.
    pub fn found(&self, claim: &Claim, text: &str) {
        if !self.is_ended.get() && self.told.borrow_mut().insert(text.to_owned()) {
            self.watch.found(&Finding::claimed(claim, text));
            self.look(self.now());
        }
    }

    /// Returns the clock's time, or `None` without a clock or if the watch ended the computation.
    fn now(&self) -> Option<Duration> {
        if self.is_ended.get() { None } else { self.watch.now() }
    }

    fn is_time_to_look(&self, now: Option<Duration>) -> bool {
        let last = self.looked.get().unwrap_or_default();
        now.is_some_and(|now| now.saturating_sub(last) >= BETWEEN_LOOKS)
    }

    fn look(&self, now: Option<Duration>) {
        if self.is_ended.get() {
            return;
        }
        self.looked.set(now);
        let (done, of) = self.count.get();
        let answer = self.watch.look(&Progress { what: &self.stage.borrow(), done, of });
        self.is_ended.set(answer.is_break());
    }
}

/// A time limit that remembers whether it stopped a computation.
///
/// Only a search that was not stopped may state that something does not exist. The deadline passes
/// when time is up or the watch ends the computation. Without a clock, only the watch can.
#[derive(Clone)]
pub struct Deadline<'a> {
    work: Option<&'a WatchedSearch<'a>>,
    end: Option<Duration>,
    has_stopped: Cell<bool>,
}

impl<'a> Deadline<'a> {
    /// Sets a deadline in `seconds` seconds. NaN and negative numbers are replaced by 0.
    #[must_use]
    pub fn after(work: &'a WatchedSearch<'a>, seconds: f64) -> Self {
        let seconds = if seconds.is_nan() { 0.0 } else { seconds.clamp(0.0, 1e9) };
        let end = work.now().map(|now| now + Duration::from_secs_f64(seconds));
        Deadline { work: Some(work), end, has_stopped: Cell::new(false) }
    }

    pub(crate) fn after_share(&self, share: f64) -> Self {
        self.work.map_or_else(Deadline::never, |work| Deadline::after(work, share * self.left()))
    }

    /// Returns a deadline that never passes.
    #[must_use]
    pub fn never() -> Self {
        Deadline { work: None, end: None, has_stopped: Cell::new(false) }
    }

    /// Returns whether the deadline has passed. The caller must then stop.
    #[must_use]
    pub fn passed(&self) -> bool {
        let Some(work) = self.work else { return false };
        let now = work.now();
        if work.is_time_to_look(now) {
            work.look(now);
        }
        let passed = work.is_ended.get() || self.end.zip(now).is_some_and(|(end, now)| now >= end);
        self.has_stopped.set(self.has_stopped.get() || passed);
        passed
    }

    /// Tells whether [`passed`](Self::passed) has ever returned `true`.
    #[must_use]
    pub fn has_stopped(&self) -> bool {
        self.has_stopped.get()
    }

    /// Returns the remaining seconds: infinity without a limit, 0 after the end of the computation.
    #[must_use]
    pub fn left(&self) -> f64 {
        match (self.work, self.end) {
            (Some(work), _) if work.is_ended.get() => 0.0,
            (Some(work), Some(end)) => {
                work.now().map_or(f64::INFINITY, |now| end.saturating_sub(now).as_secs_f64())
            }
            _ => f64::INFINITY,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::Ticking;
    use crate::watch::Unwatched;

    #[test]
    fn a_deadline_remembers_only_what_it_stopped() {
        let (clock, unwatched) = (Ticking::default(), Unwatched);
        let work = WatchedSearch::new(&clock);
        let past = Deadline::after(&work, f64::NAN);
        assert!(!past.has_stopped());
        assert!(past.passed() && past.has_stopped());
        let far = Deadline::after(&work, 1e300);
        assert!(!far.passed() && !far.has_stopped() && !Deadline::never().passed());
        assert!(far.left() > 1e8 && past.left() == 0.0);
        assert!(far.after_share(0.1).left() < 0.11 * far.left() && past.after_share(0.5).passed());
        let unwatched = WatchedSearch::new(&unwatched);
        let timeless = Deadline::after(&unwatched, 0.0);
        assert!(!timeless.passed() && timeless.left() == f64::INFINITY);
    }

    #[test]
    fn the_watch_looks_some_times_a_second_and_no_more_once_it_has_ended_the_work() {
        let clock = Ticking::ending_at_look(4);
        let work = WatchedSearch::new(&clock);
        let far = Deadline::after(&work, 1e9);
        work.show(&Progress::stage("one"));
        work.show(&Progress::stage("two"));
        assert_eq!(clock.looks(), 2, "a stage that begins is seen");
        for done in 0..250 {
            work.show(&Progress { what: "two", done, of: Some(250) });
        }
        assert_eq!(clock.looks(), 3, "what is counted is seen now and then");
        assert!((0..250).any(|_| far.passed()), "the fourth look ends the work");
        assert!(far.passed() && far.has_stopped() && far.left() == 0.0);
        let ticks = clock.ticks();
        work.show(&Progress::stage("three"));
        let tokens = kahan_algebra::lexer::lex("xdot = 0; integral H = x;").tokens;
        let system = kahan_algebra::read_unproved(&tokens).system().expect("a system");
        work.found(&system.claims[0], "integral H = x;");
        assert!(Deadline::after(&work, 1e9).passed());
        assert_eq!((clock.looks(), clock.ticks(), clock.findings()), (4, ticks, 0));
    }
}
