//! Until when work may go on.

use std::cell::Cell;
use std::time::{Duration, Instant};

/// A time after which nothing is begun, and which remembers whether something was left out for it:
/// a sentence about what was not found may only be written where nothing was.
#[derive(Clone, Debug)]
pub struct Deadline {
    end: Option<Instant>,
    has_stopped: Cell<bool>,
}

impl Deadline {
    /// So many seconds after `start`; not a number and negative ones count as 0.
    #[must_use]
    pub fn after(start: Instant, seconds: f64) -> Self {
        let seconds = if seconds.is_nan() { 0.0 } else { seconds.clamp(0.0, 1e9) };
        Deadline { end: Some(start + Duration::from_secs_f64(seconds)), has_stopped: Cell::new(false) }
    }

    /// None at all.
    #[must_use]
    pub fn never() -> Self {
        Deadline { end: None, has_stopped: Cell::new(false) }
    }

    /// Whether the time has come. Who asks stops if it has.
    #[must_use]
    pub fn passed(&self) -> bool {
        let passed = self.end.is_some_and(|end| Instant::now() >= end);
        self.has_stopped.set(self.has_stopped.get() || passed);
        passed
    }

    /// Whether work was left out.
    #[must_use]
    pub fn has_stopped(&self) -> bool {
        self.has_stopped.get()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_deadline_remembers_only_what_it_stopped() {
        let past = Deadline::after(Instant::now(), f64::NAN);
        assert!(!past.has_stopped());
        assert!(past.passed() && past.has_stopped());
        let far = Deadline::after(Instant::now(), 1e300);
        assert!(!far.passed() && !far.has_stopped() && !Deadline::never().passed());
    }
}
