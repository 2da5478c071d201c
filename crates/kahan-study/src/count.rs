//! Work of which a watch hears how much is done, from one thread or from several.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use kahan_discover::{Progress, Watch};

/// Counts the work that all threads have done, and tells its watch.
pub struct Count<'a> {
    what: &'static str,
    of: u64,
    watch: &'a dyn Watch,
    done: AtomicU64,
    is_stopped: AtomicBool,
}

impl<'a> Count<'a> {
    /// So many of these are to be done.
    pub fn new(what: &'static str, of: u64, watch: &'a dyn Watch) -> Self {
        Count { what, of, watch, done: AtomicU64::new(0), is_stopped: AtomicBool::new(false) }
    }

    /// So many more are done.
    pub fn add(&self, more: u64) {
        let done = self.done.fetch_add(more, Ordering::Relaxed) + more;
        let progress = Progress { what: self.what, done, of: Some(self.of) };
        if !self.is_stopped() && self.watch.look(&progress).is_break() {
            self.is_stopped.store(true, Ordering::Relaxed);
        }
    }

    /// Adds work that is done, and answers `Break` once the watch has ended the work.
    pub fn tell(&self, more: u64) -> ControlFlow<()> {
        self.add(more);
        if self.is_stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Whether the watch ended the work. It hears no more then.
    pub fn is_stopped(&self) -> bool {
        self.is_stopped.load(Ordering::Relaxed)
    }

    /// How many threads the work may use.
    pub fn threads(&self) -> usize {
        self.watch.threads()
    }
}
