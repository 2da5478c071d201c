//! Counts the work that one or several threads have done, and reports it to the caller's [`Watch`].

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use kahan_discover::{Progress, Watch};

/// A count of the work done by all threads, reported to a watch.
pub struct WorkCount<'a> {
    what: &'static str,
    of: u64,
    watch: &'a dyn Watch,
    done: AtomicU64,
    is_stopped: AtomicBool,
}

impl<'a> WorkCount<'a> {
    /// Starts a count up to the expected total `of`. In reports, `what` names the counted things.
    pub fn new(what: &'static str, of: u64, watch: &'a dyn Watch) -> Self {
        WorkCount { what, of, watch, done: AtomicU64::new(0), is_stopped: AtomicBool::new(false) }
    }

    /// Adds finished work and reports the total.
    pub fn add(&self, more: u64) {
        let done = self.done.fetch_add(more, Ordering::Relaxed) + more;
        let progress = Progress { what: self.what, done, of: Some(self.of) };
        if !self.is_stopped() && self.watch.look(&progress).is_break() {
            self.is_stopped.store(true, Ordering::Relaxed);
        }
    }

    /// Adds finished work; returns `Break` if the watch has cancelled the work.
    pub fn tell(&self, more: u64) -> ControlFlow<()> {
        self.add(more);
        if self.is_stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Returns whether the watch has cancelled the work.
    pub fn is_stopped(&self) -> bool {
        self.is_stopped.load(Ordering::Relaxed)
    }

    /// Returns the number of threads that the work may use.
    pub fn threads(&self) -> usize {
        self.watch.threads()
    }
}
