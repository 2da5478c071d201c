//! A watch that records the time of each finding.

use std::sync::Mutex;
use std::time::{Duration, Instant};

use kahan_discover::{Finding, Watch};

/// An observer of the search that has a clock, and lets the search use all processors.
pub(crate) struct Clock {
    begun: Instant,
    found: Mutex<Vec<(Duration, Finding)>>,
}

impl Clock {
    pub(crate) fn start() -> Self {
        Clock { begun: Instant::now(), found: Mutex::default() }
    }

    pub(crate) fn stop(self) -> (Duration, Vec<(Duration, Finding)>) {
        (self.begun.elapsed(), self.found.into_inner().expect("no thread panics"))
    }
}

impl Watch for Clock {
    fn now(&self) -> Option<Duration> {
        Some(self.begun.elapsed())
    }

    fn found(&self, finding: &Finding) {
        self.found.lock().expect("no thread panics").push((self.begun.elapsed(), finding.clone()));
    }

    fn threads(&self) -> usize {
        std::thread::available_parallelism().map_or(1, usize::from)
    }
}
